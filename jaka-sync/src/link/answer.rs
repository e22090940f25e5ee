//! What became of a command.

use std::sync::Arc;

use jaka_proto::Ticket;
use jaka_proto::wire::DecodeError;

use crate::reply::{self, Payload, Reply};
use crate::{Disconnect, Error, ErrorKind};

/// What became of a command, told to the thread that waits for it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Answer {
    Reply(String),
    /// A later command was answered: the reply will not come any more.
    Lost,
}

/// The command that the reading thread waits for itself, if any.
#[derive(Debug)]
pub(super) struct Caller<'s, 'r> {
    own: Option<Own<'s, 'r>>,
    /// Whether its command was accepted, once that is known.
    pub(super) outcome: Option<Result<(), Error>>,
}

/// A command that is waited for, and where its reply goes to: its text, and what is made of it.
#[derive(Debug)]
struct Own<'s, 'r> {
    ticket: Ticket,
    command: &'s str,
    text: &'r mut String,
    payload: &'r mut dyn Payload,
}

impl<'s, 'r> Caller<'s, 'r> {
    /// It waits for nothing of its own.
    pub(super) fn nobody() -> Self {
        Self { own: None, outcome: None }
    }

    /// It waits for the reply to a command, whose text goes to `text`.
    pub(super) fn new(ticket: Ticket, command: &'s str, text: &'r mut String, payload: &'r mut dyn Payload) -> Self {
        Self { own: Some(Own { ticket, command, text, payload }), outcome: None }
    }

    /// Reads a reply, as the caller's own if it waits for one.
    pub(super) fn read<'a>(&mut self, text: &'a str) -> Result<Reply<'a>, DecodeError> {
        self.own.as_mut().map_or_else(|| Reply::read(text), |own| own.payload.read(text))
    }

    pub(super) fn is(&self, ticket: Ticket) -> bool {
        self.ticket() == Some(ticket)
    }

    /// The command that it waits for.
    pub(super) fn ticket(&self) -> Option<Ticket> {
        self.own.as_ref().map(|own| own.ticket)
    }

    /// The reply that was read last is the caller's own.
    pub(super) fn answered(&mut self, text: &str, reply: Reply<'_>) {
        if let Some(own) = &mut self.own {
            own.text.clear();
            own.text.push_str(text);
            self.outcome = Some(reply.accepted(own.command));
        }
    }

    /// Takes an answer that was put aside.
    pub(super) fn take(&mut self, answer: Answer) {
        let Some(own) = &mut self.own else { return };
        let command = own.command;
        self.outcome = Some(match answer {
            Answer::Lost => Err(lost(command)),
            Answer::Reply(text) => {
                *own.text = text;
                let read = own.payload.read(own.text).map_err(|source| reply::unexpected(command, source));
                read.and_then(|read| read.accepted(command))
            }
        });
    }
}

pub(super) fn lost(command: &str) -> Error {
    ErrorKind::ReplyLost { command: command.to_owned() }.into()
}

/// Whether a command was on the wire when its connection was broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Progress {
    Sent,
    NotSent,
}

pub(super) fn disconnected(command: &str, progress: Progress, cause: Arc<Disconnect>) -> Error {
    let (command, sent) = (Some(command.to_owned()), progress == Progress::Sent);
    ErrorKind::Disconnected { command, sent, cause }.into()
}
