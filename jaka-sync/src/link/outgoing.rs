//! Outgoing commands and their deadlines.

use std::borrow::Cow;
use std::convert::Infallible;
use std::time::Duration;

use jaka_clock::{Clock, Stopwatch};
use jaka_proto::check::{NotSent, Rules};
use jaka_proto::exchange::{Owner, Support};
use jaka_proto::wire::Writer;
use jaka_proto::{Command, CommandInfo, Effect, FirmwareVersion, Role};

use super::not_sent_in_time;
use crate::{Error, ErrorKind};

/// Priority among threads that wait for their turn to send.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Right {
    Usual,
    /// A stop, which precedes all others.
    Stop,
}

/// Handle of a connection: its first client, or one of [`Client::try_clone`](crate::Client::try_clone).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Handle(pub(super) u64);

impl Handle {
    /// Handle of the first client.
    pub(crate) const FIRST: Self = Self(0);

    /// Owner of the requests whose replies the handle waits for. Handles and other owners share one number space.
    pub(super) fn owner(self) -> Owner {
        Owner(self.0)
    }
}

/// Reservation of a connection by one handle: decides which commands of other handles may be sent.
#[derive(Debug, Clone, Copy)]
pub struct Reservation {
    /// Reason for the error of a command that is kept back.
    pub because: &'static str,
    /// Decides whether a command passes; `None` for a command that neither the spec nor its caller knows.
    pub lets_pass: fn(Option<&CommandInfo>) -> bool,
}

/// Check by the sending thread, immediately before it sends a command: an error, the reason, keeps the command back.
/// Another thread's command is sent either before the check or after this command.
///
/// The check runs under the lock of the connection: it must not use the connection.
pub type Gate<'g, R> = Option<&'g dyn Fn() -> Result<(), R>>;

/// Gate that keeps no command back.
pub(crate) const OPEN: Gate<'static, Infallible> = None;

/// Error of a command that was not sent, or failed.
#[derive(Debug)]
pub enum SendError<R> {
    /// The gate has kept the command back, for this reason. Nothing was sent.
    KeptBack(R),
    /// The call has failed.
    Failed(Error),
}

impl<R> From<Error> for SendError<R> {
    fn from(error: Error) -> Self {
        Self::Failed(error)
    }
}

impl From<SendError<Infallible>> for Error {
    fn from(error: SendError<Infallible>) -> Self {
        match error {
            SendError::KeptBack(never) => match never {},
            SendError::Failed(error) => error,
        }
    }
}

/// Request of any type that can be sent.
pub trait Written {
    /// Checks it against the spec, as [`Command::check`].
    ///
    /// # Errors
    /// As [`Command::check`].
    fn check(&self, rules: Rules) -> Result<(), NotSent>;

    /// Writes it in its wire form.
    fn write(&self, out: &mut Writer);
}

impl<C: Command> Written for C {
    fn check(&self, rules: Rules) -> Result<(), NotSent> {
        Command::check(self, rules)
    }

    fn write(&self, out: &mut Writer) {
        self.write_request(out);
    }
}

/// Outgoing commands of one name, and their deadline.
pub(crate) struct Outgoing<'o> {
    /// The command as its caller names it.
    pub(super) command: &'o str,
    /// Name of the command in its replies.
    pub(super) name: Cow<'static, str>,
    /// Start of the timeout, which includes the wait for the turn and the sending.
    pub(super) since: Stopwatch,
    pub(super) timeout: Duration,
    pub(super) right: Right,
    /// Whether the outcomes are counted, and no thread waits for one in particular.
    pub(super) is_posted: bool,
    pub(super) by: Handle,
    /// Owner of the outcomes.
    pub(super) owner: Owner,
    /// Facts of the command; `None` for one that neither the spec nor its caller knows.
    pub(super) info: Option<&'static CommandInfo>,
    /// Firmware in whose forms it is written, and its reply is read.
    pub(super) firmware: Option<FirmwareVersion>,
}

impl<'o> Outgoing<'o> {
    /// Command of the spec, whose time begins now.
    pub(crate) fn of(clock: &Clock, info: &'static CommandInfo, timeout: Duration) -> Self {
        Self { info: Some(info), ..Self::unknown(clock, info.name, Cow::Borrowed(info.name), timeout) }
    }

    /// Any command, whose time begins now. `name` is its name in the reply and in the spec.
    pub(crate) fn named(clock: &Clock, command: &'o str, name: Cow<'static, str>, timeout: Duration) -> Self {
        Self { info: CommandInfo::of(&name), ..Self::unknown(clock, command, name, timeout) }
    }

    fn unknown(clock: &Clock, command: &'o str, name: Cow<'static, str>, timeout: Duration) -> Self {
        Self {
            command,
            name,
            since: clock.stopwatch(),
            timeout,
            right: Right::Usual,
            is_posted: false,
            by: Handle::FIRST,
            owner: Handle::FIRST.owner(),
            info: None,
            firmware: None,
        }
    }

    /// Sets the firmware in whose forms the command is written.
    pub(crate) fn in_forms_of(self, firmware: Option<FirmwareVersion>) -> Self {
        Self { firmware, ..self }
    }

    /// Fails if the form depends on the firmware and the firmware is unknown.
    pub(super) fn check_firmware(&self) -> Result<(), Error> {
        match self.info {
            Some(info) if info.needs_firmware && self.firmware.is_none() => {
                Err(ErrorKind::FirmwareUnknown { command: info.name }.into())
            }
            _ => Ok(()),
        }
    }

    /// Sets the handle that sends the command.
    pub(crate) fn of_handle(self, by: Handle) -> Self {
        Self { by, owner: by.owner(), ..self }
    }

    /// Makes the outcomes counted ones of this owner.
    pub(crate) fn posted_for(self, owner: Owner) -> Self {
        Self { owner, is_posted: true, ..self }
    }

    /// Sets the priority of the command.
    pub(crate) fn by(self, right: Right) -> Self {
        Self { right, ..self }
    }

    /// True for a stop of any handle.
    pub(super) fn is_stop(&self) -> bool {
        self.right == Right::Stop || self.info.is_some_and(|info| info.role == Some(Role::Stop))
    }

    /// Support of the command by controllers.
    pub(super) fn support(&self) -> Support {
        if self.is_stop() { Support::Everywhere } else { Support::of(self.info) }
    }

    /// True if the command changes nothing. An unknown command may change anything.
    pub(super) fn is_query(&self) -> bool {
        self.info.is_some_and(|info| info.effect == Effect::Query)
    }

    /// True if the meaning of poses may change with the command.
    pub(super) fn changes_frames(&self) -> bool {
        self.info.is_none_or(|info| info.changes.iter().any(|change| change.concerns_poses()))
    }

    pub(super) fn left(&self) -> Duration {
        self.since.left_of(self.timeout)
    }

    pub(super) fn not_sent(&self) -> Error {
        not_sent_in_time(self.command, self.timeout)
    }
}
