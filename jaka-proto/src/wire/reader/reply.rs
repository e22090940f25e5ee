//! What a reply says beside its payload, taken on the way through it.

use super::{Decode, DecodeError, Reader};
use crate::envelope::{Envelope, QUOTED_CODE, QUOTED_COMMAND, QUOTED_MESSAGE, Reply};
use crate::error_code::ErrorCode;
use crate::wire::Fields;

/// The three keys that every reply has, as far as they have come.
#[derive(Debug, Clone, Default)]
pub(super) struct Slots<'a> {
    /// True up to the reply's own object: the objects inside it have other keys.
    wanted: bool,
    command: Option<&'a str>,
    message: Option<&'a str>,
    code: Option<ErrorCode>,
}

impl Slots<'_> {
    /// True for the first object that is entered, if the keys are wanted.
    pub(super) fn enter(&mut self) -> bool {
        std::mem::take(&mut self.wanted)
    }
}

impl<'a> Reader<'a> {
    /// Takes a key that every reply has, and its value; false if another key comes, or one of these in an unusual form.
    ///
    /// # Errors
    /// The value is not as usual.
    pub(super) fn take_reply_key(&mut self) -> Result<bool, DecodeError> {
        let twice = if self.eat_key(QUOTED_CODE) {
            let code = ErrorCode::decode(self)?;
            self.reply.code.replace(code).is_some()
        } else if self.eat_key(QUOTED_MESSAGE) {
            let message = self.plain_text()?;
            self.reply.message.replace(message).is_some()
        } else if self.eat_key(QUOTED_COMMAND) {
            let command = self.plain_text()?;
            self.reply.command.replace(command).is_some()
        } else {
            return Ok(false);
        };
        if twice { Err(DecodeError::repeated()) } else { Ok(true) }
    }

    #[inline]
    fn eat_key(&mut self, quoted: &str) -> bool {
        let eaten = self.rest().starts_with(quoted.as_bytes());
        self.at += if eaten { quoted.len() } else { 0 };
        eaten
    }

    #[inline]
    fn plain_text(&mut self) -> Result<&'a str, DecodeError> {
        self.usual_text().ok_or_else(|| self.malformed("a string in its usual form"))
    }
}

/// Reads an accepted reply in one pass; `None` for any reply that takes a closer look.
pub(crate) fn read_accepted<R: Fields>(text: &str) -> Option<Reply<'_, R>> {
    let mut reader = Reader::new(text);
    reader.reply.wanted = true;
    let payload = R::read_fields(&mut reader).ok()?;
    reader.end().ok()?;
    let code = reader.reply.code.filter(|code| code.is_success())?;
    let command = reader.reply.command.map(|command| command.trim().into());
    let message = reader.reply.message.unwrap_or_default().into();
    Some(Reply { envelope: Some(Envelope { command, code: Ok(code), message }), payload: Some(Ok(payload)) })
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
