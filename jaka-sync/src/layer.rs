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

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use jaka_clock::Clock;
pub use jaka_proto::exchange::Owner;
use jaka_proto::wire::DecodeError;
use jaka_proto::{Command, CommandInfo};

#[cfg(doc)]
use crate::Config;
pub use crate::connection::names_a_port;
pub use crate::disconnect::is_text_line;
pub use crate::error::show_exchanges;
pub use crate::link::{
    Answers, AttachedRobot, Gate, Handle, Kept, Leading, Link, SendError, Sent, StopKind, Stops, UnderWay, Written,
    unexpected,
};
pub use crate::monitor::{StatusNews, describe};
pub use crate::motion_status::{needed, told};
pub use crate::stop::WrittenStop;
pub use crate::sync::Watched;
use crate::{Client, Disconnect, Error, ErrorKind, Monitor, StatusProblem, StopHandle};

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

/// Loss of the status behind a [`StatusProblem`], as a closed choice: each problem belongs to one of these.
#[derive(Debug, Clone, Copy)]
pub enum StatusLoss<'p> {
    /// No packet comes, or none that counts.
    Silence,
    /// Packets come that cannot be read.
    Unreadable(&'p DecodeError),
    /// The status connection has ended for good.
    Ended(&'p Arc<Disconnect>),
}

impl<'p> StatusLoss<'p> {
    /// Loss behind a problem.
    pub fn of(problem: &'p StatusProblem) -> Self {
        match problem {
            StatusProblem::Ended { cause } => Self::Ended(cause),
            StatusProblem::Unreadable { source } => Self::Unreadable(source),
            StatusProblem::Missing { .. }
            | StatusProblem::Stale { .. }
            | StatusProblem::Resuming
            | StatusProblem::Reconnecting => Self::Silence,
        }
    }
}

/// Parts of a [`Client`].
pub trait ClientParts: Sized {
    /// Connection of the client.
    fn link(&self) -> &Arc<Link>;

    /// Handle of the connection, by which the client sends.
    fn handle(&self) -> Handle;

    /// Another client of the same connection, for a thread that this one outlives.
    #[must_use]
    fn lent(&self) -> Self;

    /// Timeout for the reply to a command.
    fn timeout_of(&self, info: &CommandInfo) -> Duration;

    /// Sends a command unless the gate keeps it back, and waits for its reply.
    ///
    /// # Errors
    /// The reason of the gate, or as [`Client::call`].
    fn call_through<C: Command, R>(
        &mut self,
        gate: Gate<'_, R>,
        command: &C,
        timeout: Duration,
    ) -> Result<C::Reply, SendError<R>>;

    /// Sends a request of any type unless the gate keeps it back, and returns once it is accepted. Fields of the reply
    /// are not read.
    ///
    /// # Errors
    /// The reason of the gate, or as [`Client::call`].
    fn call_written<R>(
        &mut self,
        gate: Gate<'_, R>,
        request: (&'static CommandInfo, &dyn Written),
        timeout: Duration,
    ) -> Result<(), SendError<R>>;

    /// Sends commands without waiting for their replies, which are counted for their owner, and returns the number of
    /// its outstanding ones.
    ///
    /// # Errors
    /// The reason of the gate, or as [`Client::call`].
    fn post<C: Command, R>(&self, owner: Owner, gate: Gate<'_, R>, commands: &[C]) -> Result<usize, SendError<R>>;
}

impl ClientParts for Client {
    fn link(&self) -> &Arc<Link> {
        &self.link
    }

    fn handle(&self) -> Handle {
        self.handle
    }

    fn lent(&self) -> Self {
        Client::lent(self)
    }

    fn timeout_of(&self, info: &CommandInfo) -> Duration {
        Client::timeout_of(self, info)
    }

    fn call_through<C: Command, R>(
        &mut self,
        gate: Gate<'_, R>,
        command: &C,
        timeout: Duration,
    ) -> Result<C::Reply, SendError<R>> {
        Client::call_through(self, gate, command, timeout)
    }

    fn call_written<R>(
        &mut self,
        gate: Gate<'_, R>,
        request: (&'static CommandInfo, &dyn Written),
        timeout: Duration,
    ) -> Result<(), SendError<R>> {
        Client::call_written(self, gate, request, timeout)
    }

    fn post<C: Command, R>(&self, owner: Owner, gate: Gate<'_, R>, commands: &[C]) -> Result<usize, SendError<R>> {
        Client::post(self, owner, gate, commands)
    }
}

/// Parts of a [`Monitor`].
pub trait MonitorParts<S> {
    /// Clock of the monitor.
    fn clock(&self) -> &Clock;

    /// Age from which a packet is stale: [`Config::stale_after`].
    fn stale_after(&self) -> Duration;

    /// Address of the connection, with the port.
    fn address(&self) -> String;

    /// Passes the news of the port to `listener` from now on, on the monitor's thread, before the program's observers.
    fn listen(&self, listener: impl FnMut(StatusNews<'_, S>) -> ControlFlow<()> + Send + 'static);

    /// Passes the current state to `tell`, in this thread: the newest packet, and then the news that followed it.
    fn tell_known(&self, tell: impl FnMut(StatusNews<'_, S>));
}

impl<S: Send + Sync + 'static> MonitorParts<S> for Monitor<S> {
    fn clock(&self) -> &Clock {
        &self.clock
    }

    fn stale_after(&self) -> Duration {
        self.stale_after
    }

    fn address(&self) -> String {
        Monitor::address(self)
    }

    fn listen(&self, listener: impl FnMut(StatusNews<'_, S>) -> ControlFlow<()> + Send + 'static) {
        Monitor::listen(self, listener);
    }

    fn tell_known(&self, tell: impl FnMut(StatusNews<'_, S>)) {
        Monitor::tell_known(self, tell);
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
        StopHandle::write(self, kind)
    }

    fn write_now(&self) -> Option<WrittenStop> {
        StopHandle::write_now(self)
    }

    fn wait(&self, written: WrittenStop) -> Result<(), Error> {
        StopHandle::wait(self, written)
    }
}

/// Phrase about a possible reason for the end of a command connection, for the text of an error.
pub fn seat_hint(cause: &Disconnect) -> &'static str {
    cause.seat_hint()
}
