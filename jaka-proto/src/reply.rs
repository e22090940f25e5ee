//! Replies: the envelope, and the payload.

use std::borrow::Cow;

use crate::command::CommandInfo;
use crate::envelope::{ENVELOPE, Envelope, QUOTED_CODE, QUOTED_COMMAND, QUOTED_MESSAGE, code};
use crate::refusal::ErrorCode;
use crate::wire::{Decode, DecodeError, Encode, Fields, Reader, Value, Writer, read_message};

/// A reply: its command, its acceptance, and its payload.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Reply<'a, R> {
    /// Envelope of the reply; `None` for a bare Python tuple, which has only a payload.
    pub envelope: Option<Envelope<'a>>,
    /// The payload, or the reason why it does not fit; `None` if the command was refused or its acceptance is unknown,
    /// so that a missing field never hides a refusal.
    pub payload: Option<Result<R, DecodeError>>,
}

/// A reply with keys that the spec does not fix: an object, without the keys of every reply.
impl Fields for Value {
    fn write_fields(&self, out: &mut Writer) {
        for (key, value) in self.as_object().into_iter().flatten() {
            out.comma();
            out.text(key);
            out.raw(":");
            value.encode(out);
        }
    }

    fn read_fields(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mut value = Self::decode(reader)?;
        match value.as_object_mut() {
            Some(object) => object.retain(|key, _| !ENVELOPE.contains(&key.as_str())),
            None => return Err(DecodeError::unfit("an object", &value.to_string())),
        }
        Ok(value)
    }
}

/// Reads a reply as that to `command`, whosever it is: what [`Envelope::read`] and [`read_payload`] read, in one pass.
///
/// The payload means nothing unless the envelope names the command, or it is known otherwise that it is the command's.
/// A reply that is odd is read as [`Envelope::read_odd`] does, and its payload where that is not odd itself.
///
/// ```
/// use jaka_proto::messages::kinematics::{GetJointPos, GetJointPosReply};
/// use jaka_proto::{Command, read_reply};
///
/// let text = r#"{"errorCode": "0", "cmdName": "get_joint_pos", "joint_pos": [0, 90, 90, 90, -90, 0]}"#;
/// let reply = read_reply::<GetJointPosReply>(GetJointPos::INFO, text)?;
/// assert_eq!(reply.envelope.and_then(|envelope| envelope.command).as_deref(), Some("get_joint_pos"));
/// assert!(reply.payload.is_some_and(|payload| payload.is_ok()));
/// # Ok::<(), jaka_proto::wire::DecodeError>(())
/// ```
///
/// # Errors
/// The text is neither an object by its quotes and brackets nor a Python tuple.
pub fn read_reply<'a, R: Fields>(command: &CommandInfo, reply: &'a str) -> Result<Reply<'a, R>, DecodeError> {
    match read_accepted(reply) {
        Some(reply) => Ok(reply),
        None => read_closely(command, reply),
    }
}

/// Reads an accepted reply in one pass; `None` for any reply that takes a closer look.
fn read_accepted<R: Fields>(text: &str) -> Option<Reply<'_, R>> {
    let mut reader = Reader::capturing(text, take_envelope);
    let payload = R::read_fields(&mut reader).ok()?;
    if !is_accepted(&mut reader) {
        return None;
    }
    let [_, message, command] = reader.captured();
    let (command, message) = (command.map(Cow::Borrowed), Cow::Borrowed(message.unwrap_or_default()));
    let envelope = Envelope { command, code: Ok(ErrorCode(0)), message };
    Some(Reply { envelope: Some(envelope), payload: Some(Ok(payload)) })
}

/// Whether a reply that was read to its end accepts the command.
// Not generic, or each type of a reply would compile a copy. The envelope is made by the caller, since its move is
// slow.
fn is_accepted(reader: &mut Reader<'_>) -> bool {
    let [code, ..] = reader.captured();
    reader.end().is_ok() && code.is_some_and(|raw| raw == SUCCESS || self::code(raw).is_ok_and(ErrorCode::is_success))
}

/// The code of nearly all replies.
const SUCCESS: &str = "\"0\"";

/// Takes a key of the envelope, and its value where that is in its usual form.
fn take_envelope(reader: &mut Reader<'_>) -> Result<bool, DecodeError> {
    if reader.eat_key(QUOTED_CODE) {
        let code = if reader.eat(SUCCESS) { Some(SUCCESS) } else { reader.usual_scalar() };
        reader.keep(0, code)
    } else if reader.eat_key(QUOTED_MESSAGE) {
        let message = reader.usual_text();
        reader.keep(1, message)
    } else if reader.eat_key(QUOTED_COMMAND) {
        let command = reader.usual_text().map(str::trim);
        reader.keep(2, command)
    } else {
        Ok(false)
    }
}

/// Reads a refusal, or a reply in an unusual form: the envelope, then the payload if there is one.
#[cold]
fn read_closely<'a, R: Fields>(command: &CommandInfo, reply: &'a str) -> Result<Reply<'a, R>, DecodeError> {
    let envelope = read_envelope(reply)?;
    let accepted = envelope.as_ref().is_none_or(Envelope::is_accepted);
    let payload = accepted.then(|| read_payload(command, reply));
    Ok(Reply { envelope, payload })
}

/// Reads the envelope of a reply, as [`Envelope::read_odd`] does; `None` for a bare Python tuple, which has none.
///
/// # Errors
/// The text is neither an object by its quotes and brackets nor a Python tuple.
pub fn read_envelope(reply: &str) -> Result<Option<Envelope<'_>>, DecodeError> {
    if reply.starts_with('(') { Ok(None) } else { Envelope::read_odd(reply).map(Some) }
}

/// Reads the payload of an accepted reply.
///
/// A bare Python tuple, which some firmware sends in place of a JSON reply, is read as the field that the spec names.
/// Values of other keys may be [odd](Envelope::read_odd).
///
/// # Errors
/// A field is missing, comes twice or does not fit its type.
pub fn read_payload<R: Fields>(command: &CommandInfo, reply: &str) -> Result<R, DecodeError> {
    read_message(&as_object(command, reply))
}

/// The reply as a JSON object, also for a bare Python tuple.
fn as_object<'r>(command: &CommandInfo, reply: &'r str) -> Cow<'r, str> {
    let Some(key) = command.bare_reply.filter(|_| reply.trim_start().starts_with('(')) else {
        return Cow::Borrowed(reply);
    };
    let mut wrapped = Writer::new();
    wrapped.raw("{");
    wrapped.text(key);
    wrapped.raw(":");
    wrapped.text(reply.trim());
    wrapped.raw("}");
    Cow::Owned(wrapped.into_string())
}

/// Writes the reply to an accepted command, as a controller does.
pub fn write_reply(command: &CommandInfo, reply: &impl Fields, out: &mut Writer) {
    write_envelope(Some(command.name), ErrorCode(0), "", out);
    reply.write_fields(out);
    out.raw("}");
}

/// Writes the reply to a refused command, as a controller does; without `cmdName` if `command` is `None`.
pub fn write_refusal(command: Option<&str>, code: ErrorCode, message: &str, out: &mut Writer) {
    write_envelope(command, code, message, out);
    out.raw("}");
}

fn write_envelope(command: Option<&str>, code: ErrorCode, message: &str, out: &mut Writer) {
    out.raw("{\"errorCode\":");
    code.encode(out);
    out.raw(",\"errorMsg\":");
    out.text(message);
    if let Some(command) = command {
        out.raw(",\"cmdName\":");
        out.text(command);
    }
}

#[cfg(test)]
mod tests {
    use super::read_accepted;
    use crate::messages::kinematics::GetJointPosReply;

    #[test]
    fn replies_in_their_usual_form_take_one_pass() {
        for keys in [
            r#""errorCode": "0", "errorMsg": "", "joint_pos": [1, 2, 3, 4, 5, 6.5], "cmdName": "get_joint_pos""#,
            r#""errorCode":"0","errorMsg":"","joint_pos":[1,2,3,4,5,6.5],"cmdName":"get_joint_pos""#,
            r#""cmdName": "get_joint_pos", "joint_pos": [1, 2, 3, 4, 5, 6.5], "new": [{"errorCode": 7}], "errorCode": 0"#,
        ] {
            let text = format!("{{{keys}}}");
            let reply = read_accepted::<GetJointPosReply>(&text).expect(keys);
            let envelope = reply.envelope.expect("it has one");
            assert_eq!((envelope.command.as_deref(), &*envelope.message), (Some("get_joint_pos"), ""), "{keys}");
            let joints = reply.payload.expect("it is accepted").expect("it decodes").joint_position;
            assert_eq!(joints, [1.0, 2.0, 3.0, 4.0, 5.0, 6.5].into(), "{keys}");
        }
    }

    #[test]
    fn what_is_not_as_usual_is_left_to_two_passes() {
        for text in [
            r#"{"errorCode": "1", "joint_pos": [1, 2, 3, 4, 5, 6]}"#,
            r#"{"errorCode": "0", "errorCode": "0", "joint_pos": [1, 2, 3, 4, 5, 6]}"#,
            r#"{"errorCode": "0", "errorMsg": "a\n", "joint_pos": [1, 2, 3, 4, 5, 6]}"#,
            r#"{"errorCode": "0", "errorMsg": null, "joint_pos": [1, 2, 3, 4, 5, 6]}"#,
            r#"{"errorCode" : "0", "joint_pos": [1, 2, 3, 4, 5, 6]}"#,
            r#"{"errorCode": "0", "joint_pos": [1, 2, 3, 4, 5]}"#,
            r#"{"errorCode": "0", "joint_pos": [1, 2, 3, 4, 5, 6]} x"#,
            r#"{"joint_pos": [1, 2, 3, 4, 5, 6]}"#,
        ] {
            assert!(read_accepted::<GetJointPosReply>(text).is_none(), "{text}");
        }
    }
}
