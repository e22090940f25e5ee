//! Recording by its own thread: a thread that passes on bytes hands over a copy and never waits.

use std::io;
use std::mem;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};
use std::thread;

use jaka_robot::Track;
use jaka_robot::recording::{Event, Message, Port};

use super::frames::{MessageFrames, Piece};

/// Greatest number of waiting bytes. Beyond it, the recording lacks pieces, and notes that.
const LIMIT: usize = 8 << 20;

/// Size of a waiting piece in addition to its bytes, in bytes.
const OVERHEAD: usize = 128;

/// Queue of the thread that records all connections.
#[derive(Debug, Clone)]
pub(crate) struct RecordingQueue {
    sender: Sender<Waiting>,
    counts: Arc<Counts>,
}

/// Waiting item for the thread.
#[derive(Debug)]
enum Waiting {
    Passed(Arc<ProxiedConnection>, Passed),
    /// End of the input. The thread drops the sender when it has ended.
    Finish(Sender<()>),
}

#[derive(Debug)]
struct Counts {
    /// Limit on the waiting bytes, and their number.
    limit: usize,
    bytes: AtomicUsize,
    /// Number of pieces not recorded.
    missing: AtomicU64,
}

/// Connection through the proxy.
#[derive(Debug)]
pub(super) struct ProxiedConnection {
    track: Track,
    port: Port,
    /// Incomplete messages of each direction.
    frames: [Mutex<MessageFrames>; 2],
    /// Number of pieces of each direction that did not fit since the last one that did.
    missing: [AtomicU64; 2],
}

/// Direction of bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    ToRobot,
    ToClient,
}

/// Event on a connection.
#[derive(Debug)]
pub(super) enum Passed {
    Bytes(Direction, Vec<u8>),
    /// Number of pieces that did not fit.
    Missing(Direction, u64),
    /// End of a direction.
    End(Direction),
    Event(Event),
}

impl ProxiedConnection {
    pub(super) fn new(track: Track, port: Port) -> Arc<Self> {
        Arc::new(Self { track, port, frames: Default::default(), missing: Default::default() })
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

    /// Records an incomplete message of a direction whose rest will not come.
    fn flush(&self, direction: Direction) {
        mem::take(&mut *self.frames(direction)).finish(|piece| self.piece(direction, piece));
    }

    fn frames(&self, direction: Direction) -> MutexGuard<'_, MessageFrames> {
        self.frames[direction as usize].lock().unwrap_or_else(PoisonError::into_inner)
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

    /// Takes the number of missing pieces of a direction since the last call.
    fn take_missing(&self, direction: Direction) -> Option<Passed> {
        let count = self.missing[direction as usize].swap(0, Ordering::Relaxed);
        (count > 0).then_some(Passed::Missing(direction, count))
    }
}

impl Passed {
    fn size(&self) -> usize {
        OVERHEAD + if let Self::Bytes(_, bytes) = self { bytes.len() } else { 0 }
    }
}

impl RecordingQueue {
    /// # Errors
    /// The thread cannot start.
    pub(crate) fn start() -> io::Result<Self> {
        Self::with_limit(LIMIT)
    }

    fn with_limit(limit: usize) -> io::Result<Self> {
        let (sender, waiting) = mpsc::channel();
        let counts = Arc::new(Counts { limit, bytes: AtomicUsize::new(0), missing: AtomicU64::new(0) });
        let theirs = Arc::clone(&counts);
        thread::Builder::new().spawn(move || work(&waiting, &theirs.bytes))?;
        Ok(Self { sender, counts })
    }

    /// Queues a piece that is about to pass, so that the recording has a request before its reply. Never waits.
    pub(super) fn take(&self, connection: &Arc<ProxiedConnection>, passed: Passed) {
        if let Passed::Bytes(direction, _) | Passed::End(direction) = passed {
            let is_full = self.counts.bytes.load(Ordering::Relaxed) + passed.size() > self.counts.limit;
            // Ends are few and small.
            if is_full && matches!(passed, Passed::Bytes(..)) {
                connection.missing[direction as usize].fetch_add(1, Ordering::Relaxed);
                self.counts.missing.fetch_add(1, Ordering::Relaxed);
                return;
            }
            connection.take_missing(direction).into_iter().for_each(|missing| self.send(connection, missing));
        }
        self.send(connection, passed);
    }

    /// Sends an item to the thread. After the end of the thread, nothing is recorded.
    fn send(&self, connection: &Arc<ProxiedConnection>, passed: Passed) {
        self.counts.bytes.fetch_add(passed.size(), Ordering::Relaxed);
        self.sender.send(Waiting::Passed(Arc::clone(connection), passed)).ok();
    }

    /// Waits until the recorder has all queued pieces, including incomplete messages, and accepts no more. Returns the
    /// number of missing pieces.
    pub(crate) fn finish(&self) -> u64 {
        let (sender, ended) = mpsc::channel();
        self.sender.send(Waiting::Finish(sender)).ok();
        // Receives nothing: the sender is dropped with the thread, also by a panic.
        ended.recv().ok();
        self.counts.missing.load(Ordering::Relaxed)
    }
}

/// Records waiting items until the end of the input.
fn work(waiting: &Receiver<Waiting>, bytes: &AtomicUsize) {
    let mut open: Vec<Weak<ProxiedConnection>> = Vec::new();
    let ended = loop {
        match waiting.recv() {
            Ok(Waiting::Passed(connection, passed)) => {
                bytes.fetch_sub(passed.size(), Ordering::Relaxed);
                if !open.iter().any(|known| known.as_ptr() == Arc::as_ptr(&connection)) {
                    open.retain(|known| known.strong_count() > 0);
                    open.push(Arc::downgrade(&connection));
                }
                connection.record(passed);
            }
            Ok(Waiting::Finish(ended)) => break Some(ended),
            Err(_) => break None,
        }
    };
    for connection in open.iter().filter_map(Weak::upgrade) {
        for direction in [Direction::ToRobot, Direction::ToClient] {
            connection.flush(direction);
            connection.take_missing(direction).into_iter().for_each(|missing| connection.record(missing));
        }
    }
    drop(ended);
}

#[cfg(test)]
mod tests {
    use std::io::{Read, Write};
    use std::net::{Shutdown, TcpListener, TcpStream};
    use std::time::Duration;

    use jaka_robot::Recorder;
    use jaka_robot::recording::Recording;
    use jaka_tests::{LONG, RecordingBuffer};

    use super::super::pipe::Pipe;
    use super::*;

    /// Returns both ends of a connection.
    fn connected() -> (TcpStream, TcpStream) {
        let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
        let near = TcpStream::connect(listener.local_addr().expect("it listens")).expect("it listens");
        (near, listener.accept().expect("it was connected").0)
    }

    #[test]
    fn a_stop_passes_while_the_garbage_before_it_is_recorded() {
        const STOP: &[u8] = br#"{"cmdName":"stop_program"}"#;
        let recorder = Recorder::new(io::sink()).expect("a thread can be had");
        let queue = RecordingQueue::start().expect("a thread can be had");
        for garbage in [&b"x{}"[..], b"{", b"}", b"{\""] {
            let connection = ProxiedConnection::new(recorder.track(Port::Command, Duration::ZERO), Port::Command);
            let ((mut program, client), (robot, mut controller)) = (connected(), connected());
            controller.set_read_timeout(Some(LONG)).expect("a timeout can be set");
            let bytes = [&garbage.repeat((1 << 20) / garbage.len()), STOP].concat();
            let mut passed = vec![0; bytes.len()];
            let read = thread::scope(|scope| {
                // The recording waits until this guard is dropped.
                let recording = connection.frames(Direction::ToRobot);
                scope.spawn(|| Pipe { client: &client, robot: &robot, connection: &connection, queue: &queue }.run());
                scope.spawn(|| program.write_all(&bytes));
                let read = controller.read_exact(&mut passed);
                drop(recording);
                for stream in [&client, &robot, &controller] {
                    stream.shutdown(Shutdown::Both).ok();
                }
                read
            });
            assert!(read.is_ok() && passed == bytes, "the stop waits for the recording: {read:?}");
        }
    }

    #[test]
    fn what_an_open_connection_has_sent_in_part_is_recorded_at_the_end() {
        let buffer = RecordingBuffer::default();
        let recorder = Recorder::new(buffer.clone()).expect("a thread can be had");
        let queue = RecordingQueue::start().expect("a thread can be had");
        let connection = ProxiedConnection::new(recorder.track(Port::Command, Duration::ZERO), Port::Command);
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
        let connection = ProxiedConnection::new(recorder.track(Port::Command, Duration::ZERO), Port::Command);
        let bytes = |direction, text: &str| Passed::Bytes(direction, text.as_bytes().to_vec());
        // While the thread records this piece, the others wait.
        let blocked = connection.frames(Direction::ToRobot);
        queue.take(&connection, bytes(Direction::ToRobot, "{\"a\":1}{\"cut"));
        while queue.counts.bytes.load(Ordering::Relaxed) > 0 {
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
