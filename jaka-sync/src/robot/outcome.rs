//! How motions end.

use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use crate::{Disconnect, Snapshot};

/// How a motion ended, or why it is not known to have ended.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Outcome {
    /// The arm is in position; where the request tells its target, it is there.
    Reached,
    /// The motion ended before its target: it was stopped, by this program or another client.
    Stopped,
    /// The robot is in a protective stop. It moves again after `clear_error`.
    ProtectiveStop,
    /// The emergency stop is pressed.
    EmergencyStop,
    /// The arm is no longer powered and enabled.
    Disabled,
    /// The controller reports an error.
    ControllerError {
        /// The code, such as `0x10f0005`.
        code: String,
        /// The controller's message.
        message: String,
    },
    /// The time is over, and the arm may still move. Leave it, wait on, or stop it.
    Deadline,
    /// Status packets no longer come; the arm may still move.
    StatusLost {
        /// What ended the connection; `None` if it is open, and silent.
        cause: Option<Arc<Disconnect>>,
    },
}

impl Outcome {
    /// True if the arm is where it was sent.
    pub fn is_reached(&self) -> bool {
        matches!(self, Self::Reached)
    }

    /// True if the robot must not move again before somebody has looked at it.
    pub(super) fn latches(&self) -> bool {
        matches!(self, Self::ProtectiveStop | Self::EmergencyStop | Self::StatusLost { .. })
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reached => f.write_str("the motion has reached its target"),
            Self::Stopped => f.write_str("the motion was stopped before its target"),
            Self::ProtectiveStop => f.write_str("the robot is in a protective stop; `clear_error` leaves it"),
            Self::EmergencyStop => f.write_str("the emergency stop is pressed"),
            Self::Disabled => f.write_str("the arm is no longer powered and enabled"),
            Self::ControllerError { code, message } => write!(f, "the controller reports error {code}: {message}"),
            Self::Deadline => f.write_str("the motion has not ended in time; the arm may still move"),
            Self::StatusLost { cause: None } => f.write_str("status packets stopped coming; the arm may still move"),
            Self::StatusLost { cause: Some(cause) } => {
                write!(f, "the status connection ended; the arm may still move: {cause}")
            }
        }
    }
}

/// The end of a motion, with what led to it.
#[derive(Debug, Clone)]
#[non_exhaustive]
#[must_use = "a motion may have ended otherwise than at its target"]
pub struct MotionEnd {
    /// How it ended.
    pub outcome: Outcome,
    /// For how long it was waited.
    pub waited: Duration,
    /// The last packets, up to ten, the newest last.
    pub packets: Vec<Arc<Snapshot>>,
}

impl MotionEnd {
    /// Nothing if the arm is where it was sent, and this as an error otherwise.
    ///
    /// # Errors
    /// The motion ended otherwise.
    pub fn reached(self) -> Result<(), NotReached> {
        if self.outcome.is_reached() { Ok(()) } else { Err(NotReached(Box::new(self))) }
    }
}

/// A motion that did not end at its target, as an error.
#[derive(Debug)]
pub struct NotReached(Box<MotionEnd>);

impl NotReached {
    /// How the motion ended, with what led to it.
    pub fn end(&self) -> &MotionEnd {
        &self.0
    }
}

impl fmt::Display for NotReached {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.outcome.fmt(f)
    }
}

impl std::error::Error for NotReached {}
