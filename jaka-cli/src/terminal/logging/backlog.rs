//! Backlog of lines for standard error, written by its own thread: a thread that sends set-points does not wait for a
//! terminal.

use std::collections::VecDeque;
use std::io::{Write, stderr};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// Greatest number of waiting lines; further lines are only counted.
const MOST: usize = 10_000;
/// Time for which the end of the program waits for the lines.
const PATIENCE: Duration = Duration::from_secs(1);

struct Backlog {
    lines: VecDeque<String>,
    missing: usize,
    /// Whether the thread has taken lines and not yet written them.
    is_writing: bool,
}

static BACKLOG: Mutex<Backlog> = Mutex::new(Backlog { lines: VecDeque::new(), missing: 0, is_writing: false });
static CHANGED: Condvar = Condvar::new();

/// Starts the thread.
pub(super) fn begin() {
    thread::spawn(write);
}

/// Queues a line.
pub(super) fn add(line: String) {
    let mut backlog = lock();
    if backlog.lines.len() < MOST {
        backlog.lines.push_back(line);
    } else {
        backlog.missing += 1;
    }
    CHANGED.notify_all();
}

/// Waits until all lines are written, if the reader takes them.
pub(crate) fn finish() {
    let is_busy = |backlog: &mut Backlog| backlog.is_writing || !backlog.lines.is_empty();
    // On timeout, the remaining lines are lost.
    drop(CHANGED.wait_timeout_while(lock(), PATIENCE, is_busy));
}

fn write() {
    let mut backlog = lock();
    loop {
        backlog.is_writing = false;
        CHANGED.notify_all();
        backlog =
            CHANGED.wait_while(backlog, |backlog| backlog.lines.is_empty()).unwrap_or_else(PoisonError::into_inner);
        backlog.is_writing = true;
        let text: String = backlog.lines.drain(..).collect();
        let missing = std::mem::take(&mut backlog.missing);
        drop(backlog);
        // The reader may be gone.
        stderr().write_all(text.as_bytes()).ok();
        if missing > 0 {
            writeln!(stderr(), "{missing} lines are missing here: they came faster than they could be written").ok();
        }
        backlog = lock();
    }
}

/// Locks the backlog, also after a panic: each change completes before the lock is released.
fn lock() -> MutexGuard<'static, Backlog> {
    BACKLOG.lock().unwrap_or_else(PoisonError::into_inner)
}
