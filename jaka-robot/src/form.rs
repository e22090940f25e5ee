//! Forms of times, events and texts as serde's data.
#![expect(clippy::ref_option, clippy::trivially_copy_pass_by_ref, reason = "serde passes fields by reference")]

use std::fmt::Display;
use std::time::Duration;

use jaka_proto::ControllerEvent;
use serde::{Serialize, Serializer};

/// Time in seconds.
pub(crate) fn seconds<S: Serializer>(time: &Duration, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(time.as_secs_f64())
}

/// Time in seconds, if there is one.
pub(crate) fn some_seconds<S: Serializer>(time: &Option<Duration>, serializer: S) -> Result<S::Ok, S::Error> {
    time.map(|time| time.as_secs_f64()).serialize(serializer)
}

/// Text.
pub(crate) fn text<S: Serializer>(value: &impl Display, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(value)
}

/// Text, if there is one.
pub(crate) fn some_text<S: Serializer>(value: &Option<impl Display>, serializer: S) -> Result<S::Ok, S::Error> {
    value.as_ref().map(ToString::to_string).serialize(serializer)
}

/// Severity and meaning of an event, if there is one.
pub(crate) fn event<S: Serializer>(event: &Option<ControllerEvent>, serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Form {
        severity: String,
        meaning: Option<&'static str>,
    }
    let form = |event: ControllerEvent| Form { severity: event.severity().to_string(), meaning: event.meaning() };
    event.map(form).serialize(serializer)
}
