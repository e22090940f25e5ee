//! A command whose reply is looked for now and then.

use std::time::Duration;

use jaka_proto::CommandInfo;
use jaka_proto::exchange::{ReadReply, RequestId, Waiter};
use jaka_proto::wire::Writer;

use super::{Link, Outgoing};
use crate::Error;

/// A command that was sent, and whose reply has no deadline: see [`Link::poll`].
///
/// [`Link::forget`] gives up a reply that is no longer wanted.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Question {
    request: RequestId,
    command: &'static str,
}

impl Link {
    /// Sends a command whose reply is polled for. A send that takes longer than the reply timeout fails.
    pub(crate) fn ask(
        &self,
        info: &'static CommandInfo,
        write: &mut dyn FnMut(&mut Writer),
    ) -> Result<Question, Error> {
        let sent = self.send(&Outgoing::of(&self.clock, info, self.reply_timeout), write)?;
        Ok(Question { request: sent.request, command: info.name })
    }

    /// Waits for the reply to a question at most `slice`, puts its text into `text` and has `reader` read it; false if it has not come
    /// by then, and it can be polled for again. A slice of zero looks at what has come. A refusal is an error, which answers the question too.
    pub(crate) fn poll(
        &self,
        question: &Question,
        slice: Duration,
        text: &mut String,
        reader: &mut dyn ReadReply,
    ) -> Result<bool, Error> {
        let (since, mut waiter) = (self.clock.now(), Waiter::new(question.request, text, reader));
        let mut state = self.lock();
        if slice.is_zero() {
            if let Err(cause) = self.attribute_arrived(&mut state) {
                self.break_off(&mut state, cause);
            }
        }
        let (state, outcome) = self.outcome(state, question.command, &mut waiter, since, slice);
        drop(state);
        outcome.transpose().map(|answered| answered.is_some()).map_err(|error| self.attach(error))
    }

    /// Abandons a question: its reply is discarded when it comes.
    pub(crate) fn forget(&self, question: &Question) {
        self.lock().exchange.abandon(question.request);
    }
}
