//! Scalars in JSON, in the spec's form or in another one that controllers use, read by the codec of jaka-proto.
//!
//! This module has everything that this crate knows of one kind of scalar.

use jaka_proto::ErrorCode;
use jaka_proto::check::{AdvisoryRanges, FieldLimits};
use jaka_proto::wire::{Decode, Reader, Writer};
use jaka_spec::Scalar;
use serde_json::{Map, Value};

use super::departure::DepartureKind;

/// Fit of a value to a scalar.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fit {
    /// The value has the spec's form.
    Plain,
    /// The value decodes, with this departure from the spec.
    Lenient(DepartureKind),
    /// The value does not decode, because of this departure.
    Unreadable(DepartureKind),
}

impl Fit {
    fn of(is_plain: bool) -> Self {
        if is_plain { Self::Plain } else { Self::Lenient(DepartureKind::Form) }
    }
}

/// Returns the fit of a value to a scalar within limits.
pub(crate) fn fit(scalar: &Scalar, limits: &FieldLimits<'_>, value: &Value) -> Fit {
    let fit = match scalar {
        Scalar::Bool { off, on } => truth(value, off, on).map(|(_, fit)| fit),
        #[expect(clippy::cast_precision_loss, reason = "limits are small; rounding moves none across them")]
        Scalar::Int => int(value).map(|(int, fit)| within(limits, int as f64, fit)),
        Scalar::Float => float(value).map(|(float, fit)| within(limits, float, fit)),
        Scalar::Text if value.as_str().is_some_and(|text| !limits.allow_text(text)) => {
            Some(Fit::Lenient(DepartureKind::Range))
        }
        Scalar::Text => value.is_string().then_some(Fit::Plain),
        Scalar::Json => Some(Fit::Plain),
    };
    fit.unwrap_or(Fit::Unreadable(DepartureKind::Form))
}

fn within(limits: &FieldLimits<'_>, number: f64, fit: Fit) -> Fit {
    if limits.allow(number) && limits.advise(number) { fit } else { Fit::Lenient(DepartureKind::Range) }
}

/// Returns the value of a scalar from any of its forms: a truth value as true or false, a number as a number; `None` if
/// it does not fit.
pub(crate) fn read(scalar: &Scalar, value: &Value) -> Option<Value> {
    match scalar {
        Scalar::Bool { off, on } => truth(value, off, on).map(|(is_on, _)| is_on.into()),
        Scalar::Int => int(value).map(|(int, _)| int.into()),
        Scalar::Float if value.is_number() => Some(value.clone()),
        Scalar::Float => float_value(value).map(Value::from),
        Scalar::Text | Scalar::Json => Some(value.clone()),
    }
}

/// Reason why a value may not be sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Forbidden {
    /// The value does not fit its type or its range.
    Always,
    /// The value is outside of advised ranges or of those of older firmware; newer firmware may take it.
    Advisory,
}

/// Writes a value in the spec's form, if it may be sent; a truth value may also be true or false.
pub(crate) fn write(
    scalar: &Scalar,
    limits: &FieldLimits<'_>,
    ranges: AdvisoryRanges,
    value: &Value,
    out: &mut Writer,
) -> Result<(), Forbidden> {
    // A value that is only advised against is in range.
    let is_advisory = value.as_f64().is_some_and(|number| limits.advisory || limits.allow(number));
    match fit(scalar, limits, value) {
        Fit::Plain => {}
        Fit::Lenient(DepartureKind::Form) if value.is_boolean() => {}
        Fit::Lenient(DepartureKind::Range) if is_advisory && ranges == AdvisoryRanges::Ignored => {}
        Fit::Lenient(DepartureKind::Range) => {
            return Err(if is_advisory { Forbidden::Advisory } else { Forbidden::Always });
        }
        Fit::Lenient(_) | Fit::Unreadable(_) => return Err(Forbidden::Always),
    }
    let written = match scalar {
        Scalar::Bool { off, on } => truth(value, off, on).map(|(is_on, _)| out.choose(is_on, off, on)),
        Scalar::Int => value.as_i64().map(|int| out.int(int)),
        Scalar::Float => value.as_f64().map(|float| out.float(float)),
        Scalar::Text => value.as_str().map(|text| out.text(text)),
        Scalar::Json => {
            out.json(value);
            Some(())
        }
    };
    written.ok_or(Forbidden::Always)
}

/// Reads text typed on a command line, as if a controller had sent it as a string.
pub(crate) fn typed(scalar: &Scalar, text: &str) -> Option<Value> {
    let word = text.trim();
    match scalar {
        Scalar::Bool { .. } if word.eq_ignore_ascii_case("on") => Some(true.into()),
        Scalar::Bool { .. } if word.eq_ignore_ascii_case("off") => Some(false.into()),
        Scalar::Bool { off, on } => truth(&word.into(), off, on).map(|(is_on, _)| is_on.into()),
        Scalar::Int => int(&word.into()).map(|(int, _)| int.into()),
        Scalar::Float => float(&word.into()).map(|(float, _)| float.into()),
        Scalar::Text => Some(text.into()),
        Scalar::Json => Some(serde_json::from_str(text).unwrap_or_else(|_| text.into())),
    }
}

/// Returns the placeholder for a value, such as `NUMBER`.
pub(crate) fn hint(scalar: &Scalar) -> &'static str {
    match scalar {
        Scalar::Bool { .. } => "on|off",
        Scalar::Int => "INTEGER",
        Scalar::Float => "NUMBER",
        Scalar::Text => "TEXT",
        Scalar::Json => "JSON",
    }
}

/// Describes the allowed values, such as `a number, at least 0 deg/s`.
pub(crate) fn words(scalar: &Scalar, limits: &FieldLimits<'_>) -> String {
    match scalar {
        Scalar::Bool { off, on } => format!("{off} or {on}"),
        Scalar::Int => number_words("a whole number", limits),
        Scalar::Float => number_words("a number", limits),
        Scalar::Text if limits.ascii => "text of printable ASCII".to_owned(),
        Scalar::Text => "text".to_owned(),
        Scalar::Json => "any JSON".to_owned(),
    }
}

fn number_words(noun: &str, limits: &FieldLimits<'_>) -> String {
    match limits.unit {
        _ if limits.are_bounded() => format!("{noun}, {limits}"),
        "" => noun.to_owned(),
        unit => format!("{noun} (in {unit})"),
    }
}

/// Returns false, zero, or an empty value.
pub(crate) fn zero(scalar: &Scalar) -> Value {
    match scalar {
        Scalar::Bool { off, .. } => serde_json::from_str(off).unwrap_or_default(),
        Scalar::Int | Scalar::Float => 0.into(),
        Scalar::Text => "".into(),
        Scalar::Json => Map::new().into(),
    }
}

/// Reads a finite number.
fn float(value: &Value) -> Option<(f64, Fit)> {
    Some((decoded(value)?, Fit::of(value.is_number())))
}

/// Reads a finite number as leniently as the generated code does.
pub(crate) fn float_value(value: &Value) -> Option<f64> {
    float(value).map(|(float, _)| float)
}

/// Reads a whole number.
pub(crate) fn int(value: &Value) -> Option<(i64, Fit)> {
    Some((decoded(value)?, Fit::of(value.is_i64())))
}

/// Reads a truth value that the spec writes as one of two JSON texts.
fn truth(value: &Value, off: &str, on: &str) -> Option<(bool, Fit)> {
    let json = value.to_string();
    let mut is_on = None;
    Reader::new(&json).field_word("", &mut is_on, off.trim_matches('"'), on.trim_matches('"')).ok()?;
    Some((is_on?, Fit::of(json == off || json == on)))
}

/// Reads the number in `errorCode`.
pub(crate) fn error_code(value: &Value) -> Option<ErrorCode> {
    decoded(value)
}

/// Reads the value of a Python literal.
pub(crate) fn literal(text: &str) -> Option<Value> {
    let json = jaka_proto::python::to_json(text).ok()?;
    decode(&json)
}

fn decoded<T: Decode>(value: &Value) -> Option<T> {
    decode(&value.to_string())
}

fn decode<T: Decode>(json: &str) -> Option<T> {
    T::decode(&mut Reader::new(json)).ok()
}
