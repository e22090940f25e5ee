//! What a reply says beside its payload.

use jaka_proto::Envelope;
use jaka_proto::wire::DecodeError;

use crate::{Error, Exchanges};

/// What a reply says beside its payload.
#[derive(Debug)]
pub(crate) enum Reply<'a> {
    Json(Envelope<'a>),
    /// A Python tuple, of the one command that can be answered so.
    Bare,
}

impl<'a> Reply<'a> {
    pub(crate) fn read(text: &'a str) -> Result<Self, DecodeError> {
        if text.starts_with('(') { Ok(Self::Bare) } else { Envelope::read(text).map(Self::Json) }
    }

    /// Fails if the controller refused the command, or does not say whether it did.
    pub(crate) fn accepted(self, command: &str) -> Result<(), Error> {
        let Self::Json(envelope) = self else {
            return Ok(());
        };
        if let Some(mut refusal) = envelope.refusal() {
            command.clone_into(&mut refusal.command);
            return Err(Error::Refused { refusal, exchanges: Exchanges::default() });
        }
        envelope.code.map(drop).map_err(|source| unexpected(command, source))
    }
}

/// The error for a reply that does not fit the spec.
pub(crate) fn unexpected(command: &str, source: DecodeError) -> Error {
    Error::UnexpectedReply { command: command.to_owned(), source, exchanges: Exchanges::default() }
}
