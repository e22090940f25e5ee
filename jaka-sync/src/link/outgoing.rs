//! What goes out, and until when.

use std::borrow::Cow;
use std::time::Duration;

use jaka_proto::CommandInfo;

use super::failure::not_sent_in_time;
use crate::Error;
use crate::clock::{Clock, Stopwatch};

/// Who goes first where several wait for their turn to send.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Right {
    Usual,
    /// A stop passes all others.
    Stop,
}

/// Asked by the thread whose turn it is to send, as the last thing before a command goes out: an error keeps it back. What another
/// thread sends meanwhile goes out after it, or has gone out before.
///
/// It must not use the connection.
pub(crate) type Gate<'g> = Option<&'g dyn Fn() -> Result<(), Error>>;

/// What goes out: commands of one name, and until when.
pub(crate) struct Outgoing<'o> {
    /// The command as its caller names it.
    pub(super) command: &'o str,
    /// The name that replies to it have.
    pub(super) name: Cow<'static, str>,
    /// When its time began: the wait for the turn, and the sending, count towards it.
    pub(super) since: Stopwatch,
    pub(super) timeout: Duration,
    pub(super) right: Right,
    pub(super) gate: Gate<'o>,
    /// Whether the outcomes are counted, with no thread waiting for one in particular.
    pub(super) is_posted: bool,
}

impl<'o> Outgoing<'o> {
    /// A command of the spec, whose time begins now.
    pub(crate) fn of(clock: &Clock, info: &'static CommandInfo, timeout: Duration) -> Self {
        Self::named(clock, info.name, Cow::Borrowed(info.name), timeout)
    }

    /// Any command, whose time begins now; `name` is the name that its reply has.
    pub(crate) fn named(clock: &Clock, command: &'o str, name: Cow<'static, str>, timeout: Duration) -> Self {
        Self { command, name, since: clock.stopwatch(), timeout, right: Right::Usual, gate: None, is_posted: false }
    }

    /// The same by another right of way.
    pub(crate) fn by(self, right: Right) -> Self {
        Self { right, ..self }
    }

    /// The same unless this gate is shut.
    pub(crate) fn through(self, gate: Gate<'o>) -> Self {
        Self { gate, ..self }
    }

    pub(super) fn left(&self) -> Duration {
        self.since.left_of(self.timeout)
    }

    pub(super) fn not_sent(&self) -> Error {
        not_sent_in_time(self.command, self.timeout)
    }
}
