//! Replies as JSON by the names of their fields.

use jaka_dynamic::value as read;
use jaka_spec::{Command, ENVELOPE, Field, Scalar, Shape, Spec, Type};
use jaka_sync::proto::python;
use serde_json::{Map, Value};

use super::reply::json;

/// A reply by the names of its fields in Rust, without its envelope. What the spec does not know is as it came.
pub(super) fn reply(spec: &Spec, command: Option<&Command>, text: &str) -> Value {
    let fields = command.map_or(&[][..], |command| spec.reply_fields(command));
    match json(text) {
        Value::Object(reply) => {
            let payload = reply.into_iter().filter(|(key, _)| !ENVELOPE.contains(&key.as_str())).collect();
            object(spec, fields, &payload)
        }
        bare => {
            let name = command.and_then(|command| command.bare_reply.as_ref());
            match fields.iter().find(|field| Some(&field.name) == name) {
                Some(field) => Value::Object(Map::from_iter([(field.name.clone(), value(spec, &field.ty, &bare))])),
                None => bare,
            }
        }
    }
}

fn object(spec: &Spec, fields: &[Field], object: &Map<String, Value>) -> Value {
    let named = |(key, found): (&String, &Value)| match fields.iter().find(|field| field.wire == *key) {
        Some(field) => (field.name.clone(), value(spec, &field.ty, found)),
        None => (key.clone(), found.clone()),
    };
    Value::Object(object.iter().map(named).collect())
}

fn value(spec: &Spec, ty: &Type, found: &Value) -> Value {
    match (spec.shape(ty), found) {
        (Shape::Python(inner), Value::String(literal)) => match python::to_json(literal) {
            Ok(text) => value(spec, inner, &json(&text)),
            Err(_) => found.clone(),
        },
        (Shape::List(element, _), Value::Array(items)) => items.iter().map(|item| value(spec, element, item)).collect(),
        (Shape::Object(fields), Value::Object(found)) => object(spec, fields, found),
        // One with more elements than have names stays as it came.
        (Shape::Tuple { fields, .. }, Value::Array(elements)) if elements.len() <= fields.len() => {
            let named =
                fields.iter().zip(elements).map(|(field, found)| (field.name.clone(), value(spec, &field.ty, found)));
            Value::Object(named.collect())
        }
        (Shape::Scalar(Scalar::Json | Scalar::Text), _) => found.clone(),
        (
            Shape::Scalar(_) | Shape::IntEnum(_) | Shape::TextEnum(_),
            Value::Bool(_) | Value::Number(_) | Value::String(_),
        ) => {
            let text = found.as_str().map_or_else(|| found.to_string(), str::to_owned);
            read(spec, ty, &text).unwrap_or_else(|_| found.clone())
        }
        _ => found.clone(),
    }
}
