//! Difference between a message and the spec.

use std::fmt;

use jaka_proto::wire::DecodeError;

/// Difference between a message and the spec.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Departure {
    /// Place in the message, by the keys on the wire and the names of elements, such as `torqsensor[0]` or
    /// `actual_position.rx`; empty for the message as a whole.
    pub field: String,
    /// Kind of the difference.
    pub kind: DepartureKind,
    /// Value found there, as JSON; empty if there is none.
    pub found: String,
    /// Form that the spec expects there; for an unknown key, the apparent type of the value, in the spec's notation.
    pub expected: String,
    /// Effect of the difference on decoding.
    pub reading: Reading,
    /// Whether it is a number outside a range that newer firmware has widened.
    pub advisory: bool,
    /// Number of further elements of the same array that differ in the same way.
    pub more: usize,
}

impl Departure {
    /// Returns the decoder's error for it.
    pub fn error(&self) -> DecodeError {
        if self.kind == DepartureKind::Missing {
            let key = self.field.rsplit('.').next().unwrap_or_default().to_owned();
            return DecodeError::missing(&self.field, key);
        }
        DecodeError::unfit(self.expected.as_str(), &self.found).in_field(&self.field)
    }
}

/// Kind of a difference between a message and the spec.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum DepartureKind {
    /// A required key or element is missing, or is null.
    Missing,
    /// The spec does not have the key.
    Unknown,
    /// The value is of another JSON type, or written in another form.
    Form,
    /// The array has another length.
    Length,
    /// The number is out of range, or the text has characters beyond ASCII.
    Range,
    /// The enum or choice does not list the value.
    Unlisted,
}

/// Effect of a difference on decoding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    /// The value decodes to the same value or to raw JSON, or the decoder skips it.
    Lenient,
    /// The value does not decode, and so neither does the message; in a status packet, the decoder leaves the field
    /// out.
    Unreadable,
}

/// Writes one line, such as ``lenient: `speed` is "20"; expected is a number (in mm/s)``.
impl fmt::Display for Departure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { field, kind, found, expected, reading, more, .. } = self;
        f.write_str(match reading {
            Reading::Lenient => "lenient: ",
            Reading::Unreadable => "unreadable: ",
        })?;
        if field.is_empty() { f.write_str("the message") } else { write!(f, "`{field}`") }?;
        match kind {
            DepartureKind::Missing => write!(f, " is missing; expected is {expected}"),
            DepartureKind::Unknown => write!(f, " is not in the spec; it looks like `{expected}`: {found}"),
            DepartureKind::Unlisted => write!(f, " is {found}; the spec lists {expected}"),
            DepartureKind::Length => write!(f, " has another length; expected is {expected}: {found}"),
            DepartureKind::Form | DepartureKind::Range => write!(f, " is {found}; expected is {expected}"),
        }?;
        if *more == 0 { Ok(()) } else { write!(f, " (and {more} more like it)") }
    }
}
