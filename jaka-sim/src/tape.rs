//! The requests that have come.

use std::collections::VecDeque;
use std::sync::{Condvar, Mutex};
use std::time::Duration;

use crate::lock::{lock, wait};

/// How many texts are kept, and how many bytes of them.
const KEPT: usize = 10_000;
const KEPT_BYTES: usize = 16 << 20;

/// The texts of the last requests, and the count of all.
#[derive(Debug, Default)]
pub(crate) struct Tape {
    reel: Mutex<Reel>,
    grown: Condvar,
}

#[derive(Debug, Default)]
struct Reel {
    texts: VecDeque<String>,
    bytes: usize,
    count: usize,
}

impl Tape {
    /// Adds a request, and forgets the oldest where there are too many.
    pub(crate) fn record(&self, request: String) {
        let mut reel = lock(&self.reel);
        reel.bytes += request.len();
        reel.texts.push_back(request);
        reel.count += 1;
        reel.trim();
        self.grown.notify_all();
    }

    pub(crate) fn texts(&self) -> Vec<String> {
        lock(&self.reel).texts.iter().cloned().collect()
    }

    /// Waits until `count` requests have come in all; false where they have not in time.
    pub(crate) fn wait_for(&self, count: usize, timeout: Duration) -> bool {
        wait(&self.grown, lock(&self.reel), timeout, |reel| reel.count >= count).count >= count
    }
}

impl Reel {
    fn trim(&mut self) {
        while self.texts.len() > KEPT || self.bytes > KEPT_BYTES {
            let Some(oldest) = self.texts.pop_front() else { break };
            self.bytes -= oldest.len();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_oldest_are_forgotten_and_counted() {
        let tape = Tape::default();
        for i in 0..KEPT + 2 {
            tape.record(i.to_string());
        }
        let texts = tape.texts();
        assert_eq!((texts.len(), &*texts[0]), (KEPT, "2"));
        assert!(tape.wait_for(KEPT + 2, Duration::ZERO));
        assert!(!tape.wait_for(KEPT + 3, Duration::ZERO));
    }

    #[test]
    fn long_ones_are_forgotten_before() {
        let tape = Tape::default();
        for _ in 0..20 {
            tape.record("x".repeat(1 << 20));
        }
        assert_eq!(tape.texts().len(), 16);
        assert!(tape.wait_for(20, Duration::ZERO));
    }
}
