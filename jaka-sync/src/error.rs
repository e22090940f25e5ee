//! Errors of connections.

use std::error::Error as StdError;
use std::sync::Arc;
use std::time::Duration;
use std::{fmt, io};

use jaka_proto::check::{InvalidArgument, NotSent};
use jaka_proto::recording::{Entry, Event, Message, Port};
use jaka_proto::text::visible;
use jaka_proto::wire::DecodeError;
use jaka_proto::{NotInFirmware, Refusal};

use crate::{Disconnect, Remedy, StatusProblem};

/// Error of a call: an [`ErrorKind`], and the last messages of the connection if they are recorded.
///
/// Two questions matter after an error: may the command have run ([`may_have_run`](Self::may_have_run)), and can the
/// connection still be used ([`is_disconnected`](Self::is_disconnected)). Nothing is ever sent again automatically.
///
/// ```no_run
/// use jaka_sync::{Client, ErrorKind};
///
/// let mut robot = Client::connect("10.5.5.100")?;
/// if let Err(error) = robot.enable_robot() {
///     match error.kind() {
///         ErrorKind::Refused { refusal } => eprintln!("refused with code {}", refusal.code),
///         ErrorKind::Timeout { .. } => eprintln!("it may have run: {:?}", robot.get_robot_state()?),
///         _ => return Err(error),
///     }
/// }
/// # Ok::<(), jaka_sync::Error>(())
/// ```
///
/// An `Error` is one pointer wide. It can be made of an [`ErrorKind`], for tests of programs that handle errors.
pub struct Error(Box<Inner>);

struct Inner {
    kind: ErrorKind,
    /// Empty if nothing is recorded.
    exchanges: Box<[Entry]>,
}

jaka_proto::worded! {
    /// Kinds of errors, distinguished by the possible reactions of the caller: see [`Error::kind`].
    #[derive(Debug)]
    #[non_exhaustive]
    pub enum ErrorKind {
        /// The spec forbids the request. Nothing was sent; correct the named field.
        InvalidArgument(invalid: InvalidArgument) => "{invalid}",
        /// The controller's firmware does not have the command, or a field that is given. Nothing was sent.
        ///
        /// Only if the firmware is known: see [`Client::check_firmware`](crate::Client::check_firmware).
        NotInFirmware(missing: NotInFirmware) => "{missing}",
        /// No connection could be made. Check the address and the cable, and check that the controller is on.
        ///
        /// A controller may refuse a second client of its command port, which serves one.
        Connect {
            /// Address that was given, with the port.
            address: String,
            /// Expected port.
            port: Port,
            /// Error of the system.
            source: io::Error,
        } => "cannot connect to {address}",
        /// The controller refused the command, which did not run. The connection is fine.
        Refused {
            /// Code and message of the controller.
            refusal: Refusal,
        } => "{refusal}",
        /// The command was kept back: a session, a stream or a trajectory of a robot moves the arm, or the arm was
        /// stopped ([`StopHandle::stop`](crate::StopHandle::stop)). It did not run.
        KeptBack {
            /// `cmdName` of the command.
            command: String,
            /// Reason.
            because: &'static str,
        } => "`{command}` was not sent: {because}",
        /// No reply came in time. The command may have run; read the robot's state before you go on.
        ///
        /// The connection can still be used: the reply is discarded if it comes later.
        Timeout {
            /// `cmdName` of the command.
            command: String,
            /// Time for which the call waited.
            after: Duration,
        } => "no reply to `{command}` within {after:?}; it may have run",
        /// The command could not be sent in time: the controller accepts no more data, other threads were sending, or
        /// it had to wait for replies to other commands ([`Client::try_clone`](crate::Client::try_clone)). It did not
        /// run, and the connection can still be used.
        NotSentInTime {
            /// `cmdName` of the command.
            command: String,
            /// Time for which the call waited.
            after: Duration,
        } => "`{command}` could not be sent within {after:?}; it did not run",
        /// A later command was answered, this one was not. The command may have run; the connection is fine.
        ReplyLost {
            /// `cmdName` of the command.
            command: String,
        } => "`{command}` may have run, but its reply was lost: a later command was answered",
        /// The reply is not a refusal, and does not fit the spec. The command has most likely run; the connection is
        /// fine.
        ///
        /// The raw reply is kept: see [`Client::last_reply`](crate::Client::last_reply).
        UnexpectedReply {
            /// `cmdName` of the command.
            command: String,
            /// Field that does not fit.
            source: DecodeError,
        } => "`{command}` was not refused, but its reply does not fit the spec",
        /// The connection is broken for good, and each later call reports it again. Connect again when the robot's
        /// state is known.
        Disconnected {
            /// Address of the connection, with the port.
            address: String,
            /// `cmdName` of the command of this call; `None` for a status connection.
            command: Option<String>,
            /// True if the command had been sent, at least in part, and may have run.
            sent: bool,
            /// Cause of the break.
            cause: Arc<Disconnect>,
        } => (disconnected(address, command.as_deref(), *sent, cause)),
        /// Status packets came, but none in time that shows the expected state.
        StateTimeout {
            /// Time for which the call waited.
            after: Duration,
            /// Number of packets that came meanwhile.
            packets: u64,
            /// State of the arm by the last packet; `None` for a type of the program.
            says: Option<String>,
        } => (not_in_state(*after, *packets, says.as_deref())),
        /// The state of the robot is unknown: packets have just resumed after a silence, and may be old.
        StatusUnknown {
            /// Reason.
            problem: StatusProblem,
        } => "the state of the robot is unknown: {problem}",
        /// No status packet came in time. The stream can still be used.
        StatusTimeout {
            /// Address from which packets were expected, with the port.
            address: String,
            /// Time for which the call waited.
            after: Duration,
        } => "no status packet from {address} within {after:?}",
        /// A status packet does not fit the spec. The stream can still be used, and the packet's text is kept.
        UnexpectedStatus {
            /// Field that does not fit.
            source: DecodeError,
        } => "a status packet does not fit the spec",
    }
}

impl Error {
    /// Kind of the error.
    pub fn kind(&self) -> &ErrorKind {
        &self.0.kind
    }

    /// Kind of the error, without the last messages.
    pub fn into_kind(self) -> ErrorKind {
        self.0.kind
    }

    /// Remedy that a person can apply; [`Remedy::None`] if nothing is known to help.
    pub fn remedy(&self) -> Remedy {
        match self.kind() {
            ErrorKind::Connect { port: Port::Command, source, .. }
                if source.kind() == io::ErrorKind::ConnectionRefused =>
            {
                Remedy::FreeSeat
            }
            ErrorKind::Connect { .. } => Remedy::CheckAddress,
            ErrorKind::StatusTimeout { .. } => Remedy::CheckStatusPort,
            ErrorKind::StatusUnknown { problem } => problem.remedy(),
            ErrorKind::Disconnected { command: None, cause, .. } if cause.is_by_controller() => Remedy::CheckNetwork,
            // The error's fact is all that is known.
            ErrorKind::InvalidArgument(_)
            | ErrorKind::NotInFirmware(_)
            | ErrorKind::Refused { .. }
            | ErrorKind::KeptBack { .. }
            | ErrorKind::Timeout { .. }
            | ErrorKind::NotSentInTime { .. }
            | ErrorKind::ReplyLost { .. }
            | ErrorKind::UnexpectedReply { .. }
            | ErrorKind::Disconnected { .. }
            | ErrorKind::StateTimeout { .. }
            | ErrorKind::UnexpectedStatus { .. } => Remedy::None,
        }
    }

    /// True if the controller may have carried out the command although the call failed.
    pub fn may_have_run(&self) -> bool {
        match self.kind() {
            ErrorKind::Timeout { .. } | ErrorKind::ReplyLost { .. } | ErrorKind::UnexpectedReply { .. } => true,
            ErrorKind::Disconnected { sent, .. } => *sent,
            ErrorKind::InvalidArgument(_)
            | ErrorKind::NotInFirmware(_)
            | ErrorKind::Connect { .. }
            | ErrorKind::Refused { .. }
            | ErrorKind::KeptBack { .. }
            | ErrorKind::NotSentInTime { .. }
            | ErrorKind::StateTimeout { .. }
            | ErrorKind::StatusUnknown { .. }
            | ErrorKind::StatusTimeout { .. }
            | ErrorKind::UnexpectedStatus { .. } => false,
        }
    }

    /// True if the connection can no longer be used.
    pub fn is_disconnected(&self) -> bool {
        matches!(self.kind(), ErrorKind::Disconnected { .. })
    }

    /// True if a reply, a status packet or a state did not come in time, or the command could not be sent in time.
    pub fn is_timeout(&self) -> bool {
        matches!(
            self.kind(),
            ErrorKind::Timeout { .. }
                | ErrorKind::NotSentInTime { .. }
                | ErrorKind::StateTimeout { .. }
                | ErrorKind::StatusTimeout { .. }
        )
    }

    /// True if the controller refused the command.
    pub fn is_refused(&self) -> bool {
        self.refusal().is_some()
    }

    /// True if the spec forbids the request. Nothing was sent.
    pub fn is_invalid_argument(&self) -> bool {
        matches!(self.kind(), ErrorKind::InvalidArgument(_))
    }

    /// True if nothing was sent because the controller's firmware does not have the command or one of its fields.
    pub fn is_not_in_firmware(&self) -> bool {
        matches!(self.kind(), ErrorKind::NotInFirmware(_))
    }

    /// True if no connection could be made.
    pub fn is_connect(&self) -> bool {
        matches!(self.kind(), ErrorKind::Connect { .. })
    }

    /// The controller's code and message, if it refused the command.
    pub fn refusal(&self) -> Option<&Refusal> {
        if let ErrorKind::Refused { refusal } = self.kind() { Some(refusal) } else { None }
    }

    /// Last eight messages of the connection on which the call failed, oldest first: sent and received, with their
    /// times.
    ///
    /// Empty if nothing is recorded ([`Config::recorder`](crate::Config::recorder)), and for errors that concern no
    /// connection. The alternate form of the error, `{:#}`, shows them below its text.
    pub fn exchanges(&self) -> &[Entry] {
        &self.0.exchanges
    }

    /// Attaches the last messages of the connection.
    pub(crate) fn with_exchanges(mut self, exchanges: Box<[Entry]>) -> Self {
        self.0.exchanges = exchanges;
        self
    }
}

/// Shows the kind and the number of messages, which are long.
impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Error").field("kind", self.kind()).field("exchanges", &self.exchanges().len()).finish()
    }
}

/// Writes one line: the fact, which is the text of the [`kind`](Error::kind), and the [`Remedy`]. With `{:#}`, recorded
/// last messages follow below it.
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.kind())?;
        self.remedy().append(f)?;
        if f.alternate() { show_exchanges(self.exchanges(), f) } else { Ok(()) }
    }
}

impl StdError for Error {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        match self.kind() {
            ErrorKind::Connect { source, .. } => Some(source),
            ErrorKind::UnexpectedReply { source, .. } | ErrorKind::UnexpectedStatus { source } => Some(source),
            ErrorKind::Disconnected { cause, .. } => Some(&**cause),
            ErrorKind::StatusUnknown { problem } => problem.source(),
            ErrorKind::InvalidArgument(_)
            | ErrorKind::NotInFirmware(_)
            | ErrorKind::Refused { .. }
            | ErrorKind::KeptBack { .. }
            | ErrorKind::Timeout { .. }
            | ErrorKind::NotSentInTime { .. }
            | ErrorKind::ReplyLost { .. }
            | ErrorKind::StateTimeout { .. }
            | ErrorKind::StatusTimeout { .. } => None,
        }
    }
}

impl From<ErrorKind> for Error {
    fn from(kind: ErrorKind) -> Self {
        Self(Box::new(Inner { kind, exchanges: Box::default() }))
    }
}

impl From<InvalidArgument> for Error {
    fn from(invalid: InvalidArgument) -> Self {
        ErrorKind::InvalidArgument(invalid).into()
    }
}

impl From<NotInFirmware> for Error {
    fn from(missing: NotInFirmware) -> Self {
        ErrorKind::NotInFirmware(missing).into()
    }
}

impl From<NotSent> for Error {
    fn from(not_sent: NotSent) -> Self {
        match not_sent {
            NotSent::InvalidArgument(invalid) => invalid.into(),
            NotSent::NotInFirmware(missing) => (*missing).into(),
        }
    }
}

fn disconnected(address: &str, command: Option<&str>, sent: bool, cause: &Disconnect) -> String {
    let hint = cause.seat_hint();
    match command {
        None => format!("the status connection to {address} is broken"),
        Some(command) if sent => {
            format!("the connection to {address} broke during `{command}`, which may have run{hint}")
        }
        Some(command) => format!("`{command}` was not sent: the connection to {address} is broken{hint}"),
    }
}

fn not_in_state(after: Duration, packets: u64, says: Option<&str>) -> String {
    let says = says.map_or_else(String::new, |says| format!("; the last packet: {says}"));
    format!("the robot was not in the expected state within {after:?} ({packets} status packets){says}")
}

/// Number of shown characters of a message.
const SHOWN: usize = 300;

/// Writes the last messages of a connection, one per line; nothing if there are none.
pub fn show_exchanges(entries: &[Entry], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if !entries.is_empty() {
        f.write_str("\nthe last messages of the connection, by seconds since the recording began:")?;
    }
    entries.iter().try_for_each(|entry| {
        let (arrow, message) = match &entry.event {
            Event::Sent(message) => ("->", message),
            Event::Received(message) => ("<-", message),
            _ => return Ok(()),
        };
        write!(f, "\n{:12.6} {arrow} ", entry.time.as_secs_f64())?;
        show_message(message, f)
    })
}

fn show_message(message: &Message, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let text = message.to_string();
    let text = visible(&text);
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => write!(f, "{}… ({} bytes)", &text[..end], message.bytes().len()),
        None => f.write_str(&text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_result_is_as_wide_as_a_pointer() {
        assert_eq!(size_of::<Result<(), Error>>(), size_of::<usize>());
    }
}
