//! Threads of clients and monitors. The only test here: threads of others would be counted, too.

use std::fs;
use std::net::{SocketAddr, TcpListener};
use std::thread;

use jaka_benches::system::canned;
use jaka_sync::{Client, Config, Monitor};

/// Where nothing is ever said.
fn silence() -> SocketAddr {
    let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
    let address = listener.local_addr().expect("it is bound");
    thread::spawn(move || canned::keep_silent(&listener));
    address
}

/// How many threads have a name of ours; none where the system has no /proc.
fn ours() -> Option<usize> {
    let tasks = fs::read_dir("/proc/self/task").ok()?;
    let names = tasks.flatten().filter_map(|task| fs::read_to_string(task.path().join("comm")).ok());
    Some(names.filter(|name| name.starts_with("jaka")).count())
}

#[test]
fn a_client_has_no_thread_and_a_monitor_has_one() {
    if ours().is_none() {
        println!("not run: this system has no /proc");
        return;
    }
    let client = Client::connect(silence()).expect("the server listens");
    assert_eq!(ours(), Some(0));
    let monitor: Monitor = Config::new().monitor(silence()).expect("the server listens");
    // A thread has its name once it runs.
    let appeared = (0..100_000).any(|_| {
        thread::yield_now();
        ours() == Some(1)
    });
    assert!(appeared);
    drop((client, monitor));
    assert_eq!(ours(), Some(0));
}
