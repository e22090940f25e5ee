//! The receiving half of a connection.

use std::any::Any;
use std::net::TcpStream;
use std::panic::{self, AssertUnwindSafe};
use std::time::Duration;

use jaka_proto::Mistrust;
use jaka_proto::framing::{self, Framer};

use super::Link;
use super::answer::Caller;
use super::state::{Mode, State};
use crate::receive::{self, Chunk, Rest};
use crate::recorder::Tap;
use crate::{Disconnect, ports};

/// The receiving half: the reading thread takes it out of the state.
#[derive(Debug)]
pub(super) struct Inbound {
    framer: Framer,
    timeout: receive::Timeout,
    /// A panic of a logger, or of what reads a reply for its caller. It goes on once the receiving half is back in its place.
    panic: Option<Box<dyn Any + Send>>,
}

impl Inbound {
    pub(super) fn new(max_frame: usize) -> Self {
        Self { framer: Framer::new(max_frame), timeout: receive::Timeout::default(), panic: None }
    }

    pub(super) fn read(&mut self, stream: &TcpStream, tap: &Tap, left: Duration) -> Result<Chunk, Disconnect> {
        receive::chunk(stream, tap, &mut self.framer, &mut self.timeout, left)
    }

    /// Settles the debts of all messages that have been read, up to the caller's own, and says how many there were.
    pub(super) fn settle(
        &mut self,
        tap: &Tap,
        state: &mut State,
        caller: &mut Caller<'_, '_>,
    ) -> Result<usize, Disconnect> {
        let mut count = 0;
        while caller.outcome.is_none() && self.panic.is_none() {
            let Some(frame) = self.framer.next_frame().map_err(Disconnect::Frame)? else { break };
            tap.received(frame);
            let text = framing::text(frame);
            self.panic = settle_whole(state, &text, caller).map_err(|cause| explained(cause, &text))?;
            count += 1;
        }
        Ok(count)
    }

    /// The bytes that belong to no message yet.
    pub(super) fn partial(&self) -> &[u8] {
        self.framer.partial()
    }
}

/// Settles a reply, also where a logger, or what reads it for its caller, panics: whose it is has nothing to do with them.
fn settle_whole(
    state: &mut State,
    text: &str,
    caller: &mut Caller<'_, '_>,
) -> Result<Option<Box<dyn Any + Send>>, Disconnect> {
    let owed = state.ledger.outstanding();
    let settled = panic::catch_unwind(AssertUnwindSafe(|| {
        log::trace!(target: "jaka_sync::wire", "<- {text}");
        state.settle(text, caller)
    }));
    let payload = match settled {
        Ok(settled) => return settled.map(|()| None),
        Err(payload) => payload,
    };
    if state.ledger.outstanding() == owed {
        let again = panic::catch_unwind(AssertUnwindSafe(|| state.settle(text, &mut Caller::nobody())));
        // A second panic is the logger's, behind all that matters, unless the account shows that nothing was settled.
        again.unwrap_or_else(|_| if state.ledger.outstanding() < owed { Ok(()) } else { Err(Disconnect::Panicked) })?;
        // Its caller is gone.
        caller.ticket().and_then(|ticket| state.take(ticket));
    }
    Ok(Some(payload))
}

/// The same cause, unless what came shows that this is another port.
fn explained(cause: Disconnect, text: &str) -> Disconnect {
    if matches!(cause, Disconnect::Mistrust(Mistrust::Nameless)) && ports::is_status(text) {
        return Disconnect::StatusPort;
    }
    cause
}

impl Link {
    /// Puts the receiving half back, and lets a panic go on that was held up.
    pub(super) fn put_back(&self, state: &mut State, mut inbound: Box<Inbound>) {
        let payload = inbound.panic.take();
        state.inbound = Some(inbound);
        self.wake(state);
        if let Some(payload) = payload {
            panic::resume_unwind(payload);
        }
    }

    /// Settles what has been read and not looked at. Where another thread reads, it looks at all that it has read.
    pub(super) fn settle_read(&self, state: &mut State) -> Result<(), Disconnect> {
        self.with_inbound(state, |inbound, state| inbound.settle(&self.tap, state, &mut Caller::nobody()).map(drop))
    }

    /// Reads what has come, without waiting, and settles it.
    pub(super) fn settle_arrived(&self, state: &mut State) -> Result<(), Disconnect> {
        self.with_inbound(state, |inbound, state| {
            // Nobody else reads. One who sends may be waiting in the socket, which must block then: what was read has to do.
            if state.mode == Mode::Blocking && state.outbound.is_none() {
                return inbound.settle(&self.tap, state, &mut Caller::nobody()).map(drop);
            }
            Self::switch(state, Mode::Nonblocking).map_err(Disconnect::Read)?;
            let Some(stream) = state.stream.clone() else { return Ok(()) };
            loop {
                let rest = receive::arrived(&stream, &self.tap, &mut inbound.framer);
                inbound.settle(&self.tap, state, &mut Caller::nobody())?;
                if rest? == Rest::Nothing {
                    return Ok(());
                }
            }
        })
    }

    /// Does something with the receiving half, unless a thread reads or nobody will any more.
    fn with_inbound(
        &self,
        state: &mut State,
        settle: impl FnOnce(&mut Inbound, &mut State) -> Result<(), Disconnect>,
    ) -> Result<(), Disconnect> {
        if state.broken.is_some() {
            return Ok(());
        }
        let Some(mut inbound) = state.inbound.take() else {
            return Ok(());
        };
        let settled = settle(&mut inbound, state);
        if settled.is_err() {
            self.tap.stray(inbound.partial());
        }
        self.put_back(state, inbound);
        settled
    }
}
