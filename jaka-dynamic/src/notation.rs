//! Types guessed from values.

use serde_json::Value;

/// The type that a value looks like, in the spec's notation.
pub fn notation(value: &Value) -> String {
    match value {
        Value::Bool(_) => "bool".to_owned(),
        Value::Number(number) if number.is_f64() => "float".to_owned(),
        Value::Number(_) => "int".to_owned(),
        Value::String(_) => "text".to_owned(),
        Value::Array(elements) => elements_notation(elements),
        Value::Object(_) | Value::Null => "json".to_owned(),
    }
}

fn elements_notation(elements: &[Value]) -> String {
    let mut kinds: Vec<_> = elements.iter().map(notation).collect();
    kinds.sort();
    kinds.dedup();
    match kinds.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [one] => format!("{one}[]"),
        ["float", "int"] => "float[]".to_owned(),
        _ => "json".to_owned(),
    }
}
