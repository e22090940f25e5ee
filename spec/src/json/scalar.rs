//! Scalars in JSON, in the spec's form or in another one that controllers use.

use serde_json::Value;

pub(super) use super::whole::whole;

/// How a value is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// As the spec has it.
    Plain,
    /// In another form, which decodes to the same.
    Lenient,
}

/// A finite number.
pub(super) fn float(value: &Value) -> Option<(f64, Form)> {
    match value {
        Value::Number(number) => Some((number.as_f64().filter(|number| number.is_finite())?, Form::Plain)),
        Value::String(text) => Some((finite(text)?, Form::Lenient)),
        _ => None,
    }
}

/// The finite number that `text` holds.
pub(super) fn finite(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|number: &f64| number.is_finite())
}

/// A whole number.
pub(super) fn int(value: &Value) -> Option<(i64, Form)> {
    match value {
        Value::Number(number) => match number.as_i64() {
            Some(int) => Some((int, Form::Plain)),
            // What was a fraction or an exponent has been a float since it was parsed.
            None => Some((whole(&number.to_string())?, Form::Lenient)),
        },
        Value::String(text) => Some((whole(text)?, Form::Lenient)),
        _ => None,
    }
}

/// A truth value that the spec writes as one of two JSON texts.
pub(super) fn truth(value: &Value, off: &str, on: &str) -> Option<(bool, Form)> {
    let text = match value {
        Value::Bool(_) | Value::Number(_) => value.to_string(),
        Value::String(text) => text.trim().to_owned(),
        _ => return None,
    };
    let is_on = truth_word(&text, off, on)?;
    let json = value.to_string();
    Some((is_on, if json == off || json == on { Form::Plain } else { Form::Lenient }))
}

/// The truth value that `text` stands for: one of the spec's two forms, true and false, or 1 and 0.
pub(super) fn truth_word(text: &str, off: &str, on: &str) -> Option<bool> {
    let number = whole(text);
    let is = |form: &str| {
        let form = form.trim_matches('"');
        text.eq_ignore_ascii_case(form) || number.is_some() && whole(form) == number
    };
    if is(off) || is(on) {
        return Some(is(on));
    }
    if is("false") || is("true") {
        return Some(is("true"));
    }
    match number? {
        0 => Some(false),
        1 => Some(true),
        _ => None,
    }
}
