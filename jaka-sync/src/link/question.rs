//! A command whose reply is looked for now and then.

use std::time::Duration;

use jaka_proto::CommandInfo;
use jaka_proto::exchange::{ReadReply, Waiter};
use jaka_proto::wire::Writer;

use super::{Handle, Link, Outgoing, Sent};
use crate::Error;

impl Link {
    /// Sends a command whose reply is polled for, without a deadline: see [`poll`](Self::poll).
    /// [`forget`](Self::forget) gives up a reply that is no longer wanted. A send that takes longer than the reply
    /// timeout fails.
    pub fn ask(
        &self,
        by: Handle,
        info: &'static CommandInfo,
        write: &mut dyn FnMut(&mut Writer),
    ) -> Result<Sent<'static>, Error> {
        let outgoing = Outgoing::of(&self.clock, info, self.reply_timeout).of_handle(by);
        self.send(&outgoing.in_forms_of(self.firmware()), write)
    }

    /// Waits for the reply to a question at most `slice`, puts its text into `text` and has `reader` read it; false if
    /// it has not come by then, and it can be polled for again. A slice of zero looks at what has come. A refusal is an
    /// error, which answers the question too.
    pub fn poll(
        &self,
        question: &Sent<'_>,
        slice: Duration,
        text: &mut String,
        reader: &mut dyn ReadReply,
    ) -> Result<bool, Error> {
        let (since, mut waiter) = (self.clock.now(), Waiter::new(question.request, text, reader));
        let state = if slice.is_zero() { self.arrived() } else { self.state.lock() };
        let (state, outcome) = self.outcome(state, question.command, &mut waiter, since, slice);
        drop(state);
        outcome.transpose().map(|answered| answered.is_some()).map_err(|error| self.attach(error))
    }

    /// Abandons a question: its reply is discarded when it comes.
    pub fn forget(&self, question: &Sent<'_>) {
        self.state.lock().exchange.abandon(question.request);
    }
}
