//! Envelope of a reply: the keys that every reply has.

use std::borrow::Cow;

use crate::refusal::ErrorCode;
use crate::refusal::Refusal;
use crate::wire::{Decode, DecodeError, Reader, lossy_text, trimmed};

/// The keys that every reply has.
const COMMAND: &str = "cmdName";
const CODE: &str = "errorCode";
const MESSAGE: &str = "errorMsg";
pub(crate) const ENVELOPE: [&str; 3] = [COMMAND, CODE, MESSAGE];

/// Keys of the envelope with their quotes and colons.
pub(crate) const QUOTED_COMMAND: &str = "\"cmdName\":";
pub(crate) const QUOTED_CODE: &str = "\"errorCode\":";
pub(crate) const QUOTED_MESSAGE: &str = "\"errorMsg\":";

/// The part of a reply that identifies its request and shows whether the command was accepted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Envelope<'a> {
    /// `cmdName`, without the blanks that some replies put around it. Some refusals have none.
    pub command: Option<Cow<'a, str>>,
    /// `errorCode`, or why it cannot be read.
    pub code: Result<ErrorCode, DecodeError>,
    /// `errorMsg`; empty if absent.
    pub message: Cow<'a, str>,
}

impl<'a> Envelope<'a> {
    /// Reads the envelope of a reply, and checks that the whole reply is JSON.
    ///
    /// A key that comes twice is believed where both say the same. Otherwise the code is an error, so that nothing is
    /// taken for a success, and the reply names no command.
    ///
    /// # Errors
    /// The text is not a JSON object. The fields show all else.
    pub fn read(reply: &'a str) -> Result<Self, DecodeError> {
        Self::read_by(reply, Reader::next_key, Reader::raw)
    }

    /// Reads the envelope of a reply that may be odd: an object by its quotes and brackets, and perhaps not JSON
    /// throughout.
    ///
    /// Controllers send half a surrogate pair (valid JSON that stands for no text, which Python writes for a byte that
    /// it cannot read), NaN, or bytes that are not UTF-8 (see [`framing::text`](crate::framing::text)). In a message,
    /// U+FFFD stands for what stands for no text; a name with such names no command, and a code with such is an error.
    ///
    /// ```
    /// use jaka_proto::Envelope;
    ///
    /// let reply = r#"{"errorCode": "2", "errorMsg": "no \ud83d", "new": NaN, "cmdName": "jog"}"#;
    /// assert!(Envelope::read(reply).is_err());
    /// let refusal = Envelope::read_odd(reply)?.refusal().expect("the code is not zero");
    /// assert_eq!(refusal.to_string(), "the controller refused `jog` with code 2: no \u{fffd}");
    /// # Ok::<(), jaka_proto::wire::DecodeError>(())
    /// ```
    ///
    /// # Errors
    /// The text is not an object by its quotes and brackets.
    pub fn read_odd(reply: &'a str) -> Result<Self, DecodeError> {
        Self::read(reply).or_else(|_| Self::read_by(reply, Reader::next_odd_key, Reader::odd_value))
    }

    /// Reads keys and values each in one way.
    fn read_by(
        reply: &'a str,
        key: impl Fn(&mut Reader<'a>) -> Result<Option<Cow<'a, str>>, DecodeError>,
        value: impl Fn(&mut Reader<'a>) -> Result<&'a str, DecodeError>,
    ) -> Result<Self, DecodeError> {
        let mut reader = Reader::new(reply);
        let mut parts = Parts::default();
        reader.begin_object()?;
        while let Some(key) = key(&mut reader)? {
            parts.take(&key, value(&mut reader)?);
        }
        reader.end()?;
        Ok(parts.envelope())
    }

    /// Whether the reply says that the command was accepted.
    pub fn is_accepted(&self) -> bool {
        self.code.as_ref().is_ok_and(|code| code.is_success())
    }

    /// Whether the reply says that the command was refused.
    pub(crate) fn is_refusal(&self) -> bool {
        self.code.as_ref().is_ok_and(|code| !code.is_success())
    }

    /// The refusal that the reply holds, if it holds one.
    pub fn refusal(&self) -> Option<Refusal> {
        let code = self.code.as_ref().ok().filter(|code| !code.is_success())?;
        let command = self.command.as_deref().unwrap_or_default().to_owned();
        Some(Refusal { command, code: *code, message: self.message.clone().into_owned() })
    }
}

/// The three keys, as far as they have come.
#[derive(Default)]
struct Parts<'a> {
    command: Option<Cow<'a, str>>,
    /// Whether a name has come, even an invalid one.
    has_command: bool,
    code: Option<Result<ErrorCode, DecodeError>>,
    message: Option<Cow<'a, str>>,
    /// Two messages came, and did not say the same.
    messages_differ: bool,
}

impl<'a> Parts<'a> {
    /// Takes the value of a key, if it is one of the three.
    fn take(&mut self, key: &str, raw: &'a str) {
        match key {
            COMMAND => self.take_command(Reader::new(raw).text().ok().map(trimmed)),
            CODE => self.take_code(code(raw)),
            MESSAGE => self.take_message(if raw.starts_with('"') { lossy_text(raw) } else { Cow::Borrowed("") }),
            _ => {}
        }
    }

    /// Two different names count as no name.
    fn take_command(&mut self, found: Option<Cow<'a, str>>) {
        let is_same = !self.has_command || self.command == found;
        (self.command, self.has_command) = (found.filter(|_| is_same), true);
    }

    /// Of two different codes neither is believed.
    fn take_code(&mut self, found: Result<ErrorCode, DecodeError>) {
        let is_same = self.code.as_ref().is_none_or(|before| *before == found);
        self.code = Some(if is_same { found } else { Err(DecodeError::repeated().in_field("error_code")) });
    }

    /// Of two different messages neither is dropped.
    fn take_message(&mut self, found: Cow<'a, str>) {
        self.message = Some(match self.message.take() {
            Some(before) if before != found => {
                self.messages_differ = true;
                format!("{before} / {found}").into()
            }
            _ => found,
        });
    }

    fn envelope(self) -> Envelope<'a> {
        let Self { command, code, message, messages_differ, .. } = self;
        let code = code.unwrap_or_else(|| Err(DecodeError::missing("error_code", CODE)));
        // A refusal stays one.
        let code = code.and_then(|code| {
            let is_doubtful = messages_differ && code.is_success();
            if is_doubtful { Err(DecodeError::repeated().in_field("error_message")) } else { Ok(code) }
        });
        Envelope { command, code, message: message.unwrap_or_default() }
    }
}

/// The code that a value holds, all of it, or why it holds none.
pub(crate) fn code(raw: &str) -> Result<ErrorCode, DecodeError> {
    let mut value = Reader::new(raw);
    let code = ErrorCode::decode(&mut value);
    let code = code.and_then(|code| value.end().map(|()| code));
    code.map_err(|error| error.in_field("error_code"))
}
