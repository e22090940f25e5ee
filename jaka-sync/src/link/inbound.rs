//! The receiving half of a connection.

use std::any::Any;
use std::panic::{self, AssertUnwindSafe};
use std::time::Duration;

use jaka_proto::exchange::{Delivery, Exchange, OutOfSync, Waiter};
use jaka_proto::framing::{self, Framer};
use jaka_proto::wire::DecodeError;
use jaka_proto::{Envelope, read_envelope};

use super::state::{Mode, State};
use super::{Link, WIRE};
use crate::receive::{self, Chunk};
use crate::recorder::Tap;
use crate::socket::Socket;
use crate::sync::MutexGuard;
use crate::{Disconnect, ports};

/// What a panic leaves.
type Panic = Box<dyn Any + Send>;

/// The receiving half: the reading thread takes it out of the state.
#[derive(Debug)]
pub(super) struct Inbound {
    framer: Framer,
    timeout: receive::Timeout,
    /// A panic of a logger, or of what reads a reply for its caller. It goes on once the receiving half is back in its place.
    panic: Option<Panic>,
}

impl Inbound {
    pub(super) fn new(max_frame: usize) -> Self {
        Self { framer: Framer::new(max_frame), timeout: receive::Timeout::default(), panic: None }
    }

    pub(super) fn read(&mut self, stream: &Socket, tap: &Tap, left: Duration) -> Result<Chunk, Disconnect> {
        receive::chunk(stream, tap, &mut self.framer, &mut self.timeout, left)
    }

    /// Attributes all messages that have been read, up to the waiter's own reply, and says how many there were.
    pub(super) fn attribute(
        &mut self,
        tap: &Tap,
        exchange: &mut Exchange,
        waiter: &mut Waiter<'_>,
    ) -> Result<usize, Disconnect> {
        let mut count = 0;
        while !waiter.is_done() && self.panic.is_none() {
            let Some(frame) = self.framer.next_frame().map_err(Disconnect::Frame)? else { break };
            tap.received(frame);
            let text = framing::text(frame);
            self.panic = receive_one(exchange, &text, waiter).map_err(|cause| explained(cause, &text))?;
            count += 1;
        }
        Ok(count)
    }

    /// The bytes that belong to no message yet.
    pub(super) fn partial(&self) -> &[u8] {
        self.framer.partial()
    }
}

/// Attributes a reply, also where a logger, or what reads the reply for its waiter, panics: whose it is has nothing to do with them.
fn receive_one(exchange: &mut Exchange, text: &str, waiter: &mut Waiter<'_>) -> Result<Option<Panic>, Disconnect> {
    let read = panic::catch_unwind(AssertUnwindSafe(|| {
        log::trace!(target: WIRE, "<- {text}");
        waiter.read(text)
    }));
    match read {
        Ok(envelope) => deliver(exchange, text, envelope, waiter),
        Err(payload) => {
            deliver(exchange, text, read_envelope(text), &mut Waiter::nobody())?;
            // The waiter is gone.
            if let Some(request) = waiter.request() {
                exchange.discard_pending(request);
            }
            Ok(Some(payload))
        }
    }
}

/// Attributes a reply that was read, and logs one that came late.
fn deliver(
    exchange: &mut Exchange,
    text: &str,
    envelope: Result<Option<Envelope<'_>>, DecodeError>,
    waiter: &mut Waiter<'_>,
) -> Result<Option<Panic>, Disconnect> {
    let envelope = envelope.map_err(Disconnect::NotJson)?;
    let received = exchange.receive(text, envelope, waiter).map_err(Disconnect::OutOfSync)?;
    if received.delivery != Delivery::Discarded {
        return Ok(None);
    }
    let command = &received.command;
    let log = || log::debug!(target: WIRE, "late reply to `{command}` dropped");
    Ok(panic::catch_unwind(AssertUnwindSafe(log)).err())
}

/// The same cause, unless what came shows that this is another port.
fn explained(cause: Disconnect, text: &str) -> Disconnect {
    if matches!(cause, Disconnect::OutOfSync(OutOfSync::Nameless)) && ports::is_status(text) {
        return Disconnect::StatusPort;
    }
    cause
}

impl Link {
    /// Puts the receiving half back, and lets a panic go on that was held up.
    pub(super) fn put_back(&self, state: &mut State, mut inbound: Box<Inbound>) {
        let payload = inbound.panic.take();
        state.inbound = Some(inbound);
        self.state.wake();
        if let Some(payload) = payload {
            panic::resume_unwind(payload);
        }
    }

    /// Attributes what has been read and not attributed. Where another thread reads, it attributes all that it has read.
    pub(super) fn attribute_read(&self, state: &mut State) -> Result<(), Disconnect> {
        self.with_inbound(state, |inbound, state| self.attribute_all(inbound, state))
    }

    /// The state, once what has come is read, without waiting.
    pub(super) fn arrived(&self) -> MutexGuard<'_, State> {
        let mut state = self.state.lock();
        if let Err(cause) = self.attribute_arrived(&mut state) {
            self.break_off(&mut state, cause);
        }
        state
    }

    /// Reads what has come, without waiting, and attributes it.
    pub(super) fn attribute_arrived(&self, state: &mut State) -> Result<(), Disconnect> {
        self.with_inbound(state, |inbound, state| {
            // No other thread reads. A thread that sends may be waiting in the socket, which must block then: what was read has to do.
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

    /// Finds out whether the controller has ended the connection, without waiting, where no thread sends or reads. A reply that nobody waits for is not read
    /// where nothing is outstanding: it breaks the connection, and a stop may have to go out first. An end behind it is not seen then.
    pub(super) fn notice_end(&self, state: &mut State) -> Result<(), Disconnect> {
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

    fn attribute_all(&self, inbound: &mut Inbound, state: &mut State) -> Result<(), Disconnect> {
        inbound.attribute(&self.tap, &mut state.exchange, &mut Waiter::nobody()).map(drop)
    }

    /// Calls a closure with the receiving half, unless a thread reads or reading has ended.
    fn with_inbound(
        &self,
        state: &mut State,
        act: impl FnOnce(&mut Inbound, &mut State) -> Result<(), Disconnect>,
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
}
