//! Memory, handles and threads of this process, where the system tells them.

use std::alloc::System;
use std::fmt;
use std::fs;
use std::thread;
use std::time::{Duration, Instant};

use stats_alloc::StatsAlloc;

/// Timeout for ended threads and closed sockets to disappear.
const LIMIT: Duration = Duration::from_secs(60);

/// Numbers of open files and threads of the process.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Handles {
    files: usize,
    threads: usize,
}

impl Handles {
    /// Nothing where the system does not tell, which is told.
    #[must_use]
    pub fn now() -> Self {
        let count = |path| {
            let entries = fs::read_dir(path).map(Iterator::count);
            entries.unwrap_or_else(|_| {
                crate::skipped("handles and threads", "this system has no /proc");
                0
            })
        };
        // The listing itself has one.
        Self { files: count("/proc/self/fd").saturating_sub(1), threads: count("/proc/self/task") }
    }

    /// Waits until there are no more than these, and says what there are.
    #[must_use]
    pub fn settle(self) -> Self {
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

/// Number of bytes that are allocated and not freed.
#[must_use]
pub fn allocated(allocator: &StatsAlloc<System>) -> u64 {
    let stats = allocator.stats();
    u64::try_from(stats.bytes_allocated - stats.bytes_deallocated).unwrap_or(u64::MAX)
}

/// Memory of this process that is resident, holes of the heap included, in KiB; 0 if the system does not tell.
#[must_use]
pub fn resident() -> u32 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    line.and_then(|line| line.trim().trim_end_matches(" kB").parse().ok()).unwrap_or_default()
}
