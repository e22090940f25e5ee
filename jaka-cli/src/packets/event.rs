//! Events of the controller: texts printed next to a code.

use std::fmt;

use jaka_spec::{Event, EventTexts, Spec};
use jaka_sync::{ControllerEvent, Severity, UnreadableEvent};
use serde_json::Value;

use crate::builtin::of_status;

/// Name in Rust of the status packet field with the code.
pub(crate) const CODE: &str = "error_code";

/// Event of a code.
pub(crate) type Reading = Result<Option<ControllerEvent>, UnreadableEvent>;

/// Reads the event from the value of the field, which is a text. A packet without the field has no event.
pub(crate) fn read(code: Option<&Value>) -> Reading {
    code.map_or(Ok(None), |code| ControllerEvent::from_text(code.as_str().unwrap_or("not a text")))
}

/// Returns the severity of the event, if there is one. A code that is unreadable or not in the table may be an error.
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

/// Returns the meaning of the event, if it is known.
pub(crate) fn meaning(event: &Reading) -> Option<&'static str> {
    reading(event).and_then(|known| known.texts.meaning.as_deref())
}

/// Returns the possible causes of the event.
pub(crate) fn cause(event: &Reading) -> Option<Note> {
    note(of_status(), reading(event)?, Language::English, |texts| texts.cause.as_deref())
}

/// Returns the remedies for the event.
pub(crate) fn remedy(event: &Reading) -> Option<Note> {
    note(of_status(), reading(event)?, Language::English, |texts| texts.remedy.as_deref())
}

fn reading(event: &Reading) -> Option<&'static Event> {
    event.as_ref().ok().copied().flatten().and_then(known)
}

/// Returns the entry of the spec, or of a pack, for the event.
fn known(event: ControllerEvent) -> Option<&'static Event> {
    of_status().event(event.code())
}

/// Language of an explanation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Language {
    English,
    Chinese,
}

/// Cause or remedy of an event, and whether it is that of the event's family.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Note {
    pub(crate) text: &'static str,
    pub(crate) of_family: bool,
    pub(crate) language: Language,
}

/// Writes the text, with a mark if it is general.
impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.text)?;
        match (self.of_family, self.language) {
            (false, _) => Ok(()),
            (true, Language::English) => f.write_str(" (general: no source states it for this code)"),
            (true, Language::Chinese) => f.write_str("（一般说明：没有资料专门说明此事件码）"),
        }
    }
}

/// Returns the text of an event, or that of its family.
pub(crate) fn note(
    spec: &'static Spec,
    event: &'static Event,
    language: Language,
    text: fn(&EventTexts) -> Option<&str>,
) -> Option<Note> {
    let family = spec.family_of(event);
    let (own, family) = match language {
        Language::English => (&event.texts, family.map(|family| &family.texts)),
        Language::Chinese => (&event.texts_zh, family.map(|family| &family.texts_zh)),
    };
    let note = |text, of_family| Note { text, of_family, language };
    text(own).map(|text| note(text, false)).or_else(|| family.and_then(text).map(|text| note(text, true)))
}

/// Returns severity and meaning, such as `information: the robot is disabled`; `None` without an event.
pub(crate) fn describe(event: &Reading) -> Option<String> {
    let text = match (event, severity(event)?, meaning(event)) {
        (Err(_), ..) => "not an event code".to_owned(),
        (_, Severity::Unknown, _) => "severity unknown".to_owned(),
        (_, severity, Some(meaning)) => format!("{severity}: {meaning}"),
        (_, severity, None) => severity.to_string(),
    };
    Some(text)
}
