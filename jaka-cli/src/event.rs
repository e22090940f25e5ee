//! The controller's events: what is said of a code beside it.

use jaka_sync::{ControllerEvent, Severity, UnreadableEvent};
use serde_json::Value;

/// The field of status packets that has the code, by its name in Rust.
pub(crate) const CODE: &str = "error_code";

/// What a code says.
pub(crate) type Reading = Result<Option<ControllerEvent>, UnreadableEvent>;

/// What the value of the field says, which is a text. A packet without the field says of no event.
pub(crate) fn read(code: Option<&Value>) -> Reading {
    code.map_or(Ok(None), |code| ControllerEvent::from_text(code.as_str().unwrap_or("not a text")))
}

/// How grave the event is, if there is one. What cannot be read may be an error, as a code may that no table has.
pub(crate) fn severity(event: &Reading) -> Option<Severity> {
    match event {
        Ok(event) => event.map(ControllerEvent::severity),
        Err(_) => Some(Severity::Unknown),
    }
}

/// What the event means, if that is known.
pub(crate) fn meaning(event: &Reading) -> Option<&'static str> {
    event.as_ref().ok().copied().flatten().and_then(ControllerEvent::meaning)
}

/// Severity and meaning, such as `information: the robot is disabled`; nothing where there is no event.
pub(crate) fn describe(event: &Reading) -> Option<String> {
    let text = match (event, severity(event)?, meaning(event)) {
        (Err(_), ..) => "not an event code".to_owned(),
        (_, Severity::Unknown, _) => "severity unknown".to_owned(),
        (_, severity, Some(meaning)) => format!("{severity}: {meaning}"),
        (_, severity, None) => severity.to_string(),
    };
    Some(text)
}
