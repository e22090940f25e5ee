//! Waiting for replies.

use std::time::{Duration, Instant};

use jaka_proto::exchange::{ReadReply, Waiter};

use super::failure::{Progress, failed, timed_out};
use super::state::{Mode, State};
use super::{Link, Sent};
use crate::sync::MutexGuard;
use crate::{Disconnect, Error};

impl Link {
    /// Waits for the reply to a command that was sent, puts its text into `text`, and has `reader` read it. A refusal is an
    /// error.
    pub(crate) fn wait(&self, sent: &Sent<'_>, text: &mut String, reader: &mut dyn ReadReply) -> Result<(), Error> {
        let mut waiter = Waiter::new(sent.request, text, reader);
        let (mut state, outcome) = self.outcome(self.state.lock(), sent.command, &mut waiter, sent.since, sent.timeout);
        let outcome = outcome.unwrap_or_else(|| Err(self.give_up(&mut state, sent)));
        drop(state);
        outcome.map_err(|error| self.attach(error))
    }

    /// The outcome of the request that a waiter waits for; `None` if nothing has within `timeout`.
    pub(super) fn outcome<'l>(
        &'l self,
        mut state: MutexGuard<'l, State>,
        command: &str,
        waiter: &mut Waiter<'_>,
        since: Instant,
        timeout: Duration,
    ) -> (MutexGuard<'l, State>, Option<Result<(), Error>>) {
        loop {
            state.exchange.take_pending(waiter);
            if let Some(outcome) = waiter.take_outcome() {
                return (state, Some(outcome.map_err(|failure| failed(command, failure))));
            }
            if let Some(cause) = state.broken.clone() {
                return (state, Some(Err(self.disconnected(command, Progress::Sent, cause))));
            }
            let left = timeout.saturating_sub(self.clock.elapsed(since));
            if left.is_zero() {
                return (state, None);
            }
            state = self.turn(state, left, waiter);
        }
    }

    /// Reads once for all, or sleeps while another thread does.
    pub(super) fn turn<'l>(
        &'l self,
        mut state: MutexGuard<'l, State>,
        left: Duration,
        waiter: &mut Waiter<'_>,
    ) -> MutexGuard<'l, State> {
        let Some(stream) = state.stream.clone() else { return state };
        let Some(mut inbound) = state.inbound.take() else {
            drop(stream);
            return self.state.wait(state, left);
        };
        // What has been read before comes first: it may be all that anybody waits for.
        let mut attributed = inbound.attribute(&self.tap, &mut state.exchange, waiter);
        if matches!(attributed, Ok(0)) {
            attributed = Self::switch(&mut state, Mode::Blocking).map_err(Disconnect::Read).map(|()| 0);
        }
        if matches!(attributed, Ok(0)) {
            drop(state);
            let read = inbound.read(&stream, &self.tap, left);
            // Before the lock: after a reset this closes the socket.
            drop(stream);
            state = self.state.lock();
            let count = inbound.attribute(&self.tap, &mut state.exchange, waiter);
            attributed = count.and_then(|count| read.map(|_| count));
        }
        if let Err(cause) = attributed {
            self.tap.stray(inbound.partial());
            self.break_off(&mut state, cause);
        }
        self.put_back(&mut state, inbound);
        state
    }

    fn give_up(&self, state: &mut State, sent: &Sent<'_>) -> Error {
        match state.exchange.give_up(sent.request) {
            Ok(()) => timed_out(sent.command, sent.timeout),
            Err(out_of_sync) => {
                let cause = self.break_off(state, Disconnect::OutOfSync(out_of_sync));
                self.disconnected(sent.command, Progress::Sent, cause)
            }
        }
    }
}
