//! Comparison of messages as JSON.

use jaka_proto::wire::{Decode, Reader, Value};

/// Limit up to which every whole number has an exact float.
const EXACT: f64 = 9_007_199_254_740_992.0;

/// Whether two messages are the same JSON, or, if one is not JSON, the same text.
pub(crate) fn is_same(a: &str, b: &str) -> bool {
    a == b || canonical(a) == canonical(b)
}

/// Returns a text that is equal for equal JSON: no blanks, keys in order, whole numbers in one form. Text other than
/// JSON stays unchanged.
pub(super) fn canonical(text: &str) -> String {
    let mut reader = Reader::new(text);
    let value = Value::decode(&mut reader).and_then(|value| reader.end().map(|()| value));
    value.map_or_else(|_| text.to_owned(), |value| with_float_numbers(value).to_string())
}

/// Converts each number to a float, except whole numbers without an equal float. Keys are always in order.
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
