//! The command connection, shared between a client and its stop handles.
//!
//! One thread at a time has the turn to send, and enters its requests into the exchange before it sends them: so the
//! exchange has the order of the wire. The first thread that waits for a reply reads the socket for all; the others
//! sleep meanwhile. No thread holds the state's lock while the socket may block it.

mod halves;
mod inbound;
mod outbound;
mod outgoing;
mod posted;
mod state;
mod stops;

use std::error::Error as StdError;
use std::io;
use std::net::{Shutdown, SocketAddr};
use std::sync::atomic::AtomicUsize;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use jaka_clock::{Clock, Socket, lock};
use jaka_proto::exchange::{Failure, Owner, ReadReply, RequestId, Waiter};
use jaka_proto::recording::{Entry, MotionStep};
use jaka_proto::wire::{DecodeError, Writer};
use jaka_proto::{CommandInfo, FirmwareVersion};
use socket2::SockRef;

use self::halves::Inbound;
pub(crate) use self::outbound::Dispatched;
pub use self::outgoing::{Gate, Handle, SendError, Written};
pub(crate) use self::outgoing::{OPEN, Outgoing};
pub use self::posted::Answers;
pub(crate) use self::posted::MOST_OUTSTANDING;
use self::state::{LinkState, Mode};
pub use self::stops::{AttachedRobot, Kept, Leading, StopKind, Stops, UnderWay};
use crate::recorder::Tap;
use crate::sync::Watched;
use crate::{Config, Disconnect, Error, ErrorKind};

/// One command connection.
///
/// # Order of locks
/// 1. `state`. It is held while requests are entered and replies are attributed, never while a socket may block a
///    thread. The [`Gate`] runs under it: it may take 2, and must not use the connection.
/// 2. The [`Stops`], the state of a monitor's board (`Board` in `monitor.rs`), or a lock of the layer above, such as
///    jaka-robot's state of an arm, never two at once. A thread that holds one of these must not take 1.
/// 3. Locks under which no lock above is taken: the queue of a subscription (`monitor/subscription.rs`); the
///    recorder's, which are the state of a connection (`recorder/tap.rs`), or its sampler (`recorder.rs`) and then the
///    queue (`recorder/queue.rs`); and `firmware`.
///
/// The turn to send and the reader's place are not locks: they are the boxes `outbound` and `inbound`, which
/// a thread takes out of the state and puts back.
#[derive(Debug)]
pub struct Link {
    tap: Tap,
    /// Clock of the connection.
    pub clock: Clock,
    /// Timeout for sending a command whose reply has no timeout of its own.
    reply_timeout: Duration,
    /// Changes when a reply became pending, the reader's place or the turn to send became free, or the connection
    /// broke.
    state: Watched<LinkState>,
    /// Stops, what they keep back, and the session that moves the arm.
    pub stops: Arc<Stops>,
    /// Number of stops that are being sent or wait for it. While there are any, no thread starts to send another
    /// command.
    passing: AtomicUsize,
    /// Firmware that requests are checked against, if any.
    firmware: Mutex<Option<FirmwareVersion>>,
}

/// Target of log records of the wire.
const WIRE: &str = "jaka_sync::wire";

/// Time in which a thread that was woken leaves the socket: far longer than it needs.
const LEAVING: Duration = Duration::from_secs(1);

/// Command that was sent, with the data for the wait for its reply.
#[derive(Debug, Clone, Copy)]
pub struct Sent<'c> {
    request: RequestId,
    command: &'c str,
    since: Instant,
    timeout: Duration,
}

impl Sent<'_> {
    /// Sets another timeout for the reply, counted from the call that sent the command.
    pub(crate) fn within(self, timeout: Duration) -> Self {
        Self { timeout, ..self }
    }
}

impl Link {
    pub(crate) fn new(stream: impl Into<Socket>, tap: Tap, config: &Config) -> Self {
        let state = LinkState::new(stream.into(), Inbound::new(config.max_frame));
        Self {
            tap,
            clock: config.clock.clone(),
            reply_timeout: config.reply_timeout,
            state: Watched::new(&config.clock, state),
            stops: Stops::new(&config.clock),
            passing: AtomicUsize::new(0),
            firmware: Mutex::new(None),
        }
    }

    pub(crate) fn firmware(&self) -> Option<FirmwareVersion> {
        *lock(&self.firmware)
    }

    pub(crate) fn set_firmware(&self, firmware: Option<FirmwareVersion>) {
        *lock(&self.firmware) = firmware;
    }

    /// Address of the connection, with the port.
    pub fn address(&self) -> String {
        self.tap.address()
    }

    pub(crate) fn peer_addr(&self) -> io::Result<SocketAddr> {
        let state = self.state.lock();
        state
            .stream
            .as_ref()
            .map_or_else(|| Err(io::ErrorKind::NotConnected.into()), |stream| stream.system().peer_addr())
    }

    /// Returns the cause that broke the connection, if one did.
    pub fn broken(&self) -> Option<Arc<Disconnect>> {
        self.state.lock().broken.clone()
    }

    /// Returns the cause that broke the connection, even if the controller has ended it and no thread has read the end
    /// yet. Makes one system call; for a thread that waits for packets while no request is outstanding.
    pub fn lost(&self) -> Option<Arc<Disconnect>> {
        let mut state = self.state.lock();
        if let Err(cause) = self.notice_end(&mut state) {
            self.break_off(&mut state, cause);
        }
        state.broken.clone()
    }

    /// Waits for the loss of the connection for at most `time`, reads incoming messages meanwhile, and returns the
    /// cause.
    pub fn lost_within(&self, time: Duration) -> Option<Arc<Disconnect>> {
        let since = self.clock.stopwatch();
        let mut state = self.state.lock();
        loop {
            if let Some(cause) = &state.broken {
                return Some(Arc::clone(cause));
            }
            let left = since.left_of(time);
            if left.is_zero() {
                return None;
            }
            state = self.turn(state, left, &mut Waiter::nobody());
        }
    }

    /// Fails if the connection is broken, for a command that is not sent.
    pub fn check_open(&self, command: &str) -> Result<(), Error> {
        self.check(&self.state.lock(), command, Transmission::NotSent)
    }

    /// Fails if the connection is broken.
    fn check(&self, state: &LinkState, command: &str, progress: Transmission) -> Result<(), Error> {
        let broken = state.broken.clone();
        broken.map_or(Ok(()), |cause| Err(self.attach(self.disconnected(command, progress, cause))))
    }

    /// Number of sent commands that change the frames or the tool to which poses refer.
    pub fn frame_changes(&self) -> u64 {
        self.state.lock().frame_changes
    }

    /// Begins the lead of a session by this handle; the owner is that of its set-points.
    pub fn lead(&self, by: Handle, owner: Owner) -> Result<Leading, Kept> {
        // Under the lock, so that no command passes that was checked before.
        let _state = self.state.lock();
        self.stops.lead(by, owner)
    }

    /// Records an event of a motion.
    pub fn record_motion(&self, step: MotionStep, text: impl FnOnce() -> String) {
        self.tap.motion(step, text);
    }

    /// Records an error of this connection if no other entry shows it, and returns the last messages, oldest first;
    /// none if nothing is recorded.
    pub fn note(&self, error: &(dyn StdError + 'static), is_shown: bool) -> Box<[Entry]> {
        self.tap.note(error, is_shown)
    }

    /// Adds the last messages to an error, if they are recorded.
    pub(crate) fn attach(&self, error: Error) -> Error {
        self.tap.attach(error)
    }

    /// Sends a command and waits for its reply, puts the reply's text into `text`, and lets `reader` read it. A refusal
    /// is an error.
    pub(crate) fn call<R>(
        &self,
        outgoing: Outgoing<'_>,
        gate: Gate<'_, R>,
        write: &mut dyn FnMut(&mut Writer),
        text: &mut String,
        reader: &mut dyn ReadReply,
    ) -> Result<(), SendError<R>> {
        let (outgoing, stop) = self.begun(outgoing);
        let sent = self.send_through(&outgoing, gate, write);
        let outcome = sent.and_then(|sent| Ok(self.wait(&sent, text, reader)?));
        outcome.inspect_err(|_| stop.iter().for_each(UnderWay::failed))
    }

    /// Begins a stop of the program, if the command is one; its deadline begins once a session has braked.
    pub(crate) fn begun<'o>(&self, outgoing: Outgoing<'o>) -> (Outgoing<'o>, Option<UnderWay>) {
        if !outgoing.is_stop() {
            return (outgoing, None);
        }
        let stop = self.begin_stop(StopKind::Program);
        (outgoing.of_stop(stop.number(), self.clock.stopwatch()), Some(stop))
    }

    /// Begins a stop, and waits while a session brakes the arm.
    pub(crate) fn begin_stop(&self, kind: StopKind) -> UnderWay {
        let stop = self.stops.begin(kind);
        stop.wait_until_braked();
        stop
    }

    /// Sends a command.
    pub(crate) fn send<'c>(
        &self,
        outgoing: &Outgoing<'c>,
        write: &mut dyn FnMut(&mut Writer),
    ) -> Result<Sent<'c>, Error> {
        Ok(self.send_through(outgoing, OPEN, write)?)
    }

    /// Sends a command unless the gate keeps it back.
    fn send_through<'c, R>(
        &self,
        outgoing: &Outgoing<'c>,
        gate: Gate<'_, R>,
        write: &mut dyn FnMut(&mut Writer),
    ) -> Result<Sent<'c>, SendError<R>> {
        let request = self.transmit(outgoing, gate, 1, &mut |_, out| write(out))?.last;
        Ok(Sent { request, command: outgoing.command, since: outgoing.since.began, timeout: outgoing.timeout })
    }

    /// Makes the socket blocking or nonblocking. It must block while a thread reads it.
    fn switch(state: &mut LinkState, mode: Mode) -> io::Result<()> {
        if let Some(stream) = state.stream.as_ref().filter(|_| state.mode != mode) {
            stream.set_nonblocking(mode == Mode::Nonblocking)?;
            state.mode = mode;
        }
        Ok(())
    }

    /// Breaks the connection for good. The first cause stays.
    fn break_off(&self, state: &mut LinkState, cause: Disconnect) -> Arc<Disconnect> {
        if let Some(stream) = &state.stream {
            // An error here means that the socket is closed already.
            let _ = stream.shutdown(Shutdown::Both);
        }
        self.tap.broken(&cause);
        let cause = Arc::clone(state.broken.get_or_insert_with(|| Arc::new(cause)));
        self.state.wake();
        cause
    }

    /// Closes the connection in good order, since its client is dropped: queued data is still delivered.
    pub(crate) fn close(&self) {
        let mut state = self.state.lock();
        if state.broken.is_none() {
            // Unread bytes would turn the close into a reset. During a panic a logger, which may panic, must not run.
            if !std::thread::panicking() {
                let _ = self.attribute_arrived(&mut state);
            }
            self.tap.left();
            self.break_off(&mut state, Disconnect::ClientDropped);
        }
    }

    /// Ends the session after a command that ends it.
    pub(crate) fn end(&self, by: &CommandInfo) {
        let cause = Disconnect::Ended { by: by.name.to_owned() };
        self.break_off(&mut self.state.lock(), cause);
    }

    /// Error for a command whose connection is broken.
    fn disconnected(&self, command: &str, progress: Transmission, cause: Arc<Disconnect>) -> Error {
        let (command, sent) = (Some(command.to_owned()), progress == Transmission::Sent);
        ErrorKind::Disconnected { address: self.address(), command, sent, cause }.into()
    }

    /// Breaks the connection for good, and makes the system discard unsent data. The first cause stays.
    ///
    /// Only the close of the last handle with a linger time of zero discards it, and only while no thread reads: a
    /// `shutdown` delivers it, and so does a close while another thread blocks in a read. So each thread that reads or
    /// writes is woken, the last to leave closes the socket, and this method waits for that. Bytes in the network or
    /// the controller cannot be recalled.
    pub fn reset(&self, cause: Disconnect) -> Arc<Disconnect> {
        let mut state = self.state.lock();
        let broken = state.broken.get_or_insert_with(|| {
            self.tap.broken(&cause);
            Arc::new(cause)
        });
        let broken = Arc::clone(broken);
        self.state.wake();
        let Some(stream) = state.stream.take() else { return broken };
        // An error here means that the socket is closed already.
        let _ = SockRef::from(stream.system()).set_linger(Some(Duration::ZERO));
        // Wakes a thread that reads, and sends nothing. A thread that waits to send is woken only by an end of sending;
        // the data that this delivers until the thread has left would be delivered without a reset, too.
        let _ = stream.shutdown(if state.outbound.is_some() { Shutdown::Read } else { Shutdown::Both });
        let others = Arc::downgrade(&stream);
        drop(stream);
        let since = self.clock.stopwatch();
        while others.strong_count() > 0 && since.passed() < LEAVING {
            state = self.state.wait(state, LEAVING);
        }
        broken
    }
}

impl Drop for Link {
    fn drop(&mut self) {
        self.tap.left();
    }
}

/// Position of a command when its connection was broken: on the wire, or not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Transmission {
    Sent,
    NotSent,
}

/// Error for a command that failed on a connection that stays usable.
fn failed(command: &str, failure: Failure) -> Error {
    let name = command.to_owned();
    match failure {
        Failure::Refused(mut refusal) => {
            refusal.command = name;
            ErrorKind::Refused { refusal }.into()
        }
        Failure::Unexpected(source) => unexpected(command, source),
        Failure::TimedOut { after } => timed_out(command, after),
        Failure::Lost => ErrorKind::ReplyLost { command: name }.into(),
    }
}

/// Error for a reply that does not fit the spec.
pub fn unexpected(command: &str, source: DecodeError) -> Error {
    ErrorKind::UnexpectedReply { command: command.to_owned(), source }.into()
}

/// Error for a command whose reply has not come in time.
fn timed_out(command: &str, after: Duration) -> Error {
    ErrorKind::Timeout { command: command.to_owned(), after }.into()
}

/// Error for a command that could not be sent in time.
fn not_sent_in_time(command: &str, after: Duration) -> Error {
    ErrorKind::NotSentInTime { command: command.to_owned(), after }.into()
}

#[cfg(test)]
mod tests;
