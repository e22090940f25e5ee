//! The protocol as JSON Schema.

mod defs;
mod describe;
mod lenient;
mod message;

use serde_json::{Map, Value, json};

use self::defs::Defs;
use crate::Spec;

/// A JSON Schema of all messages, in the draft 2020-12.
///
/// The schema as a whole describes a message of port 10001, request or reply. Its `$defs` are:
///
/// | definition | what it describes |
/// |---|---|
/// | `request.joint_move` and so on | a request as the client sends it: nothing else passes |
/// | `reply.joint_move` and so on | a reply, or a refusal, as the client reads it: any form that controllers use passes |
/// | `request`, `reply` | any request, any reply |
/// | `accepted.joint_move` and so on | the fields of a reply to a command that was accepted |
/// | `refusal` | the reply to a command that was refused |
/// | `status` | a packet of port 10000 |
/// | `Pose` and so on | a type as requests have it |
/// | `lenient.Pose` and so on | a type as it is read; all types have one |
///
/// What newer firmware takes beyond a range, or as a further value of an enum, does not pass in a request, nor does
/// what is beyond what the spec advises. The text inside a Python literal is described, not checked.
///
/// ```
/// let schema = jaka_spec::tools::schema(&jaka_spec::builtin()?);
/// assert_eq!(schema["$defs"]["request.rapid_rate"]["properties"]["rate_value"]["maximum"], 1);
/// # Ok::<(), jaka_spec::Errors>(())
/// ```
pub fn schema(spec: &Spec) -> Value {
    let mut defs = Defs::new(spec);
    let (mut requests, mut replies) = (Vec::new(), Vec::new());
    for command in spec.commands() {
        let request = message::request(&mut defs, command);
        requests.push(defs.add(&format!("request.{}", command.wire), request));
        let reply = message::reply(&mut defs, command);
        replies.push(defs.add(&format!("reply.{}", command.wire), reply));
    }
    defs.add("request", alternatives("oneOf", &requests));
    defs.add("reply", alternatives("anyOf", &replies));
    defs.add("refusal", message::refusal());
    for (id, _) in spec.types() {
        defs.named(id, Direction::Received);
    }
    if let Some(id) = spec.status_type() {
        let status = defs.named(id, Direction::Received);
        defs.add("status", status);
    }
    root(&defs.finish())
}

/// Direction in which a value passes, which decides the forms in which it is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Direction {
    /// In the one form in which the client sends it.
    Sent,
    /// In any form in which the client reads it.
    Received,
}

fn root(defs: &Map<String, Value>) -> Value {
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "JAKA TCP protocol",
        "description": "A message of port 10001. A packet of port 10000 is described by `#/$defs/status`.",
        "oneOf": [reference("request"), reference("reply")],
        "$defs": defs,
    })
}

/// A reference to a definition. In its JSON pointer, everything but letters and digits is escaped.
fn reference(name: &str) -> Value {
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

/// A schema that passes the values of any of these schemas; none passes nothing.
fn alternatives(keyword: &str, schemas: &[Value]) -> Value {
    if schemas.is_empty() { json!({ "not": {} }) } else { json!({ keyword: schemas }) }
}

/// The schema with one more keyword.
fn with(mut schema: Value, keyword: &str, value: impl Into<Value>) -> Value {
    schema[keyword] = value.into();
    schema
}

/// The number, without a zero fraction.
fn number(value: f64) -> Value {
    let text = value.to_string();
    text.parse::<i64>().map_or_else(|_| json!(value), |whole| json!(whole))
}
