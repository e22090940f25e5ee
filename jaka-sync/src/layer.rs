//! Parts of this crate for a layer above it, such as one that waits for motions. **Not covered by semantic
//! versioning.**
//!
//! A layer sends through a [`Gate`], which keeps commands back at the last moment. It posts commands whose replies
//! nobody waits for individually, polls for the reply to a question, listens to the news of a [`Monitor`], and attaches
//! the last messages of a connection to its own errors. The traits give access to these parts of the types of this
//! crate.
//!
//! A thread that holds a lock of its layer must not use a connection, unless the lock is taken before that of the
//! connection (`Link`). A gate runs under the lock of the connection.

pub use jaka_proto::exchange::Owner;

#[cfg(doc)]
use crate::Monitor;
pub use crate::client::ClientParts;
pub use crate::connection::names_a_port;
pub use crate::disconnect::is_text_line;
pub use crate::error::show_exchanges;
pub use crate::link::{
    Answers, AttachedRobot, Gate, Handle, Kept, Leading, Link, SendError, Sent, StopKind, Stops, UnderWay, Written,
    unexpected,
};
pub use crate::monitor::{MonitorParts, StatusNews, describe};
pub use crate::motion_status::{needed, told};
pub use crate::on_drop::OnDrop;
pub use crate::stop::{StopParts, WrittenStop};
pub use crate::sync::Watched;
use crate::{Disconnect, Error, ErrorKind};

/// Failure behind an [`Error`], as a closed choice: each kind of error belongs to one of these.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Failure {
    /// The request is wrong, the firmware does not have it, or it was kept back. Nothing was sent.
    NotSent,
    /// No connection could be made.
    NotConnected,
    /// The controller refused.
    Refused,
    /// A reply does not fit the spec.
    UnfitReply,
    /// No reply came in time, or the command could not be sent in time.
    Unanswered,
    /// This side reset the connection, because set-points had no reply.
    Reset,
    /// The command connection is broken.
    CommandsLost,
    /// The status connection is broken, or no packets come that can be read.
    StatusLost,
    /// Packets came, but none shows the expected state.
    NotInState,
}

impl Failure {
    /// Failure behind an error.
    pub fn of(error: &Error) -> Self {
        match error.kind() {
            ErrorKind::InvalidArgument(_) | ErrorKind::NotInFirmware(_) | ErrorKind::KeptBack { .. } => Self::NotSent,
            ErrorKind::Connect { .. } => Self::NotConnected,
            ErrorKind::Refused { .. } => Self::Refused,
            ErrorKind::Timeout { .. } | ErrorKind::NotSentInTime { .. } | ErrorKind::ReplyLost { .. } => {
                Self::Unanswered
            }
            ErrorKind::UnexpectedReply { .. } => Self::UnfitReply,
            ErrorKind::Disconnected { cause, .. } if matches!(**cause, Disconnect::Reset { .. }) => Self::Reset,
            ErrorKind::Disconnected { command: Some(_), .. } => Self::CommandsLost,
            ErrorKind::Disconnected { command: None, .. }
            | ErrorKind::StatusUnknown { .. }
            | ErrorKind::StatusTimeout { .. }
            | ErrorKind::UnexpectedStatus { .. } => Self::StatusLost,
            ErrorKind::StateTimeout { .. } => Self::NotInState,
        }
    }
}

/// Phrase about a possible reason for the end of a command connection, for the text of an error.
pub fn seat_hint(cause: &Disconnect) -> &'static str {
    cause.seat_hint()
}
