//! Stopping from another thread.

use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_proto::Command;
use jaka_proto::exchange::TextOnly;
use jaka_proto::messages::program::StopProgram;

use crate::Error;
use crate::link::{Link, Outgoing, Right, Sent};

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
}

/// Longest time for which a stop blocks a thread that must not wait.
const AT_ONCE: Duration = Duration::from_millis(1);

impl StopHandle {
    pub(crate) fn new(link: Arc<Link>, timeout: Duration) -> Self {
        Self { link, timeout }
    }

    /// Sends `stop_program` (4.23) and waits until the controller has accepted it.
    ///
    /// # Errors
    /// As [`Client::call`](crate::Client::call); [`Disconnect::ClientDropped`](crate::Disconnect::ClientDropped) is the
    /// cause after the client was dropped. Unless the call succeeds, expect the robot to keep moving.
    pub fn stop(&self) -> Result<(), Error> {
        self.wait(&self.write()?)
    }

    /// Writes the stop.
    pub(crate) fn write(&self) -> Result<WrittenStop, Error> {
        self.write_within(self.timeout)
    }

    /// Writes the stop if that is possible at once; `None` otherwise. Blocks the thread for a moment at most.
    pub(crate) fn write_now(&self) -> Option<WrittenStop> {
        // Outstanding requests may fill the system's buffer: the write would wait, or end midway.
        if self.link.is_idle() { self.write_within(AT_ONCE).ok() } else { None }
    }

    /// Waits until the controller has accepted a stop that was written.
    pub(crate) fn wait(&self, written: &WrittenStop) -> Result<(), Error> {
        self.link.wait(&written.sent, &mut String::new(), &mut TextOnly)
    }

    fn write_within(&self, timeout: Duration) -> Result<WrittenStop, Error> {
        let outgoing = Outgoing::of(&self.link.clock, StopProgram::INFO, timeout).by(Right::Stop);
        let sent = self.link.send(&outgoing, &mut |out: &mut _| StopProgram::new().write_request(out))?;
        Ok(WrittenStop { sent: sent.within(self.timeout), at: self.link.clock.now() })
    }
}
