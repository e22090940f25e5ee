//! Handles that stop the arm from other threads.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_sync::layer::{StopParts as _, WrittenStop};

use super::state::ArmState;
use crate::{Error, StopHandle};

/// Longest wait of a stop until a servo session has braked.
const LONGEST_BRAKING: Duration = Duration::from_secs(3);

/// A stop on its way, until it is dropped.
#[derive(Debug)]
pub(super) struct UnderWay(Arc<ArmState>);

impl UnderWay {
    /// Begins a stop, and returns its number: from here on no motion is sent.
    pub(super) fn begin(state: &Arc<ArmState>) -> (Self, u64) {
        let number = state.lock().stops.begin(state.clock().now() + LONGEST_BRAKING);
        (Self(Arc::clone(state)), number)
    }
}

impl Drop for UnderWay {
    fn drop(&mut self) {
        self.0.lock().stops.end();
    }
}

/// A stop that was written, and is on its way.
#[derive(Debug)]
pub(crate) struct Written {
    stop: WrittenStop,
    number: u64,
    _under_way: UnderWay,
}

/// A stop that was sent, or was to be.
#[derive(Debug)]
pub(crate) struct Sent {
    pub(crate) number: u64,
    pub(crate) written: Option<Instant>,
    pub(crate) accepted: Result<(), Error>,
}

/// Stops the arm of a [`Robot`](crate::Robot) from another thread, and ends its wait as soon as the controller has
/// accepted the stop. Unless an [`End`](crate::End) has reported the stop by [`Cause::Stopped`](crate::Cause::Stopped),
/// the next motion is refused until [`Robot::acknowledge`](crate::Robot::acknowledge). While a stop is on its way,
/// every motion is refused.
///
/// It works as long as its robot lives: dropping the robot closes the connection on which stops go out, and `stop` then
/// fails.
///
/// This is not an emergency stop: only the robot's own safety functions protect people.
#[derive(Debug, Clone)]
#[must_use = "a stop handle stops nothing until `stop` is called"]
pub struct RobotStop {
    handle: StopHandle,
    state: Arc<ArmState>,
}

impl RobotStop {
    pub(super) fn new(handle: StopHandle, state: &Arc<ArmState>) -> Self {
        Self { handle, state: Arc::clone(state) }
    }

    /// Sends `stop_program` (4.23), waits until the controller has accepted it, and ends the wait.
    ///
    /// A [`ServoSession`](crate::ServoSession) that moves the arm brakes it first, with its next set-points: no source
    /// says that `stop_program` alone ends servo motion. The stop waits for that for 3 s at most, and for six periods
    /// at most after the last set-point. From the session's own thread it cannot brake; from an observer of the monitor
    /// no packet is seen meanwhile.
    ///
    /// # Errors
    /// As [`StopHandle::stop`]. If the call fails, the robot may keep moving: its wait continues, and the next motion
    /// is refused.
    pub fn stop(&self) -> Result<(), Error> {
        self.stop_and_tell().accepted
    }

    /// Stops the arm as [`stop`](Self::stop) does, and returns the facts of the stop.
    pub(crate) fn stop_and_tell(&self) -> Sent {
        let (_under_way, number) = UnderWay::begin(&self.state);
        self.state.wait_until_braked();
        self.state.lock().stops.send(number);
        match self.handle.write() {
            Ok(stop) => self.answered(number, Some(stop.at), self.handle.wait(&stop).map_err(Error::from)),
            Err(error) => self.answered(number, None, Err(error.into())),
        }
    }

    /// Writes the stop if that can be done at once, and no servo session moves the arm; none otherwise.
    pub(crate) fn write_now(&self) -> Option<Written> {
        if self.state.lock().stops.expects_set_point() {
            return None;
        }
        let (under_way, number) = UnderWay::begin(&self.state);
        self.state.wait_until_braked();
        // If a logger panics, another thread does the rest.
        let Ok(Some(stop)) = catch_unwind(AssertUnwindSafe(|| self.handle.write_now())) else {
            // As without the request, unless another stop was requested since.
            self.state.lock().stops.take_back(number);
            return None;
        };
        self.state.lock().stops.send(number);
        Some(Written { stop, number, _under_way: under_way })
    }

    /// Waits for the reply to a stop that was written.
    pub(crate) fn finish(&self, written: &Written) -> Sent {
        self.answered(written.number, Some(written.stop.at), self.handle.wait(&written.stop).map_err(Error::from))
    }

    fn answered(&self, number: u64, written: Option<Instant>, accepted: Result<(), Error>) -> Sent {
        self.state.take_answer(number, accepted.is_ok());
        Sent { number, written, accepted }
    }
}
