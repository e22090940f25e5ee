//! The controller's events: what is printed next to a code.

use jaka_spec::Event;
use jaka_sync::{ControllerEvent, Severity, UnreadableEvent};
use serde_json::Value;

use crate::builtin::of_status;

/// The field of status packets that has the code, by its name in Rust.
pub(crate) const CODE: &str = "error_code";

/// The event of a code.
pub(crate) type Reading = Result<Option<ControllerEvent>, UnreadableEvent>;

/// The event in the value of the field, which is a text. A packet without the field has no event.
pub(crate) fn read(code: Option<&Value>) -> Reading {
    code.map_or(Ok(None), |code| ControllerEvent::from_text(code.as_str().unwrap_or("not a text")))
}

/// How severe the event is, if there is one. A code that cannot be read, or that is not in the table, may be an error.
pub(crate) fn severity(event: &Reading) -> Option<Severity> {
    match event {
        Ok(event) => event.map(|event| match known(event).map(|known| known.severity) {
            Some(jaka_spec::Severity::Error) => Severity::Error,
            Some(jaka_spec::Severity::Warning) => Severity::Warning,
            Some(jaka_spec::Severity::Information) => Severity::Information,
            None => Severity::Unknown,
        }),
        Err(_) => Some(Severity::Unknown),
    }
}

/// What the event means, if that is known.
pub(crate) fn meaning(event: &Reading) -> Option<&'static str> {
    event.as_ref().ok().copied().flatten().and_then(known).and_then(|known| known.meaning.as_deref())
}

/// What the spec, or a pack, says of it.
fn known(event: ControllerEvent) -> Option<&'static Event> {
    of_status().event(event.code())
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
