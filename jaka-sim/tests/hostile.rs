//! Clients that mean harm: the simulator neither crashes nor takes memory without bound.

mod common;

use std::collections::VecDeque;
use std::io::{ErrorKind, Write};
use std::net::TcpStream;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use common::{LIMIT, Peer, assert_accepted, fresh, request, skipped};
use jaka_sim::{Controller, Fault};

/// Most memory that a test may take, in MiB. What it sends is far more.
const MOST_MEMORY: usize = 64;

/// Waits for the other tests: memory and descriptors are those of one of them.
fn alone() -> MutexGuard<'static, ()> {
    static ALONE: Mutex<()> = Mutex::new(());
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The memory of this process, in MiB, if pages have 4 KiB; 0 if it is not known, which is told.
fn memory() -> usize {
    let statm = std::fs::read_to_string("/proc/self/statm").unwrap_or_default();
    let pages = statm.split(' ').nth(1).and_then(|pages| pages.parse::<usize>().ok());
    pages.map_or_else(
        || {
            skipped("how much memory the simulator takes", "this system has no /proc");
            0
        },
        |pages| pages >> 8,
    )
}

/// Greatest number of connections that a test may hold at once: each takes a descriptor at either end.
fn most_connections() -> usize {
    let limits = std::fs::read_to_string("/proc/self/limits").unwrap_or_default();
    let line = limits.lines().find_map(|line| line.strip_prefix("Max open files"));
    let limit: usize = line.and_then(|line| line.split_whitespace().next()?.parse().ok()).unwrap_or(256);
    (limit / 3).clamp(32, 1000)
}

/// Checks that memory has hardly grown, and that both ports still serve.
fn assert_well(controller: &Controller, before: usize) {
    let grown = memory().saturating_sub(before);
    assert!(grown < MOST_MEMORY, "memory has grown by {grown} MiB");
    assert_accepted(&Peer::commands(controller).call("get_version"), "get_version");
    assert!(Peer::status(controller).receive().starts_with('{'));
}

/// Sends these bytes over and over, and reads what comes; true if the controller takes it all.
fn flood(peer: &mut Peer, bytes: &[u8], times: usize) -> bool {
    let mut theirs = peer.stream.try_clone().expect("a socket can be shared");
    thread::scope(|scope| {
        scope.spawn(move || std::io::copy(&mut theirs, &mut std::io::sink()));
        let taken = (0..times).all(|_| peer.stream.write_all(bytes).is_ok());
        peer.stream.shutdown(std::net::Shutdown::Both).ok();
        taken
    })
}

/// Sends these bytes over and over until the connection is full, or the controller is held up; the number of bytes that
/// it has taken.
fn fill(stream: &mut TcpStream, bytes: &[u8]) -> usize {
    stream.set_write_timeout(Some(Duration::from_millis(50))).expect("a timeout can be set");
    let mut sent = 0;
    loop {
        assert!(sent < 256 << 20, "the connection has no end");
        match stream.write(bytes) {
            Ok(count) => sent += count,
            // The process was stopped for a moment.
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => {
                assert!(matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut), "{error}");
                return sent;
            }
        }
    }
}

/// Random bytes, which are those that a fault makes up.
fn random(seed: u64) -> Vec<u8> {
    let controller = fresh();
    controller.inject(Fault::Garbage { bytes: 1 << 20, seed });
    let mut peer = Peer::commands(&controller);
    peer.send(request("get_version"));
    peer.receive_bytes(1 << 20)
}

#[test]
fn random_bytes() {
    let _alone = alone();
    let (controller, before) = (fresh(), memory());
    for seed in 0..8 {
        let bytes = random(seed);
        flood(&mut Peer::commands(&controller), &bytes, 2);
        // Without reading, and in small pieces.
        let mut peer = Peer::commands(&controller);
        bytes.chunks(97).take(200).try_for_each(|piece| peer.stream.write_all(piece)).ok();
        fill(&mut Peer::status(&controller).stream, &bytes);
    }
    assert_well(&controller, before);
}

#[test]
fn a_hundred_megabytes_without_a_brace() {
    let _alone = alone();
    let (controller, before) = (fresh(), memory());
    let bytes = vec![b'x'; 1 << 20];
    assert!(flood(&mut Peer::commands(&controller), &bytes, 100));
    assert!(controller.requests().is_empty());
    // The same within a request and within a string: the connection is closed.
    for start in ["{", "{\"", "("] {
        let mut peer = Peer::commands(&controller);
        peer.send(start);
        assert!(!flood(&mut peer, &bytes, 100));
    }
    // The status port reads nothing: the client's own buffer fills up.
    let mut reader = Peer::status(&controller);
    fill(&mut reader.stream, &bytes);
    assert!(reader.receive().starts_with('{'));
    assert_well(&controller, before);
}

#[test]
fn requests_as_long_as_they_may_be() {
    let _alone = alone();
    let (controller, before) = (fresh(), memory());
    let text = format!("{{\"cmdName\":\"get_version\",\"a\":\"{}\"}}", "x".repeat(60 << 10));
    assert!(flood(&mut Peer::commands(&controller), text.as_bytes(), 2_000));
    assert!(controller.wait_for_disconnect(LIMIT));
    assert_well(&controller, before);
}

#[test]
fn a_thousand_connections() {
    let _alone = alone();
    let (controller, before) = (fresh(), memory());
    let (mut peers, most) = (VecDeque::new(), most_connections());
    for count in 0..1000 {
        if peers.len() >= most {
            peers.pop_front();
        }
        peers.push_back(Peer::connect([controller.command_addr(), controller.status_addr()][count % 2]));
        // A full queue at the door would cost a second for each.
        if count % 50 == 0 {
            controller.publish();
            controller.send(b" ").ok();
        }
    }
    assert_well(&controller, before);
    // Those who came last are served, also among so many.
    let (mut reader, mut client) = (Peer::status(&controller), Peer::commands(&controller));
    assert!(reader.receive().starts_with('{'));
    assert_accepted(&client.call("get_version"), "get_version");
    let start = Instant::now();
    drop(controller);
    assert!(start.elapsed() < LIMIT);
}

#[test]
fn a_command_client_that_never_reads() {
    let _alone = alone();
    let (controller, before) = (fresh(), memory());
    let mut peer = Peer::commands(&controller);
    fill(&mut peer.stream, request("get_joint_pos").repeat(1_000).as_bytes());
    let mut second = Peer::commands(&controller);
    fill(&mut second.stream, request("fly").repeat(1_000).as_bytes());
    peer.read_to_end();
    assert_well(&controller, before);
}

#[test]
fn replies_that_are_kept_back_without_end() {
    let _alone = alone();
    for fault in [Fault::Hold, Fault::WithNext, Fault::Delay(Duration::MAX)] {
        let (controller, before) = (fresh(), memory());
        controller.inject_always(fault);
        // The connection is closed when too much waits.
        assert!(!flood(&mut Peer::commands(&controller), request("get_joint_pos").repeat(100).as_bytes(), 10_000));
        controller.clear_faults();
        assert_well(&controller, before);
    }
}
