//! Recording sessions to a file.

mod queue;
mod tap;

use std::fmt;
use std::fs::File;
use std::io::{self, Write};
use std::path::Path;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant, SystemTime};

use jaka_clock::{Clock, lock};
use jaka_proto::recording::{Entry, Event, Header, Message, Port};
use jaka_proto::wire::Writer;

use self::queue::EntryQueue;
pub(crate) use self::tap::Tap;

/// Greatest number of bytes of entries that wait for the writer: some seconds of entries, also with status packets.
const LIMIT: usize = 8 << 20;

/// Number of bytes of entries that are written at once.
const BLOCK: usize = 64 << 10;

/// Records the traffic of connections: requests, replies, status packets, and the beginning and end of each connection.
///
/// Given to a [`Config`](crate::Config), it records each client, status stream and monitor that the config connects.
/// The clones of a recorder write the same recording, in the format of [`recording`](crate::recording).
///
/// A separate thread writes the file, some milliseconds later. Calls never wait for it: if it falls behind by 8 MiB,
/// entries are dropped, and a `dropped` entry in their place has their number. While recording is on, errors carry the
/// last messages of their connection: see [`Error::exchanges`](crate::Error::exchanges).
///
/// The simulator can replay a session that failed, which makes the session a unit test:
///
/// ```
/// use jaka_sim::{Controller, Replay};
/// use jaka_sync::recording::Recording;
/// use jaka_sync::{Client, Config, Error, Recorder};
///
/// /// The program under test.
/// fn program(config: &Config, address: impl std::fmt::Display) -> Result<(), Error> {
///     let mut robot = Client::connect_with(config, address)?;
///     robot.get_version()?;
///     robot.enable_robot()?; // without power
///     Ok(())
/// }
///
/// // In the field: record a session that fails.
/// # let folder = std::env::temp_dir();
/// # let path = folder.join(format!("jaka-recorder-{}.jsonl", std::process::id()));
/// # let robot = Controller::start()?;
/// # let address = robot.command_addr();
/// let recorder = Recorder::create(&path)?;
/// let failed = program(&Config::new().recorder(recorder.clone()), address).unwrap_err();
/// eprintln!("{failed:#}"); // with the last messages
/// recorder.finish()?;
///
/// // In a unit test: replay it, without a robot.
/// let recording = Recording::read(&std::fs::read(&path)?)?;
/// # std::fs::remove_file(&path)?;
/// let controller = Controller::builder().replay(recording, Replay::Strict).start()?;
/// let again = program(&Config::new(), controller.command_addr()).unwrap_err();
/// assert_eq!(again.to_string(), failed.to_string());
/// assert!(controller.deviations().is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
#[must_use = "a recorder records the connections of the configurations that it is given to"]
pub struct Recorder(Arc<Shared>);

/// State that the clones of a recorder share. Dropping it ends the thread.
struct Shared {
    queue: Arc<EntryQueue>,
    started: Instant,
    connections: AtomicU32,
    thread: Option<JoinHandle<()>>,
}

/// The outcome of a recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct RecorderReport {
    /// Entries that were written.
    pub entries: u64,
    /// Number of connections that were made. If it is 0, the recording has only the reasons why none could be made.
    pub connections: u64,
    /// Entries that were dropped, because the file could not be written as fast.
    pub dropped: u64,
}

impl Recorder {
    /// Records to a new file; one that exists is overwritten.
    ///
    /// # Errors
    /// The file cannot be made, or a thread cannot be started.
    pub fn create(path: impl AsRef<Path>) -> io::Result<Self> {
        Self::new(File::create(path)?)
    }

    /// Records to any writer, which is flushed whenever all recorded entries are written.
    ///
    /// # Errors
    /// A thread cannot be started.
    pub fn new(writer: impl Write + Send + 'static) -> io::Result<Self> {
        let (queue, started) = (Arc::new(EntryQueue::new(LIMIT)), Clock::default().now());
        let theirs = Arc::clone(&queue);
        let thread = thread::Builder::new().name("jaka-recorder".to_owned());
        let thread = Some(thread.spawn(move || theirs.serve(|queue| write(queue, &header(), writer)))?);
        Ok(Self(Arc::new(Shared { queue, started, connections: AtomicU32::new(0), thread })))
    }

    /// Ends the recording, for the clones too, and waits until all entries are written. Later events are not recorded.
    ///
    /// Without this call, the recording ends when the last clone and the connections that it records are dropped.
    ///
    /// # Errors
    /// The first error of the file or writer; nothing was written after it.
    pub fn finish(&self) -> io::Result<RecorderReport> {
        self.0.queue.close();
        self.0.queue.wait_until_done()
    }

    /// Adds a connection to the recording, with the next number. The connections of this crate's clients and streams
    /// add themselves. Of status packets at most one is recorded in the interval; all of them if it is zero.
    pub fn track(&self, port: Port, status_interval: Duration) -> Track {
        self.track_by(&Clock::default(), port, status_interval)
    }

    /// Adds a connection as [`track`](Self::track) does, with times by this clock.
    pub(super) fn track_by(&self, clock: &Clock, port: Port, status_interval: Duration) -> Track {
        let (recorder, number) = (self.clone(), self.0.connections.fetch_add(1, Ordering::Relaxed) + 1);
        Track { recorder, port, number, clock: clock.clone(), status_interval, last_packet: Mutex::default() }
    }
}

impl Drop for Shared {
    fn drop(&mut self) {
        self.queue.close();
        if let Some(thread) = self.thread.take() {
            // A panic of the thread has been reported already.
            drop(thread.join());
        }
    }
}

impl fmt::Debug for Shared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Shared").field("connections", &self.connections).finish_non_exhaustive()
    }
}

fn header() -> Header {
    // A clock before 1970 is wrong in any case; the header then has 1970.
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    Header::new(now, concat!("jaka-sync ", env!("CARGO_PKG_VERSION")))
}

/// Writes the entries of the queue until the queue ends.
fn write(queue: &EntryQueue, header: &Header, mut writer: impl Write) -> io::Result<()> {
    let mut out = Writer::new();
    header.write(&mut out);
    while let Some(batch) = queue.next_batch() {
        for entry in batch {
            entry.write(&mut out);
            if out.as_str().len() >= BLOCK {
                writer.write_all(out.as_str().as_bytes())?;
                out.clear();
            }
        }
        writer.write_all(out.as_str().as_bytes())?;
        writer.flush()?;
        out.clear();
    }
    writer.write_all(out.as_str().as_bytes())?;
    writer.flush()
}

/// One connection in a recording, for programs that make their own connections, such as a proxy.
///
/// ```
/// use std::time::Duration;
///
/// use jaka_sync::Recorder;
/// use jaka_sync::recording::{Event, Message, Port};
///
/// let recorder = Recorder::new(std::io::sink())?;
/// let track = recorder.track(Port::Command, Duration::ZERO);
/// track.record(Event::Connected { address: "10.5.5.100:10001".to_owned() });
/// track.record(Event::Sent(Message::new(r#"{"cmdName":"get_version"}"#)));
/// assert_eq!(recorder.finish()?.entries, 2);
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct Track {
    recorder: Recorder,
    port: Port,
    number: u32,
    clock: Clock,
    /// Least time between two recorded status packets.
    status_interval: Duration,
    /// Time of the last recorded status packet.
    last_packet: Mutex<Option<Duration>>,
}

impl Track {
    /// Records an event with the current time.
    pub fn record(&self, event: Event) {
        self.push(&self.entry(self.now(), event));
    }

    /// Records a status packet with the current time, unless the last one was recorded within the interval before.
    pub fn record_packet(&self, packet: Message) {
        self.push_packet(&self.entry(self.now(), Event::Received(packet)));
    }

    /// Time since the start of the recording or, with a simulated clock, since the creation of the clock.
    pub(super) fn now(&self) -> Duration {
        self.clock.elapsed_since_start(self.recorder.0.started)
    }

    pub(super) fn entry(&self, time: Duration, event: Event) -> Arc<Entry> {
        Arc::new(Entry::new(time, self.port, self.number, event))
    }

    pub(super) fn push(&self, entry: &Arc<Entry>) {
        self.recorder.0.queue.push(entry);
    }

    pub(super) fn push_packet(&self, entry: &Arc<Entry>) {
        let mut last = lock(&self.last_packet);
        if last.is_none_or(|last| entry.time.saturating_sub(last) >= self.status_interval) {
            *last = Some(entry.time);
            drop(last);
            self.push(entry);
        }
    }
}
