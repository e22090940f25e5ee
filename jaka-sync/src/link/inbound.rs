//! Reading of replies by the receiving half.

use std::panic;
use std::time::Duration;

use jaka_proto::exchange::Waiter;

use super::Link;
use super::halves::Inbound;
use super::state::{Mode, State};
use crate::Disconnect;
use crate::receive::{self, Chunk};
use crate::sync::MutexGuard;

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
