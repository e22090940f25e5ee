//! The receiving half of a connection.

use std::net::TcpStream;
use std::time::Duration;

use jaka_proto::framing::Framer;

use super::Link;
use super::answer::Caller;
use super::state::{Mode, State};
use crate::Disconnect;
use crate::receive::{self, Chunk, Rest};
use crate::recorder::Tap;

/// The receiving half: the reading thread takes it out of the state.
#[derive(Debug)]
pub(super) struct Inbound {
    framer: Framer,
    timeout: receive::Timeout,
}

impl Inbound {
    pub(super) fn new(max_frame: usize) -> Self {
        Self { framer: Framer::new(max_frame), timeout: receive::Timeout::default() }
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
        while caller.outcome.is_none() {
            let Some(frame) = self.framer.next_frame().map_err(Disconnect::Frame)? else { break };
            tap.received(frame);
            let text = std::str::from_utf8(frame).map_err(|_| Disconnect::NotUtf8)?;
            log::trace!(target: "jaka_sync::wire", "<- {text}");
            state.settle(text, caller)?;
            count += 1;
        }
        Ok(count)
    }

    /// The bytes that belong to no message yet.
    pub(super) fn partial(&self) -> &[u8] {
        self.framer.partial()
    }
}

impl Link {
    /// Settles what has been read and not looked at. Where another thread reads, it looks at all that it has read.
    pub(super) fn settle_read(&self, state: &mut State) -> Result<(), Disconnect> {
        self.with_inbound(state, |inbound, state| inbound.settle(&self.tap, state, &mut Caller::nobody()).map(drop))
    }

    /// Reads what has come, without waiting, and settles it.
    pub(super) fn settle_arrived(&self, state: &mut State) -> Result<(), Disconnect> {
        self.with_inbound(state, |inbound, state| {
            // Nobody else reads, and who writes holds the lock.
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
        state.inbound = Some(inbound);
        self.wake(state);
        settled
    }
}
