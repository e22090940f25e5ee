//! Values typed on a command line.

use jaka_spec::{Scalar, Shape, Spec, Type};
use serde_json::Value;

use super::names::same;
use super::scalar;
use super::slot::Slot;

/// Reads a value of a type from text typed on a command line, for [`request`](super::request).
///
/// - A number: `20`. A truth value: `on`, `true`, `1`, or its form on the wire.
/// - A value of an enum: its name in any case, such as `absolute`, or its form on the wire.
/// - An array, or a struct that is one on the wire: `0,90,90` or `[0, 90, 90]`; the struct also as `{"x": 0, …}`.
/// - Text: unchanged. A value with parts of its own: as JSON.
///
/// Ranges and lengths are left to [`request`](super::request).
///
/// # Errors
/// The text is not a value of the type; the message describes the type.
pub fn value(spec: &Spec, ty: &Type, text: &str) -> Result<Value, String> {
    read(spec, ty, text).ok_or_else(|| {
        let expected = match spec.shape(ty) {
            Shape::Scalar(Scalar::Bool { .. }) => "on or off".to_owned(),
            _ => Slot::of_type(spec, ty).words(),
        };
        format!("`{text}` is not {expected}")
    })
}

fn read(spec: &Spec, ty: &Type, text: &str) -> Option<Value> {
    let word = text.trim();
    match spec.shape(ty) {
        Shape::Scalar(scalar) => scalar::typed(scalar, text),
        Shape::Python(_) => Some(text.into()),
        Shape::List(element, _) => list(text, |_, part| read(spec, element, part)),
        Shape::Object(_) | Shape::Choice(_) => serde_json::from_str(text).ok(),
        Shape::Tuple { fields, .. } => list(text, |index, part| match fields.get(index) {
            Some(field) => read(spec, &field.ty, part),
            // The extra part makes `request` refuse the value.
            None => Some(part.into()),
        }),
        Shape::IntEnum(values) => {
            let listed = values.iter().find(|listed| same(&listed.name, word)).map(|listed| listed.wire);
            listed.or_else(|| scalar::int(&word.into()).map(|(int, _)| int)).map(Value::from)
        }
        Shape::TextEnum(values) => {
            let listed = values.iter().find(|listed| listed.wire != word && same(&listed.name, word));
            Some(listed.map_or(word, |listed| &listed.wire).into())
        }
    }
}

/// Returns a JSON array or object unchanged; otherwise reads parts between commas, each by `read`.
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
