//! The forms in which controllers write the same value, as far as the client reads them.

use serde_json::{Map, Value, json};

use super::{Direction, reference, with};
use crate::{Scalar, Variant};

const NUMBER: &str = "lenient.float";
const INTEGER: &str = "lenient.int";
const BOOLEAN: &str = "lenient.bool";
const CODE: &str = "lenient.code";
const SUCCESS: &str = "lenient.success";

/// The definitions of the scalars.
pub(super) fn definitions() -> Map<String, Value> {
    let define = |name: &str, description: &str, plain: Value, pattern: &str| {
        let text = json!({ "type": "string", "pattern": format!("^\\s*({pattern})\\s*$") });
        (name.to_owned(), json!({ "description": description, "anyOf": [plain, text] }))
    };
    let (words, bit, decimal) = ("[Tt][Rr][Uu][Ee]|[Ff][Aa][Ll][Ss][Ee]", "\\+?0*[01](\\.0*)?|-0+", "[0-9]+\\.?[0-9]*");
    let floating = format!("[+-]?({decimal}|\\.[0-9]+)([eE][+-]?[0-9]+)?");
    let whole = "[+-]?[0-9]+(\\.0*)?";
    [
        define(NUMBER, "A number, or a string that holds one.", json!({ "type": "number" }), &floating),
        define(
            INTEGER,
            "A whole number such as 1 or 1.0, or a string that holds one.",
            json!({ "type": "integer" }),
            whole,
        ),
        define(
            BOOLEAN,
            "A truth value: true or 1, false or 0, or a string that holds one of these, in any case.",
            json!({ "enum": [true, false, 0, 1] }),
            &format!("{words}|{bit}"),
        ),
        define(
            CODE,
            "A whole number, or a string that holds one, also in hexadecimal.",
            reference(INTEGER),
            "0[xX][0-9a-fA-F]+",
        ),
        define(SUCCESS, "Zero, in any form of an error code.", json!({ "const": 0 }), "0[xX]0+|[+-]?0+(\\.0*)?"),
    ]
    .into_iter()
    .collect()
}

/// A number in any form.
fn number() -> Value {
    reference(NUMBER)
}

/// A whole number in any form.
pub(super) fn integer() -> Value {
    reference(INTEGER)
}

/// A truth value in any form, or as one of two words.
fn boolean(forms: [&str; 2]) -> Value {
    let words = forms.map(|form| form.trim_matches('"'));
    let usual = ["true", "false", "0", "1"];
    if words.iter().all(|word| usual.contains(&word.to_ascii_lowercase().as_str())) {
        return reference(BOOLEAN);
    }
    let numbers: Vec<i64> = words.iter().filter_map(|word| word.parse().ok()).collect();
    let pattern = |word: &&str| any_case(word) + if word.parse::<i64>().is_ok() { "(\\.0*)?" } else { "" };
    let words: Vec<_> = words.iter().map(pattern).collect();
    let text = json!({ "type": "string", "pattern": format!("^\\s*({})\\s*$", words.join("|")) });
    let mut forms = vec![reference(BOOLEAN), text];
    if !numbers.is_empty() {
        forms.push(json!({ "enum": numbers }));
    }
    json!({ "anyOf": forms })
}

/// The error code of an accepted command.
pub(super) fn success() -> Value {
    reference(SUCCESS)
}

/// The error code of a refused command.
pub(super) fn refused() -> Value {
    with(reference(CODE), "not", reference(SUCCESS))
}

/// The name of a command, with blanks around it or without.
pub(super) fn name(wire: &str) -> Value {
    json!({ "type": "string", "pattern": format!("^\\s*{}\\s*$", escaped(wire)) })
}

/// The tag of a variant.
pub(super) fn tag(wire: i64) -> Value {
    json!({ "enum": [wire, wire.to_string()] })
}

/// A variant with another tag than these.
pub(super) fn other_variant(variants: &[Variant]) -> Value {
    let known: Vec<_> =
        variants.iter().flat_map(|variant| [json!(variant.wire), json!(variant.wire.to_string())]).collect();
    let tag = with(reference(INTEGER), "not", json!({ "enum": known }));
    json!({
        "title": "Other",
        "description": "A kind that the spec does not list.",
        "type": "array",
        "prefixItems": [tag],
        "minItems": 1,
    })
}

/// A pattern for the word, in any case.
fn any_case(word: &str) -> String {
    let letter = |c: char| match c {
        c if c.is_ascii_alphabetic() => format!("[{}{}]", c.to_ascii_uppercase(), c.to_ascii_lowercase()),
        c => escaped(&c.to_string()),
    };
    word.chars().map(letter).collect()
}

/// A pattern for the text as it is.
fn escaped(text: &str) -> String {
    let mut pattern = String::new();
    for c in text.chars() {
        if r"\^$.|?*+()[]{}/".contains(c) {
            pattern.push('\\');
        }
        pattern.push(c);
    }
    pattern
}

/// A scalar as it is sent, or in any form in which it is read.
pub(super) fn scalar(scalar: &Scalar, direction: Direction) -> Value {
    match (scalar, direction) {
        (Scalar::Bool { off, on }, Direction::Sent) if off == "false" && on == "true" => json!({ "type": "boolean" }),
        (Scalar::Bool { off, on }, Direction::Sent) => json!({ "enum": [parsed(off), parsed(on)] }),
        (Scalar::Bool { off, on }, Direction::Received) => boolean([off, on]),
        (Scalar::Int, Direction::Sent) => json!({ "type": "integer" }),
        (Scalar::Int, Direction::Received) => integer(),
        (Scalar::Float, Direction::Sent) => json!({ "type": "number" }),
        (Scalar::Float, Direction::Received) => number(),
        (Scalar::Text, _) => json!({ "type": "string" }),
        (Scalar::Json, _) => json!({}),
    }
}

/// The value of a JSON text of the spec.
fn parsed(json: &str) -> Value {
    serde_json::from_str(json).unwrap_or_else(|_| json!(json))
}
