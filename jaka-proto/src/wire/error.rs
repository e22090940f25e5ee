//! Error for a message that could not be decoded.

use std::borrow::Cow;
use std::fmt::{self, Write};

use crate::text::{VisibleWriter, excerpt};

/// A message, or a field of one, that does not fit its type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DecodeError(Box<Inner>);

#[derive(Debug, Clone, PartialEq, Eq)]
struct Inner {
    path: String,
    kind: Kind,
}

crate::worded! {
    #[derive(Debug, Clone, PartialEq, Eq)]
    enum Kind {
        Malformed { expected: &'static str, offset: usize, found: String } => (malformed(expected, *offset, found)),
        Unfit { expected: String, found: String } => "expected {expected}, found `{found}`",
        Missing { key: Cow<'static, str> } => (missing(key)),
        Repeated => "the key appears twice",
    }
}

fn malformed(expected: &str, offset: usize, found: &str) -> String {
    if found.is_empty() {
        format!("not JSON: expected {expected} at byte {offset}, where the text ends")
    } else {
        format!("not JSON: expected {expected} at byte {offset}, found `{found}`")
    }
}

fn missing(key: &str) -> String {
    if key.is_empty() { "the element is missing".to_owned() } else { format!("the key `{key}` is missing") }
}

impl DecodeError {
    /// The text is not JSON: at `offset` there is something other than `expected`.
    pub(crate) fn malformed(text: &str, offset: usize, expected: &'static str) -> Self {
        Self::new(Kind::Malformed { expected, offset, found: excerpt(text.get(offset..).unwrap_or("")) })
    }

    /// The value is JSON, but does not fit the type.
    pub fn unfit(expected: impl Into<String>, found: &str) -> Self {
        Self::new(Kind::Unfit { expected: expected.into(), found: excerpt(found) })
    }

    /// The key is absent, or its value is null.
    pub fn missing(field: &str, key: impl Into<Cow<'static, str>>) -> Self {
        Self::new(Kind::Missing { key: key.into() }).in_field(field)
    }

    pub(crate) fn repeated() -> Self {
        Self::new(Kind::Repeated)
    }

    fn new(kind: Kind) -> Self {
        Self(Box::new(Inner { path: String::new(), kind }))
    }

    /// Puts the name of an outer field before the path of the error.
    #[must_use]
    pub fn in_field(self, field: &str) -> Self {
        self.outside(field)
    }

    /// Puts the index in an outer array before the path of the error.
    #[must_use]
    pub fn in_element(self, index: usize) -> Self {
        self.outside(&format!("[{index}]"))
    }

    fn outside(mut self, outer: &str) -> Self {
        let path = &mut self.0.path;
        let dot = if path.is_empty() || path.starts_with('[') { "" } else { "." };
        *path = format!("{outer}{dot}{path}");
        self
    }

    /// The field concerned, such as `torque_sensor.settings`; empty for the message as a whole. [`is_in`](Self::is_in)
    /// asks for the outermost field.
    pub fn field(&self) -> &str {
        &self.0.path
    }

    /// True if the error concerns this field of the message, or something inside it.
    ///
    /// ```
    /// # use jaka_proto::wire::DecodeError;
    /// let error = DecodeError::unfit("a number", "\"x\"").in_element(2).in_field("joint_actual_position");
    /// assert_eq!(error.field(), "joint_actual_position[2]");
    /// assert!(error.is_in("joint_actual_position") && !error.is_in("joint"));
    /// ```
    pub fn is_in(&self, field: &str) -> bool {
        let inner = self.0.path.strip_prefix(field).filter(|_| !field.is_empty());
        inner.is_some_and(|inner| inner.is_empty() || inner.starts_with(['.', '[']))
    }

    /// True if the text is not JSON at all, rather than JSON of another shape.
    pub fn is_malformed(&self) -> bool {
        matches!(self.0.kind, Kind::Malformed { .. })
    }
}

/// In one line, for any message: see [`text`](crate::text).
impl fmt::Display for DecodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Inner { path, kind } = &*self.0;
        if !path.is_empty() {
            write!(VisibleWriter(&mut *f), "field `{path}`: ")?;
        }
        write!(f, "{kind}")
    }
}

impl std::error::Error for DecodeError {}
