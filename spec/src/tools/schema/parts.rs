//! Parts of schemas: the two forms of a value, references, alternatives, keywords and numbers.

use serde_json::{Value, json};

/// How a value is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// In the one form in which the client sends it.
    Sent,
    /// In any form in which the client reads it.
    Received,
}

/// A reference to a definition. In its JSON pointer, everything but letters and digits is escaped.
pub(super) fn reference(name: &str) -> Value {
    let escape = |byte: u8| match byte {
        b'~' => "~0".to_owned(),
        b'/' => "~1".to_owned(),
        b'-' | b'.' | b'_' => char::from(byte).to_string(),
        byte if byte.is_ascii_alphanumeric() => char::from(byte).to_string(),
        byte => format!("%{byte:02X}"),
    };
    let name: String = name.bytes().map(escape).collect();
    json!({ "$ref": format!("#/$defs/{name}") })
}

/// A schema that passes what one of the schemas passes; none passes nothing.
pub(super) fn alternatives(keyword: &str, schemas: &[Value]) -> Value {
    if schemas.is_empty() { json!({ "not": {} }) } else { json!({ keyword: schemas }) }
}

/// The schema with one more keyword.
pub(super) fn with(mut schema: Value, keyword: &str, value: impl Into<Value>) -> Value {
    schema[keyword] = value.into();
    schema
}

/// The number, without a fraction where it has none.
pub(super) fn number(value: f64) -> Value {
    let text = value.to_string();
    text.parse::<i64>().map_or_else(|_| json!(value), |whole| json!(whole))
}
