//! What is checked before a request is sent.

use std::fmt;

use crate::wire::Typed;

/// What a number or text may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Least value allowed.
    pub min: Option<f64>,
    /// Greatest value allowed.
    pub max: Option<f64>,
    /// True where newer firmware takes more than this.
    pub advisory: bool,
    /// True for text that may hold printable ASCII only.
    pub ascii: bool,
    /// Unit of the limits.
    pub unit: &'static str,
}

impl Limits {
    /// Any finite number, any text.
    pub const NONE: Self = Self { min: None, max: None, advisory: false, ascii: false, unit: "" };

    fn allows(&self, value: f64) -> bool {
        self.min.is_none_or(|min| value >= min) && self.max.is_none_or(|max| value <= max)
    }
}

/// In words, such as `0 to 1` or `at least 0 deg/s`.
impl fmt::Display for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.min, self.max) {
            (Some(min), Some(max)) => write!(f, "{min} to {max}")?,
            (Some(min), None) => write!(f, "at least {min}")?,
            (None, Some(max)) => write!(f, "at most {max}")?,
            (None, None) => f.write_str("a finite number")?,
        }
        match self.unit {
            "" => Ok(()),
            unit if self.min.is_none() && self.max.is_none() => write!(f, " (in {unit})"),
            unit => write!(f, " {unit}"),
        }
    }
}

/// Whether ranges are enforced that newer firmware has widened.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AdvisoryRanges {
    /// They are enforced like all others.
    #[default]
    Enforced,
    /// They are left to the controller.
    Ignored,
}

/// A request that the spec forbids. Nothing was sent.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct InvalidArgument {
    /// `cmdName` of the request.
    pub command: String,
    /// The field's Rust name, such as `pose.x`.
    pub field: String,
    /// The value given.
    pub value: String,
    /// What is allowed.
    pub allowed: String,
    /// True where newer firmware may take the value, and the check can be switched off.
    pub advisory: bool,
}

impl InvalidArgument {
    /// An argument that is refused before it is sent.
    pub fn new(
        command: impl Into<String>,
        field: impl Into<String>,
        value: impl Into<String>,
        allowed: impl Into<String>,
        advisory: bool,
    ) -> Self {
        let (command, field) = (command.into(), field.into());
        Self { command, field, value: value.into(), allowed: allowed.into(), advisory }
    }
}

impl fmt::Display for InvalidArgument {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { command, field, value, allowed, advisory } = self;
        write!(f, "`{command}` was not sent: field `{field}` is {value}, allowed is {allowed}")?;
        if *advisory { f.write_str("; newer firmware may take it (see `AdvisoryRanges`)") } else { Ok(()) }
    }
}

impl std::error::Error for InvalidArgument {}

/// A place inside a request, from which its fields are checked.
#[derive(Debug, Clone, Copy)]
pub struct Place<'p> {
    command: &'static str,
    name: PlaceName,
    outer: Option<&'p Place<'p>>,
    ranges: AdvisoryRanges,
}

#[derive(Debug, Clone, Copy)]
enum PlaceName {
    Request,
    Field(&'static str),
    Element(usize),
}

impl<'p> Place<'p> {
    /// The request as a whole.
    pub fn request(command: &'static str, ranges: AdvisoryRanges) -> Self {
        Self { command, name: PlaceName::Request, outer: None, ranges }
    }

    /// Checks a field of what stands here.
    ///
    /// # Errors
    /// The field holds what the spec forbids.
    pub fn check<T: Validate>(&'p self, name: &'static str, value: &T, limits: &Limits) -> Result<(), InvalidArgument> {
        value.validate(&self.inner(PlaceName::Field(name)), limits)
    }

    fn inner(&'p self, name: PlaceName) -> Place<'p> {
        Self { command: self.command, name, outer: Some(self), ranges: self.ranges }
    }

    fn path(&self) -> String {
        let outer = self.outer.map(Self::path).unwrap_or_default();
        match self.name {
            PlaceName::Request => outer,
            PlaceName::Field(name) if outer.is_empty() => name.to_owned(),
            PlaceName::Field(name) => format!("{outer}.{name}"),
            PlaceName::Element(index) => format!("{outer}[{index}]"),
        }
    }

    fn invalid(&self, value: impl Into<String>, allowed: impl Into<String>, advisory: bool) -> InvalidArgument {
        InvalidArgument::new(self.command, self.path(), value, allowed, advisory)
    }

    fn number(&self, value: f64, limits: &Limits) -> Result<(), InvalidArgument> {
        if !value.is_finite() {
            return Err(self.invalid(value.to_string(), limits.to_string(), false));
        }
        if limits.allows(value) || (limits.advisory && self.ranges == AdvisoryRanges::Ignored) {
            return Ok(());
        }
        Err(self.invalid(value.to_string(), limits.to_string(), limits.advisory))
    }

    /// Checks a value of an enum: `known` is true for the listed values, `advisory` for those of newer firmware.
    ///
    /// # Errors
    /// The value is not listed, or only newer firmware takes it.
    pub fn listed(&self, value: &dyn fmt::Display, standing: Standing, allowed: &str) -> Result<(), InvalidArgument> {
        match standing {
            Standing::Listed => Ok(()),
            Standing::Advisory if self.ranges == AdvisoryRanges::Ignored => Ok(()),
            Standing::Advisory => Err(self.invalid(value.to_string(), allowed, true)),
            Standing::Unknown => Err(self.invalid(value.to_string(), allowed, false)),
        }
    }
}

/// How the spec knows a value of an enum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Standing {
    /// Every firmware takes it.
    Listed,
    /// Only newer firmware takes it.
    Advisory,
    /// The spec does not know it.
    Unknown,
}

/// A value that can be checked against the spec.
pub trait Validate {
    /// Checks the value, which stands at `place`.
    ///
    /// # Errors
    /// The spec forbids the value.
    fn validate(&self, place: &Place<'_>, limits: &Limits) -> Result<(), InvalidArgument>;
}

impl Validate for f64 {
    fn validate(&self, place: &Place<'_>, limits: &Limits) -> Result<(), InvalidArgument> {
        place.number(*self, limits)
    }
}

impl Validate for i64 {
    #[expect(clippy::cast_precision_loss, reason = "limits are small whole numbers; rounding moves none across them")]
    fn validate(&self, place: &Place<'_>, limits: &Limits) -> Result<(), InvalidArgument> {
        place.number(*self as f64, limits)
    }
}

impl Validate for bool {
    fn validate(&self, _place: &Place<'_>, _limits: &Limits) -> Result<(), InvalidArgument> {
        Ok(())
    }
}

impl Validate for String {
    fn validate(&self, place: &Place<'_>, limits: &Limits) -> Result<(), InvalidArgument> {
        let printable = self.bytes().all(|b| b == b' ' || b.is_ascii_graphic());
        if limits.ascii && !printable {
            return Err(place.invalid(format!("`{self}`"), "printable ASCII", limits.advisory));
        }
        Ok(())
    }
}

impl Validate for serde_json::Value {
    fn validate(&self, _place: &Place<'_>, _limits: &Limits) -> Result<(), InvalidArgument> {
        Ok(())
    }
}

/// What is given as raw JSON is not checked.
impl<T: Validate> Validate for Typed<T> {
    fn validate(&self, place: &Place<'_>, limits: &Limits) -> Result<(), InvalidArgument> {
        self.known().map_or(Ok(()), |value| value.validate(place, limits))
    }
}

impl<T: Validate> Validate for Option<T> {
    fn validate(&self, place: &Place<'_>, limits: &Limits) -> Result<(), InvalidArgument> {
        self.as_ref().map_or(Ok(()), |value| value.validate(place, limits))
    }
}

impl<T: Validate> Validate for [T] {
    fn validate(&self, place: &Place<'_>, limits: &Limits) -> Result<(), InvalidArgument> {
        let each = |(index, item): (usize, &T)| item.validate(&place.inner(PlaceName::Element(index)), limits);
        self.iter().enumerate().try_for_each(each)
    }
}

impl<T: Validate> Validate for Vec<T> {
    fn validate(&self, place: &Place<'_>, limits: &Limits) -> Result<(), InvalidArgument> {
        self.as_slice().validate(place, limits)
    }
}

impl<T: Validate, const N: usize> Validate for [T; N] {
    fn validate(&self, place: &Place<'_>, limits: &Limits) -> Result<(), InvalidArgument> {
        self.as_slice().validate(place, limits)
    }
}
