//! Replies in another style than the one in which they were written.

use jaka_proto::messages::power::{GetRobotState, GetRobotStateReply};
use jaka_proto::wire::{Encode, Typed, Writer};
use jaka_proto::{Command, Envelope, ErrorCode, read_payload, write_reply};
use jaka_spec::{ERROR_CODE, ERROR_MESSAGE, Field, Spec};

use super::values::Values;
use super::{CodeStyle, KeyOrder, ReplyStyle};
use crate::State;
use crate::json_text::{members, respace};

/// Rewrites a reply, which was written in the document's style.
///
/// What is not a JSON object stays as it is.
pub(crate) fn restyle(style: ReplyStyle, spec: &Spec, state: &State, reply: &mut Writer) {
    if style == ReplyStyle::default() {
        return;
    }
    if style.robot_error {
        add_robot_error(state, reply);
    }
    if let Some(text) = rewritten(style, spec, reply.as_str()) {
        reply.clear();
        reply.raw(&text);
    }
}

/// Adds the controller's error to the answer that has room for it.
fn add_robot_error(state: &State, reply: &mut Writer) {
    let Ok(envelope) = Envelope::read(reply.as_str()) else { return };
    if envelope.command.as_deref() != Some(GetRobotState::INFO.name) || envelope.refusal().is_some() {
        return;
    }
    let Ok(mut answer) = read_payload::<GetRobotStateReply>(GetRobotState::INFO, reply.as_str()) else { return };
    answer.error_code = Some(Typed::Known(state.error_code.clone()));
    answer.error_message = Some(state.error_message.clone());
    reply.clear();
    write_reply(GetRobotState::INFO, &answer, reply);
}

fn rewritten(style: ReplyStyle, spec: &Spec, reply: &str) -> Option<String> {
    let envelope = Envelope::read(reply).ok()?;
    let command = envelope.command.as_deref().and_then(|name| spec.command(name));
    let fields = command.map_or(&[][..], |command| spec.reply_fields(command));
    let values = Values { spec, style };
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
    if style.key_order == KeyOrder::Reversed {
        rewritten.reverse();
    }
    Some(respace(&format!("{{{}}}", rewritten.join(",")), style.separators))
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
