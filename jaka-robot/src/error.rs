//! Errors, their kinds, the last messages before them, and ends of motions.

mod end;
mod kind;
mod line;

use std::error::Error as StdError;
use std::fmt;
use std::sync::Arc;

use jaka_proto::Refusal;
use jaka_proto::check::InvalidArgument;
use jaka_proto::recording::Entry;
use jaka_sync::layer::{Link, SendError, show_exchanges};

pub use self::end::{End, Phase, Rest};
pub use self::kind::ErrorKind;
use self::kind::Group;
#[cfg(feature = "serde")]
use crate::Evidence;
use crate::cause::Occurrence;
use crate::{Cause, GuardTrip, Remedy};

/// Error of a call: an [`ErrorKind`], and the last messages of the connection if they were recorded.
///
/// Two questions matter after an error: may the command have run ([`may_have_run`](Self::may_have_run)), and can the
/// connection still be used ([`is_disconnected`](Self::is_disconnected)). Nothing is ever sent twice on its own.
///
/// ```no_run
/// use std::time::Duration;
///
/// use jaka_robot::motion::JointMove;
/// use jaka_robot::{Cause, ErrorKind, Robot};
///
/// let mut robot = Robot::connect("10.5.5.100")?;
/// let turn = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 5.0], 5.0).acceleration(20.0);
/// if let Err(error) = robot.start(&turn) {
///     match error.kind() {
///         ErrorKind::Refused { refusal, .. } => eprintln!("refused with code {}", refusal.code),
///         ErrorKind::Connection(lost) if lost.is_timeout() => eprintln!("it may have run: {lost}"),
///         _ if error.cause() == Cause::NotPowered => robot.power_up(Duration::from_secs(60))?,
///         _ => return Err(error),
///     }
/// }
/// # Ok::<(), jaka_robot::Error>(())
/// ```
///
/// With the feature `serde` an error is written as its `cause`, the `text` of its kind, `may_have_run`, and the
/// `evidence` for the cause.
///
/// An `Error` is one pointer wide. It can be made of an [`ErrorKind`], for tests of programs that handle errors.
pub struct Error(Box<Inner>);

struct Inner {
    kind: ErrorKind,
    /// Empty where nothing is recorded.
    exchanges: Box<[Entry]>,
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

    /// Cause of the end of a motion, or of its refusal: the same for an event in each kind of motion.
    pub fn cause(&self) -> Cause {
        self.kind().cause()
    }

    /// Remedy for the error; [`Remedy::None`] where none is known.
    pub fn remedy(&self) -> Remedy {
        self.kind().remedy()
    }

    /// Remedy if the arm may have moved: the cause's, unless the error has its own.
    fn remedy_of_event(&self) -> Remedy {
        match self.remedy() {
            Remedy::None | Remedy::SeeError => self.cause().remedy(),
            own => own,
        }
    }

    /// Cause and the evidence for it.
    pub(crate) fn occurrence(&self) -> Occurrence {
        Occurrence { cause: self.cause(), evidence: self.kind().evidence() }
    }

    /// True if the controller may have carried out the command although the call failed.
    ///
    /// A call that sends several commands, such as [`Robot::power_up`](crate::Robot::power_up), reports the failed one:
    /// those before it were carried out.
    pub fn may_have_run(&self) -> bool {
        self.kind().meaning().may_have_run
    }

    /// True if the connection is unusable.
    pub fn is_disconnected(&self) -> bool {
        self.kind().meaning().group == Group::Disconnected
    }

    /// True if a reply, a status packet or a state did not come in time, or the command could not be sent in time.
    pub fn is_timeout(&self) -> bool {
        self.kind().meaning().group == Group::Timeout
    }

    /// True if the controller refused the command.
    pub fn is_refused(&self) -> bool {
        self.kind().meaning().group == Group::Refused
    }

    /// True if the spec forbids the request, or an option of this crate does not take its value. Nothing that moves the
    /// arm was sent.
    pub fn is_invalid_argument(&self) -> bool {
        self.kind().meaning().group == Group::InvalidArgument
    }

    /// True if nothing was sent because the controller's firmware does not have the command or one of its fields.
    pub fn is_not_in_firmware(&self) -> bool {
        self.kind().meaning().group == Group::NotInFirmware
    }

    /// True if no connection could be made.
    pub fn is_connect(&self) -> bool {
        self.kind().meaning().group == Group::Connect
    }

    /// The controller's code and message, if it refused the command.
    pub fn refusal(&self) -> Option<&Refusal> {
        if let ErrorKind::Refused { refusal, .. } = self.kind() { Some(refusal) } else { None }
    }

    /// Last eight messages of the connection on which the call failed, oldest first: sent and received, with their
    /// times.
    ///
    /// Empty where nothing is recorded ([`Config::recorder`](crate::Config::recorder)), and for errors that concern no
    /// connection. The alternate form of the error, `{:#}`, shows them below its text.
    pub fn exchanges(&self) -> &[Entry] {
        match self.kind() {
            ErrorKind::Connection(error) if self.0.exchanges.is_empty() => error.exchanges(),
            ErrorKind::NotSent { because, .. } => because.exchanges(),
            _ => &self.0.exchanges,
        }
    }

    /// Error of the connection, if a call of it failed: this one, or a query before it.
    pub fn connection(&self) -> Option<&jaka_sync::Error> {
        match self.kind() {
            ErrorKind::Connection(error) => Some(error),
            ErrorKind::NotSent { because, .. } => because.connection(),
            _ => None,
        }
    }

    /// Error for a command that was not sent because of this error of a query before it. Errors that say so themselves
    /// stay.
    pub(crate) fn before(self, command: &str) -> Self {
        let remedy = match self.kind() {
            ErrorKind::Connection(_) | ErrorKind::Refused { .. } | ErrorKind::NotAtRest { .. } => {
                self.remedy_of_event()
            }
            _ => return self,
        };
        self.before_with(
            command,
            match remedy {
                // Nothing of this call has to be stopped.
                Remedy::ConnectAndStop => Remedy::Connection(jaka_sync::Remedy::FreeSeat),
                Remedy::None | Remedy::SeeError => Remedy::Connection(jaka_sync::Remedy::TryAgain),
                other => other,
            },
        )
    }

    /// Error for a command that was not sent because of this error, with this remedy.
    pub(crate) fn before_with(self, command: &str, remedy: Remedy) -> Self {
        ErrorKind::NotSent { command: command.to_owned(), because: self, remedy }.into()
    }

    /// Error of an end other than the commanded one.
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

    /// Attaches the last messages of the connection.
    pub(crate) fn with_exchanges(mut self, exchanges: impl Into<Box<[Entry]>>) -> Self {
        self.0.exchanges = exchanges.into();
        self
    }
}

/// The kind, and the number of messages: they are long.
impl fmt::Debug for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Error").field("kind", self.kind()).field("exchanges", &self.exchanges().len()).finish()
    }
}

/// One line of text: the fact, which is the text of the [`kind`](Error::kind), and the [`Remedy`](crate::Remedy) in
/// calls of this crate. With `{:#}`, the last messages follow below if they were recorded.
impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.kind())?;
        self.remedy().append(f)?;
        if f.alternate() { show_exchanges(self.exchanges(), f) } else { Ok(()) }
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Error {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Form {
            cause: Cause,
            text: String,
            may_have_run: bool,
            evidence: Evidence,
        }
        let Occurrence { cause, evidence } = self.occurrence();
        let (text, may_have_run) = (self.kind().to_string(), self.may_have_run());
        Form { cause, text, may_have_run, evidence }.serialize(serializer)
    }
}

impl StdError for Error {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        self.kind().meaning().source
    }
}

impl From<ErrorKind> for Error {
    fn from(kind: ErrorKind) -> Self {
        Self(Box::new(Inner { kind, exchanges: Box::default() }))
    }
}

/// A refusal of any command is [`ErrorKind::Refused`]; all else is [`ErrorKind::Connection`].
impl From<jaka_sync::Error> for Error {
    fn from(error: jaka_sync::Error) -> Self {
        let Some(refusal) = error.refusal().cloned() else { return ErrorKind::Connection(error).into() };
        Self::from(ErrorKind::Refused { refusal, explanation: None }).with_exchanges(error.exchanges())
    }
}

impl From<jaka_sync::ErrorKind> for Error {
    fn from(kind: jaka_sync::ErrorKind) -> Self {
        jaka_sync::Error::from(kind).into()
    }
}

impl From<GuardTrip> for Error {
    fn from(trip: GuardTrip) -> Self {
        ErrorKind::GuardTripped { trip: Arc::new(trip) }.into()
    }
}

impl From<InvalidArgument> for Error {
    fn from(invalid: InvalidArgument) -> Self {
        jaka_sync::Error::from(invalid).into()
    }
}

/// The reason of a gate of this crate, or the error of the call.
impl From<SendError<Error>> for Error {
    fn from(error: SendError<Error>) -> Self {
        match error {
            SendError::KeptBack(reason) => reason,
            SendError::Failed(error) => error.into(),
        }
    }
}

/// Errors with the last messages of a connection.
pub(crate) trait Attach {
    /// Attaches the last messages of the connection, if they were recorded.
    fn attach(&self, error: Error) -> Error;
}

impl Attach for Link {
    fn attach(&self, error: Error) -> Error {
        let exchanges = self.note(&error, error.is_refused() || error.is_disconnected());
        error.with_exchanges(exchanges)
    }
}

/// Name of an option of this crate, and the type that has it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OptionName {
    of: &'static str,
    option: &'static str,
}

impl OptionName {
    pub(crate) const fn new(of: &'static str, option: &'static str) -> Self {
        Self { of, option }
    }

    /// Error for a value that the option does not take.
    pub(crate) fn refuse(self, value: impl fmt::Display, expected: impl Into<String>) -> Error {
        let Self { of, option } = self;
        ErrorKind::InvalidOption { option, of, value: value.to_string(), expected: expected.into() }.into()
    }

    /// Checks an angle, a speed or an acceleration: with less than a thousandth a turn takes hours.
    pub(crate) fn check_at_least(self, given: f64, unit: &str) -> Result<(), Error> {
        const LEAST: f64 = 1e-3;
        if given.is_finite() && given >= LEAST {
            return Ok(());
        }
        Err(self.refuse(given, format!("a number of at least {LEAST} {unit}")))
    }
}

#[cfg(test)]
mod tests {
    use std::io;

    use super::*;
    use crate::Disconnect;

    #[test]
    fn a_result_is_as_wide_as_a_pointer() {
        assert_eq!(size_of::<Result<(), Error>>(), size_of::<usize>());
    }

    #[test]
    fn an_error_of_leaving_servo_mode_has_the_cause_and_the_connection_of_what_failed() {
        let cause = Arc::new(Disconnect::Read(io::ErrorKind::ConnectionReset.into()));
        let leaving: Error = jaka_sync::ErrorKind::Disconnected {
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

/// Cause of the end of a session, a stream or a trajectory, its text and its remedy.
#[derive(Debug, Clone)]
pub(crate) struct SessionEnd {
    cause: Cause,
    because: String,
    remedy: Remedy,
}

impl SessionEnd {
    /// End that needs no remedy.
    pub(crate) fn new(cause: Cause, because: impl Into<String>) -> Self {
        Self { cause, because: because.into(), remedy: Remedy::None }
    }

    /// End by an error.
    pub(crate) fn of(error: &Error) -> Self {
        Self { cause: error.cause(), because: error.kind().to_string(), remedy: error.remedy() }
    }

    /// End of a trajectory.
    pub(crate) fn of_trajectory(end: &End) -> Self {
        Self { cause: end.cause(), because: end.to_string(), remedy: end.remedy() }
    }

    /// Error of a call after the end.
    pub(crate) fn into_error(self) -> Error {
        let Self { cause, because, remedy } = self;
        ErrorKind::SessionEnded { cause, because, remedy }.into()
    }
}
