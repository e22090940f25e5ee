//! Every fault of the simulator with every kind of call: what the call ends with, and what the next ones do.
//!
//! With `JAKA_RELIABILITY`, the matrix is gone through so many times; after the first, the faults and the pauses between
//! calls are random.
//!
//! One test, alone in its process, so that threads can be counted. `docs/reliability.md` has the table that it makes.

mod calls;
mod cell;
mod model;
mod outcome;
mod robot;
mod status;
mod table;
mod troubles;

use std::thread;
use std::time::{Duration, Instant};

use expect_test::expect_file;
use proptest::test_runner::{RngAlgorithm, TestRng};

use self::cell::{Cell, Kind, LIMIT, Next, Seen};
use self::model::Expected;
use self::troubles::Trouble;

#[test]
fn each_fault_with_each_kind_of_call() {
    let troubles = troubles::all();
    let cells = troubles.iter().map(|trouble| Kind::ALL.map(|kind| both(trouble, kind, Duration::ZERO)));
    let table = table::table(&troubles, &cells.collect::<Vec<_>>());
    println!("{table}");
    expect_file!["../../../docs/reliability.md"].assert_eq(&table::in_document(&table));
    let mut random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    for round in 1..jaka_tests::reliability_times() {
        println!("round {round}");
        for trouble in &troubles {
            let trouble = trouble.at_random(&mut random);
            for kind in Kind::ALL {
                both(&trouble, kind, troubles::pause(&mut random));
            }
        }
    }
}

/// One cell, with a next call of another name and with one of the same name, where that makes a difference.
fn both(trouble: &Trouble, kind: Kind, pause: Duration) -> Expected {
    one(trouble, kind, Next::Other, pause);
    let expected = model::expected(trouble, kind);
    if expected.same.is_some() {
        one(trouble, kind, Next::Same, pause);
    }
    expected
}

fn one(trouble: &Trouble, kind: Kind, next: Next, pause: Duration) {
    let before = threads();
    let since = Instant::now();
    let cell = Cell::new(trouble, kind, next, pause);
    let name = cell.to_string();
    let expected = Seen { first: cell.expected.first, beside: cell.expected.beside, next: cell.then };
    assert_eq!(cell.run(), expected, "{name}");
    drop(cell);
    assert!(since.elapsed() < LIMIT, "{name}: {:?}", since.elapsed());
    // The kernel may list a thread for a moment after it was joined.
    let since = Instant::now();
    while threads().is_some_and(|now| before.is_some_and(|before| now > before)) {
        assert!(since.elapsed() < LIMIT, "{name}: a thread is left");
        thread::yield_now();
    }
}

/// How many threads the process has, where the system lists them.
fn threads() -> Option<usize> {
    let threads = std::fs::read_dir("/proc/self/task").ok().map(Iterator::count);
    if threads.is_none() {
        jaka_tests::skipped("whether a thread is left", "this system has no /proc");
    }
    threads
}
