//! Stopping from another thread.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_proto::Command;
use jaka_proto::exchange::TextOnly;
use jaka_proto::messages::program::StopProgram;

use crate::Error;
use crate::link::{Link, Outgoing, Sent, StopKind, UnderWay};

/// Stops the running motion or program of a [`Client`](crate::Client) from any thread, even while a call waits.
///
/// The stop is sent on the client's connection, since the command port serves one client. So the handle works while the
/// client lives: dropping the client closes the connection, and [`stop`](Self::stop) then fails. Keep the client as
/// long as the arm may move.
///
/// A stop is sent before all other commands that wait, also between the writes of a [`Pipeline`](crate::Pipeline). The
/// controller first processes the commands that were sent before it. This is not an emergency stop: only the robot's
/// own safety functions protect people.
///
/// ```no_run
/// # let mut robot = jaka_sync::Client::connect("10.5.5.100")?;
/// let stop = robot.stop_handle();
/// std::thread::spawn(move || {
///     // When a light curtain, a key press or a timer says so:
///     if let Err(error) = stop.stop() {
///         eprintln!("the robot may still move: {error}");
///     }
/// });
/// # Ok::<(), jaka_sync::Error>(())
/// ```
#[derive(Debug, Clone)]
#[must_use = "a stop handle stops nothing until `stop` is called"]
pub struct StopHandle {
    link: Arc<Link>,
    timeout: Duration,
}

/// Stop that was written and whose reply is pending.
#[derive(Debug)]
pub struct WrittenStop {
    sent: Sent<'static>,
    /// Time at which the write had ended.
    pub at: Instant,
    under_way: UnderWay,
}

/// Longest time for which a stop blocks a thread that must not wait.
const AT_ONCE: Duration = Duration::from_millis(1);

impl StopHandle {
    pub(crate) fn new(link: Arc<Link>, timeout: Duration) -> Self {
        Self { link, timeout }
    }

    /// Sends `stop_program` (4.23) and waits until the controller has accepted it.
    ///
    /// While set-points of a robot of this connection (jaka-robot) move the arm, they brake it first, for 3 s at most:
    /// no source says that `stop_program` alone ends servo motion. The stop goes out at once if a set-point is overdue,
    /// and from the thread that sends the set-points, which cannot brake then.
    ///
    /// If the connection has, or has had, a robot, no motion, no entry into servo mode and no set-point goes out from
    /// the call on, through any handle, until the robot acknowledges the stop and was seen at rest. Raw requests
    /// ([`Client::call_raw`](crate::Client::call_raw)) are not kept back. `stop_program` by any other call of a handle,
    /// also a raw one and one in a [`Pipeline`](crate::Pipeline), stops likewise; a raw request of a command that no
    /// spec has is not known to be a stop.
    ///
    /// # Errors
    /// As [`Client::call`](crate::Client::call); [`Disconnect::ClientDropped`](crate::Disconnect::ClientDropped) is the
    /// cause after the client was dropped. Unless the call succeeds, expect the robot to keep moving.
    pub fn stop(&self) -> Result<(), Error> {
        self.wait(self.write(StopKind::Program)?)
    }

    /// Sends `stop_program` as [`stop`](Self::stop) does, but at once: no set-point brakes the arm before, and none
    /// goes out after it.
    ///
    /// # Errors
    /// As [`stop`](Self::stop).
    pub fn stop_now(&self) -> Result<(), Error> {
        self.wait(self.write(StopKind::ProgramNow)?)
    }

    fn written(&self, sent: Sent<'static>, under_way: UnderWay) -> WrittenStop {
        WrittenStop { sent: sent.within(self.timeout), at: self.link.clock.now(), under_way }
    }

    fn write_within(&self, stop: &UnderWay, timeout: Duration) -> Result<Sent<'static>, Error> {
        let clock = &self.link.clock;
        let outgoing = Outgoing::of(clock, StopProgram::INFO, timeout).of_stop(stop.number(), clock.stopwatch());
        self.link.send(&outgoing, &mut |out: &mut _| StopProgram::new().write_request(out))
    }
}

/// Parts of a [`StopHandle`].
pub trait StopParts {
    /// Writes the stop, once a session has braked.
    ///
    /// # Errors
    /// As [`StopHandle::stop`].
    fn write(&self, kind: StopKind) -> Result<WrittenStop, Error>;

    /// Writes a stop that ends a motion if that is possible at once, and no session moves the arm; `None` otherwise.
    /// Blocks the thread for a moment at most.
    fn write_now(&self) -> Option<WrittenStop>;

    /// Waits until the controller has accepted a stop that was written.
    ///
    /// # Errors
    /// As [`StopHandle::stop`].
    fn wait(&self, written: WrittenStop) -> Result<(), Error>;
}

impl StopParts for StopHandle {
    fn write(&self, kind: StopKind) -> Result<WrittenStop, Error> {
        let stop = self.link.begin_stop(kind);
        match self.write_within(&stop, self.timeout) {
            Ok(sent) => Ok(self.written(sent, stop)),
            Err(error) => {
                stop.failed();
                Err(error)
            }
        }
    }

    fn write_now(&self) -> Option<WrittenStop> {
        // Outstanding requests may fill the system's buffer: the write would wait, or end midway.
        if !self.link.is_idle() || self.link.stops.is_led() {
            return None;
        }
        let stop = self.link.begin_stop(StopKind::OfMotion);
        // If a logger panics, another thread does the rest.
        match catch_unwind(AssertUnwindSafe(|| self.write_within(&stop, AT_ONCE))) {
            Ok(Ok(sent)) => Some(self.written(sent, stop)),
            Ok(Err(_)) => {
                stop.take_back();
                None
            }
            // It may have gone out.
            Err(_) => None,
        }
    }

    fn wait(&self, written: WrittenStop) -> Result<(), Error> {
        let WrittenStop { sent, under_way, .. } = written;
        let accepted = self.link.wait(&sent, &mut String::new(), &mut TextOnly);
        accepted.inspect_err(|_| under_way.failed())
    }
}
