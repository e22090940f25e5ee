//! Checks of a request before it is sent.

use std::fmt;

use crate::firmware::{FirmwareRange, FirmwareVersion, NotInFirmware};
use crate::wire::Typed;

/// Limits of the values of a field, and the firmware that has the field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldLimits<'u> {
    /// Least value allowed.
    pub min: Option<f64>,
    /// Greatest value allowed.
    pub max: Option<f64>,
    /// True if newer firmware takes more than the range.
    pub advisory: bool,
    /// Advisory bounds of numbers, in addition to the range.
    pub advised: Advised<'u>,
    /// True for text that may hold printable ASCII only.
    pub ascii: bool,
    /// Unit of the limits.
    pub unit: &'u str,
    /// The firmware that has the field.
    pub firmware: FirmwareRange,
}

/// Advisory bound of a number, which [`AdvisoryRanges::Ignored`] leaves to the controller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Advice<'u> {
    /// Greatest magnitude.
    pub max: f64,
    /// True if the number should not be zero either.
    pub nonzero: bool,
    /// Unit of the numbers concerned; empty for all numbers of the field.
    pub unit: &'u str,
}

/// Advisory bounds of the numbers of a field: at most one [`Advice`] for each unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Advised<'u> {
    rows: &'u [Advice<'u>],
    times: f64,
}

impl FieldLimits<'_> {
    /// Any finite number, any text, in any firmware.
    pub const NONE: Self = Self {
        min: None,
        max: None,
        advisory: false,
        advised: Advised::NONE,
        ascii: false,
        unit: "",
        firmware: FirmwareRange::ALL,
    };

    /// True for a number within the range, also beyond advice.
    pub fn allow(&self, value: f64) -> bool {
        self.min.is_none_or(|min| value >= min) && self.max.is_none_or(|max| value <= max)
    }

    /// True for a number that may be sent: one within the range, or any number where newer firmware takes more and that
    /// is left to the controller.
    pub fn permit(&self, value: f64, ranges: AdvisoryRanges) -> bool {
        self.allow(value) || self.advisory && ranges == AdvisoryRanges::Ignored
    }

    /// True for a number within the advice.
    pub fn advise(&self, value: f64) -> bool {
        self.advised.allow(value, self.unit)
    }

    /// True if numbers have a least or a greatest value.
    pub fn are_bounded(&self) -> bool {
        let (min, max, _) = self.ends();
        min.is_some() || max.is_some()
    }

    /// The ends of the range within the advice, and whether zero is excluded.
    fn ends(&self) -> (Option<f64>, Option<f64>, bool) {
        let Some(advice) = self.advised.of(self.unit) else { return (self.min, self.max, false) };
        let min = self.min.map_or(-advice.max, |min| min.max(-advice.max));
        let max = self.max.map_or(advice.max, |max| max.min(advice.max));
        (Some(min), Some(max), advice.nonzero)
    }

    /// True for text that may be sent.
    pub fn allow_text(&self, text: &str) -> bool {
        !self.ascii || text.bytes().all(|b| b == b' ' || b.is_ascii_graphic())
    }
}

/// In words, such as `0 to 1`, `at least 0 deg/s` or `more than 0, at most 265 deg/s`.
impl fmt::Display for FieldLimits<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (min, max, nonzero) = self.ends();
        match (min, max) {
            (Some(0.0), Some(max)) if nonzero => write!(f, "more than 0, at most {max}")?,
            (Some(min), Some(max)) => write!(f, "{min} to {max}")?,
            (Some(min), None) => write!(f, "at least {min}")?,
            (None, Some(max)) => write!(f, "at most {max}")?,
            (None, None) => f.write_str("a finite number")?,
        }
        match self.unit {
            "" => {}
            unit if min.is_none() && max.is_none() => write!(f, " (in {unit})")?,
            unit => write!(f, " {unit}")?,
        }
        if nonzero && min != Some(0.0) { f.write_str(", not 0") } else { Ok(()) }
    }
}

/// Treatment of advisory ranges: ranges that newer firmware has widened, and ranges that are only advised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AdvisoryRanges {
    /// The check enforces them like all other ranges.
    #[default]
    Enforced,
    /// The check leaves them to the controller.
    Ignored,
}

/// Rules for the check of a request, in addition to the spec.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rules {
    /// Treatment of advisory ranges.
    pub ranges: AdvisoryRanges,
    /// The controller's firmware, for requests to be refused that it does not have; none for any.
    pub firmware: Option<FirmwareVersion>,
}

impl From<AdvisoryRanges> for Rules {
    fn from(ranges: AdvisoryRanges) -> Self {
        Self { ranges, firmware: None }
    }
}

crate::worded! {
    /// Reason for which a request is not sent.
    #[derive(Debug, Clone, PartialEq, Eq)]
    pub enum NotSent {
        /// The spec forbids it.
        InvalidArgument(invalid: InvalidArgument) => "{invalid}",
        /// The controller's firmware does not have it.
        NotInFirmware(missing: Box<NotInFirmware>) => "{missing}",
    }
}

impl std::error::Error for NotSent {}

impl From<InvalidArgument> for NotSent {
    fn from(invalid: InvalidArgument) -> Self {
        Self::InvalidArgument(invalid)
    }
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
    /// Allowed values, in words.
    pub allowed: String,
    /// True if [`AdvisoryRanges`] can switch the check off: newer firmware may take the value, or the document only
    /// advises against it.
    pub advisory: bool,
}

impl InvalidArgument {
    /// Value that no firmware takes.
    pub fn new(
        command: impl Into<String>,
        field: impl Into<String>,
        value: impl Into<String>,
        allowed: impl Into<String>,
    ) -> Self {
        let (command, field) = (command.into(), field.into());
        Self { command, field, value: value.into(), allowed: allowed.into(), advisory: false }
    }

    /// Marks the value as refused by an advisory range.
    #[must_use]
    pub fn in_advisory_range(self) -> Self {
        Self { advisory: true, ..self }
    }
}

impl fmt::Display for InvalidArgument {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { command, field, value, allowed, advisory } = self;
        write!(f, "`{command}` was not sent: field `{field}` is {value}, allowed is {allowed}")?;
        if *advisory {
            f.write_str("; this is advisory: `AdvisoryRanges::Ignored` leaves it to the controller")
        } else {
            Ok(())
        }
    }
}

impl std::error::Error for InvalidArgument {}

/// A place inside a request, from which its fields are checked.
#[derive(Debug, Clone, Copy)]
pub struct Place<'p> {
    command: &'static str,
    name: PlaceName,
    outer: Option<&'p Place<'p>>,
    rules: Rules,
    /// Advisory bounds of the numbers here, unless a field in between has its own.
    advised: Advised<'p>,
}

#[derive(Debug, Clone, Copy)]
enum PlaceName {
    Request,
    Field(&'static str),
    Element(usize),
}

impl<'p> Place<'p> {
    /// The request as a whole.
    pub fn request(command: &'static str, rules: Rules) -> Self {
        Self { command, name: PlaceName::Request, outer: None, rules, advised: Advised::NONE }
    }

    /// Checks a field of this item.
    ///
    /// # Errors
    /// The field holds what the spec forbids, or holds something and the controller's firmware does not have it.
    // Not generic, or each type of a field would compile a copy.
    pub fn check(&'p self, name: &'static str, value: &dyn Validate, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        let mut place = self.inner(PlaceName::Field(name));
        if !limits.advised.is_none() && self.rules.ranges == AdvisoryRanges::Enforced {
            place.advised = limits.advised;
        }
        if value.is_present() {
            place.exists(&limits.firmware)?;
        }
        value.validate(&place, limits)
    }

    /// Checks that the controller's firmware has this item, if the firmware is known.
    pub(crate) fn exists(&self, range: &FirmwareRange) -> Result<(), NotSent> {
        let Some(firmware) = self.rules.firmware.filter(|firmware| !range.contains(*firmware)) else {
            return Ok(());
        };
        let field = Some(self.path()).filter(|path| !path.is_empty());
        Err(NotSent::NotInFirmware(Box::new(NotInFirmware::new(self.command, field, firmware, *range))))
    }

    /// Checks that the controller's firmware takes a value of an enum, if the firmware is known.
    ///
    /// # Errors
    /// It does not.
    pub fn takes(&self, value: &dyn fmt::Display, range: &FirmwareRange) -> Result<(), NotSent> {
        self.exists(range).map_err(|missing| match missing {
            NotSent::NotInFirmware(missing) => NotSent::NotInFirmware(Box::new(missing.with_value(value.to_string()))),
            other @ NotSent::InvalidArgument(_) => other,
        })
    }

    fn inner(&'p self, name: PlaceName) -> Place<'p> {
        Self { command: self.command, name, outer: Some(self), rules: self.rules, advised: self.advised }
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

    fn invalid(&self, value: impl Into<String>, allowed: impl Into<String>) -> InvalidArgument {
        InvalidArgument::new(self.command, self.path(), value, allowed)
    }

    fn number(&self, value: f64, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        if !value.is_finite() {
            return Err(self.invalid(value.to_string(), limits.to_string()).into());
        }
        let is_permitted = limits.permit(value, self.rules.ranges);
        if is_permitted && self.advised.allow(value, limits.unit) {
            return Ok(());
        }
        let limits = FieldLimits { advised: self.advised, ..*limits };
        let invalid = self.invalid(value.to_string(), limits.to_string());
        Err(if limits.advisory || is_permitted { invalid.in_advisory_range() } else { invalid }.into())
    }

    /// Checks that no element of an array is omitted before a given one, which would take its place.
    ///
    /// # Errors
    /// There is such an element. Each is given by its name, and whether it is there.
    pub fn no_gap(&'p self, elements: &[(&'static str, bool)]) -> Result<(), NotSent> {
        let given = elements.iter().rposition(|(_, is_given)| *is_given).unwrap_or_default();
        let Some((name, _)) = elements[..given].iter().find(|(_, is_given)| !is_given) else { return Ok(()) };
        let allowed = "a value, since a later one is given";
        Err(self.inner(PlaceName::Field(name)).invalid("left out", allowed).into())
    }

    /// Checks a value of an enum: `known` is true for the listed values, `advisory` for those of newer firmware.
    ///
    /// # Errors
    /// The value is not listed, or only newer firmware takes it.
    pub fn listed(&self, value: &dyn fmt::Display, standing: Standing, allowed: &str) -> Result<(), NotSent> {
        match standing {
            Standing::Listed => Ok(()),
            Standing::Advisory if self.rules.ranges == AdvisoryRanges::Ignored => Ok(()),
            Standing::Advisory => Err(self.invalid(value.to_string(), allowed).in_advisory_range().into()),
            Standing::Unknown => Err(self.invalid(value.to_string(), allowed).into()),
        }
    }
}

/// Status of a value of an enum in the spec.
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
    /// The spec forbids the value, or the controller's firmware does not have a field of it.
    fn validate(&self, place: &Place<'_>, limits: &FieldLimits<'_>) -> Result<(), NotSent>;

    /// False for an optional value that is left out.
    fn is_present(&self) -> bool {
        true
    }
}

impl Validate for f64 {
    fn validate(&self, place: &Place<'_>, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        place.number(*self, limits)
    }
}

impl Validate for i64 {
    #[expect(clippy::cast_precision_loss, reason = "limits are small whole numbers; rounding moves none across them")]
    fn validate(&self, place: &Place<'_>, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        place.number(*self as f64, limits)
    }
}

impl Validate for bool {
    fn validate(&self, _place: &Place<'_>, _limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        Ok(())
    }
}

impl Validate for String {
    fn validate(&self, place: &Place<'_>, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        if !limits.allow_text(self) {
            let invalid = place.invalid(format!("`{self}`"), "printable ASCII");
            return Err(if limits.advisory { invalid.in_advisory_range() } else { invalid }.into());
        }
        Ok(())
    }
}

impl Validate for serde_json::Value {
    fn validate(&self, _place: &Place<'_>, _limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        Ok(())
    }
}

/// Checks a typed value; raw JSON is not checked.
impl<T: Validate> Validate for Typed<T> {
    fn validate(&self, place: &Place<'_>, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        self.known().map_or(Ok(()), |value| value.validate(place, limits))
    }
}

impl<T: Validate> Validate for Option<T> {
    fn validate(&self, place: &Place<'_>, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        self.as_ref().map_or(Ok(()), |value| value.validate(place, limits))
    }

    fn is_present(&self) -> bool {
        self.is_some()
    }
}

impl<T: Validate> Validate for [T] {
    fn validate(&self, place: &Place<'_>, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        let each = |(index, item): (usize, &T)| item.validate(&place.inner(PlaceName::Element(index)), limits);
        self.iter().enumerate().try_for_each(each)
    }
}

impl<T: Validate> Validate for Vec<T> {
    fn validate(&self, place: &Place<'_>, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        self.as_slice().validate(place, limits)
    }
}

impl<T: Validate, const N: usize> Validate for [T; N] {
    fn validate(&self, place: &Place<'_>, limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        self.as_slice().validate(place, limits)
    }
}

impl<'u> Advised<'u> {
    /// Nothing.
    pub const NONE: Self = Self::to(&[]);

    /// These rows.
    pub const fn to(rows: &'u [Advice<'u>]) -> Self {
        Self { rows, times: 1.0 }
    }

    /// Multiplies the bounds by `count`, or by one where `count` is absent or not positive.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "counts are small whole numbers")]
    pub fn times(self, count: impl Into<Option<i64>>) -> Self {
        Self { times: count.into().unwrap_or(1).max(1) as f64, ..self }
    }

    /// True if nothing is advised.
    pub const fn is_none(&self) -> bool {
        self.rows.is_empty()
    }

    /// True for a number in this unit that is within the bounds.
    fn allow(&self, value: f64, unit: &str) -> bool {
        self.of(unit).is_none_or(|row| value.abs() <= row.max && !(row.nonzero && value == 0.0))
    }

    /// Returns the advisory bound of a number in this unit, multiplied by the count.
    fn of(&self, unit: &str) -> Option<Advice<'u>> {
        let row = self.rows.iter().find(|row| row.unit.is_empty() || row.unit == unit)?;
        Some(Advice { max: row.max * self.times, ..*row })
    }
}
