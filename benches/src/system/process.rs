//! What Linux reports about this process in `/proc`.

use std::fs;
use std::time::Duration;

/// CPU time of this process, with that of threads that have ended, in steps of 10 ms; none where `/proc` does not tell.
pub fn cpu() -> Option<Duration> {
    cpu_of("self")
}

/// The same of another process.
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

/// How many threads there are.
pub fn threads() -> Option<u64> {
    status("Threads:")
}

/// How often threads of this process have slept, and been made to wait: of those that have not ended.
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
