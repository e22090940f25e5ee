//! Queue of the entries that wait for the writer.

use std::collections::VecDeque;
use std::io;
use std::mem;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::Duration;

use jaka_clock::lock;
use jaka_proto::recording::{Entry, Event};

use super::RecorderReport;

/// Time for which entries are gathered before they are written, so that the writer is not woken for each of them.
const GATHERING: Duration = Duration::from_millis(5);

/// Size of an entry without its message, in bytes.
const OVERHEAD: usize = 128;

/// Queue of the entries that wait for the writer. Adding one never waits for the file.
#[derive(Debug)]
pub(super) struct EntryQueue {
    state: Mutex<QueueState>,
    /// Signalled when the writer has something to do, and when it has ended.
    changed: Condvar,
    limit: usize,
}

#[derive(Debug, Default)]
struct QueueState {
    waiting: VecDeque<Arc<Entry>>,
    bytes: usize,
    writer_sleeps: bool,
    closed: bool,
    report: RecorderReport,
    /// Outcome of the writer, once it has ended.
    ended: Option<Result<(), (io::ErrorKind, String)>>,
}

impl EntryQueue {
    /// A queue of at most this many bytes.
    pub(super) fn new(limit: usize) -> Self {
        Self { state: Mutex::default(), changed: Condvar::new(), limit }
    }

    /// Adds an entry, or counts it as dropped if there is no room.
    pub(super) fn push(&self, entry: &Arc<Entry>) {
        let mut state = lock(&self.state);
        if state.closed {
            return;
        }
        let size = size(entry);
        if state.ended.is_some() || state.bytes + size > self.limit {
            state.drop_entry(entry);
            return;
        }
        state.bytes += size;
        state.waiting.push_back(Arc::clone(entry));
        if state.writer_sleeps {
            self.changed.notify_all();
        }
    }

    /// Returns all entries that wait, some milliseconds after the first of them; `None` once the recording has ended.
    pub(super) fn next_batch(&self) -> Option<VecDeque<Arc<Entry>>> {
        let mut state = lock(&self.state);
        while state.waiting.is_empty() {
            if state.closed {
                return None;
            }
            state.writer_sleeps = true;
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
            state.writer_sleeps = false;
        }
        let gathered = self.changed.wait_timeout_while(state, GATHERING, |state| !state.closed);
        state = gathered.unwrap_or_else(PoisonError::into_inner).0;
        state.bytes = 0;
        let batch = mem::take(&mut state.waiting);
        for entry in &batch {
            state.report.entries += u64::from(!matches!(entry.event, Event::Dropped { .. }));
            state.report.connections += u64::from(matches!(entry.event, Event::Connected { .. }));
        }
        Some(batch)
    }

    /// Runs the writer, and notes its outcome, even after a panic.
    pub(super) fn serve(&self, write: impl FnOnce(&Self) -> io::Result<()>) {
        let written = catch_unwind(AssertUnwindSafe(|| write(self)));
        let ended = written.unwrap_or_else(|_| Err(io::Error::other("the writer panicked")));
        let mut state = lock(&self.state);
        state.ended = Some(ended.map_err(|error| (error.kind(), error.to_string())));
        state.waiting.clear();
        drop(state);
        self.changed.notify_all();
    }

    /// Ends the recording. The entries that wait are still written.
    pub(super) fn close(&self) {
        lock(&self.state).closed = true;
        self.changed.notify_all();
    }

    /// Waits until the writer has ended.
    pub(super) fn wait_until_done(&self) -> io::Result<RecorderReport> {
        let mut state = lock(&self.state);
        loop {
            match &state.ended {
                Some(Ok(())) => return Ok(state.report),
                Some(Err((kind, text))) => return Err(io::Error::new(*kind, text.clone())),
                None => state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner),
            }
        }
    }
}

impl QueueState {
    /// Counts an entry as dropped, at the end of the queue: one count for each connection, so there are never many.
    fn drop_entry(&mut self, entry: &Entry) {
        self.report.dropped += 1;
        let counts = self.waiting.iter_mut().rev().map_while(|last| match last.event {
            Event::Dropped { count } => Some((last, count)),
            _ => None,
        });
        for (last, count) in counts {
            if last.connection == entry.connection {
                let event = Event::Dropped { count: count + 1 };
                *last = Arc::new(Entry::new(last.time, last.port, last.connection, event));
                return;
            }
        }
        let event = Event::Dropped { count: 1 };
        self.waiting.push_back(Arc::new(Entry::new(entry.time, entry.port, entry.connection, event)));
    }
}

fn size(entry: &Entry) -> usize {
    OVERHEAD + entry.event.message().map_or(0, |message| message.bytes().len())
}

#[cfg(test)]
mod tests {
    use jaka_proto::recording::{Message, Port};

    use super::*;

    fn entry(connection: u32, text: &str) -> Arc<Entry> {
        Arc::new(Entry::new(Duration::ZERO, Port::Command, connection, Event::Sent(Message::new(text))))
    }

    #[test]
    fn what_does_not_fit_is_counted_in_its_place() {
        let queue = EntryQueue::new(2 * OVERHEAD + 2);
        for (connection, text) in [(1, "a"), (2, "b"), (1, "c"), (2, "d"), (1, "e")] {
            queue.push(&entry(connection, text));
        }
        let batch = queue.next_batch().expect("entries wait");
        let seen: Vec<_> = batch.iter().map(|entry| (entry.connection, entry.event.clone())).collect();
        let sent = |text| Event::Sent(Message::new(text));
        let dropped = |count| Event::Dropped { count };
        assert_eq!(seen, [(1, sent("a")), (2, sent("b")), (1, dropped(2)), (2, dropped(1))]);
        queue.push(&entry(1, "f"));
        assert_eq!(queue.next_batch().expect("there is room again").len(), 1);
        queue.close();
        queue.push(&entry(1, "g"));
        assert!(queue.next_batch().is_none());
        queue.serve(|_| Ok(()));
        let report = queue.wait_until_done().expect("the writer has ended well");
        assert_eq!((report.entries, report.dropped), (3, 3));
    }

    #[test]
    fn a_writer_that_fails_or_panics_leaves_no_thread_waiting() {
        let queue = EntryQueue::new(1000);
        queue.serve(|_| Err(io::Error::new(io::ErrorKind::StorageFull, "no space left")));
        queue.push(&entry(1, "a"));
        let error = queue.wait_until_done().expect_err("the writer has failed");
        assert_eq!((error.kind(), error.to_string()), (io::ErrorKind::StorageFull, "no space left".to_owned()));
        let queue = EntryQueue::new(1000);
        queue.serve(|_| panic!("as the test wants"));
        assert_eq!(queue.wait_until_done().expect_err("the writer has panicked").to_string(), "the writer panicked");
    }
}
