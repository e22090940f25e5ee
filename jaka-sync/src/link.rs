//! The command connection, shared between a client and its stop handles.
//!
//! Whoever sends holds the state's lock, so the ledger's order is the wire's. Whoever waits for a reply reads the
//! socket for all, or sleeps while another does.

mod answer;
mod inbound;
mod posted;
mod question;
mod reset;
mod state;
mod wait;

use std::borrow::Cow;
use std::io::{self, ErrorKind, Write};
use std::net::{Shutdown, SocketAddr, TcpStream};
use std::sync::{Arc, Condvar, Mutex, MutexGuard};
use std::time::{Duration, Instant};

use jaka_proto::messages::frames::{SetToolId, SetToolOffsets, SetUserId, SetUserOffsets};
use jaka_proto::wire::Writer;
use jaka_proto::{Command, CommandInfo, Ticket};

use self::answer::{Progress, disconnected};
use self::inbound::Inbound;
pub(crate) use self::posted::Answers;
pub(crate) use self::question::Question;
use self::state::{Mode, State};
use crate::recorder::Tap;
use crate::{Config, Disconnect, Error};

/// One command connection.
#[derive(Debug)]
pub(crate) struct Link {
    tap: Tap,
    /// How long a command may take to go out where nobody says how long its reply may take.
    reply_timeout: Duration,
    state: Mutex<State>,
    /// Signalled when an answer was put aside, the reader's place became free, or the connection broke.
    turned: Condvar,
}

/// What changes the frames to which poses refer.
const FRAME_COMMANDS: [&str; 4] =
    [SetToolId::INFO.name, SetUserId::INFO.name, SetToolOffsets::INFO.name, SetUserOffsets::INFO.name];

/// Asked under the lock under which a command goes out, as the last thing before it does: an error keeps it back. What another
/// thread sends meanwhile goes out behind it, or has gone out before.
///
/// It must not use the connection.
pub(crate) type Gate<'g> = Option<&'g dyn Fn() -> Result<(), Error>>;

/// A command on its way: what is needed to wait for its reply.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sent<'c> {
    ticket: Ticket,
    command: &'c str,
    since: Instant,
    timeout: Duration,
}

impl Sent<'_> {
    fn left(&self) -> Duration {
        self.timeout.saturating_sub(self.since.elapsed())
    }
}

impl Link {
    pub(crate) fn new(stream: TcpStream, tap: Tap, config: &Config) -> Self {
        let state = State::new(stream, Inbound::new(config.max_frame));
        Self { tap, reply_timeout: config.reply_timeout, state: Mutex::new(state), turned: Condvar::new() }
    }

    pub(crate) fn peer_addr(&self) -> io::Result<SocketAddr> {
        let state = self.lock();
        state.stream.as_ref().map_or_else(|| Err(ErrorKind::NotConnected.into()), |stream| stream.peer_addr())
    }

    /// A thread that panicked while it held the lock left the state as it was: every change is made whole.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    /// What broke the connection, if something did.
    pub(crate) fn broken(&self) -> Option<Arc<Disconnect>> {
        self.lock().broken.clone()
    }

    /// Fails where the connection is broken, for a command that is not sent.
    pub(crate) fn check_open(&self, command: &str) -> Result<(), Error> {
        let broken = self.broken();
        broken.map_or(Ok(()), |cause| Err(self.attach(disconnected(command, Progress::NotSent, cause))))
    }

    /// How often commands have gone out that change what poses refer to.
    pub(crate) fn frame_changes(&self) -> u64 {
        self.lock().frame_changes
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
        gate: Gate<'_>,
        write: &mut dyn FnMut(&mut Writer),
    ) -> Result<Sent<'c>, Error> {
        let since = Instant::now();
        let ticket = self.transmit(&mut self.lock(), command, gate, |state| self.enter(state, owed, write))?;
        Ok(Sent { ticket, command, since, timeout })
    }

    /// Sends so many commands of one name in one write, and says of how many posted commands the replies are outstanding,
    /// which are counted. `write` writes the request with an index.
    pub(crate) fn post(
        &self,
        command: &'static str,
        gate: Gate<'_>,
        count: usize,
        write: &mut dyn FnMut(usize, &mut Writer),
    ) -> Result<usize, Error> {
        let mut state = self.lock();
        self.transmit(&mut state, command, gate, |state| {
            for index in 0..count {
                let ticket = self.enter(state, Cow::Borrowed(command), &mut |out| write(index, out));
                state.posted.sent(ticket, command);
            }
        })?;
        Ok(state.posted.outstanding())
    }

    /// Sends the commands that are entered.
    fn transmit<T>(
        &self,
        state: &mut State,
        command: &str,
        gate: Gate<'_>,
        enter: impl FnOnce(&mut State) -> T,
    ) -> Result<T, Error> {
        // None of what has been read and not looked at is a reply to a command that goes out now.
        if let Err(cause) = self.settle_read(state) {
            self.break_off(state, cause);
        }
        if let Some(cause) = state.broken.clone() {
            return Err(self.attach(disconnected(command, Progress::NotSent, cause)));
        }
        gate.map_or(Ok(()), |gate| gate())?;
        state.out.clear();
        let entered = enter(state);
        if let Err(source) = self.write(state) {
            let cause = self.break_off(state, Disconnect::Write(source));
            return Err(self.attach(disconnected(command, Progress::Sent, cause)));
        }
        Ok(entered)
    }

    /// Puts a command behind what is to go out, and enters it as owed a reply.
    fn enter(&self, state: &mut State, owed: Cow<'static, str>, write: &mut dyn FnMut(&mut Writer)) -> Ticket {
        let start = state.out.as_str().len();
        write(&mut state.out);
        let request = &state.out.as_str()[start..];
        log::trace!(target: "jaka_sync::wire", "-> {request}");
        self.tap.sent(request);
        state.frame_changes += u64::from(FRAME_COMMANDS.contains(&&*owed));
        state.ledger.sent(owed)
    }

    /// Writes what is to go out, and waits until the system has taken it.
    fn write(&self, state: &mut State) -> io::Result<()> {
        let Some(stream) = state.stream.clone() else { return Err(ErrorKind::NotConnected.into()) };
        let mut stream = &*stream;
        let mut written = 0;
        if state.mode == Mode::Nonblocking {
            match stream.write(state.out.as_str().as_bytes()) {
                Ok(len) if len == state.out.as_str().len() => return Ok(()),
                Ok(len) => written = len,
                Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => {}
                Err(error) => return Err(error),
            }
            Self::switch(state, Mode::Blocking)?;
        }
        stream.write_all(&state.out.as_str().as_bytes()[written..])
    }

    /// Has the socket block or not. It must block where somebody reads it.
    fn switch(state: &mut State, mode: Mode) -> io::Result<()> {
        if let Some(stream) = state.stream.as_ref().filter(|_| state.mode != mode) {
            stream.set_nonblocking(mode == Mode::Nonblocking)?;
            state.mode = mode;
        }
        Ok(())
    }

    /// Breaks the connection for good. The first cause stays.
    fn break_off(&self, state: &mut State, cause: Disconnect) -> Arc<Disconnect> {
        if let Some(stream) = &state.stream {
            // An error here means that the socket is closed already.
            let _ = stream.shutdown(Shutdown::Both);
        }
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
}

impl Drop for Link {
    fn drop(&mut self) {
        self.tap.left();
    }
}

#[cfg(test)]
mod tests;
