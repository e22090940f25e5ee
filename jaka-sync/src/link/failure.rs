//! The errors of calls.

use std::sync::Arc;
use std::time::Duration;

use jaka_proto::exchange::Failure;
use jaka_proto::wire::DecodeError;

use super::Link;
use crate::{Disconnect, Error, ErrorKind};

/// Whether a command was on the wire when its connection was broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Progress {
    Sent,
    NotSent,
}

/// The error for a command that failed on a connection that can be used on.
pub(super) fn failed(command: &str, failure: Failure) -> Error {
    let name = command.to_owned();
    match failure {
        Failure::Refused(mut refusal) => {
            refusal.command = name;
            ErrorKind::Refused { refusal }.into()
        }
        Failure::Unexpected(source) => unexpected(command, source),
        Failure::TimedOut { after } => timed_out(command, after),
        Failure::Lost => ErrorKind::ReplyLost { command: name }.into(),
    }
}

/// The error for a reply that does not fit the spec.
pub fn unexpected(command: &str, source: DecodeError) -> Error {
    ErrorKind::UnexpectedReply { command: command.to_owned(), source }.into()
}

/// The error for a command whose reply has not come in time.
pub(super) fn timed_out(command: &str, after: Duration) -> Error {
    ErrorKind::Timeout { command: command.to_owned(), after }.into()
}

/// The error for a command that could not be sent in time.
pub(super) fn not_sent_in_time(command: &str, after: Duration) -> Error {
    ErrorKind::NotSentInTime { command: command.to_owned(), after }.into()
}

impl Link {
    /// The error for a command whose connection is broken.
    pub(super) fn disconnected(&self, command: &str, progress: Progress, cause: Arc<Disconnect>) -> Error {
        let (command, sent) = (Some(command.to_owned()), progress == Progress::Sent);
        ErrorKind::Disconnected { address: self.address(), command, sent, cause }.into()
    }
}
