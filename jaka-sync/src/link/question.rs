//! A command whose reply is looked for now and then.

use std::borrow::Cow;
use std::time::{Duration, Instant};

use jaka_proto::wire::Writer;
use jaka_proto::{CommandInfo, Ticket};

use super::Link;
use super::answer::{Caller, Progress, disconnected};
use crate::Error;
use crate::reply::Payload;

/// A command that was sent, and whose reply has no deadline: see [`Link::poll`].
///
/// [`Link::forget`] gives up a reply that nobody will look for any more.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Question {
    ticket: Ticket,
    command: &'static str,
}

impl Link {
    /// Sends a command whose reply is polled for. A send that takes longer than the reply timeout fails.
    pub(crate) fn ask(
        &self,
        info: &'static CommandInfo,
        write: &mut dyn FnMut(&mut Writer),
    ) -> Result<Question, Error> {
        let sent = self.send(info.name, Cow::Borrowed(info.name), self.reply_timeout, None, write)?;
        Ok(Question { ticket: sent.ticket, command: info.name })
    }

    /// Waits for the reply to a question at most `slice`, puts its text into `text` and has `payload` read it; false if it has not come
    /// by then, and it can be polled for again. A slice of zero looks at what has come. A refusal is an error, which answers the question too.
    pub(crate) fn poll(
        &self,
        question: &Question,
        slice: Duration,
        text: &mut String,
        payload: &mut dyn Payload,
    ) -> Result<bool, Error> {
        let since = Instant::now();
        let mut caller = Caller::new(question.ticket, question.command, text, payload);
        let mut state = self.lock();
        if slice.is_zero() {
            if let Err(cause) = self.settle_arrived(&mut state) {
                self.break_off(&mut state, cause);
            }
        }
        loop {
            if let Some(answer) = state.take(question.ticket) {
                caller.take(answer);
            }
            if let Some(outcome) = caller.outcome {
                return outcome.map(|()| true).map_err(|error| self.attach(error));
            }
            if let Some(cause) = state.broken.clone() {
                return Err(self.attach(disconnected(question.command, Progress::Sent, cause)));
            }
            let left = slice.saturating_sub(since.elapsed());
            if left.is_zero() {
                return Ok(false);
            }
            state = self.turn(state, left, &mut caller);
        }
    }

    /// Gives up the reply to a question: it belongs to nobody when it comes.
    pub(crate) fn forget(&self, question: &Question) {
        let mut state = self.lock();
        if state.take(question.ticket).is_none() {
            state.ledger.abandon(question.ticket);
        }
    }
}
