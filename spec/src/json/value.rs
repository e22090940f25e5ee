//! Values as they are typed on a command line.

use serde_json::Value;

use super::limits::{Limits, Slot};
use super::names::same;
use super::scalar::{finite, truth_word, whole};
use crate::{Spec, Type, TypeKind};

/// Reads a value of a type from what was typed on a command line, for [`request`](super::request).
///
/// - A number: `20`. A truth value: `on`, `true`, `1`, or as the wire writes it.
/// - A value of an enum: its name in any case, such as `absolute`, or its form on the wire.
/// - An array, or a struct that is one on the wire: `0,90,90` or `[0, 90, 90]`; the struct also as `{"x": 0, …}`.
/// - Text: as it is. Whatever has parts of its own: as JSON.
///
/// Ranges and lengths are left to [`request`](super::request).
///
/// # Errors
/// The text is no value of the type; the message says what is.
pub fn value(spec: &Spec, ty: &Type, text: &str) -> Result<Value, String> {
    read(spec, ty, text).ok_or_else(|| {
        let expected = match ty {
            Type::Bool { .. } => "on or off".to_owned(),
            ty => Slot { place: "", ty, limits: Limits::default() }.words(spec),
        };
        format!("`{text}` is not {expected}")
    })
}

fn read(spec: &Spec, ty: &Type, text: &str) -> Option<Value> {
    let word = text.trim();
    match ty {
        Type::Bool { off, on } => match word.to_ascii_lowercase().as_str() {
            "on" => Some(true.into()),
            "off" => Some(false.into()),
            _ => truth_word(word, off, on).map(Value::from),
        },
        Type::Int => whole(word).map(Value::from),
        Type::Float => finite(word).map(Value::from),
        Type::Text | Type::Python(_) => Some(text.into()),
        Type::Json => Some(serde_json::from_str(text).unwrap_or_else(|_| text.into())),
        Type::List(element) | Type::Array(element, _) => list(text, |_, part| read(spec, element, part)),
        Type::Named(name) => named(spec, name, text),
    }
}

fn named(spec: &Spec, name: &str, text: &str) -> Option<Value> {
    let word = text.trim();
    let Some(def) = spec.type_def(name) else { return read(spec, &Type::Json, text) };
    match &def.kind {
        TypeKind::Object(_) | TypeKind::Choice(_) => serde_json::from_str(text).ok(),
        TypeKind::Array { fields, .. } => list(text, |index, part| match fields.get(index) {
            Some(field) => read(spec, &field.ty, part),
            // One too many, which `request` refuses.
            None => Some(part.into()),
        }),
        TypeKind::IntEnum(values) => {
            let listed = values.iter().find(|listed| same(&listed.name, word));
            listed.map(|listed| listed.wire).or_else(|| whole(word)).map(Value::from)
        }
        TypeKind::TextEnum(values) => {
            let listed = values.iter().find(|listed| listed.wire != word && same(&listed.name, word));
            Some(listed.map_or(word, |listed| &listed.wire).into())
        }
        TypeKind::Wrapper(ty, _) => read(spec, ty, text),
    }
}

/// A JSON array or object as it is; otherwise parts between commas, each read by `read`.
fn list(text: &str, read: impl Fn(usize, &str) -> Option<Value>) -> Option<Value> {
    if let Ok(json @ (Value::Array(_) | Value::Object(_))) = serde_json::from_str(text) {
        return Some(json);
    }
    let text = text.trim();
    let inner = text.strip_prefix('[').and_then(|text| text.strip_suffix(']')).unwrap_or(text);
    if inner.trim().is_empty() {
        return Some(Value::Array(Vec::new()));
    }
    inner.split(',').enumerate().map(|(index, part)| read(index, part)).collect()
}
