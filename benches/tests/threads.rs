//! Threads of clients and monitors. The only test here: threads of others would be counted, too.

#[path = "../../tests/src/skipped.rs"]
#[allow(unreachable_pub, reason = "it is public where it lives")]
mod skipped;

use std::fs;
use std::net::{SocketAddr, TcpListener};
use std::thread;
use std::time::{Duration, Instant};

use jaka_benches::system::canned;
use jaka_sync::{Client, Config, Monitor};

use self::skipped::skipped;

/// Longer than a thread takes to begin, however busy the machine is.
const LIMIT: Duration = Duration::from_secs(60);

/// Address of a server that never sends a byte.
fn silence() -> SocketAddr {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    thread::spawn(move || canned::keep_silent(&listener));
    address
}

/// Number of threads whose name starts with `jaka`; none if the system has no /proc.
fn ours() -> Option<usize> {
    let tasks = fs::read_dir("/proc/self/task").ok()?;
    let names = tasks.flatten().filter_map(|task| fs::read_to_string(task.path().join("comm")).ok());
    Some(names.filter(|name| name.starts_with("jaka")).count())
}

#[test]
fn a_client_has_no_thread_and_a_monitor_has_one() {
    if ours().is_none() {
        skipped("the threads of a client and of a monitor", "this system has no /proc");
        return;
    }
    let client = Client::connect(silence()).expect("the server listens");
    assert_eq!(ours(), Some(0));
    let monitor: Monitor = Monitor::connect_with(&Config::new(), silence()).expect("the server listens");
    // A thread has its name once it runs.
    let since = Instant::now();
    while ours() != Some(1) {
        assert!(since.elapsed() < LIMIT, "the monitor has no thread");
        thread::yield_now();
    }
    drop((client, monitor));
    // The kernel may list a thread for a moment after it was joined.
    let since = Instant::now();
    while ours() != Some(0) {
        assert!(since.elapsed() < LIMIT, "the monitor's thread is left");
        thread::yield_now();
    }
}
