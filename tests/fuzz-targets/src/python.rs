//! Python literals and JSON, either way.

use jaka_proto::python::{from_json, to_json};
use serde_json::Value;

/// A literal that was read is JSON, and comes back from there; JSON that `serde_json` reads has a literal.
///
/// # Panics
/// One of these is not so.
pub fn python(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    if let Ok(json) = to_json(text) {
        let literal = from_json(&json).unwrap_or_else(|error| panic!("{error}: {json}"));
        assert_eq!(to_json(&literal), Ok(json), "{literal}");
    }
    let Ok(value) = serde_json::from_str::<Value>(text) else { return };
    match from_json(text) {
        Ok(literal) => {
            let json = to_json(&literal).unwrap_or_else(|error| panic!("{error}: {literal}"));
            assert_eq!(serde_json::from_str::<Value>(&json).ok(), Some(value), "{literal}");
        }
        Err(error) => assert!(error.to_string().contains("at most 64 levels of nesting"), "{error}: {text}"),
    }
}
