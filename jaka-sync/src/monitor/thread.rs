//! What the monitor's thread does.

use std::net::TcpStream;
use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_proto::framing::{self, FrameError, Framer};
use jaka_proto::recording::Port;
use jaka_proto::wire::{Decode, DecodeError, Reader};

use super::{Board, Snapshot};
use crate::receive::{self, Chunk};
use crate::recorder::{self, Tap};
use crate::resync;
use crate::{Config, Disconnect, Error};

/// A read waits at most this long; the end of the connection and of the monitor end it at once.
const READ: Duration = Duration::from_secs(1);

/// The same where packets wait to be posted.
const REST: Duration = Duration::from_millis(1);

/// For how long packets are passed over for newer ones that have come already.
const BEHIND: Duration = Duration::from_millis(50);

/// The reader of the status port.
pub(super) struct Worker<S> {
    board: Arc<Board<S>>,
    address: String,
    config: Config,
    pub(super) number: u64,
    tap: Tap,
    /// The packet before the latest, whose memory is used again.
    spare: Option<Arc<Snapshot<S>>>,
}

impl<S: Decode> Worker<S> {
    pub(super) fn new(board: Arc<Board<S>>, address: String, config: Config) -> Self {
        Self { board, address, config, number: 0, tap: Tap::default(), spare: None }
    }

    /// Reads until the monitor is dropped, or the connection ends and is not made anew.
    pub(super) fn run(mut self, connected: (Arc<TcpStream>, Tap)) {
        let mut connected = Some(connected);
        while let Some((stream, tap)) = connected.take() {
            self.tap = tap;
            let cause = self.read(&stream);
            self.record_end(&cause);
            connected = self.reconnect(cause);
        }
        self.end();
    }

    /// Tells all who wait that no packet will come any more.
    pub(super) fn end(&self) {
        let mut state = self.board.lock();
        for queue in state.queues.drain(..) {
            queue.close();
        }
        self.board.wake(state);
    }

    fn record_end(&self, cause: &Disconnect) {
        if self.board.lock().closing { self.tap.left() } else { self.tap.broken(cause) }
    }

    /// Reads until the connection ends, and says why it did.
    fn read(&mut self, stream: &TcpStream) -> Disconnect {
        let mut framer = Framer::for_status(self.config.max_frame);
        let cause = self.read_into(&mut framer, stream);
        self.tap.stray(framer.partial());
        cause
    }

    fn read_into(&mut self, framer: &mut Framer, stream: &TcpStream) -> Disconnect {
        let mut timeout = receive::Timeout::default();
        let mut newest = String::new();
        // When the first came of the packets that have not been posted.
        let mut waiting: Option<Instant> = None;
        loop {
            let chunk =
                receive::chunk(stream, &self.tap, framer, &mut timeout, if waiting.is_some() { REST } else { READ });
            match chunk.and_then(|chunk| self.take_newest(framer, &mut newest).map(|found| (chunk, found))) {
                Ok((chunk, found)) => {
                    waiting = waiting.or(found.then(Instant::now));
                    // What has gathered is old but for its end. A controller that floods the port is behind for ever.
                    let is_behind = chunk == Chunk::Part && waiting.is_some_and(|since| since.elapsed() < BEHIND);
                    if !is_behind && waiting.take().is_some() {
                        let decoded = self.decode(&newest);
                        self.post(decoded);
                    }
                }
                Err(cause) => return cause,
            }
        }
    }

    /// Keeps the text of the newest packet that has arrived in full; false if there is none.
    fn take_newest(&mut self, framer: &mut Framer, newest: &mut String) -> Result<bool, Disconnect> {
        self.count_dropped(resync::record_lost(framer, &self.tap));
        let mut found = 0;
        loop {
            match framer.next_frame() {
                Ok(None) => break,
                Ok(Some(frame)) => {
                    self.tap.packet(frame);
                    newest.clear();
                    newest.push_str(&framing::text(frame));
                    found += 1;
                }
                Err(error) => self.resync(framer, error)?,
            }
        }
        self.number += found;
        self.board.lock().counters.skipped += found.saturating_sub(1);
        Ok(found > 0)
    }

    /// Goes on at the next packet.
    fn resync(&mut self, framer: &mut Framer, error: FrameError) -> Result<(), Disconnect> {
        let dropped = resync::resync(framer, &self.tap, error)?;
        self.board.lock().counters.resyncs += 1;
        self.count_dropped(dropped);
        Ok(())
    }

    fn count_dropped(&self, bytes: usize) {
        if bytes > 0 {
            self.board.lock().counters.dropped_bytes += u64::try_from(bytes).unwrap_or(u64::MAX);
        }
    }

    /// Decodes a packet, in the place of an earlier one that nobody holds any more if there is one.
    fn decode(&mut self, packet: &str) -> Result<Arc<Snapshot<S>>, DecodeError> {
        let (mut reader, received, number) = (Reader::new(packet), Instant::now(), self.number);
        let mut spare = self.spare.take();
        if let Some(snapshot) = spare.as_mut().and_then(Arc::get_mut) {
            snapshot.status.decode_into(&mut reader)?;
            reader.end()?;
            (snapshot.received, snapshot.number, snapshot.unfit) = (received, number, reader.take_unfit());
        }
        match spare {
            Some(snapshot) if snapshot.number == number => Ok(snapshot),
            _ => {
                let status = S::decode(&mut reader)?;
                reader.end()?;
                Ok(Arc::new(Snapshot { status, received, number, unfit: reader.take_unfit() }))
            }
        }
    }

    pub(super) fn post(&mut self, decoded: Result<Arc<Snapshot<S>>, DecodeError>) {
        let mut state = self.board.lock();
        match decoded {
            Ok(snapshot) => {
                state.counters.packet(snapshot.received);
                state.counters.unfit += u64::from(!snapshot.unfit.is_empty());
                state.unfit = None;
                state.reconnecting = false;
                // A queue that nobody else holds has lost its subscription.
                state.queues.retain(|queue| Arc::strong_count(queue) > 1);
                for queue in &state.queues {
                    queue.push(Arc::clone(&snapshot));
                }
                self.spare = state.latest.replace(Arc::clone(&snapshot));
                // Called without the lock, so that they can ask the monitor.
                let mut observers = std::mem::take(&mut state.observers);
                drop(state);
                observers.call(&snapshot);
                state = self.board.lock();
                let added = std::mem::replace(&mut state.observers, observers);
                state.observers.join(added);
            }
            Err(error) => {
                log::debug!(target: "jaka_sync::wire", "status packet dropped: {error}");
                state.counters.unfit += 1;
                state.unfit = Some(error);
            }
        }
        self.board.wake(state);
    }

    /// Connects anew as the policy says; `None` if the monitor has come to its end.
    pub(super) fn reconnect(&self, mut cause: Disconnect) -> Option<(Arc<TcpStream>, Tap)> {
        for attempt in 0.. {
            let Some(delay) = self.config.reconnect.delay(attempt).filter(|_| !self.board.lock().closing) else {
                break;
            };
            if self.pause(delay) {
                break;
            }
            match recorder::connect(&self.address, Port::Status, &self.config) {
                Ok(connected) => return self.connected(connected),
                Err(Error::Connect { source, .. }) => cause = Disconnect::Read(source),
                Err(_) => {}
            }
        }
        self.board.lock().ended = Some(Arc::new(cause));
        None
    }

    /// Waits, and says whether the monitor was dropped meanwhile.
    fn pause(&self, delay: Duration) -> bool {
        let since = Instant::now();
        let mut state = self.board.lock();
        state.counters.interrupted();
        state.reconnecting = true;
        loop {
            let left = delay.saturating_sub(since.elapsed());
            if state.closing || left.is_zero() {
                return state.closing;
            }
            state = self.board.wait(state, left);
        }
    }

    fn connected(&self, (stream, tap): (TcpStream, Tap)) -> Option<(Arc<TcpStream>, Tap)> {
        let mut state = self.board.lock();
        if state.closing {
            tap.left();
            return None;
        }
        state.tap = tap.clone();
        let stream = Arc::new(stream);
        state.stream = Some(Arc::clone(&stream));
        state.counters.reconnects += 1;
        Some((stream, tap))
    }
}
