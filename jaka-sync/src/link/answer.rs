//! What became of a command.

use std::sync::Arc;

use jaka_proto::Ticket;

use super::Sent;
use crate::reply::{self, Reply};
use crate::{Disconnect, Error, Exchanges};

/// What became of a command, told to the thread that waits for it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Answer {
    Reply(String),
    Lost,
}

/// The command that the reading thread waits for itself, if any.
#[derive(Debug)]
pub(super) struct Caller<'s, 'r> {
    own: Option<(&'s Sent<'s>, &'r mut String)>,
    /// Whether its command was accepted, once that is known.
    pub(super) outcome: Option<Result<(), Error>>,
}

impl<'s, 'r> Caller<'s, 'r> {
    /// It waits for nothing of its own.
    pub(super) fn nobody() -> Self {
        Self { own: None, outcome: None }
    }

    /// It waits for the reply to `sent`, whose text goes to `reply`.
    pub(super) fn new(sent: &'s Sent<'s>, reply: &'r mut String) -> Self {
        Self { own: Some((sent, reply)), outcome: None }
    }

    pub(super) fn is(&self, ticket: Ticket) -> bool {
        self.own.as_ref().is_some_and(|(sent, _)| sent.ticket == ticket)
    }

    pub(super) fn answered(&mut self, text: &str, envelope: Reply<'_>) {
        if let Some((sent, reply)) = &mut self.own {
            reply.clear();
            reply.push_str(text);
            self.outcome = Some(envelope.accepted(sent.command));
        }
    }

    /// A later command was answered: the caller's own reply, if it is that, will not come any more.
    pub(super) fn lost(&mut self, ticket: Ticket) -> bool {
        let own = self.own.as_ref().filter(|(sent, _)| sent.ticket == ticket);
        if let Some((sent, _)) = own {
            self.outcome = Some(Err(lost(sent.command)));
        }
        own.is_some()
    }

    /// Takes an answer that another thread has put aside.
    pub(super) fn take(&mut self, answer: Answer) {
        let Some((sent, reply)) = &mut self.own else { return };
        self.outcome = Some(match answer {
            Answer::Lost => Err(lost(sent.command)),
            Answer::Reply(text) => {
                **reply = text;
                let read = Reply::read(reply).map_err(|source| reply::unexpected(sent.command, source));
                read.and_then(|read| read.accepted(sent.command))
            }
        });
    }
}

pub(super) fn lost(command: &str) -> Error {
    Error::ReplyLost { command: command.to_owned(), exchanges: Exchanges::default() }
}

/// Whether a command was on the wire when its connection was broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Progress {
    Sent,
    NotSent,
}

pub(super) fn disconnected(command: &str, progress: Progress, cause: Arc<Disconnect>) -> Error {
    let (command, sent) = (Some(command.to_owned()), progress == Progress::Sent);
    Error::Disconnected { command, sent, cause, exchanges: Exchanges::default() }
}
