//! Outgoing commands and their deadlines.

use std::borrow::Cow;
use std::convert::Infallible;
use std::time::Duration;

use jaka_clock::{Clock, Stopwatch};
use jaka_proto::check::{NotSent, Rules};
use jaka_proto::exchange::{Owner, Support};
use jaka_proto::wire::Writer;
use jaka_proto::{Command, CommandInfo, Effect, Role};

use super::not_sent_in_time;
use crate::Error;

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
    /// Role of the request for the arm; `None` if it has none, or is not known.
    pub(super) role: Option<Role>,
    /// True if only its caller knows the request: its role is that of its command.
    pub(super) is_raw: bool,
    /// Number of the stop, if it is one that has begun.
    pub(super) stop: Option<u64>,
    /// Whether the outcomes are counted, and no thread waits for one in particular.
    pub(super) is_posted: bool,
    pub(super) by: Handle,
    /// Owner of the outcomes.
    pub(super) owner: Owner,
    /// Facts of the command; `None` for one that neither the spec nor its caller knows.
    pub(super) info: Option<&'static CommandInfo>,
}

impl<'o> Outgoing<'o> {
    /// Command of the spec, whose time begins now.
    pub(crate) fn of(clock: &Clock, info: &'static CommandInfo, timeout: Duration) -> Self {
        let unknown = Self::unknown(clock, info.name, Cow::Borrowed(info.name), timeout);
        Self { info: Some(info), role: info.role, is_raw: false, ..unknown }
    }

    /// Any command, whose time begins now. `name` is its name in the reply and in the spec.
    pub(crate) fn named(clock: &Clock, command: &'o str, name: Cow<'static, str>, timeout: Duration) -> Self {
        let info = CommandInfo::of(&name);
        Self { info, role: info.and_then(|info| info.role), ..Self::unknown(clock, command, name, timeout) }
    }

    fn unknown(clock: &Clock, command: &'o str, name: Cow<'static, str>, timeout: Duration) -> Self {
        Self {
            command,
            name,
            since: clock.stopwatch(),
            timeout,
            role: None,
            is_raw: true,
            stop: None,
            is_posted: false,
            by: Handle::FIRST,
            owner: Handle::FIRST.owner(),
            info: None,
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

    /// Sets the role of the request, which may differ from that of its command.
    pub(crate) fn in_role(self, role: Option<Role>) -> Self {
        Self { role, ..self }
    }

    /// Sets the number of the stop that the command sends, and the start of its timeout.
    pub(crate) fn of_stop(self, number: u64, since: Stopwatch) -> Self {
        Self { stop: Some(number), since, ..self }
    }

    /// True for a stop, which is sent before all other commands that wait.
    pub(super) fn is_stop(&self) -> bool {
        self.role == Some(Role::Stop)
    }

    /// Support of the command by controllers.
    pub(super) fn support(&self) -> Support {
        Support::of(self.role)
    }

    /// True if the command changes nothing. An unknown command may change anything.
    pub(super) fn is_query(&self) -> bool {
        self.info.is_some_and(|info| info.effect == Effect::Query)
    }

    /// True unless the command is known to move nothing. An unknown command may move the arm.
    pub(super) fn may_move(&self) -> bool {
        self.role.map_or(self.info.is_none(), Role::moves)
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
