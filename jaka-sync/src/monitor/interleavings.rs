//! Interleavings of threads that share a monitor's board: a thread that waits is always woken.
//!
//! `.ci/interleavings` runs these tests. Under shuttle a wait never times out, so a lost wake-up is a deadlock, which
//! shuttle reports with its schedule.

use std::sync::Arc;
use std::time::Duration;

use shuttle::thread;

use super::thread::Worker;
use super::{Board, BoardState, Monitor};
use crate::recorder::Tap;
use crate::{Config, Disconnect, Reconnect, Snapshot};

/// Number of schedules that each test tries at random, and again with a few switches of threads at any place.
const SCHEDULES: usize = 5000;
const SWITCHES: usize = 3;

/// Longer than any test.
const LONG: Duration = Duration::from_secs(3600);

fn check(test: fn()) {
    shuttle::check_random(test, SCHEDULES);
    shuttle::check_pct(test, SCHEDULES, SWITCHES);
}

/// Monitor without a connection, and the worker of its thread.
fn monitor(config: &Config) -> (Arc<Monitor<i64>>, Worker<i64>) {
    let board = Arc::new(Board::new(&config.clock, BoardState::new(None, Tap::default())));
    let worker = Worker::new(Arc::clone(&board), String::new(), config.clone());
    (Arc::new(Monitor { board, clock: config.clock.clone(), thread: None, timeout: LONG, stale_after: LONG }), worker)
}

/// Two packets, and then the end of the connection.
fn two_packets(mut worker: Worker<i64>) {
    for packet in 1..=2 {
        worker.number += 1;
        worker.post(Ok(Snapshot::arriving(packet, worker.number)));
    }
    assert!(worker.reconnect(Disconnect::Closed { partial: 0 }).is_none());
    worker.end();
}

#[test]
fn each_waiter_is_woken_by_its_packet_or_by_the_end() {
    check(|| {
        let (monitor, worker) = monitor(&Config::new());
        let waiting = |wanted| {
            let monitor = Arc::clone(&monitor);
            thread::spawn(move || monitor.wait_until(|packet| *packet == wanted, LONG))
        };
        let (second, never) = (waiting(2), waiting(3));
        two_packets(worker);
        // The connection may have ended before the thread looked at the newest packet.
        match second.join().expect("it does not panic") {
            Ok(found) => assert_eq!((found.status, found.number), (2, 2)),
            Err(error) => assert!(error.is_disconnected(), "{error:?}"),
        }
        let error = never.join().expect("it does not panic").expect_err("there is none");
        assert!(error.is_disconnected(), "{error:?}");
    });
}

#[test]
fn who_watches_sees_newer_packets_only() {
    check(|| {
        let (monitor, worker) = monitor(&Config::new());
        let sending = thread::spawn(move || two_packets(worker));
        let mut seen = Vec::new();
        let watched = monitor.watch(LONG, |packet| {
            seen.extend(packet.map(|packet| packet.number));
            None::<()>
        });
        assert!(watched.is_err_and(|error| error.is_disconnected()));
        assert!(seen.is_sorted_by(|a, b| a < b) && seen.iter().all(|number| *number <= 2), "{seen:?}");
        sending.join().expect("it does not panic");
        assert_eq!(monitor.last_known_packet().map(|packet| packet.number), Some(2));
    });
}

#[test]
fn dropping_a_monitor_ends_the_pause_before_it_reconnects() {
    check(|| {
        let config = Config::new().reconnect(Reconnect::Attempts { limit: 1, delay: LONG, longest: LONG });
        let (monitor, worker) = monitor(&config);
        let connecting = thread::spawn(move || worker.reconnect(Disconnect::Closed { partial: 0 }).is_none());
        drop(monitor);
        assert!(connecting.join().expect("it does not panic"), "nothing was connected");
    });
}

#[test]
fn a_subscription_has_each_packet_and_then_its_end() {
    check(|| {
        let (monitor, worker) = monitor(&Config::new());
        let subscription = monitor.subscribe(1);
        let sending = thread::spawn(move || two_packets(worker));
        let received: Vec<_> =
            std::iter::from_fn(|| subscription.next_packet_within(LONG)).map(|packet| packet.number).collect();
        sending.join().expect("it does not panic");
        assert!(subscription.is_closed());
        assert!(received == [1, 2] || (received == [2] && subscription.dropped() == 1), "{received:?}");
    });
}
