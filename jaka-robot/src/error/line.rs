//! Facts of several events in one line.

use std::error::Error as StdError;

use super::Error;
use crate::{Cause, Remedy};

/// Consequence of a stop that the controller did not accept.
pub(super) const STOP_NOT_ACCEPTED: &str = "the stop that followed was not accepted, so the arm may still move";

/// Facts in one line, which begins with the event of its cause and names no event twice.
#[derive(Debug)]
pub(super) struct Line {
    text: String,
    told: Vec<Cause>,
}

impl Line {
    /// Line of one event.
    pub(super) fn of(cause: Cause, text: String) -> Self {
        Self { text, told: vec![cause] }
    }

    /// Line of an error, if there is one.
    pub(super) fn of_error(error: Option<&Error>) -> Self {
        match error {
            Some(error) => Self { text: error.kind().event(), told: error.kind().causes() },
            None => Self { text: String::new(), told: Vec::new() },
        }
    }

    /// Adds a consequence, and the event that caused it: in front if it is the cause of the line, and not at all if the
    /// line has it already.
    pub(super) fn followed_by(self, what: &str, because: Option<&Error>) -> Self {
        let Self { text, mut told } = self;
        let before = if text.is_empty() { String::new() } else { format!("{text}; ") };
        let new = because.filter(|error| !told.contains(&Error::cause(error)));
        let text = match new {
            Some(error) if told.iter().all(|&other| error.cause() < other) => {
                format!("{}; {before}{what}", error.kind().event())
            }
            Some(error) => format!("{before}{what}: {}", error.kind().event()),
            None => format!("{before}{what}"),
        };
        told.extend(new.map(|error| error.kind().causes()).unwrap_or_default());
        Self { text, told }
    }

    /// Text of the line.
    pub(super) fn into_text(self) -> String {
        self.text
    }
}

/// Text that begins with the fact of the cause, unless it has that already.
pub(super) fn with_fact(cause: Cause, text: String) -> String {
    let fact = cause.to_string();
    if text.contains(&fact) { text } else { format!("{fact}: {text}") }
}

/// Errors of two events, the second of which followed the first.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sequence<'e> {
    first: Option<&'e Error>,
    then: &'e Error,
}

impl<'e> Sequence<'e> {
    /// Sequence of these errors, or the second alone.
    pub(super) fn new(first: impl Into<Option<&'e Error>>, then: &'e Error) -> Self {
        Self { first: first.into(), then }
    }

    /// Facts of both, and the consequence, in words.
    pub(super) fn line(self, what: &str) -> String {
        Line::of_error(self.first).followed_by(what, Some(self.then)).into_text()
    }

    /// Cause, the first by precedence.
    pub(super) fn cause(self) -> Cause {
        self.leading().cause()
    }

    /// Causes of all events.
    pub(super) fn causes(self) -> Vec<Cause> {
        self.first.into_iter().chain([self.then]).flat_map(|error| error.kind().causes()).collect()
    }

    /// Remedy for the cause.
    pub(super) fn remedy(self) -> Remedy {
        self.leading().remedy_of_event()
    }

    /// Source of the error that has the cause.
    pub(super) fn source(self) -> Option<&'e (dyn StdError + 'static)> {
        self.leading().source()
    }

    /// Error that has the cause.
    fn leading(self) -> &'e Error {
        match self.first {
            Some(first) if first.cause() <= self.then.cause() => first,
            _ => self.then,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io;
    use std::sync::Arc;
    use std::time::Duration;

    use super::*;
    use crate::{Disconnect, ErrorKind, StatusProblem};

    fn lost(command: &str) -> Error {
        let cause = Arc::new(Disconnect::Read(io::ErrorKind::ConnectionReset.into()));
        let (address, command) = ("arm:10001".to_owned(), Some(command.to_owned()));
        jaka_sync::ErrorKind::Disconnected { address, command, sent: true, cause }.into()
    }

    fn stale() -> Error {
        ErrorKind::StatusUnknown { problem: StatusProblem::Stale { age: Duration::from_secs(3) } }.into()
    }

    fn stopped() -> Error {
        ErrorKind::NotReady { occurrence: Cause::EmergencyStop.into() }.into()
    }

    #[test]
    fn an_event_that_ends_a_session_and_its_landing_is_told_once_and_its_remedy_apart() {
        let error: Error = ErrorKind::NotLanded { first: stopped(), landing: stopped() }.into();
        let fact = "the emergency stop is pressed; the arm was not braked to rest";
        assert_eq!(error.kind().to_string(), fact);
        assert_eq!(error.remedy(), Remedy::ReleaseEmergencyStop);
        assert_eq!(error.to_string(), format!("{fact}; {}", Remedy::ReleaseEmergencyStop));
    }

    #[test]
    fn a_lost_connection_is_told_once_where_servo_mode_cannot_be_left_because_of_it() {
        let landing = ErrorKind::NotLanded { first: stale(), landing: lost("servo_j") }.into();
        let error: Error = ErrorKind::ServoModeNotLeft { first: Some(landing), leaving: lost("servo_move") }.into();
        let told = error.kind().to_string();
        assert!(
            told.starts_with(&format!("{}: the connection to arm:10001 broke during", Cause::CommandsLost)),
            "{told}"
        );
        let first =
            "; the state of the robot is unknown: the last status packet came 3.0s ago; the arm was not braked to rest";
        let leaving = "; servo mode may be on, because leaving it failed or was not confirmed";
        assert!(told.ends_with(&format!("{first}{leaving}")), "{told}");
        assert_eq!(told.matches("arm:10001").count(), 1, "{told}");
        assert_eq!((error.cause(), error.remedy()), (Cause::CommandsLost, Remedy::ConnectAndStop));
        assert_eq!(error.source().map(ToString::to_string).as_deref(), Some("receiving failed"));
    }

    #[test]
    fn events_of_several_causes_are_all_told_the_first_by_precedence_in_front() {
        let error: Error = ErrorKind::NotStopped { first: stale(), stopping: stopped() }.into();
        let fact = "the emergency stop is pressed; the state of the robot is unknown: the last status packet came 3.0s ago; \
                    the stop that followed was not accepted, so the arm may still move";
        assert_eq!(error.kind().to_string(), fact);
        let error: Error = ErrorKind::NotStopped { first: stopped(), stopping: stale() }.into();
        let fact = "the emergency stop is pressed; the stop that followed was not accepted, so the arm may still move: the \
                    state of the robot is unknown: the last status packet came 3.0s ago";
        assert_eq!(error.kind().to_string(), fact);
        assert_eq!(error.remedy(), Remedy::ReleaseEmergencyStop);
    }
}
