//! Requests and replies.

use serde_json::{Value, json};

use super::defs::Defs;
use super::{Direction, describe, lenient, reference, with};
use crate::keys::{COMMAND_NAME as NAME, ERROR_CODE as CODE, ERROR_MESSAGE as MESSAGE};
use crate::{Command, Field, Request};

/// A request, in the form in which the client sends it.
pub(super) fn request(defs: &mut Defs<'_>, command: &Command) -> Value {
    let schema = match &command.request {
        Request::Fields(fields) => named_object(defs, command, fields, None),
        Request::Choice(choice) => {
            let mut variants = Vec::new();
            for variant in &choice.variants {
                let object = named_object(defs, command, &variant.fields, Some((&choice.tag, variant.wire)));
                let object = with(object, "title", variant.name.clone());
                variants.push(with(object, "description", variant.doc.clone()));
            }
            json!({ "oneOf": variants })
        }
    };
    let schema = with(schema, "title", title(command));
    let schema = with(schema, "description", describe::request(command));
    if command.deprecated.is_some() { with(schema, "deprecated", true) } else { schema }
}

/// The object of a request: `cmdName`, the tag of its variant, and the fields.
fn named_object(defs: &mut Defs<'_>, command: &Command, fields: &[Field], tag: Option<(&String, i64)>) -> Value {
    let mut object = defs.object(fields, Direction::Sent);
    let mut required = vec![json!(NAME)];
    object["properties"][NAME] = json!({ "const": command.wire });
    if let Some((key, value)) = tag {
        object["properties"][key] = json!({ "const": value });
        required.push(json!(key));
    }
    required.extend(object["required"].as_array().cloned().unwrap_or_default());
    with(object, "required", required)
}

/// A reply or a refusal, in any form in which the client reads it.
pub(super) fn reply(defs: &mut Defs<'_>, command: &Command) -> Value {
    let fields = defs.spec.reply_fields(command);
    let mut accepted = defs.object(fields, Direction::Received);
    let mut required = vec![json!(NAME)];
    required.extend(accepted["required"].as_array().cloned().unwrap_or_default());
    accepted["required"] = json!(required);
    let accepted = defs.add(&format!("accepted.{}", command.wire), accepted);
    let bare = command.bare_reply.as_ref().and_then(|name| fields.iter().find(|field| field.name == *name));
    let bare = bare.map(|field| format!("A bare Python tuple in place of JSON stands for `{}`.", field.wire));
    let text = "Further keys may come, in any order. A refusal has none, and may lack the name.";
    json!({
        "title": format!("Reply to {}", title(command)),
        "description": describe::join(&[text, &bare.unwrap_or_default()]),
        "type": "object",
        "properties": {
            NAME: lenient::name(&command.wire),
            MESSAGE: { "description": "Explains a refusal. May be absent on success." },
        },
        "required": [CODE],
        "if": { "properties": { CODE: lenient::success() } },
        "then": accepted,
        "else": reference("refusal"),
    })
}

/// The reply to a command that was refused.
pub(super) fn refusal() -> Value {
    json!({
        "description": "The reply to a command that was refused: a code other than zero, and mostly a message.",
        "type": "object",
        "properties": { CODE: lenient::refused() },
        "required": [CODE],
    })
}

fn title(command: &Command) -> String {
    let section = command.section.as_ref().map(|section| format!(" ({section})")).unwrap_or_default();
    format!("{}{section}", command.wire)
}
