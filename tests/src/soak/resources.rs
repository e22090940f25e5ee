//! Memory, handles and threads of this process, where the system tells them.

use std::fmt;
use std::fs;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// How long threads and sockets may take to disappear after they have ended.
const LIMIT: Duration = Duration::from_secs(60);

/// What the process holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Handles {
    pub(super) files: usize,
    pub(super) threads: usize,
}

impl Handles {
    /// Nothing where the system does not tell.
    pub(super) fn now() -> Self {
        let count = |path| fs::read_dir(path).map(Iterator::count).unwrap_or_default();
        // The listing itself has one.
        Self { files: count("/proc/self/fd").saturating_sub(1), threads: count("/proc/self/task") }
    }

    /// Waits until there are no more than these, and says what there are.
    pub(super) fn settle(self) -> Self {
        let since = Instant::now();
        loop {
            let now = Self::now();
            if (now.files <= self.files && now.threads <= self.threads) || since.elapsed() > LIMIT {
                return now;
            }
            thread::yield_now();
        }
    }
}

impl fmt::Display for Handles {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} handles and {} threads", self.files, self.threads)
    }
}

/// The most that was held at once, as far as somebody looked.
#[derive(Debug, Default)]
pub(super) struct Peak {
    files: AtomicUsize,
    threads: AtomicUsize,
}

impl Peak {
    pub(super) fn look(&self) {
        let now = Handles::now();
        self.files.fetch_max(now.files, Ordering::Relaxed);
        self.threads.fetch_max(now.threads, Ordering::Relaxed);
    }

    pub(super) fn most(&self) -> Handles {
        Handles { files: self.files.load(Ordering::Relaxed), threads: self.threads.load(Ordering::Relaxed) }
    }
}

/// Memory of this process that is in use, in KiB; 0 where the system does not tell.
pub(super) fn memory() -> u32 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    line.and_then(|line| line.trim().trim_end_matches(" kB").parse().ok()).unwrap_or_default()
}

/// By how much a straight line through the samples rises from the first to the last, by least squares.
pub(super) fn growth(samples: &[u32]) -> f64 {
    let numbered = || (0u32..).map(f64::from).zip(samples.iter().copied().map(f64::from));
    let (count, sum_x, sum_y) = numbered().fold((0.0, 0.0, 0.0), |(n, x, y), (at, value)| (n + 1.0, x + at, y + value));
    if count < 2.0 {
        return 0.0;
    }
    let (mean_x, mean_y) = (sum_x / count, sum_y / count);
    let (both, square) = numbered().fold((0.0, 0.0), |(both, square), (x, y)| {
        (both + (x - mean_x) * (y - mean_y), square + (x - mean_x) * (x - mean_x))
    });
    both / square * (count - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_that_of_the_line() {
        assert!((growth(&[10, 20, 30, 40]) - 30.0).abs() < 1e-9);
        assert!((growth(&[40, 30, 20, 10]) + 30.0).abs() < 1e-9);
        assert!(growth(&[5, 5, 5]).abs() < 1e-9 && growth(&[5]).abs() < 1e-9);
        // One high sample in the middle is no trend.
        assert!(growth(&[5, 5, 100, 5, 5]).abs() < 1e-9);
    }
}
