//! A thread that waits for the reply to a request.

use std::fmt;
use std::time::Duration;

use super::{Pending, RequestId};
use crate::command::CommandInfo;
use crate::envelope::Envelope;
use crate::refusal::Refusal;
use crate::reply::{read_envelope, read_payload, read_reply};
use crate::wire::{DecodeError, Fields};

/// Reason for the failure of a request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Failure {
    /// The controller refused the command.
    Refused(Refusal),
    /// The reply does not fit the spec, or does not say whether the command was accepted.
    Unexpected(DecodeError),
    /// A later request was answered: the reply will not come any more.
    Lost,
    /// The reply to a posted request has not come in time.
    TimedOut {
        /// Time waited for the reply.
        after: Duration,
    },
}

/// Reads replies as the type that a thread waits for, in the one pass that also attributes each reply.
pub trait ReadReply {
    /// Reads a reply as the awaited one, for any request. `None` for a bare Python tuple, which has no envelope.
    ///
    /// # Errors
    /// The text is neither an object by its quotes and brackets nor a Python tuple.
    fn read<'a>(&mut self, text: &'a str) -> Result<Option<Envelope<'a>>, DecodeError>;
}

impl fmt::Debug for dyn ReadReply + '_ {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("ReadReply")
    }
}

/// The reply's text is all that is wanted.
#[derive(Debug, Clone, Copy, Default)]
pub struct TextOnly;

impl ReadReply for TextOnly {
    fn read<'a>(&mut self, text: &'a str) -> Result<Option<Envelope<'a>>, DecodeError> {
        read_envelope(text)
    }
}

/// The payload of the reply that was read last, if the command was accepted.
#[derive(Debug)]
pub struct TypedReply<R> {
    command: &'static CommandInfo,
    payload: Option<Result<R, DecodeError>>,
}

impl<R: Fields> TypedReply<R> {
    /// Reads replies as that to `command`; none has been read yet.
    pub fn new(command: &'static CommandInfo) -> Self {
        Self { command, payload: None }
    }

    /// The payload of the reply that was read last, which is `text`.
    ///
    /// # Errors
    /// The payload does not fit.
    pub fn take(self, text: &str) -> Result<R, DecodeError> {
        self.payload.unwrap_or_else(|| read_payload(self.command, text))
    }
}

impl<R: Fields> ReadReply for TypedReply<R> {
    fn read<'a>(&mut self, text: &'a str) -> Result<Option<Envelope<'a>>, DecodeError> {
        let reply = read_reply(self.command, text)?;
        self.payload = reply.payload;
        Ok(reply.envelope)
    }
}

/// A thread that waits for the reply to a request, or reads for others alone.
#[derive(Debug)]
pub struct Waiter<'r> {
    own: Option<Own<'r>>,
    outcome: Option<Result<(), Failure>>,
}

/// The request, and the destination of its reply: its text, and the values read from it.
#[derive(Debug)]
struct Own<'r> {
    request: RequestId,
    text: &'r mut String,
    reader: &'r mut dyn ReadReply,
}

impl<'r> Waiter<'r> {
    /// Waits for the reply to a request. Its text goes to `text`, and it is read by `reader`.
    pub fn new(request: RequestId, text: &'r mut String, reader: &'r mut dyn ReadReply) -> Self {
        Self { own: Some(Own { request, text, reader }), outcome: None }
    }

    /// Waits for no reply: a thread that reads for others.
    pub fn nobody() -> Self {
        Self { own: None, outcome: None }
    }

    /// The request, if it waits for the reply to one.
    pub fn request(&self) -> Option<RequestId> {
        self.own.as_ref().map(|own| own.request)
    }

    /// Takes the outcome of its request, once it is known: whether the command was accepted.
    pub fn take_outcome(&mut self) -> Option<Result<(), Failure>> {
        self.outcome.take()
    }

    /// True once the outcome of its request is known.
    pub fn is_done(&self) -> bool {
        self.outcome.is_some()
    }

    /// Reads a reply, as its own if it waits for one. [`Exchange::receive`](super::Exchange::receive) then finds its
    /// request.
    ///
    /// # Errors
    /// The text is neither an object by its quotes and brackets nor a Python tuple.
    pub fn read<'a>(&mut self, text: &'a str) -> Result<Option<Envelope<'a>>, DecodeError> {
        self.own.as_mut().map_or_else(|| read_envelope(text), |own| own.reader.read(text))
    }

    pub(super) fn is_for(&self, request: RequestId) -> bool {
        self.request() == Some(request)
    }

    pub(super) fn fail(&mut self, failure: Failure) {
        self.outcome = Some(Err(failure));
    }

    /// The reply that was read last is its own.
    pub(super) fn complete(&mut self, text: &str, envelope: Option<Envelope<'_>>) {
        if let Some(own) = &mut self.own {
            own.text.clear();
            own.text.push_str(text);
            self.outcome = Some(accepted(envelope));
        }
    }

    /// Takes the pending outcome.
    pub(super) fn take(&mut self, pending: Pending) {
        let Some(own) = &mut self.own else { return };
        self.outcome = Some(match pending {
            Pending::Lost => Err(Failure::Lost),
            Pending::Reply(text) => {
                *own.text = text;
                own.reader.read(own.text).map_err(Failure::Unexpected).and_then(accepted)
            }
        });
    }
}

/// Fails if the controller refused the command, or does not say whether it did. A bare Python tuple is not a refusal.
pub(super) fn accepted(envelope: Option<Envelope<'_>>) -> Result<(), Failure> {
    let Some(envelope) = envelope else { return Ok(()) };
    match envelope.refusal() {
        Some(refusal) => Err(Failure::Refused(refusal)),
        None => envelope.code.map(drop).map_err(Failure::Unexpected),
    }
}
