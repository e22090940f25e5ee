//! What a status packet says against a motion.

use jaka_proto::messages::status::RobotStatus;

use crate::{ControllerEvent, Outcome, Severity};

/// What a packet shows against a motion.
#[derive(Debug)]
pub(super) enum News {
    /// The motion has ended.
    Ends(Outcome),
    /// It counts only once the arm is at rest: a code that is in no table.
    AtRest(Outcome),
}

/// What a packet says against a motion; of events only one that was not shown before.
pub(super) fn news(status: &RobotStatus, code_before: Option<&str>) -> Option<News> {
    if let Some(stop) = stop(status) {
        return Some(News::Ends(stop));
    }
    let (severity, report) = event(status, code_before).unzip();
    match (severity, report) {
        (Some(Severity::Error), Some(report)) => Some(News::Ends(report)),
        _ if status.powered_on == Some(false) => Some(News::Ends(Outcome::NotPowered)),
        _ if status.enabled == Some(false) => Some(News::Ends(Outcome::NotEnabled)),
        (Some(Severity::Unknown), Some(report)) => Some(News::AtRest(report)),
        _ => None,
    }
}

/// An event that was not shown before, with its severity; a code that cannot be read is unknown.
fn event(status: &RobotStatus, code_before: Option<&str>) -> Option<(Severity, Outcome)> {
    let code = code(status).filter(|code| Some(*code) != code_before)?;
    let event = status.event().ok().flatten();
    let severity = event.map_or(Severity::Unknown, ControllerEvent::severity);
    let message = status.error_message.clone().unwrap_or_default();
    Some((severity, Outcome::ControllerError { code: code.to_owned(), event, message }))
}

/// The code of the event that the status shows, as it is written; none where it shows none.
pub(super) fn code(status: &RobotStatus) -> Option<&str> {
    status.error_code.as_deref().filter(|_| !matches!(status.event(), Ok(None)))
}

/// A stop that keeps the arm from moving until it has been acknowledged.
pub(super) fn stop(status: &RobotStatus) -> Option<Outcome> {
    match status {
        RobotStatus { emergency_stop: Some(true), .. } => Some(Outcome::EmergencyStop),
        RobotStatus { protective_stop: Some(true), .. } => Some(Outcome::ProtectiveStop),
        _ => None,
    }
}
