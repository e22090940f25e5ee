//! No thread outlives its controller. Alone in its process, so that threads can be counted.

#![cfg(target_os = "linux")]

mod common;

use std::time::Instant;

use common::{LIMIT, Peer, fresh, request};
use jaka_sim::Fault;

fn threads() -> usize {
    std::fs::read_dir("/proc/self/task").expect("Linux lists threads").count()
}

#[test]
fn no_thread_is_left() {
    let before = threads();
    for _ in 0..10 {
        let controller = fresh();
        let mut peers = [Peer::commands(&controller), Peer::commands(&controller), Peer::status(&controller)];
        controller.inject(Fault::Hold);
        peers[1].send(request("power_on"));
        peers[2].receive();
        // Each of these connections gets a thread for waiting bytes, and so do those whose clients have already closed
        // them.
        controller.links().hold();
        controller.publish();
        controller.send(b"{}").expect("a client is connected");
        peers[1] = Peer::commands(&controller);
        assert!(threads() > before);
        // One that is waited for, and one whose action has ended.
        controller.when(|_| false, |_| {}).expect("a thread starts");
        assert!(controller.when(|_| true, |_| {}).expect("a thread starts").wait(LIMIT));
        drop(controller);
        // The kernel may list a thread for a moment after it was joined.
        let start = Instant::now();
        while threads() > before {
            assert!(start.elapsed() < LIMIT, "{} threads are left", threads() - before);
            std::thread::yield_now();
        }
    }
}
