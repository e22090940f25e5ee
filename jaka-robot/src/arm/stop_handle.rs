//! Handles that stop the arm from other threads.

use std::time::Instant;

use jaka_sync::layer::{StopKind, StopParts as _, WrittenStop};

use crate::{Error, StopHandle};

/// A stop that was sent, or was to be.
#[derive(Debug)]
pub(crate) struct Sent {
    pub(crate) written: Option<Instant>,
    pub(crate) accepted: Result<(), Error>,
}

/// Stops the arm of a [`Robot`](crate::Robot) from another thread, and ends its wait as soon as the controller has
/// accepted the stop.
///
/// From the call on, no motion, no entry into servo mode and no set-point goes out through any handle of the
/// connection, until [`Robot::acknowledge`](crate::Robot::acknowledge) and until the arm was seen at rest. The report
/// of the stop by an [`End`](crate::End) or an error is no acknowledgement. Raw requests of a client are not kept back.
/// Every [`StopHandle`] of the connection and every `stop_program` that one of its clients sends stops likewise.
///
/// It works as long as its robot lives: dropping the robot closes the connection on which stops go out, and `stop` then
/// fails.
///
/// This is not an emergency stop: only the robot's own safety functions protect people.
#[derive(Debug, Clone)]
#[must_use = "a stop handle stops nothing until `stop` is called"]
pub struct RobotStop {
    handle: StopHandle,
}

impl RobotStop {
    pub(super) fn new(handle: StopHandle) -> Self {
        Self { handle }
    }

    /// Sends `stop_program` (4.23), waits until the controller has accepted it, and ends the wait.
    ///
    /// A [`ServoSession`](crate::ServoSession), a stream or a trajectory that moves the arm brakes it first, with its
    /// next set-points: no source says that `stop_program` alone ends servo motion. The stop waits for that for 3 s at
    /// most, and for six periods at most after the last set-point. From the session's own thread it goes out at once.
    /// From an observer of the monitor no packet is seen meanwhile.
    ///
    /// # Errors
    /// As [`StopHandle::stop`]. If the call fails, the robot may keep moving: its wait continues, and the next motion
    /// is refused.
    pub fn stop(&self) -> Result<(), Error> {
        Ok(self.handle.stop()?)
    }

    /// Sends `stop_program` at once: no set-point brakes the arm before, and none goes out after it.
    ///
    /// For a program that knows that the controller itself brakes an arm in servo mode; no source says so.
    ///
    /// # Errors
    /// As [`stop`](Self::stop).
    pub fn stop_now(&self) -> Result<(), Error> {
        Ok(self.handle.stop_now()?)
    }

    /// Ends a motion: the next one waits for rest, and nothing has to be acknowledged.
    pub(crate) fn end_motion(&self) -> Sent {
        match self.handle.write(StopKind::OfMotion) {
            Ok(stop) => self.finish(stop),
            Err(error) => Sent { written: None, accepted: Err(error.into()) },
        }
    }

    /// Writes a stop that ends a motion if that can be done at once; none otherwise.
    pub(crate) fn write_now(&self) -> Option<WrittenStop> {
        self.handle.write_now()
    }

    /// Waits for the reply to a stop that was written.
    pub(crate) fn finish(&self, stop: WrittenStop) -> Sent {
        Sent { written: Some(stop.at), accepted: self.handle.wait(stop).map_err(Error::from) }
    }
}
