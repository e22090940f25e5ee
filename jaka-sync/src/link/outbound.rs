//! Writing of requests by the sending half.

use std::borrow::Cow;
use std::io;
use std::sync::atomic::Ordering;

use jaka_clock::Socket;
use jaka_proto::exchange::{RequestId, Waiter};
use jaka_proto::wire::Writer;

use super::halves::Outbound;
use super::outgoing::{Gate, Outgoing, SendError};
use super::state::{LinkState, Mode};
use super::{Link, Transmission, WIRE};
use crate::on_drop::OnDrop;
use crate::sync::MutexGuard;
use crate::{Disconnect, Error};

/// Commands that were sent.
#[derive(Debug)]
pub(crate) struct Dispatched {
    /// The last of the commands.
    pub(super) last: RequestId,
    /// Number of commands sent.
    pub(crate) sent: usize,
    /// Number of outstanding posted commands of their owner.
    pub(crate) outstanding: usize,
}

impl Link {
    /// Sends up to this many commands in one write, and enters them into the exchange. `write` writes the request with
    /// an index. Of long requests, beside a reservation, and of a command that the controller may lack, only some are
    /// sent at once.
    ///
    /// The thread whose turn it is asks the gate and enters the commands under the lock: the exchange has the order of
    /// the wire, and nothing is sent after a stop that the gate knows of. Between the gate and the write no code of the
    /// program runs. The logger gets its lines afterwards, when other threads can send again.
    pub(crate) fn transmit<R>(
        &self,
        outgoing: &Outgoing<'_>,
        gate: Gate<'_, R>,
        count: usize,
        write: &mut dyn FnMut(usize, &mut Writer),
    ) -> Result<Dispatched, SendError<R>> {
        let mut lines = log::log_enabled!(target: WIRE, log::Level::Trace).then(Vec::new);
        let dispatched = self.dispatch(outgoing, gate, count, write, lines.as_mut())?;
        if let Some(lines) = lines {
            // If the logger panics, no thread waits for the reply.
            let abandon = || self.state.lock().exchange.abandon(dispatched.last);
            let unawaited = (!outgoing.is_posted).then(|| OnDrop(abandon));
            for line in lines {
                log::trace!(target: WIRE, "-> {line}");
            }
            std::mem::forget(unawaited);
        }
        Ok(dispatched)
    }

    /// Begins to send a stop: until the result is dropped, no thread starts to send another command.
    pub(super) fn pass_first(&self) -> OnDrop<impl Fn()> {
        self.passing.fetch_add(1, Ordering::SeqCst);
        OnDrop(|| {
            self.passing.fetch_sub(1, Ordering::SeqCst);
            // With the lock, so that no thread is between checking and waiting.
            let _state = self.state.lock();
            self.state.wake();
        })
    }

    /// Sends without logging; `lines` gets the requests that were sent.
    fn dispatch<R>(
        &self,
        outgoing: &Outgoing<'_>,
        gate: Gate<'_, R>,
        count: usize,
        write: &mut dyn FnMut(usize, &mut Writer),
        lines: Option<&mut Vec<String>>,
    ) -> Result<Dispatched, SendError<R>> {
        let _passing = outgoing.is_stop().then(|| self.pass_first());
        let (mut turn, mut state) = self.take_turn(outgoing)?;
        let (Some(outbound), Some(stream)) = (turn.outbound.as_mut(), state.stream.clone()) else {
            return Err(self.attach(outgoing.not_sent()).into());
        };
        // A panic of the writing code leaves no request: none is entered yet, and the next call clears the buffer.
        outbound.compose(count.min(state.room(outgoing, &self.stops)), write);
        match gate {
            Some(gate) => gate().map_err(SendError::KeptBack)?,
            None => self.stops.check(outgoing).map_err(|error| self.attach(error))?,
        }
        self.enter(&mut state, outbound, outgoing);
        drop(state);
        let written = self.write(outbound, &stream, outgoing);
        // Before the lock: after a reset this closes the socket.
        drop(stream);
        let mut state = self.state.lock();
        let sent = self.written(&mut state, outbound, outgoing, written);
        if let Some(lines) = lines {
            lines.extend(outbound.texts().map(str::to_owned));
        }
        state.outbound = turn.outbound.take();
        self.state.wake();
        drop(state);
        Ok(sent.map_err(|error| self.attach(error))?)
    }

    /// Enters the composed requests into the exchange.
    fn enter(&self, state: &mut LinkState, outbound: &mut Outbound, outgoing: &Outgoing<'_>) {
        outbound.texts().for_each(|text| self.tap.sent(text));
        let support = outgoing.support();
        if state.exchange.room(support, &outgoing.name) < usize::MAX {
            state.untried_until = self.clock.now().checked_add(outgoing.left());
        }
        let now = outgoing.is_posted.then(|| self.clock.now());
        for (_, request) in &mut outbound.requests {
            *request = match (now, &outgoing.name) {
                (Some(now), Cow::Borrowed(command)) => state.exchange.post(outgoing.owner, support, command, now),
                (_, name) => state.exchange.send(outgoing.owner, support, name.clone()),
            };
        }
        state.count_changes(outgoing, outbound.requests.len() as u64);
        self.stops.entered(outbound.requests.iter().map(|(_, request)| *request), outgoing);
    }

    /// Writes the composed requests until the deadline, and returns the number of bytes that the system has taken.
    fn write(&self, outbound: &mut Outbound, stream: &Socket, outgoing: &Outgoing<'_>) -> io::Result<usize> {
        let (bytes, mut written) = (outbound.out.as_str().as_bytes(), 0);
        while written < bytes.len() {
            let left = outgoing.left();
            if left.is_zero() {
                break;
            }
            outbound.timeout.set(stream, left)?;
            match stream.write(&bytes[written..], Some(left)) {
                Ok(0) => return Err(io::ErrorKind::WriteZero.into()),
                Ok(len) => written += len,
                Err(error) => match error.kind() {
                    io::ErrorKind::Interrupted => {}
                    io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut => {
                        self.wait_in_writes()?;
                        outbound.timeout.lengthen(stream, outgoing.left())?;
                    }
                    _ => return Err(error),
                },
            }
        }
        Ok(written)
    }

    /// Makes the socket blocking, so that the next write waits in it.
    fn wait_in_writes(&self) -> io::Result<()> {
        let mut state = self.state.lock();
        if state.broken.is_some() {
            return Err(io::ErrorKind::NotConnected.into());
        }
        Self::switch(&mut state, Mode::Blocking)
    }

    /// Outcome of a write. A request written in part cannot be taken back, and nothing can be sent after it.
    fn written(
        &self,
        state: &mut LinkState,
        outbound: &Outbound,
        outgoing: &Outgoing<'_>,
        written: io::Result<usize>,
    ) -> Result<Dispatched, Error> {
        let cause = match written {
            Ok(len) if len == outbound.out.as_str().len() => {
                let (sent, outstanding) = (outbound.requests.len(), state.exchange.posted_outstanding(outgoing.owner));
                // There is one at least, unless nothing was to be sent.
                let last = outbound.requests.last().map_or_else(RequestId::default, |(_, request)| *request);
                return Ok(Dispatched { last, sent, outstanding });
            }
            Ok(0) => match withdraw(state, outbound) {
                Ok(()) => return Err(outgoing.not_sent()),
                Err(cause) => cause,
            },
            Ok(_) => Disconnect::Write(io::Error::new(
                io::ErrorKind::TimedOut,
                "a command was written in part by its deadline",
            )),
            Err(source) => Disconnect::Write(source),
        };
        Err(self.disconnected(outgoing.command, Transmission::Sent, self.break_off(state, cause)))
    }

    /// Waits until no other thread sends, no stop waits for the turn, and there is [room](LinkState::room). Fails for a
    /// command that a reservation keeps back.
    pub(super) fn take_turn<'l>(
        &'l self,
        outgoing: &Outgoing<'_>,
    ) -> Result<(Turn<'l>, MutexGuard<'l, LinkState>), Error> {
        let mut state = self.state.lock();
        loop {
            // No message that has been read and not attributed is a reply to a command that is sent now.
            if let Err(cause) = self.attribute_read(&mut state) {
                self.break_off(&mut state, cause);
            }
            self.check(&state, outgoing.command, Transmission::NotSent)?;
            let lets_pass = !outgoing.is_stop() && self.passing.load(Ordering::SeqCst) > 0;
            let is_free = !lets_pass && state.outbound.is_some();
            if is_free {
                if state.room(outgoing, &self.stops) > 0 {
                    return Ok((Turn { link: self, outbound: state.outbound.take() }, state));
                }
                // It does not wait for room beside a session that it may not use.
                if self.stops.leaders().is_some_and(|leads| !leads.contains(&outgoing.owner)) {
                    self.stops.check(outgoing).map_err(|error| self.attach(error))?;
                }
            }
            let left = outgoing.left();
            if left.is_zero() {
                return Err(self.attach(outgoing.not_sent()));
            }
            if !is_free {
                state = self.state.wait(state, left);
                continue;
            }
            // Replies make room.
            let left = left.min(state.until_room(&self.clock));
            state = self.turn(state, left, &mut Waiter::nobody());
        }
    }
}

/// Withdraws the entered requests of which nothing was sent. They are the last entered ones: no other thread had the
/// turn.
fn withdraw(state: &mut LinkState, outbound: &Outbound) -> Result<(), Disconnect> {
    let mut requests = outbound.requests.iter().rev();
    requests.try_for_each(|(_, request)| state.exchange.withdraw(*request)).map_err(Disconnect::OutOfSync)
}

/// Turn to send. Dropping it passes the turn to the next thread.
#[derive(Debug)]
pub(super) struct Turn<'l> {
    link: &'l Link,
    pub(super) outbound: Option<Box<Outbound>>,
}

/// The lock must not be held when the turn is dropped: declare the lock's guard after it.
impl Drop for Turn<'_> {
    fn drop(&mut self) {
        if let Some(outbound) = self.outbound.take() {
            self.link.state.lock().outbound = Some(outbound);
            self.link.state.wake();
        }
    }
}
