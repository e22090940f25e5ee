//! A client and a monitor together: motions that are waited for.

mod explain;
mod motion;
mod outcome;
mod wait;

use std::fmt::Display;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::messages::types::JointPosition;

pub use self::explain::Explanation;
pub use self::motion::Motion;
pub use self::outcome::{MotionEnd, NotReached, Outcome};
use self::wait::{Grace, Wait};
use crate::monitor::Waker;
use crate::{Client, Config, Error, Monitor, ServoConfig, ServoSession, StopHandle};

/// A robot whose motions are waited for: a [`Client`] for commands and a [`Monitor`] for what comes of them.
///
/// ```no_run
/// use std::time::Duration;
/// use jaka_sync::Robot;
/// use jaka_sync::motion::JointMove;
/// use jaka_sync::types::MoveMode;
///
/// let mut robot = Robot::connect("10.5.5.100")?;
/// robot.power_up(Duration::from_secs(60))?;
/// let request = JointMove {
///     mode: MoveMode::Absolute,
///     joint_position: [0.0, 90.0, 90.0, 90.0, -90.0, 0.0].into(),
///     speed: 20.0,
///     acceleration: Some(60.0),
/// };
/// robot.run(&request, Duration::from_secs(30))?.reached()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// After a protective stop, an emergency stop or a lost connection, motions are refused until
/// [`acknowledge`](Self::acknowledge) is called: somebody should have looked first. Nothing is ever sent again, or enabled
/// again, on its own.
#[derive(Debug)]
pub struct Robot {
    client: Client,
    monitor: Arc<Monitor>,
    grace: Grace,
    silence: Duration,
    /// What must be acknowledged before the arm moves again. The monitor's thread sets it, too.
    latched: Arc<Mutex<Option<Outcome>>>,
    batch: Option<Batch>,
    stops: Arc<Stops>,
    /// The stops that this robot's program has been told of.
    stops_told: u64,
}

/// The stops that were asked for through handles, by their numbers from 1.
#[derive(Debug, Default)]
struct Stops {
    /// The latest that was asked for.
    begun: AtomicU64,
    /// The latest that the controller has taken.
    taken: AtomicU64,
}

impl Stops {
    /// A stop, if one was asked for beyond those that were told of.
    fn asked_since(&self, told: u64) -> Option<Outcome> {
        (self.begun.load(Ordering::SeqCst) != told).then_some(Outcome::Stopped)
    }
}

/// Motions that were accepted and have not been waited for.
#[derive(Debug, Clone, Copy)]
struct Batch {
    sent: Instant,
    target: Option<JointPosition>,
}

impl Robot {
    /// Connects to a controller at the protocol's ports, 10001 and 10000.
    ///
    /// # Errors
    /// As [`Client::connect`] and [`Monitor::connect`].
    pub fn connect(address: impl Display) -> Result<Self, Error> {
        let config = Config::new();
        let monitor: Monitor = config.monitor(&address)?;
        Ok(Self::new(config.connect(address)?, monitor))
    }

    /// A robot of connections that have been made, to the same controller.
    ///
    /// The monitor can be shared: given as an [`Arc`], or taken from [`monitor`](Self::monitor).
    pub fn new(client: Client, monitor: impl Into<Arc<Monitor>>) -> Self {
        let monitor = monitor.into();
        let grace = Grace { time: Duration::from_millis(400), packets: 3 };
        let latched = Arc::default();
        latch_on_stops(&monitor, &latched);
        Self {
            client,
            monitor,
            grace,
            silence: Duration::from_secs(2),
            latched,
            batch: None,
            stops: Arc::default(),
            stops_told: 0,
        }
    }

    /// Sets how long the arm may take to begin a motion, and how many packets must have come by then. 0.4 s and three by
    /// default.
    ///
    /// If the arm has not left its position within that, the motion is taken to have had no length, or, where its target is
    /// known and the arm is not there, to have been stopped.
    #[must_use]
    pub fn start_grace(mut self, time: Duration, packets: u32) -> Self {
        self.grace = Grace { time, packets: packets.max(1) };
        self
    }

    /// Sets how long status packets may stay away while a motion is waited for. 2 s by default.
    #[must_use]
    pub fn status_silence(mut self, time: Duration) -> Self {
        self.silence = time;
        self
    }

    /// The client, for all other commands.
    ///
    /// Motions that are sent through it are not refused after a stop, and not waited for.
    pub fn client(&mut self) -> &mut Client {
        &mut self.client
    }

    /// The monitor, which can be cloned for other threads.
    pub fn monitor(&self) -> &Arc<Monitor> {
        &self.monitor
    }

    /// Powers and enables the arm, each step when the status says that the one before is done.
    ///
    /// # Errors
    /// As [`Client::call`]; [`Error::StatusTimeout`] if the status does not follow in time.
    pub fn power_up(&mut self, timeout: Duration) -> Result<(), Error> {
        let since = Instant::now();
        let left = || timeout.saturating_sub(since.elapsed());
        let now = self.monitor.wait_until(|_| true, left())?;
        if now.status.powered_on != Some(true) {
            self.client.power_on()?;
            self.monitor.wait_until(|status| status.powered_on == Some(true), left())?;
        }
        if now.status.enabled != Some(true) {
            self.client.enable_robot()?;
            self.monitor.wait_until(|status| status.enabled == Some(true), left())?;
        }
        Ok(())
    }

    /// Sends a motion and waits for its end.
    ///
    /// # Errors
    /// As [`start`](Self::start), but the reply is waited for no longer than `timeout`. All that happens after the motion
    /// was accepted is told by the [`MotionEnd`].
    pub fn run(&mut self, motion: &impl Motion, timeout: Duration) -> Result<MotionEnd, Error> {
        let since = Instant::now();
        self.send(motion, timeout)?;
        Ok(self.wait(timeout.saturating_sub(since.elapsed())))
    }

    /// Sends a motion, which starts when those before it have ended. [`wait`](Self::wait) then waits for all of them.
    ///
    /// # Errors
    /// As [`Client::call`]; [`Error::NotAcknowledged`] after a stop or a lost connection. Nothing was sent then.
    pub fn start<M: Motion>(&mut self, motion: &M) -> Result<(), Error> {
        self.send(motion, self.client.timeout_of(M::INFO))
    }

    fn send<M: Motion>(&mut self, motion: &M, timeout: Duration) -> Result<(), Error> {
        self.check_latch()?;
        let gate = self.gate();
        self.client.call_through(Some(&gate), motion, timeout).map_err(|error| self.explained(error))?;
        // Packets that came before the reply may be older than the motion.
        let sent = Instant::now();
        self.batch = Some(Batch { sent, target: motion.target() });
        Ok(())
    }

    /// Waits for the end of all motions that were started; at once, with [`Outcome::Reached`], if there are none.
    pub fn wait(&mut self, timeout: Duration) -> MotionEnd {
        let since = Instant::now();
        let Some(batch) = self.batch.take() else {
            return MotionEnd { outcome: Outcome::Reached, waited: Duration::ZERO, packets: Vec::new() };
        };
        let mut wait = Wait::new(batch.sent, batch.target, self.grace);
        let mut outcome = self.watch(&mut wait, timeout);
        // Where the target is not known, the arm may be in position because of a stop that is on its way.
        let begun = self.stops.begun.load(Ordering::SeqCst);
        if outcome.is_reached() && batch.target.is_none() && begun != self.stops_told {
            outcome = Outcome::Stopped;
        }
        if matches!(outcome, Outcome::Stopped) {
            self.stops_told = begun;
        }
        if outcome.latches() {
            lock(&self.latched).get_or_insert_with(|| outcome.clone());
        }
        if matches!(outcome, Outcome::Deadline) {
            // The motions may go on: they can be waited for again.
            self.batch = Some(batch);
        }
        MotionEnd { outcome, waited: since.elapsed(), packets: wait.packets.into() }
    }

    fn watch(&self, wait: &mut Wait, timeout: Duration) -> Outcome {
        let since = Instant::now();
        loop {
            let heard = self.monitor.last().map(|snapshot| snapshot.number);
            let left = timeout.saturating_sub(since.elapsed());
            let watched = self.monitor.watch(left.min(self.silence), |snapshot| {
                if self.stops.taken.load(Ordering::SeqCst) > self.stops_told {
                    return Some(Outcome::Stopped);
                }
                snapshot.and_then(|snapshot| wait.look(snapshot))
            });
            match watched {
                Ok(Some(outcome)) => return outcome,
                Err(_) => return Outcome::StatusLost { cause: self.monitor.disconnect() },
                Ok(None) if since.elapsed() >= timeout => return Outcome::Deadline,
                Ok(None) if self.monitor.last().map(|snapshot| snapshot.number) == heard => {
                    return Outcome::StatusLost { cause: None };
                }
                Ok(None) => {}
            }
        }
    }

    /// Enters servo mode, in which set-points come one by one: waits until the controller is in it.
    ///
    /// # Errors
    /// As [`Client::call`]; [`Error::NotAcknowledged`] after a stop or a lost connection; [`Error::StatusTimeout`] if the
    /// controller does not enter servo mode in time.
    pub fn servo(&mut self, config: &ServoConfig) -> Result<ServoSession<'_>, Error> {
        self.check_latch()?;
        ServoSession::enter(self, config)
    }

    pub(crate) fn check_latch(&self) -> Result<(), Error> {
        not_latched(self.latch())
    }

    /// Keeps back what would move the arm behind a stop: one that has begun by the time of the write is on the wire before it,
    /// or will be sent behind it.
    pub(crate) fn gate(&self) -> impl Fn() -> Result<(), Error> + use<> {
        let (latched, stops, told) = (Arc::clone(&self.latched), Arc::clone(&self.stops), self.stops_told);
        move || not_latched(lock(&latched).clone().or_else(|| stops.asked_since(told)))
    }

    /// What must be acknowledged before the arm moves again, if something must.
    ///
    /// A stop latches whenever a packet shows it, also between motions; one that was asked for through a [`RobotStop`] where
    /// no [`MotionEnd`] has told of it.
    pub fn latch(&self) -> Option<Outcome> {
        let cause = self.client.disconnect().or_else(|| self.monitor.disconnect());
        let mut latched = lock(&self.latched);
        if latched.is_none() {
            *latched = cause.map(|cause| Outcome::StatusLost { cause: Some(cause) });
        }
        latched.clone().or_else(|| self.stops.asked_since(self.stops_told))
    }

    /// Says that somebody has looked: motions are sent again, if nothing else keeps the arm from moving.
    pub fn acknowledge(&mut self) {
        *lock(&self.latched) = None;
        self.stops_told = self.stops.begun.load(Ordering::SeqCst);
        self.batch = None;
    }

    /// The same error, with the reason for a refusal where the status tells it.
    fn explained(&self, error: Error) -> Error {
        match (self.explain(&error), error) {
            (Some(explanation), Error::Refused { refusal, exchanges }) => {
                Error::RefusedBecause { refusal, explanation, exchanges }
            }
            (_, error) => error,
        }
    }

    /// Why the controller refused a command of the [`client`](Self::client), as far as the status tells, and what helps.
    ///
    /// Motions of the robot itself are explained in their error: [`Error::RefusedBecause`].
    pub fn explain(&self, error: &Error) -> Option<Explanation> {
        let status = self.monitor.last();
        Explanation::of(error.refusal()?, status.as_ref().map(|snapshot| &snapshot.status))
    }

    /// A handle that stops the arm from another thread and so ends a [`wait`](Self::wait).
    pub fn stop_handle(&self) -> RobotStop {
        RobotStop { handle: self.client.stop_handle(), stops: Arc::clone(&self.stops), waker: self.monitor.waker() }
    }
}

fn not_latched(latch: Option<Outcome>) -> Result<(), Error> {
    latch.map_or(Ok(()), |outcome| Err(Error::NotAcknowledged { outcome: Box::new(outcome) }))
}

fn lock(latched: &Mutex<Option<Outcome>>) -> MutexGuard<'_, Option<Outcome>> {
    latched.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Has the monitor latch a robot at each stop that a packet shows, for as long as the robot lives.
fn latch_on_stops(monitor: &Monitor, latched: &Arc<Mutex<Option<Outcome>>>) {
    let latched = Arc::downgrade(latched);
    monitor.observe(move |snapshot| {
        let Some(latched) = latched.upgrade() else {
            return ControlFlow::Break(());
        };
        if let Some(stop) = wait::trouble(&snapshot.status).filter(Outcome::latches) {
            lock(&latched).get_or_insert(stop);
        }
        ControlFlow::Continue(())
    });
}

/// Stops the arm of a [`Robot`] from another thread, and ends its wait as soon as the controller has taken the stop. Unless a
/// [`MotionEnd`] has told of the stop, the next motion is refused until [`Robot::acknowledge`].
///
/// This is no emergency stop; people are protected by the robot's own safety functions alone.
#[derive(Debug, Clone)]
pub struct RobotStop {
    handle: StopHandle,
    stops: Arc<Stops>,
    waker: Waker<RobotStatus>,
}

impl RobotStop {
    /// Sends `stop_program` (4.23), waits until the controller has taken it, and ends the wait.
    ///
    /// # Errors
    /// As [`StopHandle::stop`]. Unless the call succeeds, expect the robot to move on: its wait goes on by the status, and the
    /// next motion is refused.
    pub fn stop(&self) -> Result<(), Error> {
        // From here on no motion is sent.
        let number = self.stops.begun.fetch_add(1, Ordering::SeqCst) + 1;
        self.handle.stop()?;
        self.stops.taken.fetch_max(number, Ordering::SeqCst);
        self.waker.wake();
        Ok(())
    }
}
