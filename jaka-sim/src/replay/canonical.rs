//! Comparison of messages as JSON.

use jaka_proto::wire::{Decode, Reader, Value};

/// Up to here every whole number has a float of its own.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// True if two messages are the same JSON, or, where one is not JSON, the same text.
pub(crate) fn is_same(a: &str, b: &str) -> bool {
    a == b || canonical(a) == canonical(b)
}

/// The one text for all that is the same JSON: no blanks, keys in order, whole numbers without their form. What is not
/// JSON stays as it is.
pub(super) fn canonical(text: &str) -> String {
    let mut reader = Reader::new(text);
    let value = Value::decode(&mut reader).and_then(|value| reader.end().map(|()| value));
    value.map_or_else(|_| text.to_owned(), |value| with_float_numbers(value).to_string())
}

/// The value with each number as a float, unless it is a whole number that no float is equal to. Keys are in order in
/// any case.
fn with_float_numbers(value: Value) -> Value {
    match value {
        Value::Number(number) => match number.as_f64() {
            Some(float) if number.is_f64() || float.abs() < EXACT => float.into(),
            _ => number.into(),
        },
        Value::Array(elements) => elements.into_iter().map(with_float_numbers).collect(),
        Value::Object(fields) => fields.into_iter().map(|(key, value)| (key, with_float_numbers(value))).collect(),
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn order_blanks_and_forms_of_numbers_make_no_difference() {
        assert!(is_same(r#"{"a": 1, "b": [1.50, "x"]}"#, r#"{"b":[1.5,"x"],"a":1.0}"#));
        assert!(is_same(r#"{"a":{"c":null,"b":true}}"#, r#"{"a":{"b":true,"c":null}}"#));
        assert!(is_same("garbage", "garbage"));
    }

    #[test]
    fn all_else_does() {
        for other in [r#"{"a":2}"#, r#"{"a":"1"}"#, r#"{"a":1,"b":1}"#, r#"{"a":[1]}"#, "{}", "a", r#"{"a":1}}"#] {
            assert!(!is_same(r#"{"a":1}"#, other), "{other}");
        }
        assert!(!is_same("9007199254740993", "9007199254740992"));
        assert!(!is_same("[1,2]", "[2,1]"));
    }
}
