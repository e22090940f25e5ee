//! Stops from other threads, and what they keep back.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use jaka_sync::layer::{Clock, StopParts as _, Waker, Watched, WrittenStop};

use crate::{Cause, Error, Occurrence, StopHandle};

/// The stops that were asked for through handles, by their numbers from 1.
#[derive(Debug)]
pub(crate) struct Stops {
    /// The latest that was asked for.
    begun: AtomicU64,
    /// The latest that the controller has accepted.
    taken: AtomicU64,
    /// The latest that goes out, or has gone out: before that a servo session may brake.
    sent: AtomicU64,
    /// How many are on their way to the controller.
    under_way: AtomicU64,
    /// What stops wait for: that no session moves the arm any more. Nothing is locked under it.
    next_set_point: Watched<Expected>,
}

/// What stops wait for before they go out.
#[derive(Debug, Default)]
struct Expected {
    /// Until when a servo session that moves the arm sends its next set-point; none where none moves it.
    set_point: Option<Instant>,
    /// When the first stop that waits for a session to brake goes out at the latest; none where none waits.
    stop: Option<Instant>,
}

/// How long a stop waits at most for a servo session to brake.
const LONGEST_BRAKING: Duration = Duration::from_secs(3);

impl Stops {
    pub(super) fn new(clock: &Clock) -> Self {
        Self {
            begun: AtomicU64::new(0),
            taken: AtomicU64::new(0),
            sent: AtomicU64::new(0),
            under_way: AtomicU64::new(0),
            next_set_point: Watched::new(clock, Expected::default()),
        }
    }

    /// The number of the latest stop that the controller has accepted.
    pub(super) fn taken(&self) -> u64 {
        self.taken.load(Ordering::SeqCst)
    }

    /// The number of the latest stop that has gone out or is about to.
    pub(super) fn sent(&self) -> u64 {
        self.sent.load(Ordering::SeqCst)
    }

    /// The number of the latest stop that was asked for.
    pub(super) fn begun(&self) -> u64 {
        self.begun.load(Ordering::SeqCst)
    }

    /// A stop that keeps motions back: one that is on its way, or one after the last that was reported to the program.
    pub(super) fn pending(&self, told: u64) -> Option<Occurrence> {
        (self.is_under_way() || self.begun() != told).then(|| Cause::Stopped.into())
    }

    /// A servo session that moves the arm sends its next set-point within this time; none where none moves it.
    pub(crate) fn expect_set_point(&self, within: Option<Duration>) {
        let mut next = self.next_set_point.lock();
        if within.is_none() && next.set_point.is_none() {
            return;
        }
        next.set_point = within.map(|within| self.next_set_point.clock().now() + within);
        if next.set_point.is_none() {
            self.next_set_point.wake();
        }
    }

    /// Waits while a servo session brakes. One whose next set-point is overdue does not: the arm has none to follow.
    fn wait_until_braked(&self) {
        let mut next = self.next_set_point.lock();
        while let (Some(due), Some(latest)) = (next.set_point, next.stop) {
            let left = self.next_set_point.clock().left(due.min(latest));
            if left.is_zero() {
                break;
            }
            next = self.next_set_point.wait(next, left);
        }
        next.stop = None;
    }

    /// How long a stop waits yet for a servo session to brake; none where none waits.
    #[cfg(feature = "stream")]
    pub(crate) fn time_to_brake(&self) -> Option<Duration> {
        self.next_set_point.lock().stop.map(|latest| self.next_set_point.clock().left(latest))
    }

    /// True while the controller has not answered a stop.
    pub(super) fn is_under_way(&self) -> bool {
        self.under_way.load(Ordering::SeqCst) > 0
    }
}

/// A stop on its way, until it is dropped.
#[derive(Debug)]
struct UnderWay(Arc<Stops>);

impl UnderWay {
    fn begin(stops: &Arc<Stops>) -> (Self, u64) {
        // Who sees the stop knows when it goes out.
        stops.next_set_point.lock().stop.get_or_insert(stops.next_set_point.clock().now() + LONGEST_BRAKING);
        stops.under_way.fetch_add(1, Ordering::SeqCst);
        (Self(Arc::clone(stops)), stops.begun.fetch_add(1, Ordering::SeqCst) + 1)
    }
}

impl Drop for UnderWay {
    fn drop(&mut self) {
        self.0.under_way.fetch_sub(1, Ordering::SeqCst);
    }
}

/// A stop that was written, and is on its way.
#[derive(Debug)]
pub(super) struct Written {
    stop: WrittenStop,
    number: u64,
    _under_way: UnderWay,
}

/// A stop that was sent, or was to be.
#[derive(Debug)]
pub(super) struct Sent {
    pub(super) number: u64,
    pub(super) written: Option<Instant>,
    pub(super) accepted: Result<(), Error>,
}

/// Stops the arm of a [`Robot`](super::Robot) from another thread, and ends its wait as soon as the controller has accepted the
/// stop. Unless an [`End`](crate::End) has reported the stop by [`Cause::Stopped`], the next motion is refused until
/// [`Robot::acknowledge`](super::Robot::acknowledge). While a stop is on its way, every motion is refused.
///
/// It works as long as its robot lives: dropping the robot closes the connection on which stops go out, and `stop` then fails.
///
/// This is not an emergency stop: only the robot's own safety functions protect people.
#[derive(Debug, Clone)]
#[must_use = "a stop handle stops nothing until `stop` is called"]
pub struct RobotStop {
    pub(super) handle: StopHandle,
    pub(super) stops: Arc<Stops>,
    pub(super) waker: Waker,
}

impl RobotStop {
    /// Sends `stop_program` (4.23), waits until the controller has accepted it, and ends the wait.
    ///
    /// A [`ServoSession`](crate::ServoSession) that moves the arm brakes it first, with its next set-points: no source says that `stop_program` alone
    /// ends servo motion. The stop waits for that for 3 s at most, and for six periods at most after the last set-point.
    /// From the session's own thread it cannot brake; from an observer of the monitor no packet is seen meanwhile.
    ///
    /// # Errors
    /// As [`StopHandle::stop`]. Unless the call succeeds, expect the robot to keep moving: its wait goes on, and the
    /// next motion is refused.
    pub fn stop(&self) -> Result<(), Error> {
        self.stop_and_tell().accepted
    }

    /// The same, and what is known of the stop.
    pub(super) fn stop_and_tell(&self) -> Sent {
        // From here on no motion is sent.
        let (_under_way, number) = UnderWay::begin(&self.stops);
        self.stops.wait_until_braked();
        self.stops.sent.fetch_max(number, Ordering::SeqCst);
        match self.handle.write() {
            Ok(stop) => self.answered(number, Some(stop.at), self.handle.wait(&stop).map_err(Error::from)),
            Err(error) => self.answered(number, None, Err(error.into())),
        }
    }

    /// Writes the stop if that can be done at once, and no servo session moves the arm; none otherwise.
    pub(super) fn write_now(&self) -> Option<Written> {
        if self.stops.next_set_point.lock().set_point.is_some() {
            return None;
        }
        let (under_way, number) = UnderWay::begin(&self.stops);
        self.stops.wait_until_braked();
        // What a logger's panic leaves undone another thread does.
        let Ok(Some(stop)) = catch_unwind(AssertUnwindSafe(|| self.handle.write_now())) else {
            // As if it had not been asked for, unless another has been since.
            let _ = self.stops.begun.compare_exchange(number, number - 1, Ordering::SeqCst, Ordering::SeqCst);
            return None;
        };
        self.stops.sent.fetch_max(number, Ordering::SeqCst);
        Some(Written { stop, number, _under_way: under_way })
    }

    /// Waits for the reply to a stop that was written.
    pub(super) fn finish(&self, written: &Written) -> Sent {
        self.answered(written.number, Some(written.stop.at), self.handle.wait(&written.stop).map_err(Error::from))
    }

    fn answered(&self, number: u64, written: Option<Instant>, accepted: Result<(), Error>) -> Sent {
        if accepted.is_ok() {
            self.stops.taken.fetch_max(number, Ordering::SeqCst);
            self.waker.wake();
        } else {
            // A program that learned of it, or acknowledged it, did not know that it would fail.
            self.stops.begun.fetch_add(1, Ordering::SeqCst);
        }
        Sent { number, written, accepted }
    }
}
