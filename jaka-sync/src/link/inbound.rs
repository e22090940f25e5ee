//! Reading of replies by the receiving half.

use std::panic;
use std::time::{Duration, Instant};

use jaka_proto::exchange::{ReadReply, Waiter};
use jaka_proto::wire::Writer;
use jaka_proto::{CommandInfo, Role};

use super::halves::Inbound;
use super::state::{LinkState, Mode};
use super::{Handle, Link, Outgoing, Sent, Transmission, failed, timed_out};
use crate::receive::{self, Chunk};
use crate::sync::MutexGuard;
use crate::{Disconnect, Error};

impl Link {
    /// Puts the receiving half back, and resumes a panic that it holds.
    pub(super) fn put_back(&self, state: &mut LinkState, mut inbound: Box<Inbound>) {
        let payload = inbound.panic.take();
        state.inbound = Some(inbound);
        self.state.wake();
        if let Some(payload) = payload {
            panic::resume_unwind(payload);
        }
    }

    /// Attributes the messages that have been read and not attributed. While another thread reads, that thread
    /// attributes all that it has read.
    pub(super) fn attribute_read(&self, state: &mut LinkState) -> Result<(), Disconnect> {
        self.with_inbound(state, |inbound, state| self.attribute_all(inbound, state))
    }

    /// Returns the state after the bytes that have come are read, without waiting.
    pub(super) fn arrived(&self) -> MutexGuard<'_, LinkState> {
        let mut state = self.state.lock();
        if let Err(cause) = self.attribute_arrived(&mut state) {
            self.break_off(&mut state, cause);
        }
        state
    }

    /// Reads the bytes that have come, without waiting, and attributes their messages.
    pub(super) fn attribute_arrived(&self, state: &mut LinkState) -> Result<(), Disconnect> {
        self.with_inbound(state, |inbound, state| {
            // No other thread reads. A thread that sends may be waiting in the socket, which must block then: only
            // bytes that were read are attributed.
            if state.mode == Mode::Blocking && state.outbound.is_none() {
                return self.attribute_all(inbound, state);
            }
            Self::switch(state, Mode::Nonblocking).map_err(Disconnect::Read)?;
            let Some(stream) = state.stream.clone() else { return Ok(()) };
            loop {
                let chunk = receive::arrived(&stream, &self.tap, &mut inbound.framer, Duration::ZERO);
                self.attribute_all(inbound, state)?;
                if chunk? != Chunk::Part {
                    return Ok(());
                }
            }
        })
    }

    /// Detects an end of the connection by the controller, without waiting, if no thread sends or reads. While nothing
    /// is outstanding, it does not read a reply that nobody waits for: such a reply breaks the connection, and a stop
    /// may have to be sent first. It does not see an end behind such a reply.
    pub(super) fn notice_end(&self, state: &mut LinkState) -> Result<(), Disconnect> {
        if state.outbound.is_none() {
            return Ok(());
        }
        if state.exchange.outstanding() > 0 {
            return self.attribute_arrived(state);
        }
        self.with_inbound(state, |inbound, state| {
            Self::switch(state, Mode::Nonblocking).map_err(Disconnect::Read)?;
            let Some(stream) = state.stream.clone() else { return Ok(()) };
            receive::check_end(&stream, &inbound.framer)
        })
    }

    fn attribute_all(&self, inbound: &mut Inbound, state: &mut LinkState) -> Result<(), Disconnect> {
        inbound.attribute((&self.tap, &self.stops), &mut state.exchange, &mut Waiter::nobody()).map(drop)
    }

    /// Calls a closure with the receiving half, unless a thread reads or reading has ended.
    fn with_inbound(
        &self,
        state: &mut LinkState,
        act: impl FnOnce(&mut Inbound, &mut LinkState) -> Result<(), Disconnect>,
    ) -> Result<(), Disconnect> {
        if state.broken.is_some() {
            return Ok(());
        }
        let Some(mut inbound) = state.inbound.take() else {
            return Ok(());
        };
        let done = act(&mut inbound, state);
        if done.is_err() {
            self.tap.stray(inbound.partial());
        }
        self.put_back(state, inbound);
        done
    }

    /// Waits for the reply to a command that was sent, puts its text into `text`, and lets `reader` read it. A refusal
    /// is an error.
    pub(crate) fn wait(&self, sent: &Sent<'_>, text: &mut String, reader: &mut dyn ReadReply) -> Result<(), Error> {
        let mut waiter = Waiter::new(sent.request, text, reader);
        let (mut state, outcome) = self.outcome(self.state.lock(), sent.command, &mut waiter, sent.since, sent.timeout);
        let outcome = outcome.unwrap_or_else(|| Err(self.give_up(&mut state, sent)));
        drop(state);
        outcome.map_err(|error| self.attach(error))
    }

    /// Outcome of the request that a waiter waits for; `None` without one within `timeout`.
    pub(super) fn outcome<'l>(
        &'l self,
        mut state: MutexGuard<'l, LinkState>,
        command: &str,
        waiter: &mut Waiter<'_>,
        since: Instant,
        timeout: Duration,
    ) -> (MutexGuard<'l, LinkState>, Option<Result<(), Error>>) {
        loop {
            state.exchange.take_pending(waiter);
            if let Some(outcome) = waiter.take_outcome() {
                return (state, Some(outcome.map_err(|failure| failed(command, failure))));
            }
            if let Some(cause) = state.broken.clone() {
                return (state, Some(Err(self.disconnected(command, Transmission::Sent, cause))));
            }
            let left = timeout.saturating_sub(self.clock.elapsed(since));
            if left.is_zero() {
                return (state, None);
            }
            state = self.turn(state, left, waiter);
        }
    }

    /// Reads once for all threads, or sleeps while another thread reads.
    pub(super) fn turn<'l>(
        &'l self,
        mut state: MutexGuard<'l, LinkState>,
        left: Duration,
        waiter: &mut Waiter<'_>,
    ) -> MutexGuard<'l, LinkState> {
        let Some(stream) = state.stream.clone() else { return state };
        let Some(mut inbound) = state.inbound.take() else {
            drop(stream);
            return self.state.wait(state, left);
        };
        // Bytes that were read before come first: they may be the only ones that a thread waits for.
        let mut attributed = inbound.attribute((&self.tap, &self.stops), &mut state.exchange, waiter);
        if matches!(attributed, Ok(0)) {
            attributed = Self::switch(&mut state, Mode::Blocking).map_err(Disconnect::Read).map(|()| 0);
        }
        if matches!(attributed, Ok(0)) {
            drop(state);
            let read = inbound.read(&stream, &self.tap, left);
            // Before the lock: after a reset this closes the socket.
            drop(stream);
            state = self.state.lock();
            let count = inbound.attribute((&self.tap, &self.stops), &mut state.exchange, waiter);
            attributed = count.and_then(|count| read.map(|_| count));
        }
        if let Err(cause) = attributed {
            self.tap.stray(inbound.partial());
            self.break_off(&mut state, cause);
        }
        self.put_back(&mut state, inbound);
        state
    }

    fn give_up(&self, state: &mut LinkState, sent: &Sent<'_>) -> Error {
        match state.exchange.give_up(sent.request) {
            Ok(()) => timed_out(sent.command, sent.timeout),
            Err(out_of_sync) => {
                let cause = self.break_off(state, Disconnect::OutOfSync(out_of_sync));
                self.disconnected(sent.command, Transmission::Sent, cause)
            }
        }
    }

    /// Sends a command whose reply is polled for, without a deadline: see [`poll`](Self::poll).
    /// [`forget`](Self::forget) gives up the reply. A send that takes longer than the reply timeout fails.
    pub fn ask(
        &self,
        (info, role, by): (&'static CommandInfo, Option<Role>, Handle),
        write: &mut dyn FnMut(&mut Writer),
    ) -> Result<Sent<'static>, Error> {
        let outgoing = Outgoing::of(&self.clock, info, self.reply_timeout).of_handle(by).in_role(role);
        self.send(&outgoing, write)
    }

    /// Waits for the reply to a question for at most `slice`, puts its text into `text` and lets `reader` read it.
    /// Returns false if it has not come by then, and the caller can poll again. A slice of zero checks the bytes that
    /// have come. A refusal is an error, which answers the question too.
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
