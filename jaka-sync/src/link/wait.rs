//! Waiting for replies.

use std::sync::MutexGuard;
use std::time::Duration;

use super::answer::{Caller, Progress, disconnected};
use super::posted::time_up;
use super::state::{Mode, State};
use super::{Link, Sent};
use crate::reply::Payload;
use crate::{Disconnect, Error};

impl Link {
    /// Waits for the reply to a command that was sent, puts its text into `text`, and has `payload` read it. A refusal is an
    /// error.
    pub(crate) fn wait(&self, sent: &Sent<'_>, text: &mut String, payload: &mut dyn Payload) -> Result<(), Error> {
        self.answer(sent, Caller::new(sent.ticket, sent.command, text, payload)).map_err(|error| self.attach(error))
    }

    fn answer(&self, sent: &Sent<'_>, mut caller: Caller<'_, '_>) -> Result<(), Error> {
        let mut state = self.lock();
        loop {
            if let Some(answer) = state.take(sent.ticket) {
                caller.take(answer);
            }
            if let Some(outcome) = caller.outcome {
                return outcome;
            }
            if let Some(cause) = state.broken.clone() {
                return Err(disconnected(sent.command, Progress::Sent, cause));
            }
            let left = sent.left();
            if left.is_zero() {
                return Err(self.give_up(&mut state, sent));
            }
            state = self.turn(state, left, &mut caller);
        }
    }

    /// Reads once for all, or sleeps while another thread does.
    pub(super) fn turn<'l>(
        &'l self,
        mut state: MutexGuard<'l, State>,
        left: Duration,
        caller: &mut Caller<'_, '_>,
    ) -> MutexGuard<'l, State> {
        let Some(stream) = state.stream.clone() else { return state };
        let Some(mut inbound) = state.inbound.take() else {
            drop(stream);
            return self.sleep(state, left);
        };
        // What has been read before comes first: it may be all that anybody waits for.
        let mut settled = inbound.settle(&self.tap, &mut state, caller);
        if matches!(settled, Ok(0)) {
            settled = Self::switch(&mut state, Mode::Blocking).map_err(Disconnect::Read).map(|()| 0);
        }
        if matches!(settled, Ok(0)) {
            drop(state);
            let read = inbound.read(&stream, &self.tap, left);
            // Before the lock: after a reset this closes the socket.
            drop(stream);
            state = self.lock();
            settled = inbound.settle(&self.tap, &mut state, caller).and_then(|count| read.map(|_| count));
        }
        if let Err(cause) = settled {
            self.tap.stray(inbound.partial());
            self.break_off(&mut state, cause);
        }
        self.put_back(&mut state, inbound);
        state
    }

    pub(super) fn sleep<'l>(&'l self, mut state: MutexGuard<'l, State>, left: Duration) -> MutexGuard<'l, State> {
        state.sleepers += 1;
        let mut state = match self.turned.wait_timeout(state, left) {
            Ok((state, _)) => state,
            Err(poisoned) => poisoned.into_inner().0,
        };
        state.sleepers -= 1;
        state
    }

    fn give_up(&self, state: &mut State, sent: &Sent<'_>) -> Error {
        match state.ledger.give_up(sent.ticket) {
            Ok(()) => time_up(sent.command, sent.timeout),
            Err(mistrust) => {
                let cause = self.break_off(state, Disconnect::Mistrust(mistrust));
                disconnected(sent.command, Progress::Sent, cause)
            }
        }
    }
}
