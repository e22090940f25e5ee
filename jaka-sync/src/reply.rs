//! What a reply says beside its payload.

use std::fmt;

use jaka_proto::wire::{DecodeError, Fields};
use jaka_proto::{CommandInfo, Envelope, read_payload, read_reply};

use crate::{Error, ErrorKind};

/// What a reply says beside its payload.
#[derive(Debug)]
pub(crate) enum Reply<'a> {
    Json(Envelope<'a>),
    /// A Python tuple, of the one command that can be answered so.
    Bare,
}

impl<'a> Reply<'a> {
    pub(crate) fn read(text: &'a str) -> Result<Self, DecodeError> {
        if text.starts_with('(') { Ok(Self::Bare) } else { Envelope::read_odd(text).map(Self::Json) }
    }

    /// Fails if the controller refused the command, or does not say whether it did.
    pub(crate) fn accepted(self, command: &str) -> Result<(), Error> {
        let Self::Json(envelope) = self else {
            return Ok(());
        };
        if let Some(mut refusal) = envelope.refusal() {
            command.clone_into(&mut refusal.command);
            return Err(ErrorKind::Refused { refusal, explanation: None }.into());
        }
        envelope.code.map(drop).map_err(|source| unexpected(command, source))
    }
}

/// The error for a reply that does not fit the spec.
pub(crate) fn unexpected(command: &str, source: DecodeError) -> Error {
    ErrorKind::UnexpectedReply { command: command.to_owned(), source }.into()
}

/// What a call makes of the reply that it waits for, in the pass that reads whose reply it is.
pub(crate) trait Payload {
    /// Reads a reply as the one that is waited for, whosever it is.
    fn read<'a>(&mut self, text: &'a str) -> Result<Reply<'a>, DecodeError>;
}

impl fmt::Debug for dyn Payload + '_ {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Payload")
    }
}

/// The reply's text is all that is asked for.
pub(crate) struct TextAlone;

impl Payload for TextAlone {
    fn read<'a>(&mut self, text: &'a str) -> Result<Reply<'a>, DecodeError> {
        Reply::read(text)
    }
}

/// The payload of the reply that was read last, if the controller accepted the command.
pub(crate) struct Typed<R> {
    info: &'static CommandInfo,
    payload: Option<Result<R, DecodeError>>,
}

impl<R: Fields> Typed<R> {
    /// Nothing was read that answers the command.
    pub(crate) fn new(info: &'static CommandInfo) -> Self {
        Self { info, payload: None }
    }

    /// The payload of the reply that was read last, which is `text`.
    pub(crate) fn take(self, text: &str) -> Result<R, DecodeError> {
        self.payload.unwrap_or_else(|| read_payload(self.info, text))
    }
}

impl<R: Fields> Payload for Typed<R> {
    fn read<'a>(&mut self, text: &'a str) -> Result<Reply<'a>, DecodeError> {
        let reply = read_reply(self.info, text)?;
        self.payload = reply.payload;
        Ok(reply.envelope.map_or(Reply::Bare, Reply::Json))
    }
}
