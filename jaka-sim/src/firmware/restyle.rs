//! Replies in another style than the one in which they were written.

use jaka_proto::messages::power::GetRobotState;
use jaka_proto::wire::{Encode, Writer};
use jaka_proto::{Command, ControllerEvent, Envelope, ErrorCode};
use jaka_spec::{ERROR_CODE, ERROR_MESSAGE, Field, Spec};
use serde_json::json;

use super::values::Values;
use super::{CodeStyle, EventStyle, KeyOrder, ReplyStyle};
use crate::State;
use crate::json_text::{members, respace};

/// Rewrites a reply, which was written in the document's style.
///
/// What is not a JSON object stays as it is.
pub(crate) fn restyle(style: ReplyStyle, spec: &Spec, state: &State, reply: &mut Writer) {
    if style == ReplyStyle::DOCUMENT {
        return;
    }
    if let Some(text) = rewritten(style, spec, state, reply.as_str()) {
        reply.clear();
        reply.raw(&text);
    }
}

fn rewritten(style: ReplyStyle, spec: &Spec, state: &State, reply: &str) -> Option<String> {
    let envelope = Envelope::read(reply).ok()?;
    let command = envelope.command.as_deref().and_then(|name| spec.command(name));
    let fields = command.map_or(&[][..], |command| spec.reply_fields(command));
    let values = Values::new(spec, style);
    let mut rewritten = Vec::new();
    for (key, value) in members(reply)? {
        let mut out = Writer::new();
        out.text(&key);
        out.raw(":");
        match (Part::of(&key, fields), envelope.code.as_ref()) {
            (Part::Code, Ok(code)) => write_code(*code, style.codes, &mut out),
            (Part::Message, Ok(code)) if code.is_success() && !style.success_message => continue,
            (Part::Payload(field), _) => values.field(field, value, &mut out),
            _ => out.raw(value),
        }
        rewritten.push(out.into_string());
    }
    if envelope.command.as_deref() == Some(GetRobotState::INFO.name) && envelope.refusal().is_none() {
        rewritten.extend(event(style.event, fields, state));
    }
    if style.key_order == KeyOrder::Reversed {
        rewritten.reverse();
    }
    Some(respace(&format!("{{{}}}", rewritten.join(",")), style.separators))
}

/// The members that tell the controller's event, where there is one.
fn event(style: EventStyle, fields: &[Field], state: &State) -> Vec<String> {
    let number = || ControllerEvent::from_text(&state.error_code).ok().flatten().map_or(0, ControllerEvent::code);
    let code = match style {
        EventStyle::Absent => return Vec::new(),
        EventStyle::Number => json!(number()),
        EventStyle::Text => json!(state.error_code),
    };
    let values = [("error_code", code), ("error_message", json!(state.error_message))];
    let member = |(name, value)| {
        let field = fields.iter().find(|field| field.name == name)?;
        Some(format!("{}:{value}", json!(field.wire)))
    };
    values.into_iter().filter_map(member).collect()
}

fn write_code(code: ErrorCode, style: CodeStyle, out: &mut Writer) {
    match style {
        CodeStyle::Hexadecimal if code.0 >= 0 => out.text(&format!("{:#x}", code.0)),
        CodeStyle::Text | CodeStyle::Hexadecimal => code.encode(out),
        CodeStyle::Number => out.int(code.0),
    }
}

/// What a member of a reply is.
enum Part<'f> {
    Code,
    Message,
    Payload(&'f Field),
    Other,
}

impl<'f> Part<'f> {
    fn of(key: &str, fields: &'f [Field]) -> Self {
        match key {
            ERROR_CODE => Self::Code,
            ERROR_MESSAGE => Self::Message,
            key => fields.iter().find(|field| field.wire == key).map_or(Self::Other, Self::Payload),
        }
    }
}
