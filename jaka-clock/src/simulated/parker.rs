//! Parker of a thread.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, Thread};
use std::time::{Duration, Instant};

/// Parker of a thread, for one wait at a time.
#[derive(Debug)]
pub(super) struct Parker {
    thread: Thread,
    is_woken: AtomicBool,
}

/// Real time after which a wait asks whether something is wrong.
const PATIENCE: Duration = Duration::from_secs(10);

impl Parker {
    /// Parker of this thread.
    pub(super) fn new() -> Self {
        Self { thread: thread::current(), is_woken: AtomicBool::new(false) }
    }

    /// Begins a wait.
    pub(super) fn begin_wait(&self) {
        self.is_woken.store(false, Ordering::SeqCst);
    }

    pub(super) fn wake(&self) {
        self.is_woken.store(true, Ordering::SeqCst);
        self.thread.unpark();
    }

    pub(super) fn is_woken(&self) -> bool {
        self.is_woken.load(Ordering::SeqCst)
    }

    /// Waits for a wake-up. In a wait that is long in real time, calls `ask` repeatedly, with the time waited.
    pub(super) fn wait(&self, mut ask: impl FnMut(Duration)) {
        let mut since = Instant::now();
        let mut waited = Duration::ZERO;
        while !self.is_woken() {
            thread::park_timeout(PATIENCE);
            if since.elapsed() >= PATIENCE && !self.is_woken() {
                waited += since.elapsed();
                since = Instant::now();
                ask(waited);
            }
        }
    }
}
