//! The place where a thread waits.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, Thread};
use std::time::{Duration, Instant};

/// The place where a thread waits, one wait at a time.
#[derive(Debug)]
pub(crate) struct Seat {
    thread: Thread,
    is_woken: AtomicBool,
}

/// How long a wait lasts before it asks whether something is wrong.
const PATIENCE: Duration = Duration::from_secs(10);

impl Seat {
    /// This thread's.
    pub(crate) fn new() -> Self {
        Self { thread: thread::current(), is_woken: AtomicBool::new(false) }
    }

    /// A wait begins.
    pub(crate) fn sit_down(&self) {
        self.is_woken.store(false, Ordering::SeqCst);
    }

    pub(crate) fn wake(&self) {
        self.is_woken.store(true, Ordering::SeqCst);
        self.thread.unpark();
    }

    pub(crate) fn is_woken(&self) -> bool {
        self.is_woken.load(Ordering::SeqCst)
    }

    /// Waits until it is woken. Where that takes long in real time, asks what is wrong.
    pub(crate) fn wait(&self, mut ask: impl FnMut(Duration)) {
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
