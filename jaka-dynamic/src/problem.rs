//! Problem in a request.

use std::fmt;

use jaka_proto::text::excerpt;
use serde_json::Value;

/// One thing in a request that the spec forbids.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Problem {
    /// The field concerned, such as `pose.x`.
    pub field: String,
    /// Kind of the problem.
    pub kind: ProblemKind,
    /// The value given, as JSON; empty where none was.
    pub value: String,
    /// Description of the allowed values; for an unknown field, of the fields that exist.
    pub allowed: String,
    /// True where the check can be switched off: newer firmware may take the value, or it is only advised against.
    pub advisory: bool,
}

/// Kind of a problem with a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProblemKind {
    /// There is no such field.
    Unknown,
    /// The field must be given and is not.
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

/// One line, such as ``field `speed` is -1; allowed is a number, at least 0 deg/s``.
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

/// The JSON of a value, or the beginning of it.
pub(super) fn shown(value: &Value) -> String {
    excerpt(&value.to_string())
}

/// The path of a field inside what stands at `outer`.
pub(super) fn member(outer: &str, name: &str) -> String {
    if outer.is_empty() { name.to_owned() } else { format!("{outer}.{name}") }
}

/// The path of an element of the array at `outer`.
pub(super) fn element(outer: &str, index: usize) -> String {
    format!("{outer}[{index}]")
}
