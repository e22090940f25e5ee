//! Every fault of the simulator with every kind of call: what the call ends with, and what the next ones do.
//!
//! Cells wait most of the time, so many are gone through at once.
//!
//! With `JAKA_RELIABILITY`, the matrix is gone through so many times; after the first, the faults and the pauses between
//! calls are random.
//!
//! One test, alone in its process, so that threads can be counted. `docs/reliability.md` has the table that it makes.

mod calls;
mod cell;
mod link;
mod model;
mod motion;
mod outcome;
mod robot;
mod servo;
mod status;
mod table;
mod troubles;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use expect_test::expect_file;
use proptest::test_runner::{RngAlgorithm, TestRng};

use self::cell::{Cell, Kind, LIMIT, Next, Seen};
use self::troubles::Trouble;

/// How many cells are gone through at once.
const AT_ONCE: usize = 48;

#[test]
fn each_fault_with_each_kind_of_call() {
    let before = threads();
    let troubles = troubles::all();
    go_through(&troubles, || Duration::ZERO);
    let cells = troubles.iter().map(|trouble| Kind::ALL.map(|kind| model::expected(trouble, kind)));
    let table = table::table(&troubles, &cells.collect::<Vec<_>>());
    println!("{table}");
    expect_file!["../../../docs/reliability.md"].assert_eq(&table::in_document(&table));
    let mut random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    for round in 1..jaka_tests::reliability_times() {
        println!("round {round}");
        let troubles: Vec<_> = troubles.iter().map(|trouble| trouble.at_random(&mut random)).collect();
        go_through(&troubles, || troubles::pause(&mut random));
    }
    // The kernel may list a thread for a moment after it was joined.
    let since = Instant::now();
    while threads().len() > before.len() {
        assert!(since.elapsed() < LIMIT, "threads are left: {:?}, and {before:?} before", threads());
        thread::yield_now();
    }
}

/// A cell to come: where it makes a difference, there is one with a next call of another name and one with one of the same name.
type Task<'t> = (&'t Trouble, Kind, Next, Duration);

/// Goes through all cells, and fails if one of them does.
fn go_through(troubles: &[Trouble], mut pause: impl FnMut() -> Duration) {
    let mut tasks: Vec<Task<'_>> = Vec::new();
    for trouble in troubles {
        for kind in Kind::ALL {
            let has_same = model::expected(trouble, kind).same.is_some();
            let nexts = [Some(Next::Other), has_same.then_some(Next::Same)];
            tasks.extend(nexts.into_iter().flatten().map(|next| (trouble, kind, next, pause())));
        }
    }
    let (place, failed) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let work = || {
        while let Some(task) = tasks.get(place.fetch_add(1, Ordering::SeqCst)) {
            // Has told by then what is wrong.
            if catch_unwind(AssertUnwindSafe(|| one(*task))).is_err() {
                let (trouble, kind, next, _) = task;
                failed
                    .lock()
                    .unwrap_or_else(PoisonError::into_inner)
                    .push(format!("{trouble}, {kind:?}, then {next:?}"));
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..AT_ONCE {
            scope.spawn(work);
        }
    });
    let failed = failed.into_inner().unwrap_or_else(PoisonError::into_inner);
    assert!(failed.is_empty(), "{} of {} cells: {failed:#?}", failed.len(), tasks.len());
}

fn one((trouble, kind, next, pause): Task<'_>) {
    let since = Instant::now();
    let cell = Cell::new(trouble, kind, next, pause);
    let name = cell.to_string();
    let expected = Seen { first: cell.expected.first, beside: cell.expected.beside, next: cell.then };
    assert_eq!(cell.run(), expected, "{name}");
    drop(cell);
    assert!(since.elapsed() < LIMIT, "{name}: {:?}", since.elapsed());
}

/// The names of the threads that the process has, where the system lists them.
fn threads() -> Vec<String> {
    let name = |entry: std::fs::DirEntry| std::fs::read_to_string(entry.path().join("comm")).unwrap_or_default();
    let Ok(threads) = std::fs::read_dir("/proc/self/task") else {
        jaka_tests::skipped("whether a thread is left", "this system has no /proc");
        return Vec::new();
    };
    threads.flatten().map(name).collect()
}
