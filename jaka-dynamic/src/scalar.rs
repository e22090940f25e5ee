//! Scalars in JSON, in the spec's form or in another one that controllers use, read by the codec of jaka-proto.

use jaka_proto::ErrorCode;
use jaka_proto::wire::{Decode, Reader};
use serde_json::Value;

/// How a value is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// As the spec has it.
    Plain,
    /// In another form, which decodes to the same.
    Lenient,
}

impl Form {
    fn of(is_plain: bool) -> Self {
        if is_plain { Self::Plain } else { Self::Lenient }
    }
}

/// A finite number.
pub(super) fn float(value: &Value) -> Option<(f64, Form)> {
    Some((decoded(value)?, Form::of(value.is_number())))
}

/// A whole number.
pub(super) fn int(value: &Value) -> Option<(i64, Form)> {
    Some((decoded(value)?, Form::of(value.is_i64())))
}

/// A truth value that the spec writes as one of two JSON texts.
pub(super) fn truth(value: &Value, off: &str, on: &str) -> Option<(bool, Form)> {
    let json = value.to_string();
    let mut is_on = None;
    Reader::new(&json).field_word("", &mut is_on, off.trim_matches('"'), on.trim_matches('"')).ok()?;
    Some((is_on?, Form::of(json == off || json == on)))
}

/// The number in `errorCode`.
pub(super) fn error_code(value: &Value) -> Option<ErrorCode> {
    decoded(value)
}

/// The value of a Python literal.
pub(super) fn literal(text: &str) -> Option<Value> {
    let json = jaka_proto::python::to_json(text).ok()?;
    decode(&json)
}

fn decoded<T: Decode>(value: &Value) -> Option<T> {
    decode(&value.to_string())
}

fn decode<T: Decode>(json: &str) -> Option<T> {
    T::decode(&mut Reader::new(json)).ok()
}
