//! Log of the received requests.

use std::collections::VecDeque;
use std::sync::Mutex;
use std::time::Duration;

use jaka_clock::{Clock, Signal, lock};

/// Greatest number of texts in the log, and of their bytes.
const KEPT: usize = 10_000;
const KEPT_BYTES: usize = 16 << 20;

/// Texts of the last requests, and the count of all.
#[derive(Debug, Default)]
pub(crate) struct RequestLog {
    logged: Mutex<Logged>,
    grown: Signal,
}

#[derive(Debug, Default)]
struct Logged {
    texts: VecDeque<String>,
    bytes: usize,
    count: usize,
}

impl RequestLog {
    pub(crate) fn new(time: &Clock) -> Self {
        Self { logged: Mutex::default(), grown: Signal::new(time) }
    }

    /// Adds a request, and removes the oldest ones beyond the limits.
    pub(crate) fn record(&self, request: String) {
        let mut logged = lock(&self.logged);
        logged.bytes += request.len();
        logged.texts.push_back(request);
        logged.count += 1;
        logged.trim();
        self.grown.notify_all();
    }

    pub(crate) fn texts(&self) -> Vec<String> {
        lock(&self.logged).texts.iter().cloned().collect()
    }

    /// Waits until `count` requests were received in total; returns false on timeout.
    pub(crate) fn wait_for(&self, count: usize, timeout: Duration) -> bool {
        self.grown.wait_until(&self.logged, timeout, |logged| logged.count >= count).count >= count
    }
}

impl Logged {
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
        let request_log = RequestLog::default();
        for i in 0..KEPT + 2 {
            request_log.record(i.to_string());
        }
        let texts = request_log.texts();
        assert_eq!((texts.len(), &*texts[0]), (KEPT, "2"));
        assert!(request_log.wait_for(KEPT + 2, Duration::ZERO));
        assert!(!request_log.wait_for(KEPT + 3, Duration::ZERO));
    }

    #[test]
    fn long_ones_are_forgotten_before() {
        let request_log = RequestLog::default();
        for _ in 0..20 {
            request_log.record("x".repeat(1 << 20));
        }
        assert_eq!(request_log.texts().len(), 16);
        assert!(request_log.wait_for(20, Duration::ZERO));
    }
}
