//! Records what has passed on a thread of its own: a thread that passes bytes on hands over a copy and never waits.

use std::collections::VecDeque;
use std::io;
use std::mem;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, Weak};
use std::thread;

use jaka_sync::Track;
use jaka_sync::recording::{Event, Message, Port};

use super::frames::{Frames, Piece};

/// How many bytes may wait. Beyond that, pieces are missing in the recording, which says so.
const LIMIT: usize = 8 << 20;

/// What a waiting piece takes in addition to its bytes.
const OVERHEAD: usize = 128;

/// Records what passes on all connections, on a thread of its own.
#[derive(Debug, Clone)]
pub(crate) struct RecordingQueue(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    state: Mutex<State>,
    /// Signalled when there is something to do, and when the thread has ended.
    changed: Condvar,
    limit: usize,
}

#[derive(Debug, Default)]
struct State {
    waiting: VecDeque<(Arc<Connection>, Passed)>,
    bytes: usize,
    /// No more pieces are accepted, and the thread ends when the queue is empty.
    closed: bool,
    /// The thread has ended.
    ended: bool,
    /// How many pieces were not recorded.
    missing: u64,
}

/// A connection that passes through the proxy.
#[derive(Debug)]
pub(super) struct Connection {
    track: Track,
    port: Port,
    /// What each direction has sent in part.
    frames: [Mutex<Frames>; 2],
}

/// The direction of bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    ToRobot,
    ToClient,
}

/// Something that happened on a connection.
#[derive(Debug)]
pub(super) enum Passed {
    Bytes(Direction, Vec<u8>),
    /// The number of pieces that did not fit.
    Missing(Direction, u64),
    /// A direction has ended.
    End(Direction),
    Event(Event),
}

impl Connection {
    pub(super) fn new(track: Track, port: Port) -> Arc<Self> {
        Arc::new(Self { track, port, frames: Default::default() })
    }

    fn record(&self, passed: Passed) {
        match passed {
            Passed::Bytes(direction, bytes) => {
                self.frames(direction).take(&bytes, |piece| self.piece(direction, piece));
            }
            Passed::Missing(direction, count) => {
                self.flush(direction);
                self.track.record(Event::Dropped { count });
            }
            Passed::End(direction) => self.flush(direction),
            Passed::Event(event) => self.track.record(event),
        }
    }

    /// Records an incomplete message of a direction, the rest of which will not come.
    fn flush(&self, direction: Direction) {
        mem::take(&mut *self.frames(direction)).finish(|piece| self.piece(direction, piece));
    }

    fn frames(&self, direction: Direction) -> MutexGuard<'_, Frames> {
        self.frames[usize::from(direction == Direction::ToClient)].lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn piece(&self, direction: Direction, piece: Piece<'_>) {
        let (Piece::Message(bytes) | Piece::Stray(bytes)) = piece;
        let message = Message::new(bytes);
        match (direction, piece) {
            (Direction::ToRobot, _) => self.track.record(Event::Sent(message)),
            (Direction::ToClient, Piece::Message(_)) if self.port == Port::Status => self.track.record_packet(message),
            (Direction::ToClient, _) => self.track.record(Event::Received(message)),
        }
    }
}

impl Passed {
    fn size(&self) -> usize {
        OVERHEAD + if let Self::Bytes(_, bytes) = self { bytes.len() } else { 0 }
    }
}

impl RecordingQueue {
    /// # Errors
    /// The thread cannot be started.
    pub(crate) fn start() -> io::Result<Self> {
        Self::with_limit(LIMIT)
    }

    fn with_limit(limit: usize) -> io::Result<Self> {
        let queue = Self(Arc::new(Shared { state: Mutex::default(), changed: Condvar::new(), limit }));
        let theirs = queue.clone();
        thread::Builder::new().spawn(move || theirs.work())?;
        Ok(queue)
    }

    /// Takes what is about to pass, so that the recording has a request before its reply. Waits for nothing but the queue's lock.
    pub(super) fn take(&self, connection: &Arc<Connection>, passed: Passed) {
        let mut state = self.lock();
        if state.closed {
            return;
        }
        let size = passed.size();
        match passed {
            Passed::Bytes(direction, _) if state.bytes + size > self.0.limit => state.miss(connection, direction),
            // These are few, and small.
            passed => {
                state.bytes += size;
                state.waiting.push_back((Arc::clone(connection), passed));
            }
        }
        self.0.changed.notify_all();
    }

    /// Waits until all that was taken is with the recorder, also what was sent in part, and takes no more. Says how many pieces are
    /// missing.
    pub(crate) fn finish(&self) -> u64 {
        let mut state = self.lock();
        state.closed = true;
        self.0.changed.notify_all();
        while !state.ended {
            state = self.0.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        state.missing
    }

    fn work(&self) {
        let _end = StopOnDrop(self);
        let mut open: Vec<Weak<Connection>> = Vec::new();
        while let Some((connection, passed)) = self.next() {
            if !open.iter().any(|known| known.as_ptr() == Arc::as_ptr(&connection)) {
                open.retain(|known| known.strong_count() > 0);
                open.push(Arc::downgrade(&connection));
            }
            connection.record(passed);
        }
        for connection in open.iter().filter_map(Weak::upgrade) {
            connection.flush(Direction::ToRobot);
            connection.flush(Direction::ToClient);
        }
    }

    /// The next entry to record; none at the end.
    fn next(&self) -> Option<(Arc<Connection>, Passed)> {
        let mut state = self.lock();
        while state.waiting.is_empty() {
            if state.closed {
                return None;
            }
            state = self.0.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        let next = state.waiting.pop_front()?;
        state.bytes -= next.1.size();
        Some(next)
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        // Every change is complete before the lock is released.
        self.0.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl State {
    /// Counts a piece that does not fit, in one entry with those before it.
    fn miss(&mut self, connection: &Arc<Connection>, direction: Direction) {
        self.missing += 1;
        let last = self.waiting.iter_mut().rev().find(|(theirs, _)| Arc::ptr_eq(theirs, connection));
        match last {
            Some((_, Passed::Missing(same, count))) if *same == direction => *count += 1,
            _ => {
                self.bytes += OVERHEAD;
                self.waiting.push_back((Arc::clone(connection), Passed::Missing(direction, 1)));
            }
        }
    }
}

/// Ends all waits for the thread when it ends, also by a panic.
struct StopOnDrop<'s>(&'s RecordingQueue);

impl Drop for StopOnDrop<'_> {
    fn drop(&mut self) {
        let mut state = self.0.lock();
        (state.closed, state.ended) = (true, true);
        state.waiting.clear();
        drop(state);
        self.0.0.changed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use jaka_sync::recording::Recording;
    use jaka_sync::{Recorder, StatusSampling};
    use jaka_tests::RecordingBuffer;

    use super::*;

    #[test]
    fn what_an_open_connection_has_sent_in_part_is_recorded_at_the_end() {
        let buffer = RecordingBuffer::default();
        let recorder = Recorder::new(buffer.clone()).expect("a thread can be had");
        let queue = RecordingQueue::start().expect("a thread can be had");
        let connection = Connection::new(recorder.track(Port::Command, StatusSampling::All), Port::Command);
        queue.take(&connection, Passed::Bytes(Direction::ToRobot, b"{\"a\":1}{\"cut".to_vec()));
        assert_eq!(queue.finish(), 0);
        recorder.finish().expect("memory can be written");
        let recording: Recording = buffer.read().expect("it has just been written");
        let sent = recording.entries.iter().filter_map(|entry| entry.event.message()).map(ToString::to_string);
        assert_eq!(sent.collect::<Vec<_>>(), ["{\"a\":1}", "{\"cut"]);
    }

    #[test]
    fn what_does_not_fit_is_missing_and_counted_and_nobody_waits() {
        let buffer = RecordingBuffer::default();
        let recorder = Recorder::new(buffer.clone()).expect("a thread can be had");
        let queue = RecordingQueue::with_limit(2 * OVERHEAD).expect("a thread can be had");
        let connection = Connection::new(recorder.track(Port::Command, StatusSampling::All), Port::Command);
        let bytes = |direction, text: &str| Passed::Bytes(direction, text.as_bytes().to_vec());
        // While the thread records this one, the others wait.
        let blocked = connection.frames(Direction::ToRobot);
        queue.take(&connection, bytes(Direction::ToRobot, "{\"a\":1}{\"cut"));
        while !queue.lock().waiting.is_empty() {
            thread::yield_now();
        }
        for text in ["\":2}{}", &"x".repeat(500), &"y".repeat(500)] {
            queue.take(&connection, bytes(Direction::ToRobot, text));
        }
        queue.take(&connection, Passed::End(Direction::ToRobot));
        drop(blocked);
        assert_eq!(queue.finish(), 2);
        queue.take(&connection, bytes(Direction::ToRobot, "{\"late\":1}"));
        recorder.finish().expect("memory can be written");
        let recording: Recording = buffer.read().expect("it has just been written");
        let events = recording.entries.iter().map(|entry| match &entry.event {
            Event::Sent(message) => message.to_string(),
            Event::Dropped { count } => format!("{count} missing"),
            other => panic!("{other:?}"),
        });
        assert_eq!(events.collect::<Vec<_>>(), ["{\"a\":1}", "{\"cut\":2}", "{}", "2 missing"]);
    }
}
