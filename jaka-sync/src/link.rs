//! The command connection, shared between a client and its stop handles.
//!
//! Whoever sends holds the state's lock, so the ledger's order is the wire's. Whoever waits for a reply reads the
//! socket for all, or sleeps while another does.

use std::borrow::Cow;
use std::io::{self, Write};
use std::net::{Shutdown, SocketAddr, TcpStream};
use std::sync::{Arc, Condvar, Mutex, MutexGuard};
use std::time::{Duration, Instant};

use jaka_proto::framing::Framer;
use jaka_proto::wire::Writer;
use jaka_proto::{Arrival, CommandInfo, Ledger, Mistrust, Ticket};

use crate::receive::{self, Chunk};
use crate::recorder::Tap;
use crate::reply::{self, Reply};
use crate::{Config, Disconnect, Error, Exchanges};

/// One command connection.
#[derive(Debug)]
pub(crate) struct Link {
    stream: TcpStream,
    tap: Tap,
    state: Mutex<State>,
    /// Signalled when an answer was put aside, the reader's place became free, or the connection broke.
    turned: Condvar,
    inbound: Mutex<Inbound>,
}

#[derive(Debug, Default)]
struct State {
    ledger: Ledger,
    out: Writer,
    reader: Reader,
    sleepers: usize,
    /// Replies read by one thread for another.
    aside: Vec<(Ticket, Answer)>,
    broken: Option<Arc<Disconnect>>,
}

/// Whether some thread reads the socket.
#[derive(Debug, Default, PartialEq, Eq, Clone, Copy)]
enum Reader {
    #[default]
    Nobody,
    Somebody,
}

/// What became of a command.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Answer {
    Reply(String),
    Lost,
}

/// The receiving half: only the reading thread locks it.
#[derive(Debug)]
struct Inbound {
    framer: Framer,
    timeout: receive::Timeout,
}

/// A command on its way: what is needed to wait for its reply.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sent<'c> {
    pub(crate) ticket: Ticket,
    pub(crate) command: &'c str,
    pub(crate) since: Instant,
    pub(crate) timeout: Duration,
}

impl Sent<'_> {
    fn left(&self) -> Duration {
        self.timeout.saturating_sub(self.since.elapsed())
    }
}

impl Link {
    pub(crate) fn new(stream: TcpStream, tap: Tap, config: &Config) -> Self {
        let inbound = Inbound { framer: Framer::new(config.max_frame), timeout: receive::Timeout::default() };
        Self { stream, tap, state: Mutex::default(), turned: Condvar::new(), inbound: Mutex::new(inbound) }
    }

    pub(crate) fn peer_addr(&self) -> io::Result<SocketAddr> {
        self.stream.peer_addr()
    }

    /// A thread that panicked while it held the lock left the state as it was: every change is made whole.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    /// What broke the connection, if something did.
    pub(crate) fn broken(&self) -> Option<Arc<Disconnect>> {
        self.lock().broken.clone()
    }

    /// The same error, with the last messages where they are recorded.
    pub(crate) fn attach(&self, error: Error) -> Error {
        self.tap.attach(error)
    }

    /// Sends a command, and enters it as owed a reply.
    pub(crate) fn send<'c>(
        &self,
        command: &'c str,
        owed: Cow<'static, str>,
        timeout: Duration,
        write: impl FnOnce(&mut Writer),
    ) -> Result<Sent<'c>, Error> {
        let since = Instant::now();
        let mut state = self.lock();
        if let Err(cause) = self.settle_read(&mut state) {
            self.break_off(&mut state, cause);
        }
        if let Some(cause) = state.broken.clone() {
            return Err(self.attach(disconnected(command, Progress::NotSent, cause)));
        }
        state.out.clear();
        let State { out, .. } = &mut *state;
        write(out);
        log::trace!(target: "jaka_sync::wire", "-> {}", state.out.as_str());
        self.tap.sent(state.out.as_str());
        let ticket = state.ledger.sent(owed);
        if let Err(source) = (&self.stream).write_all(state.out.as_str().as_bytes()) {
            let cause = self.break_off(&mut state, Disconnect::Write(source));
            return Err(self.attach(disconnected(command, Progress::Sent, cause)));
        }
        Ok(Sent { ticket, command, since, timeout })
    }

    /// Settles what has been read and not looked at: none of it is a reply to a command that goes out now.
    fn settle_read(&self, state: &mut State) -> Result<(), Disconnect> {
        // Where another thread reads, it looks at all that it has read.
        let nobody_reads = state.reader == Reader::Nobody && state.broken.is_none();
        let Some(mut inbound) = self.inbound.try_lock().ok().filter(|_| nobody_reads) else {
            return Ok(());
        };
        let settled = self.settle_all(&mut inbound.framer, state);
        if settled.is_err() {
            self.tap.stray(inbound.framer.partial());
        }
        self.wake(state);
        settled
    }

    /// Settles the debts of all messages that have been read, and puts aside what somebody waits for.
    fn settle_all(&self, framer: &mut Framer, state: &mut State) -> Result<(), Disconnect> {
        while let Some(text) = self.next_message(framer)? {
            let reply = Reply::read(text).map_err(Disconnect::NotJson)?;
            let arrival = state.arrived(&reply).map_err(Disconnect::Mistrust)?;
            state.put_aside(&arrival, text, None);
        }
        Ok(())
    }

    /// Breaks the connection for good. The first cause stays.
    fn break_off(&self, state: &mut State, cause: Disconnect) -> Arc<Disconnect> {
        // An error here means that the socket is closed already.
        let _ = self.stream.shutdown(Shutdown::Both);
        self.tap.broken(&cause);
        let cause = Arc::clone(state.broken.get_or_insert_with(|| Arc::new(cause)));
        self.wake(state);
        cause
    }

    /// Ends the session after a command that ends it.
    pub(crate) fn end(&self, by: &CommandInfo) {
        let cause = Disconnect::Ended { by: by.name.to_owned() };
        self.break_off(&mut self.lock(), cause);
    }

    fn wake(&self, state: &State) {
        if state.sleepers > 0 {
            self.turned.notify_all();
        }
    }

    /// Waits for the reply to a command that was sent, and puts its text into `reply`. A refusal is an error.
    pub(crate) fn wait(&self, sent: &Sent<'_>, reply: &mut String) -> Result<(), Error> {
        self.answer(sent, reply).map_err(|error| self.attach(error))
    }

    fn answer(&self, sent: &Sent<'_>, reply: &mut String) -> Result<(), Error> {
        let mut state = self.lock();
        loop {
            if let Some(answer) = state.take(sent.ticket) {
                return deliver(answer, sent, reply);
            }
            if let Some(cause) = state.broken.clone() {
                return Err(disconnected(sent.command, Progress::Sent, cause));
            }
            let left = sent.left();
            if left.is_zero() {
                return Err(self.give_up(&mut state, sent));
            }
            if state.reader == Reader::Somebody {
                state.sleepers += 1;
                state = self.sleep(state, left);
                state.sleepers -= 1;
                continue;
            }
            state.reader = Reader::Somebody;
            drop(state);
            let read = self.read(sent, reply);
            state = self.lock();
            state.reader = Reader::Nobody;
            self.wake(&state);
            match read {
                Ok(ReadEnd::Mine(accepted)) => return accepted,
                Ok(ReadEnd::TimeUp) => {}
                Err(cause) => drop(self.break_off(&mut state, cause)),
            }
        }
    }

    fn sleep<'s>(&self, state: MutexGuard<'s, State>, left: Duration) -> MutexGuard<'s, State> {
        match self.turned.wait_timeout(state, left) {
            Ok((state, _)) => state,
            Err(poisoned) => poisoned.into_inner().0,
        }
    }

    fn give_up(&self, state: &mut State, sent: &Sent<'_>) -> Error {
        match state.ledger.give_up(sent.ticket) {
            Ok(()) => {
                let (command, exchanges) = (sent.command.to_owned(), Exchanges::default());
                Error::Timeout { command, after: sent.timeout, exchanges }
            }
            Err(mistrust) => {
                let cause = self.break_off(state, Disconnect::Mistrust(mistrust));
                disconnected(sent.command, Progress::Sent, cause)
            }
        }
    }

    /// Reads replies, each for whom it belongs to, until the caller's own has come or its time is up.
    fn read(&self, sent: &Sent<'_>, reply: &mut String) -> Result<ReadEnd, Disconnect> {
        let mut inbound = self.inbound.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let read = self.read_into(&mut inbound, sent, reply);
        if read.is_err() {
            self.tap.stray(inbound.framer.partial());
        }
        read
    }

    fn read_into(&self, inbound: &mut Inbound, sent: &Sent<'_>, reply: &mut String) -> Result<ReadEnd, Disconnect> {
        let Inbound { framer, timeout } = inbound;
        loop {
            while let Some(text) = self.next_message(framer)? {
                match self.settle(text, sent)? {
                    Settled::Mine(accepted) => {
                        reply.clear();
                        reply.push_str(text);
                        return Ok(ReadEnd::Mine(accepted));
                    }
                    Settled::MineLost => return Ok(ReadEnd::Mine(Err(lost(sent)))),
                    Settled::Other => {}
                }
            }
            match receive::chunk(&self.stream, &self.tap, framer, timeout, sent.left()) {
                Ok(Chunk::Some) => {}
                Ok(Chunk::TimeUp) => return Ok(ReadEnd::TimeUp),
                Err(cause) => return Err(cause),
            }
        }
    }

    /// The next message among the bytes that have come.
    fn next_message<'f>(&self, framer: &'f mut Framer) -> Result<Option<&'f str>, Disconnect> {
        let Some(frame) = framer.next_frame().map_err(Disconnect::Frame)? else {
            return Ok(None);
        };
        self.tap.received(frame);
        let text = std::str::from_utf8(frame).map_err(|_| Disconnect::NotUtf8)?;
        log::trace!(target: "jaka_sync::wire", "<- {text}");
        Ok(Some(text))
    }

    /// Reads what has arrived, without waiting, and calls `each` with the commands that `mine` knows and what became of
    /// them: accepted, refused, or no answer any more.
    ///
    /// Where another thread is reading, what it has read for this one so far has to do.
    pub(crate) fn drain(
        &self,
        mine: impl Fn(Ticket) -> bool,
        mut each: impl FnMut(Ticket, Result<(), Error>),
        command: &str,
    ) -> Result<(), Error> {
        let mut state = self.lock();
        if state.reader == Reader::Nobody {
            // With the lock held, nobody writes while the socket does not block.
            if let Err(cause) = self.read_arrived(&mut state) {
                self.break_off(&mut state, cause);
            }
            self.wake(&state);
        }
        let (answered, kept): (Vec<_>, _) = state.aside.drain(..).partition(|(ticket, _)| mine(*ticket));
        state.aside = kept;
        for (ticket, answer) in answered {
            let sent = Sent { ticket, command, since: Instant::now(), timeout: Duration::ZERO };
            let accepted = deliver(answer, &sent, &mut String::new());
            each(ticket, accepted.map_err(|error| self.attach(error)));
        }
        let broken = state.broken.clone();
        broken.map_or(Ok(()), |cause| Err(self.attach(disconnected(command, Progress::Sent, cause))))
    }

    fn read_arrived(&self, state: &mut State) -> Result<(), Disconnect> {
        let Ok(mut inbound) = self.inbound.try_lock() else {
            return Ok(());
        };
        let read = self.read_all(&mut inbound, state);
        if read.is_err() {
            self.tap.stray(inbound.framer.partial());
        }
        read
    }

    fn read_all(&self, inbound: &mut Inbound, state: &mut State) -> Result<(), Disconnect> {
        let Inbound { framer, timeout } = inbound;
        self.stream.set_nonblocking(true).map_err(Disconnect::Read)?;
        let arrived = loop {
            match receive::chunk(&self.stream, &self.tap, framer, timeout, Duration::from_secs(1)) {
                Ok(Chunk::Some) => {}
                Ok(Chunk::TimeUp) => break Ok(()),
                Err(cause) => break Err(cause),
            }
        };
        self.stream.set_nonblocking(false).map_err(Disconnect::Read)?;
        self.settle_all(framer, state)?;
        arrived
    }

    /// Gives up the reply to a command: it belongs to nobody when it comes.
    pub(crate) fn forget(&self, ticket: Ticket) {
        let mut state = self.lock();
        if let Err(mistrust) = state.ledger.give_up(ticket) {
            self.break_off(&mut state, Disconnect::Mistrust(mistrust));
        }
    }

    /// Settles the debt that a reply belongs to.
    fn settle(&self, text: &str, sent: &Sent<'_>) -> Result<Settled, Disconnect> {
        let reply = Reply::read(text).map_err(Disconnect::NotJson)?;
        let mut state = self.lock();
        let arrival = state.arrived(&reply).map_err(Disconnect::Mistrust)?;
        state.put_aside(&arrival, text, Some(sent.ticket));
        self.wake(&state);
        if arrival.ticket == sent.ticket {
            return Ok(Settled::Mine(reply.accepted(sent.command)));
        }
        Ok(if arrival.lost.contains(&sent.ticket) { Settled::MineLost } else { Settled::Other })
    }
}

/// Whose debt a reply settled: the caller's own, and whether the command was accepted, or another's.
#[derive(Debug)]
enum Settled {
    Mine(Result<(), Error>),
    /// A later command was answered: the caller's reply will not come any more.
    MineLost,
    Other,
}

/// How reading ended: with the caller's own reply, and whether the command was accepted, or with its time.
#[derive(Debug)]
enum ReadEnd {
    Mine(Result<(), Error>),
    TimeUp,
}

impl State {
    /// Whose reply this is.
    fn arrived(&mut self, reply: &Reply<'_>) -> Result<Arrival, Mistrust> {
        self.ledger.arrived_reply(match reply {
            Reply::Json(envelope) => Some(envelope),
            Reply::Bare => None,
        })
    }

    /// Puts aside what others than the caller wait for: the reply, and that replies are lost.
    fn put_aside(&mut self, arrival: &Arrival, text: &str, caller: Option<Ticket>) {
        let lost = arrival.lost.iter().filter(|ticket| Some(**ticket) != caller);
        self.aside.extend(lost.map(|ticket| (*ticket, Answer::Lost)));
        if !arrival.awaited {
            log::debug!(target: "jaka_sync::wire", "late reply to `{}` dropped", arrival.command);
        } else if Some(arrival.ticket) != caller {
            self.aside.push((arrival.ticket, Answer::Reply(text.to_owned())));
        }
    }

    fn take(&mut self, ticket: Ticket) -> Option<Answer> {
        let place = self.aside.iter().position(|(owner, _)| *owner == ticket)?;
        Some(self.aside.swap_remove(place).1)
    }
}

fn deliver(answer: Answer, sent: &Sent<'_>, reply: &mut String) -> Result<(), Error> {
    match answer {
        Answer::Reply(text) => {
            *reply = text;
            let read = Reply::read(reply).map_err(|source| reply::unexpected(sent.command, source));
            read?.accepted(sent.command)
        }
        Answer::Lost => Err(lost(sent)),
    }
}

fn lost(sent: &Sent<'_>) -> Error {
    Error::ReplyLost { command: sent.command.to_owned(), exchanges: Exchanges::default() }
}

/// Whether a command was on the wire when its connection was broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Progress {
    Sent,
    NotSent,
}

fn disconnected(command: &str, progress: Progress, cause: Arc<Disconnect>) -> Error {
    let (command, sent) = (Some(command.to_owned()), progress == Progress::Sent);
    Error::Disconnected { command, sent, cause, exchanges: Exchanges::default() }
}

impl Drop for Link {
    fn drop(&mut self) {
        self.tap.left();
    }
}
