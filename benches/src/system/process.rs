//! Figures that Linux reports in `/proc` about this process.

use std::fs;
use std::time::Duration;

/// CPU time of this process, with that of threads that have ended, in steps of 10 ms; `None` if `/proc` does not tell.
pub fn cpu() -> Option<Duration> {
    cpu_of("self")
}

/// CPU time of a process, which `process` names below `/proc`; otherwise as [`cpu`].
pub fn cpu_of(process: &str) -> Option<Duration> {
    let text = fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    let fields: Vec<_> = text.rsplit(')').next()?.split_whitespace().collect();
    let ticks = |index: usize| fields.get(index).and_then(|field| field.parse::<u64>().ok());
    Some(Duration::from_millis(10 * (ticks(11)? + ticks(12)?)))
}

/// CPU time of the calling thread.
pub fn thread_cpu() -> Option<Duration> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split_whitespace().next()?.parse().ok().map(Duration::from_nanos)
}

/// Memory in use, in KiB.
pub fn resident() -> Option<u64> {
    status("VmRSS:")
}

/// Number of threads of this process.
pub fn threads() -> Option<u64> {
    status("Threads:")
}

/// Number of voluntary and involuntary context switches of the running threads of this process.
pub fn switches() -> Option<u64> {
    let threads = fs::read_dir("/proc/self/task").ok()?;
    let of = |thread: fs::DirEntry| {
        let text = fs::read_to_string(thread.path().join("status")).ok()?;
        Some(number(&text, "voluntary_ctxt_switches:")? + number(&text, "nonvoluntary_ctxt_switches:")?)
    };
    Some(threads.flatten().filter_map(of).sum())
}

fn status(key: &str) -> Option<u64> {
    number(&fs::read_to_string("/proc/self/status").ok()?, key)
}

fn number(text: &str, key: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix(key))?;
    line.split_whitespace().next()?.parse().ok()
}
