//! Work of the monitor's thread: reads, decodes and posts packets, and reconnects.

use std::panic::{self, AssertUnwindSafe};
use std::sync::Arc;
use std::time::Duration;

use jaka_clock::{Clock, Stopwatch};
use jaka_proto::wire::{Decode, DecodeError, Reader};

use super::observer::{Observers, StatusNews};
use super::{Board, BoardState};
use crate::packets::{Between, Packets, Silence};
use crate::receive::Chunk;
use crate::{Config, Disconnect, ErrorKind, Snapshot};

/// Longest wait of a read; an end of the connection or of the monitor ends it at once.
const READ: Duration = Duration::from_secs(1);

/// Longest wait of a read while packets wait to be posted.
const REST: Duration = Duration::from_millis(1);

/// Longest time for which packets are skipped if newer ones have already come.
const BEHIND: Duration = Duration::from_millis(50);

/// The reader of the status port.
pub(super) struct Worker<S> {
    board: Arc<Board<S>>,
    address: String,
    config: Config,
    pub(super) number: u64,
    /// The packet before the latest, whose memory is reused.
    spare: Option<Arc<Snapshot<S>>>,
    /// Packets that were overtaken by the newest. They are handed out once the newest is posted: a slow observer of an
    /// old packet must not delay the newest.
    passed: Vec<Arc<Snapshot<S>>>,
    silence: Silence,
}

impl<S: Decode> Worker<S> {
    pub(super) fn new(board: Arc<Board<S>>, address: String, config: Config) -> Self {
        Self { board, address, config, number: 0, spare: None, passed: Vec::new(), silence: Silence::default() }
    }

    /// Reads until the monitor is dropped, or until the connection ends and no reconnect follows.
    pub(super) fn run(mut self, packets: Packets) {
        let mut connected = Some(packets);
        while let Some(mut packets) = connected.take() {
            let read = panic::catch_unwind(AssertUnwindSafe(|| self.read(&mut packets)));
            let cause = read.unwrap_or(Disconnect::Panicked);
            if self.board.lock().closing {
                packets.tap.left();
            } else {
                packets.tap.broken(&cause);
            }
            connected = self.reconnect(cause);
        }
        self.end();
    }

    /// Tells all waiting threads that no more packets will come.
    pub(super) fn end(&self) {
        let mut state = self.board.lock();
        for queue in state.queues.drain(..) {
            queue.close();
        }
        self.board.tell(state);
    }

    /// Reads until the connection ends, and returns the cause.
    fn read(&mut self, packets: &mut Packets) -> Disconnect {
        // The newest packet until it is posted, and the time since the first unposted packet came.
        let (mut newest, mut waiting) = (String::new(), None::<Stopwatch>);
        loop {
            let chunk = packets.read(if waiting.is_some() { REST } else { READ });
            let taken = chunk.and_then(|chunk| self.take_newest(packets, &mut newest).map(|()| chunk));
            self.count(std::mem::take(&mut packets.between));
            match taken {
                Ok(chunk) => {
                    waiting = waiting.or((!newest.is_empty()).then(|| self.config.clock.stopwatch()));
                    // All accumulated packets but the last are old. This never catches up with a controller that floods
                    // the port.
                    let is_behind =
                        chunk == Chunk::Part && waiting.as_ref().is_some_and(|since| since.passed() < BEHIND);
                    if !is_behind && waiting.take().is_some() {
                        self.post_newest(&mut newest);
                    }
                }
                Err(cause) => {
                    self.post_newest(&mut newest);
                    packets.record_rest();
                    return cause;
                }
            }
        }
    }

    fn post_newest(&mut self, newest: &mut String) {
        if !newest.is_empty() {
            let decoded = self.decode(newest);
            newest.clear();
            self.post(decoded);
        }
    }

    /// Keeps the text of the newest packet that has arrived in full, and skips the packets before it.
    fn take_newest(&mut self, packets: &mut Packets, newest: &mut String) -> Result<(), Disconnect> {
        while packets.next()? {
            if !newest.is_empty() {
                self.pass_over(newest);
            }
            self.number += 1;
            std::mem::swap(newest, &mut packets.text);
        }
        Ok(())
    }

    /// Keeps an overtaken packet for queues and observers: it may show a stop.
    fn pass_over(&mut self, packet: &str) {
        let mut state = self.board.lock();
        state.counters.counted.skipped += 1;
        if state.queues.is_empty() && state.observers.is_empty() {
            return;
        }
        drop(state);
        let decoded = self.decode(packet);
        let is_unfit = decoded.as_ref().map_or(true, |snapshot| !snapshot.unfit.is_empty());
        self.board.lock().counters.counted.unfit += u64::from(is_unfit);
        self.passed.extend(decoded);
    }

    fn count(&self, between: Between) {
        if between != Between::default() {
            let counted = &mut self.board.lock().counters.counted;
            counted.dropped_bytes += u64::try_from(between.bytes).unwrap_or(u64::MAX);
            counted.resyncs += between.resyncs;
        }
    }

    /// Decodes a packet. A panic of the user's own decoder becomes an error.
    fn decode(&mut self, packet: &str) -> Result<Arc<Snapshot<S>>, DecodeError> {
        let (spare, number, clock) = (self.spare.take(), self.number, &self.config.clock);
        let decoded = panic::catch_unwind(AssertUnwindSafe(|| decode_over(spare, packet, number, clock)));
        let mut decoded = decoded
            .unwrap_or_else(|_| Err(DecodeError::unfit("a packet that the program's own decoder accepts", packet)))?;
        // No other thread has it yet.
        if let Some(snapshot) = Arc::get_mut(&mut decoded) {
            snapshot.follows_silence = self.silence.is_followed_by(snapshot.received, self.config.stale_after);
        }
        Ok(decoded)
    }

    pub(super) fn post(&mut self, decoded: Result<Arc<Snapshot<S>>, DecodeError>) {
        let mut came = std::mem::take(&mut self.passed);
        let unreadable = decoded.as_ref().err().cloned();
        let newest = decoded.as_ref().map_or(0, |snapshot| snapshot.number);
        came.extend(decoded.as_ref().ok().map(Arc::clone));
        let tell = |observers: &mut Observers<S>| {
            for packet in &came {
                observers.tell(StatusNews::Packet { packet, is_newest: packet.number == newest });
            }
            if let Some(source) = &unreadable {
                observers.tell(StatusNews::Unreadable(source));
            }
        };
        let spare = self.tell_then(tell, |state| match decoded {
            Ok(snapshot) => {
                state.counters.packet(snapshot.received);
                state.counters.counted.unfit += u64::from(!snapshot.unfit.is_empty());
                state.unfit = None;
                state.reconnecting = false;
                state.latest.replace(snapshot)
            }
            Err(error) => {
                state.counters.counted.unfit += 1;
                state.unfit = Some(error);
                None
            }
        });
        if let Some(error) = unreadable {
            log::debug!(target: "jaka_sync::wire", "status packet dropped: {error}");
        } else {
            self.spare = spare;
        }
        self.tell_then(|observers| observers.tell(StatusNews::Shown), |_| ());
        for snapshot in came.drain(..) {
            self.hand_out(&snapshot);
        }
        self.passed = came;
        self.board.tell(self.board.lock());
    }

    /// Calls the listeners, and then changes the board: a thread that sees the change there comes after them. A
    /// listener that is added meanwhile is called, too.
    fn tell_then<T>(&self, tell: impl Fn(&mut Observers<S>), change: impl FnOnce(&mut BoardState<S>) -> T) -> T {
        let mut told: Option<Observers<S>> = None;
        let mut state = self.board.lock();
        while !state.observers.listeners.is_empty() {
            let mut untold = state.observers.take_listeners();
            // Without the lock, so that they can ask the monitor.
            drop(state);
            tell(&mut untold);
            match &mut told {
                Some(told) => told.join(untold),
                None => told = Some(untold),
            }
            state = self.board.lock();
        }
        if let Some(told) = told {
            state.observers.listeners = told.listeners;
        }
        change(&mut state)
    }

    /// Hands a packet to the queues and the observers.
    fn hand_out(&self, snapshot: &Arc<Snapshot<S>>) {
        let mut state = self.board.lock();
        // A queue that is not shared belongs to a dropped subscription.
        state.queues.retain(|queue| Arc::strong_count(queue) > 1);
        for queue in &state.queues {
            queue.push(Arc::clone(snapshot));
        }
        if state.observers.users.is_empty() {
            return;
        }
        // Called without the lock, so that they can ask the monitor.
        let mut users = state.observers.take_users();
        drop(state);
        users.call(snapshot);
        let mut state = self.board.lock();
        users.join(state.observers.take_users());
        state.observers.users = users.users;
    }

    /// Reconnects by the policy; `None` if the monitor has ended.
    pub(super) fn reconnect(&self, mut cause: Disconnect) -> Option<Packets> {
        for attempt in 0.. {
            let Some(delay) = self.config.reconnect.delay(attempt).filter(|_| !self.board.lock().closing) else {
                break;
            };
            if self.pause(delay) {
                break;
            }
            match Packets::connect(&self.address, &self.config) {
                Ok(packets) => return self.connected(packets),
                Err(error) => {
                    if let ErrorKind::Connect { source, .. } = error.into_kind() {
                        cause = Disconnect::Read(source);
                    }
                }
            }
        }
        let cause = Arc::new(cause);
        self.tell_then(
            |observers| observers.tell(StatusNews::Ended(&cause)),
            |state| state.ended = Some(Arc::clone(&cause)),
        );
        None
    }

    /// Waits, and returns whether the monitor was dropped meanwhile.
    fn pause(&self, delay: Duration) -> bool {
        self.tell_then(
            |observers| observers.tell(StatusNews::Reconnecting),
            |state| {
                state.counters.interrupted();
                state.reconnecting = true;
            },
        );
        self.board.wait_for(delay, |state| state.closing.then_some(())).is_some()
    }

    fn connected(&self, packets: Packets) -> Option<Packets> {
        let mut state = self.board.lock();
        if state.closing {
            packets.tap.left();
            return None;
        }
        state.tap = packets.tap.clone();
        state.stream = Some(Arc::clone(&packets.stream));
        state.counters.counted.reconnects += 1;
        Some(packets)
    }
}

/// Decodes a packet, into the memory of an unused earlier one if there is one.
fn decode_over<S: Decode>(
    mut spare: Option<Arc<Snapshot<S>>>,
    packet: &str,
    number: u64,
    clock: &Clock,
) -> Result<Arc<Snapshot<S>>, DecodeError> {
    let (mut reader, received) = (Reader::new(packet), clock.now());
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
            let unfit = reader.take_unfit();
            Ok(Arc::new(Snapshot {
                status,
                received,
                number,
                unfit,
                follows_silence: false,
                untold: None,
                clock: clock.clone(),
            }))
        }
    }
}
