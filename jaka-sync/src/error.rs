//! What can go wrong, told apart by what the caller can do about it.

use std::error::Error as StdError;
use std::fmt::{self, Write};
use std::io;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::check::{InvalidArgument, NotSent};
use jaka_proto::framing::FrameError;
use jaka_proto::recording::Entry;
use jaka_proto::text::VisibleWriter;
use jaka_proto::wire::DecodeError;
use jaka_proto::{Mistrust, NotInFirmware, Refusal};

use crate::recorder::{self, Exchanges};

/// Why a call failed.
///
/// Two questions matter after an error: may the command have run ([`may_have_run`](Self::may_have_run)), and can the
/// connection still be used ([`is_disconnected`](Self::is_disconnected)). Nothing is ever sent twice on its own.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// The spec forbids the request. Nothing was sent; correct the field that is named.
    InvalidArgument(InvalidArgument),
    /// The controller's firmware does not have the command, or a field that is given. Nothing was sent.
    ///
    /// Only where the firmware is known: see [`Client::check_firmware`](crate::Client::check_firmware).
    NotInFirmware(NotInFirmware),
    /// No connection could be made. Check the address, the cable, and whether the controller is on.
    Connect {
        /// The address given.
        address: String,
        /// Why not, in the system's words.
        source: io::Error,
    },
    /// The address of a robot names a port, and a robot has two: 10001 for commands and 10000 for its status. Give the address without a
    /// port, or both addresses to [`Config::connect_robot`](crate::Config::connect_robot). Nothing was connected to.
    PortInAddress {
        /// The address given.
        address: String,
    },
    /// The controller refused the command, which did not run. The connection is fine.
    Refused {
        /// The controller's own words.
        refusal: Refusal,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// The same for a motion of a [`Robot`](crate::Robot), where its status tells why. The motion did not run.
    RefusedBecause {
        /// The controller's own words.
        refusal: Refusal,
        /// Why, and what helps.
        explanation: crate::Explanation,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// No reply came in time. The command may have run; read the robot's state before you go on.
    ///
    /// The connection can still be used: the reply, when it comes, is taken off and given to nobody.
    Timeout {
        /// `cmdName` of the command.
        command: String,
        /// How long was waited.
        after: Duration,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// The command could not be sent in time: the controller takes nothing more in, or other threads were sending. It did not run, and
    /// the connection can still be used.
    NotSentInTime {
        /// `cmdName` of the command.
        command: String,
        /// How long was waited.
        after: Duration,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// A later command was answered, this one was not. The command may have run; the connection is fine.
    ReplyLost {
        /// `cmdName` of the command.
        command: String,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// The controller accepted the command, but its reply does not fit the spec. The connection is fine.
    ///
    /// The raw reply is kept: see [`Client::last_reply`](crate::Client::last_reply).
    UnexpectedReply {
        /// `cmdName` of the command.
        command: String,
        /// Which field does not fit.
        source: DecodeError,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// The connection is broken for good, and each later call says so again. Connect anew when the robot's state is known.
    Disconnected {
        /// `cmdName` of the command of this call; none for a status stream.
        command: Option<String>,
        /// True if the command had been sent, at least in part, and may have run.
        sent: bool,
        /// What broke the connection.
        cause: Arc<Disconnect>,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// Status packets came, and none said in time what was waited for.
    StateTimeout {
        /// How long was waited.
        after: Duration,
        /// How many packets came meanwhile.
        packets: u64,
        /// What the last one says of the arm; none for a type of the user's own.
        says: Option<String>,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// A motion was not sent, since it is not known whether the robot is stopped. See to the status port, or, for a program that
    /// must do without it, [`Robot::move_without_status`](crate::Robot::move_without_status).
    StatusUnknown {
        /// Why it is not known, and what helps.
        problem: crate::StatusProblem,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// The robot is in a state that keeps it from doing what was asked. Nothing that moves the arm was sent.
    NotReady {
        /// Which state, and what helps.
        explanation: crate::Explanation,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// So many set-points of a servo session were not answered. No set-point goes out any more.
    SetPointsUnanswered {
        /// How many.
        count: usize,
        /// For how long the oldest of them had not been answered.
        oldest: Duration,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// A set-point was not sent: its servo session has ended.
    SessionEnded {
        /// Why it has ended.
        because: String,
    },
    /// No status packet came in time. The stream can still be used.
    StatusTimeout {
        /// How long was waited.
        after: Duration,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
    /// A motion was not sent, since the robot has stopped or a connection was lost, and nobody has acknowledged it: see
    /// [`Robot::acknowledge`](crate::Robot::acknowledge).
    NotAcknowledged {
        /// What happened.
        outcome: Box<crate::Outcome>,
    },
    /// Servo mode could not be left, or it is not known that it was: the arm may still be in servo mode. Where the connection is
    /// broken ([`is_disconnected`](Error::is_disconnected)), no stop can be sent on it either.
    ServoModeNotLeft {
        /// What failed in the session before; none where only leaving did.
        first: Option<Box<Error>>,
        /// Why servo mode could not be left.
        leaving: Box<Error>,
    },
    /// A status packet does not fit the spec. The stream can still be used, and the packet's text is kept.
    UnexpectedStatus {
        /// Which field does not fit.
        source: DecodeError,
        /// The last messages, where they were recorded.
        exchanges: Exchanges,
    },
}

impl Error {
    /// True if the controller may have carried out the command although the call failed.
    pub fn may_have_run(&self) -> bool {
        match self {
            Self::Timeout { .. }
            | Self::ReplyLost { .. }
            | Self::UnexpectedReply { .. }
            | Self::SetPointsUnanswered { .. }
            | Self::ServoModeNotLeft { .. } => true,
            Self::Disconnected { sent, .. } => *sent,
            _ => false,
        }
    }

    /// True if the connection is of no use any more.
    pub fn is_disconnected(&self) -> bool {
        match self {
            Self::Disconnected { .. } => true,
            Self::ServoModeNotLeft { leaving, .. } => leaving.is_disconnected(),
            _ => false,
        }
    }

    /// True if a reply, a status packet or a state did not come in time, or the command could not be sent in time.
    pub fn is_timeout(&self) -> bool {
        matches!(
            self,
            Self::Timeout { .. } | Self::NotSentInTime { .. } | Self::StatusTimeout { .. } | Self::StateTimeout { .. }
        )
    }

    /// True if the controller refused the command.
    pub fn is_refused(&self) -> bool {
        self.refusal().is_some()
    }

    /// True if nothing was sent because the spec forbids the request.
    pub fn is_invalid_argument(&self) -> bool {
        matches!(self, Self::InvalidArgument(_))
    }

    /// True if nothing was sent because the controller's firmware does not have the command or one of its fields.
    pub fn is_not_in_firmware(&self) -> bool {
        matches!(self, Self::NotInFirmware(_))
    }

    /// True if no connection could be made.
    pub fn is_connect(&self) -> bool {
        matches!(self, Self::Connect { .. } | Self::PortInAddress { .. })
    }

    /// The controller's code and message, if it refused the command.
    pub fn refusal(&self) -> Option<&Refusal> {
        match self {
            Self::Refused { refusal, .. } | Self::RefusedBecause { refusal, .. } => Some(refusal),
            _ => None,
        }
    }

    /// The last eight messages of the connection on which the call failed, oldest first: sent and received, with their times.
    ///
    /// Empty where nothing is recorded ([`Config::recorder`](crate::Config::recorder)), and for errors that concern no
    /// connection. The alternate form of the error, `{:#}`, shows them below its text.
    pub fn exchanges(&self) -> &[Entry] {
        match self {
            Self::Refused { exchanges, .. }
            | Self::RefusedBecause { exchanges, .. }
            | Self::Timeout { exchanges, .. }
            | Self::NotSentInTime { exchanges, .. }
            | Self::ReplyLost { exchanges, .. }
            | Self::UnexpectedReply { exchanges, .. }
            | Self::Disconnected { exchanges, .. }
            | Self::StatusTimeout { exchanges, .. }
            | Self::StateTimeout { exchanges, .. }
            | Self::StatusUnknown { exchanges, .. }
            | Self::NotReady { exchanges, .. }
            | Self::SetPointsUnanswered { exchanges, .. }
            | Self::UnexpectedStatus { exchanges, .. } => exchanges.entries(),
            Self::ServoModeNotLeft { leaving, .. } => leaving.exchanges(),
            _ => &[],
        }
    }

    /// Where the last messages are kept; the same variants as above.
    pub(crate) fn exchanges_mut(&mut self) -> Option<&mut Exchanges> {
        match self {
            Self::Refused { exchanges, .. }
            | Self::RefusedBecause { exchanges, .. }
            | Self::Timeout { exchanges, .. }
            | Self::NotSentInTime { exchanges, .. }
            | Self::ReplyLost { exchanges, .. }
            | Self::UnexpectedReply { exchanges, .. }
            | Self::Disconnected { exchanges, .. }
            | Self::StatusTimeout { exchanges, .. }
            | Self::StateTimeout { exchanges, .. }
            | Self::StatusUnknown { exchanges, .. }
            | Self::NotReady { exchanges, .. }
            | Self::SetPointsUnanswered { exchanges, .. }
            | Self::UnexpectedStatus { exchanges, .. } => Some(exchanges),
            _ => None,
        }
    }

    /// In one line, whatever the controller says.
    fn write_text(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut f = VisibleWriter(f);
        match self {
            Self::InvalidArgument(invalid) => write!(f, "{invalid}"),
            Self::NotInFirmware(missing) => write!(f, "{missing}"),
            Self::Connect { address, .. } => write!(f, "cannot connect to {address}"),
            Self::PortInAddress { address } => write!(
                f,
                "cannot connect to {address}: a robot has two ports, so its address has none; two addresses can be given to \
                 `Config::connect_robot`"
            ),
            Self::Refused { refusal, .. } => write!(f, "{refusal}"),
            Self::RefusedBecause { refusal, explanation, .. } => write!(f, "{refusal}; {explanation}"),
            Self::Timeout { command, after, .. } => {
                write!(f, "no reply to `{command}` within {after:?}; it may have run")
            }
            Self::NotSentInTime { command, after, .. } => {
                write!(f, "`{command}` could not be sent within {after:?}; it did not run")
            }
            Self::ReplyLost { command, .. } => {
                write!(f, "the reply to `{command}` is lost, a later command was answered; it may have run")
            }
            Self::UnexpectedReply { command, .. } => {
                write!(f, "`{command}` was accepted, but its reply does not fit the spec")
            }
            Self::Disconnected { command: None, .. } => f.write_str("the status connection is broken"),
            Self::Disconnected { command: Some(command), sent: false, .. } => {
                write!(f, "`{command}` was not sent: the connection is broken")
            }
            Self::Disconnected { command: Some(command), .. } => {
                write!(f, "the connection broke during `{command}`, which may have run")
            }
            Self::ServoModeNotLeft { first, leaving } => {
                if let Some(first) = first {
                    write!(f, "{first}; and ")?;
                }
                write!(f, "servo mode may be on, since it is not known that it was left: {leaving}")?;
                if leaving.is_disconnected() { f.write_str("; no stop can be sent on this connection") } else { Ok(()) }
            }
            Self::StateTimeout { after, packets, says, .. } => {
                write!(f, "the state did not come within {after:?}, in {packets} status packets")?;
                says.as_ref().map_or(Ok(()), |says| write!(f, "; the last one says: {says}"))
            }
            Self::StatusUnknown { problem, .. } => {
                write!(f, "nothing was sent that moves the arm, since its state is not known: {problem}")
            }
            Self::NotReady { explanation, .. } => write!(f, "the robot cannot do this now: {explanation}"),
            Self::SetPointsUnanswered { count, oldest, .. } => write!(
                f,
                "{count} set-points were not answered, the oldest for {oldest:.1?}, so no more are sent and the session has ended"
            ),
            Self::SessionEnded { because } => write!(f, "not sent: the servo session has ended, since {because}"),
            Self::NotAcknowledged { outcome } => {
                write!(
                    f,
                    "nothing is sent that moves the arm, until `acknowledge` says that somebody has looked: {outcome}"
                )
            }
            Self::StatusTimeout { after, .. } => write!(f, "no status packet within {after:?}"),
            Self::UnexpectedStatus { .. } => f.write_str("a status packet does not fit the spec"),
        }
    }
}

/// One line of text; with `{:#}` the last messages below it, where they were recorded.
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_text(f)?;
        if f.alternate() { recorder::show(self.exchanges(), f) } else { Ok(()) }
    }
}

impl StdError for Error {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        match self {
            Self::Connect { source, .. } => Some(source),
            Self::UnexpectedReply { source, .. } | Self::UnexpectedStatus { source, .. } => Some(source),
            Self::Disconnected { cause, .. } => Some(&**cause),
            // The texts of `InvalidArgument`, `NotInFirmware` and `Refused` are this error's own.
            _ => None,
        }
    }
}

impl From<InvalidArgument> for Error {
    fn from(invalid: InvalidArgument) -> Self {
        Self::InvalidArgument(invalid)
    }
}

impl From<NotSent> for Error {
    fn from(not_sent: NotSent) -> Self {
        match not_sent {
            NotSent::InvalidArgument(invalid) => Self::InvalidArgument(invalid),
            NotSent::NotInFirmware(missing) => Self::NotInFirmware(missing),
        }
    }
}

/// What broke a connection.
#[derive(Debug)]
#[non_exhaustive]
pub enum Disconnect {
    /// The controller closed the connection.
    Closed {
        /// How many bytes of an unfinished message had come.
        partial: usize,
    },
    /// The system reported an error while sending.
    Write(io::Error),
    /// The system reported an error while receiving.
    Read(io::Error),
    /// Bytes came that are no message, or a message longer than the limit.
    Frame(FrameError),
    /// A message came that is no JSON object by its quotes and brackets.
    NotJson(DecodeError),
    /// A reply came, or failed to come, in a way that leaves in doubt whose the next ones are.
    Mistrust(Mistrust),
    /// This side reset the connection, so that the system does not send what it had queued: set-points of a servo session and the
    /// end of servo mode were not answered.
    Reset {
        /// How many set-points were not answered.
        unanswered: u64,
    },
    /// A panic in this program, of a logger for instance, kept a reply from being attributed.
    Panicked,
    /// The client was dropped, and with it the connection: stop handles cannot stop any more.
    ClientDropped,
    /// This is the status port, or something that sends what it sends; port 10001 takes commands.
    StatusPort,
    /// This is the command port, or something that answers as it does; port 10000 sends the status.
    CommandPort,
    /// A command that ends the session was carried out.
    Ended {
        /// `cmdName` of the command.
        by: String,
    },
}

/// In one line, whatever came over the connection: see [`text`](crate::proto::text).
impl fmt::Display for Disconnect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut f = VisibleWriter(f);
        match self {
            Self::Closed { partial } => {
                f.write_str("the controller closed the connection")?;
                if *partial > 0 {
                    write!(f, " within a message, of which {partial} bytes had come")?;
                }
                f.write_str("; it may have shut down, or another client may have taken the command port")
            }
            Self::Write(_) => f.write_str("sending failed"),
            Self::Read(_) => f.write_str("receiving failed"),
            Self::Frame(error) if is_text_line(error) => {
                write!(f, "this firmware sends status as text lines, which only very old versions do: {error}")
            }
            Self::Frame(error) => write!(f, "{error}"),
            Self::NotJson(error) => write!(f, "a message came that is no JSON: {error}"),
            Self::Reset { unanswered } => write!(
                f,
                "the connection was reset: {unanswered} set-points and the end of servo mode were not answered, \
                 and those that the system had not sent yet are discarded; others may still move the arm"
            ),
            Self::Mistrust(mistrust) => write!(f, "{mistrust}"),
            Self::Panicked => f.write_str("a panic in this program kept a reply from being attributed"),
            Self::ClientDropped => f.write_str("the client was dropped, and with it the connection"),
            Self::StatusPort => {
                f.write_str("a status packet came instead of a reply: this is the status port, port 10001 takes commands")
            }
            Self::CommandPort => f.write_str(
                "a reply to a command came instead of a status packet: this is the command port, port 10000 sends the status",
            ),
            Self::Ended { by } => write!(f, "`{by}` ended the session"),
        }
    }
}

/// Firmware before the JSON protocol sent lines such as `joint_actual_position:(…)`.
pub(crate) fn is_text_line(error: &FrameError) -> bool {
    matches!(error, FrameError::Garbage { excerpt } if excerpt.bytes().starts_with(b"joint_actual_position"))
}

impl StdError for Disconnect {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        match self {
            Self::Write(source) | Self::Read(source) => Some(source),
            _ => None,
        }
    }
}
