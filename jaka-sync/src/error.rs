//! Errors, their kinds, the messages that led to them, and ends of motions.

mod end;
mod exchanges;
mod kind;
mod line;
mod option_name;

use std::error::Error as StdError;
use std::fmt;

use jaka_proto::check::{InvalidArgument, NotSent};
use jaka_proto::recording::Entry;
use jaka_proto::{NotInFirmware, Refusal};

pub use self::end::{End, Phase, Rest};
pub use self::kind::ErrorKind;
use self::kind::Group;
pub(crate) use self::option_name::OptionName;
#[cfg(feature = "stream")]
use crate::cause::Occurrence;
use crate::{Cause, Remedy};

/// Why a call failed: an [`ErrorKind`], and the last messages of the connection where they are recorded.
///
/// Two questions matter after an error: may the command have run ([`may_have_run`](Self::may_have_run)), and can the
/// connection still be used ([`is_disconnected`](Self::is_disconnected)). Nothing is ever sent twice on its own.
///
/// ```no_run
/// use jaka_sync::{Client, ErrorKind};
///
/// let mut robot = Client::connect("10.5.5.100")?;
/// if let Err(error) = robot.enable_robot() {
///     match error.kind() {
///         ErrorKind::Refused { refusal, .. } => eprintln!("refused with code {}", refusal.code),
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
    /// Empty where nothing is recorded.
    exchanges: Box<[Entry]>,
}

impl Error {
    /// What went wrong.
    pub fn kind(&self) -> &ErrorKind {
        &self.0.kind
    }

    /// What went wrong, without the last messages.
    pub fn into_kind(self) -> ErrorKind {
        self.0.kind
    }

    /// Cause of the end of moving, or why moving is kept back: the same for an event in each way of moving.
    pub fn cause(&self) -> Cause {
        self.kind().cause()
    }

    /// Remedy: what somebody can do about it; [`Remedy::None`] where nothing is known to help.
    pub fn remedy(&self) -> Remedy {
        self.kind().remedy()
    }

    /// Remedy where the arm may have moved: that of the cause, unless the error has one of its own.
    fn remedy_of_event(&self) -> Remedy {
        match self.remedy() {
            Remedy::None | Remedy::SeeError => self.cause().remedy(),
            own => own,
        }
    }

    /// Cause and the evidence for it.
    #[cfg(feature = "stream")]
    pub(crate) fn occurrence(&self) -> Occurrence {
        Occurrence { cause: self.cause(), evidence: self.kind().evidence() }
    }

    /// True if the controller may have carried out the command although the call failed.
    ///
    /// Where a call sends several commands, as [`Robot::power_up`](crate::Robot::power_up) does, this is about the one that failed: those
    /// before it were carried out.
    pub fn may_have_run(&self) -> bool {
        self.kind().meaning().1
    }

    /// True if the connection can no longer be used.
    pub fn is_disconnected(&self) -> bool {
        self.kind().meaning().0 == Group::Disconnected
    }

    /// True if a reply, a status packet or a state did not come in time, or the command could not be sent in time.
    pub fn is_timeout(&self) -> bool {
        self.kind().meaning().0 == Group::Timeout
    }

    /// True if the controller refused the command.
    pub fn is_refused(&self) -> bool {
        self.kind().meaning().0 == Group::Refused
    }

    /// True if the spec forbids the request, or an option of this crate does not take its value. Nothing that moves the arm
    /// was sent.
    pub fn is_invalid_argument(&self) -> bool {
        self.kind().meaning().0 == Group::InvalidArgument
    }

    /// True if nothing was sent because the controller's firmware does not have the command or one of its fields.
    pub fn is_not_in_firmware(&self) -> bool {
        self.kind().meaning().0 == Group::NotInFirmware
    }

    /// True if no connection could be made.
    pub fn is_connect(&self) -> bool {
        self.kind().meaning().0 == Group::Connect
    }

    /// The controller's code and message, if it refused the command.
    pub fn refusal(&self) -> Option<&Refusal> {
        if let ErrorKind::Refused { refusal, .. } = self.kind() { Some(refusal) } else { None }
    }

    /// The last eight messages of the connection on which the call failed, oldest first: sent and received, with their times.
    ///
    /// Empty where nothing is recorded ([`Config::recorder`](crate::Config::recorder)), and for errors that concern no
    /// connection. The alternate form of the error, `{:#}`, shows them below its text.
    pub fn exchanges(&self) -> &[Entry] {
        &self.0.exchanges
    }

    /// Error of an end that is not what was commanded.
    fn not_reached(end: End) -> Self {
        let exchanges = end.error.as_ref().map_or_else(Vec::new, |error| error.exchanges().to_vec());
        Self::from(ErrorKind::NotReached { end: Box::new(end) }).with_exchanges(exchanges)
    }

    /// True for the trip of a guard alone.
    fn is_trip(&self) -> bool {
        matches!(self.kind(), ErrorKind::GuardTripped { .. })
    }

    pub(crate) fn kind_mut(&mut self) -> &mut ErrorKind {
        &mut self.0.kind
    }

    /// The same error, with the last messages of its connection.
    pub(crate) fn with_exchanges(mut self, exchanges: impl Into<Box<[Entry]>>) -> Self {
        self.0.exchanges = exchanges.into();
        self
    }
}

/// The kind, and how many messages there are: they are long.
impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Error").field("kind", self.kind()).field("exchanges", &self.exchanges().len()).finish()
    }
}

/// One line of text: the fact, which is the text of the [`kind`](Error::kind), and the [`Remedy`](crate::Remedy) in the
/// calls of this crate. With `{:#}` the last messages stand below it, where they were recorded.
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.kind())?;
        self.remedy().append(f)?;
        if f.alternate() { exchanges::show(self.exchanges(), f) } else { Ok(()) }
    }
}

impl StdError for Error {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        self.kind().meaning().2
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

#[cfg(test)]
mod tests {
    use std::io;
    use std::sync::Arc;

    use super::*;
    use crate::Disconnect;

    #[test]
    fn a_result_is_as_wide_as_a_pointer() {
        assert_eq!(size_of::<Result<(), Error>>(), size_of::<usize>());
    }

    #[test]
    fn an_error_of_leaving_servo_mode_has_the_cause_and_the_connection_of_what_failed() {
        let cause = Arc::new(Disconnect::Read(io::ErrorKind::ConnectionReset.into()));
        let leaving: Error = ErrorKind::Disconnected {
            address: String::new(),
            command: Some("servo_move".to_owned()),
            sent: true,
            cause,
        }
        .into();
        let error: Error = ErrorKind::ServoModeNotLeft { first: None, leaving }.into();
        assert!(error.is_disconnected() && error.may_have_run());
        assert_eq!(error.source().map(ToString::to_string).as_deref(), Some("receiving failed"));
    }
}
