//! Problem in a request.

use std::fmt;

use jaka_proto::text::excerpt;
use serde_json::Value;

/// Violation of the spec in a request.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Problem {
    /// Path of the field, such as `pose.x`.
    pub field: String,
    /// Kind of the problem.
    pub kind: ProblemKind,
    /// Value given, as JSON; empty if none was.
    pub value: String,
    /// Description of the allowed values; for an unknown field, of the known fields.
    pub allowed: String,
    /// Whether the check can be switched off: newer firmware may take the value, or the spec only advises against it.
    pub advisory: bool,
}

/// Kind of a problem with a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProblemKind {
    /// The field does not exist.
    Unknown,
    /// A required field is missing.
    Missing,
    /// The field is given twice: by its wire spelling and by its Rust name.
    Repeated,
    /// The value is of the wrong type or out of range.
    Forbidden,
}

impl Problem {
    pub(super) fn new(field: &str, kind: ProblemKind, value: &Value, allowed: String) -> Self {
        let value = if kind == ProblemKind::Missing { String::new() } else { shown(value) };
        Self { field: field.to_owned(), kind, value, allowed, advisory: false }
    }
}

/// Writes one line, such as ``field `speed` is -1; allowed is a number, at least 0 deg/s``.
impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { field, kind, value, allowed, advisory } = self;
        match kind {
            ProblemKind::Unknown => write!(f, "there is no field `{field}`; {allowed}")?,
            ProblemKind::Missing => write!(f, "field `{field}` is missing; allowed is {allowed}")?,
            ProblemKind::Repeated => write!(f, "field `{field}` is given twice, also as {value}")?,
            ProblemKind::Forbidden => write!(f, "field `{field}` is {value}; allowed is {allowed}")?,
        }
        if *advisory { f.write_str("; this is advisory") } else { Ok(()) }
    }
}

impl std::error::Error for Problem {}

/// Returns the JSON of a value, or the beginning of it.
pub(super) fn shown(value: &Value) -> String {
    excerpt(&value.to_string())
}

/// Returns the path of a field inside the value at `outer`.
pub(super) fn member(outer: &str, name: &str) -> String {
    if outer.is_empty() { name.to_owned() } else { format!("{outer}.{name}") }
}

/// Returns the path of an element of the array at `outer`.
pub(super) fn element(outer: &str, index: usize) -> String {
    format!("{outer}[{index}]")
}
