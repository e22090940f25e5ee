//! The sending half of a connection, and whose turn it is to send.

use std::borrow::Cow;
use std::io::{self, Write};
use std::net::TcpStream;
use std::sync::MutexGuard;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use jaka_proto::Ticket;
use jaka_proto::wire::Writer;

use super::answer::{Progress, disconnected};
use super::state::{Mode, State};
use super::{FRAME_COMMANDS, Gate, Link};
use crate::{Disconnect, Error, ErrorKind};

/// About how much goes out in one write: behind it a stop can go out.
const PIECE: usize = 4096;

/// How long a write blocks at most: then it looks at its deadline, and at the connection.
const SLICE: Duration = Duration::from_millis(50);

/// The shortest timeout of a write.
const SHORTEST: Duration = Duration::from_millis(1);

/// The sending half: the thread whose turn it is takes it out of the state.
#[derive(Debug, Default)]
pub(super) struct Outbound {
    out: Writer,
    /// Where each request ends, and what it is entered as.
    requests: Vec<(usize, Ticket)>,
    timeout: Timeout,
}

/// The write timeout that the socket has, so that it is set only where it must change.
#[derive(Debug, Default)]
struct Timeout(Duration);

impl Timeout {
    /// Sets a timeout that is no longer than the time left. A shorter one does, too: whoever waits to the end writes a few times more.
    fn set(&mut self, stream: &TcpStream, left: Duration) -> io::Result<()> {
        if !self.0.is_zero() && self.0 <= left.max(SHORTEST) {
            return Ok(());
        }
        self.change(stream, (left / 8 * 7).clamp(SHORTEST, SLICE))
    }

    /// Sets a longer one behind a write that had to wait, where there is time for it.
    fn lengthen(&mut self, stream: &TcpStream, left: Duration) -> io::Result<()> {
        if self.0 < SLICE && left >= SLICE { self.change(stream, SLICE) } else { Ok(()) }
    }

    fn change(&mut self, stream: &TcpStream, timeout: Duration) -> io::Result<()> {
        stream.set_write_timeout(Some(timeout))?;
        self.0 = timeout;
        Ok(())
    }
}

/// Who goes first where several wait for their turn to send.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Right {
    Usual,
    /// A stop passes all others.
    Stop,
}

/// What goes out: commands of one name, and until when.
#[derive(Debug)]
pub(super) struct Dispatch<'d> {
    pub(super) command: &'d str,
    /// The name under which replies are owed.
    pub(super) owed: Cow<'static, str>,
    pub(super) since: Instant,
    pub(super) timeout: Duration,
    pub(super) right: Right,
    /// Whether the replies are counted, with nobody waiting for one in particular.
    pub(super) is_posted: bool,
}

impl Dispatch<'_> {
    fn left(&self) -> Duration {
        self.timeout.saturating_sub(self.since.elapsed())
    }

    fn not_sent(&self) -> Error {
        ErrorKind::NotSentInTime { command: self.command.to_owned(), after: self.timeout }.into()
    }
}

/// What went out.
#[derive(Debug)]
pub(super) struct Dispatched {
    /// The last of the commands.
    pub(super) last: Ticket,
    /// How many commands.
    pub(super) count: usize,
    /// How many posted commands are outstanding.
    pub(super) posted: usize,
}

/// The turn to send, which the next one has when this is dropped.
#[derive(Debug)]
struct Turn<'l> {
    link: &'l Link,
    outbound: Option<Box<Outbound>>,
}

/// Whoever has the turn must not hold the lock when it drops it: declare the lock's guard behind it.
impl Drop for Turn<'_> {
    fn drop(&mut self) {
        if let Some(outbound) = self.outbound.take() {
            let mut state = self.link.lock();
            state.outbound = Some(outbound);
            self.link.wake(&state);
        }
    }
}

/// A stop that is on its way: until it is dropped, no other command begins to go out.
#[derive(Debug)]
struct Passing<'l>(&'l Link);

impl<'l> Passing<'l> {
    fn new(link: &'l Link) -> Self {
        link.stops.fetch_add(1, Ordering::SeqCst);
        Self(link)
    }
}

impl Drop for Passing<'_> {
    fn drop(&mut self) {
        self.0.stops.fetch_sub(1, Ordering::SeqCst);
        self.0.wake(&self.0.lock());
    }
}

impl Link {
    /// Sends up to so many commands in one write, and enters them as owed a reply. `write` writes the request with an index; of long
    /// ones, not all go out at once.
    ///
    /// The gate is asked, and the commands are entered, under the lock by the thread whose turn it is: so the ledger's order is the
    /// wire's, and nothing goes out behind a stop that the gate knows of.
    pub(super) fn transmit(
        &self,
        dispatch: &Dispatch<'_>,
        gate: Gate<'_>,
        count: usize,
        write: &mut dyn FnMut(usize, &mut Writer),
    ) -> Result<Dispatched, Error> {
        let _passing = (dispatch.right == Right::Stop).then(|| Passing::new(self));
        let (mut turn, mut state) = self.take_turn(dispatch)?;
        gate.map_or(Ok(()), |gate| gate())?;
        let (Some(outbound), Some(stream)) = (turn.outbound.as_mut(), state.stream.clone()) else {
            return Err(self.attach(dispatch.not_sent()));
        };
        // A panic of what writes or logs leaves nothing behind that was not sent.
        outbound.compose(count, write);
        self.enter(&mut state, outbound, dispatch);
        drop(state);
        let written = self.write(outbound, &stream, dispatch);
        // Before the lock: after a reset this closes the socket.
        drop(stream);
        let mut state = self.lock();
        let sent = self.written(&mut state, outbound, dispatch, written);
        state.outbound = turn.outbound.take();
        self.wake(&state);
        drop(state);
        sent.map_err(|error| self.attach(error))
    }

    /// Waits until nobody else sends, and no stop waits to.
    fn take_turn<'l>(&'l self, dispatch: &Dispatch<'_>) -> Result<(Turn<'l>, MutexGuard<'l, State>), Error> {
        let mut state = self.lock();
        loop {
            // None of what has been read and not looked at is a reply to a command that goes out now.
            if let Err(cause) = self.settle_read(&mut state) {
                self.break_off(&mut state, cause);
            }
            if let Some(cause) = state.broken.clone() {
                return Err(self.attach(disconnected(dispatch.command, Progress::NotSent, cause)));
            }
            let lets_pass = dispatch.right == Right::Usual && self.stops.load(Ordering::SeqCst) > 0;
            if !lets_pass && state.outbound.is_some() {
                return Ok((Turn { link: self, outbound: state.outbound.take() }, state));
            }
            let left = dispatch.left();
            if left.is_zero() {
                return Err(self.attach(dispatch.not_sent()));
            }
            state = self.sleep(state, left);
        }
    }

    /// Enters what is to go out as owed replies.
    fn enter(&self, state: &mut State, outbound: &mut Outbound, dispatch: &Dispatch<'_>) {
        let (mut start, now) = (0, dispatch.is_posted.then(Instant::now));
        for (end, ticket) in &mut outbound.requests {
            self.tap.sent(&outbound.out.as_str()[start..*end]);
            *ticket = state.ledger.sent(dispatch.owed.clone());
            state.frame_changes += u64::from(FRAME_COMMANDS.contains(&&*dispatch.owed));
            if let (Some(now), Cow::Borrowed(command)) = (now, &dispatch.owed) {
                state.posted.sent(*ticket, command, now);
            }
            start = *end;
        }
    }

    /// Writes what is to go out until its deadline, and says how many bytes the system has taken.
    fn write(&self, outbound: &mut Outbound, mut stream: &TcpStream, dispatch: &Dispatch<'_>) -> io::Result<usize> {
        let (bytes, mut written) = (outbound.out.as_str().as_bytes(), 0);
        while written < bytes.len() {
            let left = dispatch.left();
            if left.is_zero() {
                break;
            }
            outbound.timeout.set(stream, left)?;
            match stream.write(&bytes[written..]) {
                Ok(0) => return Err(io::ErrorKind::WriteZero.into()),
                Ok(len) => written += len,
                Err(error) => match error.kind() {
                    io::ErrorKind::Interrupted => {}
                    io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut => {
                        self.wait_in_writes()?;
                        outbound.timeout.lengthen(stream, dispatch.left())?;
                    }
                    _ => return Err(error),
                },
            }
        }
        Ok(written)
    }

    /// Has the socket block, so that the next write waits in it.
    fn wait_in_writes(&self) -> io::Result<()> {
        let mut state = self.lock();
        if state.broken.is_some() {
            return Err(io::ErrorKind::NotConnected.into());
        }
        Self::switch(&mut state, Mode::Blocking)
    }

    /// What became of a write. What was written in part cannot be taken back, and nothing can be sent behind it.
    fn written(
        &self,
        state: &mut State,
        outbound: &Outbound,
        dispatch: &Dispatch<'_>,
        written: io::Result<usize>,
    ) -> Result<Dispatched, Error> {
        let cause = match written {
            Ok(len) if len == outbound.out.as_str().len() => {
                let count = outbound.requests.len();
                // There is one at least, unless nothing was to be sent.
                let last = outbound.requests.last().map_or_else(Ticket::default, |(_, ticket)| *ticket);
                return Ok(Dispatched { last, count, posted: state.posted.outstanding() });
            }
            Ok(0) => match withdraw(state, outbound) {
                Ok(()) => return Err(dispatch.not_sent()),
                Err(cause) => cause,
            },
            Ok(_) => Disconnect::Write(io::Error::new(
                io::ErrorKind::TimedOut,
                "a command was written in part by its deadline",
            )),
            Err(source) => Disconnect::Write(source),
        };
        Err(disconnected(dispatch.command, Progress::Sent, self.break_off(state, cause)))
    }
}

impl Outbound {
    /// Writes requests, up to a piece of them.
    fn compose(&mut self, count: usize, write: &mut dyn FnMut(usize, &mut Writer)) {
        self.out.clear();
        self.requests.clear();
        let mut start = 0;
        for index in 0..count {
            write(index, &mut self.out);
            let text = self.out.as_str();
            log::trace!(target: "jaka_sync::wire", "-> {}", &text[start..]);
            start = text.len();
            self.requests.push((start, Ticket::default()));
            if start >= PIECE {
                break;
            }
        }
    }
}

/// Takes back what was entered and not sent at all. It is the last that was entered: nobody else had the turn.
fn withdraw(state: &mut State, outbound: &Outbound) -> Result<(), Disconnect> {
    for (_, ticket) in outbound.requests.iter().rev() {
        state.ledger.withdraw(*ticket).map_err(Disconnect::Mistrust)?;
        state.posted.settle(*ticket);
    }
    Ok(())
}
