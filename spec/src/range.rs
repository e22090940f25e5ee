//! Limits of numbers.

/// An inclusive range, open at an end that is `None`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Range {
    /// Least value allowed.
    pub min: Option<f64>,
    /// Greatest value allowed.
    pub max: Option<f64>,
    /// True if newer firmware takes more than this.
    pub advisory: bool,
}

/// Limits of a field's numbers that are enforced unless the caller leaves them to the controller.
#[derive(Debug, Clone, PartialEq)]
pub struct Advice {
    /// Greatest magnitude.
    pub max: f64,
    /// True if the number should not be zero either.
    pub nonzero: bool,
    /// Unit of the bounded numbers, if the field has numbers of several units.
    pub unit: Option<String>,
    /// Condition under which it holds; `None` if it always holds.
    pub when: Option<Condition>,
    /// Name in Rust of the whole number by which `max` is multiplied; 1 where that is left out.
    pub per: Option<String>,
}

/// Condition that another field, an enum of whole numbers, has a certain value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Condition {
    /// The other field's name in Rust.
    pub field: String,
    /// The value on the wire.
    pub value: i64,
}

impl Advice {
    /// The part of a range that it leaves.
    pub fn within(&self, range: Range) -> Range {
        let min = range.min.map_or(-self.max, |min| min.max(-self.max));
        let max = range.max.map_or(self.max, |max| max.min(self.max));
        Range { min: Some(min), max: Some(max), ..range }
    }
}
