//! Types guessed from values.

use serde_json::Value;

/// The type that a value looks like, in the spec's notation.
///
/// Numbers in arrays are floats: where all of them are whole, others of their kind need not be. A number that is too large for an `int`
/// is `json`, which keeps all its digits.
pub fn notation(value: &Value) -> String {
    match value {
        Value::Bool(_) => "bool".to_owned(),
        Value::Number(number) if number.is_f64() => "float".to_owned(),
        Value::Number(number) if number.is_i64() => "int".to_owned(),
        Value::String(_) => "text".to_owned(),
        Value::Array(elements) => elements_notation(elements),
        Value::Number(_) | Value::Object(_) | Value::Null => "json".to_owned(),
    }
}

fn elements_notation(elements: &[Value]) -> String {
    let mut kinds: Vec<_> = elements.iter().map(notation).collect();
    kinds.sort();
    kinds.dedup();
    match kinds.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["int" | "float"] | ["float", "int"] => "float[]".to_owned(),
        [one] => format!("{one}[]"),
        _ => "json".to_owned(),
    }
}
