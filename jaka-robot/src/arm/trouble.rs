//! Events in a status packet that end a motion.

use jaka_proto::messages::status::RobotStatus;

use crate::{Cause, ControllerEvent, Explanation, Occurrence, Severity};

/// Event in a packet that ends a motion, at once or when the arm is at rest.
#[derive(Debug)]
pub(crate) enum News {
    /// The motion has ended.
    Ends(Occurrence),
    /// It counts only once the arm is at rest: a code that is in no table.
    AtRest(Occurrence),
}

/// A stop that a packet shows.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Stop {
    Emergency,
    Protective,
}

impl Stop {
    pub(crate) fn cause(self) -> Cause {
        match self {
            Self::Emergency => Cause::EmergencyStop,
            Self::Protective => Cause::ProtectiveStop,
        }
    }

    pub(crate) fn explanation(self) -> Explanation {
        match self {
            Self::Emergency => Explanation::EmergencyStop,
            Self::Protective => Explanation::ProtectiveStop,
        }
    }
}

/// Finds an event in a packet that ends a motion; of the controller's events only one that was not shown before.
pub(crate) fn news(status: &RobotStatus, code_before: Option<&str>) -> Option<News> {
    if let Some(stop) = stop(status) {
        return Some(News::Ends(stop.cause().into()));
    }
    let (severity, report) = event(status, code_before).unzip();
    match (severity, report) {
        (Some(Severity::Error), Some(report)) => Some(News::Ends(report)),
        _ if status.powered_on == Some(false) => Some(News::Ends(Cause::NotPowered.into())),
        _ if status.enabled == Some(false) => Some(News::Ends(Cause::NotEnabled.into())),
        (Some(Severity::Unknown), Some(report)) => Some(News::AtRest(report)),
        _ => None,
    }
}

/// An event that was not shown before, with its severity; a code that cannot be read is unknown.
fn event(status: &RobotStatus, code_before: Option<&str>) -> Option<(Severity, Occurrence)> {
    let code = code(status).filter(|code| Some(*code) != code_before)?;
    let event = status.event().ok().flatten();
    let severity = event.map_or(Severity::Unknown, ControllerEvent::severity);
    let message = status.error_message.clone().unwrap_or_default();
    Some((severity, Occurrence::event(code, event, message)))
}

/// Code of the event in the status, as written there; `None` without an event.
pub(crate) fn code(status: &RobotStatus) -> Option<&str> {
    status.error_code.as_deref().filter(|_| !matches!(status.event(), Ok(None)))
}

/// A stop that keeps the arm from moving until it has been acknowledged.
pub(crate) fn stop(status: &RobotStatus) -> Option<Stop> {
    match status {
        RobotStatus { emergency_stop: Some(true), .. } => Some(Stop::Emergency),
        RobotStatus { protective_stop: Some(true), .. } => Some(Stop::Protective),
        _ => None,
    }
}
