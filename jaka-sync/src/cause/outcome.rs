//! How motions end.

use std::error::Error as StdError;
use std::sync::Arc;

use jaka_proto::ControllerEvent;
use jaka_proto::wire::DecodeError;

use super::table::Cause;
use super::trip::GuardTrip;
use crate::Disconnect;

jaka_proto::worded! {
    /// How a motion ended, or why it is not known to have ended.
    #[derive(Debug, Clone)]
    #[non_exhaustive]
    pub enum Outcome {
        /// The arm is at its target, by the controller's own answer to a query after the motion.
        Reached => "the motion has reached its target",
        /// The arm is at rest, and it is not known whether it is at its target: the request does not determine it (a
        /// relative motion in a queue or with a rotation), a frame changed meanwhile, the motion may blend into the
        /// next one within its tolerance, or the position query failed
        /// ([`MotionEnd::not_answered`](crate::MotionEnd::not_answered)): then only packets show that the arm is at
        /// rest, and these may be old.
        AtRest => "the arm is at rest, but it is not known whether it is at its target",
        /// There is nothing to wait for: this robot has no motion that was accepted and not waited for. Motions that were sent
        /// through [`Robot::client`](crate::Robot::client) are not waited for.
        NoMotion => "there was nothing to wait for: no motion of this robot was accepted",
        /// The motion ended before its target: this program or another client stopped it. The arm may still be braking.
        Stopped => "the motion was stopped before its target",
        /// The robot is in a protective stop. It moves again after `clear_error`.
        ProtectiveStop => "the robot is in a protective stop",
        /// The emergency stop is pressed.
        EmergencyStop => "the emergency stop is pressed",
        /// The arm has no power any more.
        NotPowered => "the arm has no power",
        /// The arm is not enabled any more: another client has disabled it, or the controller.
        NotEnabled => "the arm is not enabled",
        /// The controller reports an error that it did not report before the motion; or, if the arm is at rest but not at its target, a
        /// code that no table has. Warnings and information do not end a motion. The arm may still move: other fields of the status show
        /// whether it is stopped.
        ControllerError {
            /// The code as the controller writes it, such as `0x0F0034`.
            code: String,
            /// The event with its severity and, if it is known, its meaning; none for a code that cannot be read.
            event: Option<ControllerEvent>,
            /// The controller's message.
            message: String,
        } => (reported(code, *event, message)),
        /// The motion has not ended within the timeout, and the arm may still move. Leave it, wait again, or stop it.
        Deadline => "the motion has not ended in time",
        /// The guard of [`Robot::run_until`](crate::Robot::run_until) has tripped: the arm was stopped, or nothing was sent.
        Guard(trip: Arc<GuardTrip>) => "the guard tripped: {trip}",
        /// The command connection was lost: another client may have taken it over, or the controller has shut down. The motion may go on, and
        /// cannot be stopped over this connection: use the emergency stop, or connect again and stop it. Nothing reconnects on its own.
        ConnectionLost {
            /// Where the connection led, with the port.
            address: String,
            /// What ended the connection.
            cause: Arc<Disconnect>,
        } => (connection_lost(address, cause)),
        /// Status packets that can be read no longer come; the arm may still move.
        StatusLost {
            /// What ended the connection; `None` if it is open.
            cause: Option<Arc<Disconnect>>,
            /// What cannot be read of the packets that come; `None` if none come.
            unreadable: Option<DecodeError>,
        } => (status_lost(cause.as_deref(), unreadable.as_ref())),
    }
}

// Each text begins with the fact of the cause.

fn reported(code: &str, event: Option<ControllerEvent>, message: &str) -> String {
    let fact = Cause::ControllerError;
    match event {
        Some(event) => format!("{fact}: {event}: {message}"),
        None => format!("{fact}: code {code}: {message}"),
    }
}

fn connection_lost(address: &str, cause: &Disconnect) -> String {
    let (fact, hint) = (Cause::CommandsLost, cause.seat_hint());
    format!("{fact} ({address}{hint}): {cause}")
}

fn status_lost(cause: Option<&Disconnect>, unreadable: Option<&DecodeError>) -> String {
    let fact = Cause::StatusLost;
    match (cause, unreadable) {
        (None, None) => fact.to_string(),
        (None, Some(source)) => format!("{fact}: {source}"),
        (Some(cause), _) => format!("{fact}: the status connection ended: {cause}"),
    }
}

impl Outcome {
    /// Cause of the end.
    pub fn cause(&self) -> Cause {
        match self {
            Self::Reached => Cause::Reached,
            Self::AtRest => Cause::AtRest,
            Self::NoMotion => Cause::NoMotion,
            Self::Stopped => Cause::Stopped,
            Self::ProtectiveStop => Cause::ProtectiveStop,
            Self::EmergencyStop => Cause::EmergencyStop,
            Self::NotPowered => Cause::NotPowered,
            Self::NotEnabled => Cause::NotEnabled,
            Self::ControllerError { .. } => Cause::ControllerError,
            Self::Deadline => Cause::Deadline,
            Self::Guard(trip) => trip.cause(),
            Self::ConnectionLost { .. } => Cause::CommandsLost,
            Self::StatusLost { .. } => Cause::StatusLost,
        }
    }

    /// True if the arm is where it was sent.
    pub fn is_reached(&self) -> bool {
        matches!(self, Self::Reached)
    }

    /// True if the arm is at rest, and nothing shows that it is not where it was sent.
    pub fn is_at_rest(&self) -> bool {
        matches!(self, Self::Reached | Self::AtRest)
    }

    /// What is below the error whose text is part of this one's.
    pub(crate) fn source(&self) -> Option<&(dyn StdError + 'static)> {
        match self {
            Self::ConnectionLost { cause, .. } | Self::StatusLost { cause: Some(cause), .. } => cause.source(),
            _ => None,
        }
    }

    /// What becomes of the motions and of later ones. Each value is named, so that a new one does not compile before it
    /// is decided.
    pub(crate) fn consequence(&self) -> Consequence {
        match self {
            Self::Reached | Self::AtRest | Self::NoMotion | Self::Stopped | Self::NotPowered | Self::NotEnabled => {
                Consequence::Over
            }
            Self::Guard(_) => Consequence::Over,
            Self::ProtectiveStop | Self::EmergencyStop => Consequence::Latched,
            Self::StatusLost { .. } => Consequence::LatchedMayMove,
            Self::ControllerError { .. } => Consequence::MayMove,
            Self::Deadline | Self::ConnectionLost { .. } => Consequence::GoesOn,
        }
    }
}

/// What becomes of the motions after an end of the wait for them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Consequence {
    /// They have ended.
    Over,
    /// They have ended, and no other is sent before somebody has acknowledged that.
    Latched,
    /// The same, and the arm may still move.
    LatchedMayMove,
    /// They are not waited for any more, and the arm may still move.
    MayMove,
    /// They may go on, and can be waited for again.
    GoesOn,
}

impl Consequence {
    /// True if no motion is sent before somebody has acknowledged it.
    pub(crate) fn latches(self) -> bool {
        match self {
            Self::Latched | Self::LatchedMayMove => true,
            Self::Over | Self::MayMove | Self::GoesOn => false,
        }
    }

    /// True if the arm may still move.
    pub(crate) fn may_move(self) -> bool {
        match self {
            Self::LatchedMayMove | Self::MayMove | Self::GoesOn => true,
            Self::Over | Self::Latched => false,
        }
    }
}
