//! Attribution of the replies of a recording to its requests.

use std::collections::HashMap;
use std::time::Duration;

use super::{Ending, Event, Message, Port, Recording};
use crate::exchange::sent::{Recipient, SentRequests};
use crate::exchange::{Owner, RequestId, Support};
use crate::{CommandInfo, Envelope, Request};

/// A recorded request, and its outcome.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Answered {
    /// The request.
    pub request: Message,
    /// Time at which it was sent, counted from the start of the recording.
    pub sent: Duration,
    /// Outcome of the request.
    pub answer: Answer,
}

/// Outcome of a request.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Answer {
    /// A reply, in time or late.
    Reply {
        /// The reply.
        reply: Message,
        /// Time from the request to the arrival of the reply.
        after: Duration,
    },
    /// No reply, and the connection ended from the other side.
    Closed {
        /// Party that ended it.
        by: Ending,
    },
    /// No reply.
    Nothing,
}

/// Requests with their outcomes: see [`Recording::answers`].
pub(super) fn answers(recording: &Recording) -> Vec<Answered> {
    let mut pairs = Pairs::default();
    for entry in recording.entries.iter().filter(|entry| entry.port == Port::Command) {
        match &entry.event {
            Event::Sent(request) => pairs.sent(entry.connection, request, entry.time),
            Event::Received(reply) => pairs.received(entry.connection, reply, entry.time),
            Event::Closed { by, .. } => pairs.closed(entry.connection, *by),
            _ => {}
        }
    }
    pairs.all
}

#[derive(Debug, Default)]
struct Pairs {
    all: Vec<Answered>,
    connections: HashMap<u32, Connection>,
}

/// The requests of one connection that have no reply yet.
#[derive(Debug)]
struct Connection {
    sent: SentRequests,
    /// Their places in the recording.
    open: Vec<(RequestId, usize)>,
}

impl Default for Connection {
    fn default() -> Self {
        Self { sent: SentRequests::new(Request::bare_reply_command()), open: Vec::new() }
    }
}

impl Pairs {
    fn sent(&mut self, connection: u32, request: &Message, sent: Duration) {
        let name = request.text().and_then(|text| Envelope::read(text).ok()?.command).unwrap_or_default();
        let connection = self.connections.entry(connection).or_default();
        let support = Support::of(CommandInfo::of(&name).and_then(|info| info.role));
        let id = connection.sent.push(Owner::default(), support, name.into_owned().into(), Recipient::Waiter);
        connection.open.push((id, self.all.len()));
        self.all.push(Answered { request: request.clone(), sent, answer: Answer::Nothing });
    }

    fn received(&mut self, connection: u32, reply: &Message, time: Duration) {
        let Some(connection) = self.connections.get_mut(&connection) else { return };
        let Some(id) = completed_by(&mut connection.sent, reply) else { return };
        let Some(place) = connection.open.iter().position(|(owner, _)| *owner == id) else { return };
        let (_, place) = connection.open.swap_remove(place);
        let after = time.saturating_sub(self.all[place].sent);
        self.all[place].answer = Answer::Reply { reply: reply.clone(), after };
    }

    fn closed(&mut self, connection: u32, by: Ending) {
        let last = self.connections.remove(&connection).and_then(|connection| connection.open.last().copied());
        // Requests sent before the last one may have been lost before.
        if let (Some((_, place)), Ending::Controller | Ending::Failure) = (last, by) {
            self.all[place].answer = Answer::Closed { by };
        }
    }
}

fn completed_by(sent: &mut SentRequests, reply: &Message) -> Option<RequestId> {
    let text = reply.text()?;
    let envelope = if text.starts_with('(') { None } else { Some(Envelope::read(text).ok()?) };
    sent.complete_by(envelope.as_ref(), drop).ok()?.map(|request| request.id)
}
