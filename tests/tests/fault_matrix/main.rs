//! Every fault of the simulator with every kind of call: what the call ends with, and what the next ones do.
//!
//! Cells wait most of the time, so many are gone through at once. Where a machine is so busy that a deadline of a tenth of a second
//! passes before a call was sent, or a reply was read, a few cells are tried again, alone. Wrong data, a wrong `Reached` and a motion
//! after an error that denies it fail at once.
//!
//! With `JAKA_RELIABILITY`, the matrix runs this many times; after the first, the faults and the pauses between
//! calls are random.
//!
//! One test, alone in its process, so that threads can be counted. `docs/reliability.md` has the table that it makes.

mod calls;
mod cell;
mod guarded;
mod landings;
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

/// How many cells may be tried again, and how often each.
const TRIED_AGAIN: usize = 20;
const TRIES: usize = 3;

#[test]
fn each_fault_with_each_kind_of_call() {
    let before = threads();
    let troubles = troubles::all();
    go_through(&troubles, || Duration::ZERO);
    landings::go_through(&troubles);
    guarded::go_through(&troubles);
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
    let (place, late, failed) = (AtomicUsize::new(0), Mutex::new(Vec::new()), Mutex::new(Vec::new()));
    let work = || {
        while let Some(task) = tasks.get(place.fetch_add(1, Ordering::SeqCst)) {
            match one(*task) {
                Ok(()) => {}
                Err(Failure::Late(text)) => push(&late, (*task, text)),
                Err(Failure::Wrong(name)) => push(&failed, name),
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..AT_ONCE {
            scope.spawn(work);
        }
    });
    let late = late.into_inner().unwrap_or_else(PoisonError::into_inner);
    println!("tried again, alone: {:#?}", late.iter().map(|(_, text)| text).collect::<Vec<_>>());
    assert!(late.len() <= TRIED_AGAIN, "{} of {} cells are to be tried again", late.len(), tasks.len());
    for (task, text) in late {
        if (0..TRIES).all(|_| one(task).is_err()) {
            push(&failed, text);
        }
    }
    let failed = failed.into_inner().unwrap_or_else(PoisonError::into_inner);
    assert!(failed.is_empty(), "{} of {} cells: {failed:#?}", failed.len(), tasks.len());
}

fn push<T>(to: &Mutex<Vec<T>>, what: T) {
    to.lock().unwrap_or_else(PoisonError::into_inner).push(what);
}

/// How a cell failed.
enum Failure {
    /// It ended in another way than the model says, as it may where a deadline passes too early.
    Late(String),
    /// It has told by then what is wrong.
    Wrong(String),
}

/// The machine was too busy for a cell: what it is about did not happen. The payload of a panic.
pub(crate) struct TooBusy(pub(crate) String);

fn one((trouble, kind, next, pause): Task<'_>) -> Result<(), Failure> {
    let since = Instant::now();
    let cell = Cell::new(trouble, kind, next, pause);
    let name = cell.to_string();
    let expected = Seen { first: cell.expected.first, stop: cell.expected.stop, next: cell.then };
    let seen = match catch_unwind(AssertUnwindSafe(|| cell.run())) {
        Ok(seen) => seen,
        Err(payload) => match payload.downcast::<TooBusy>() {
            Ok(busy) => return Err(Failure::Late(format!("{name}: {}", busy.0))),
            Err(_) => return Err(Failure::Wrong(name)),
        },
    };
    if catch_unwind(AssertUnwindSafe(|| drop(cell))).is_err() || since.elapsed() >= LIMIT {
        return Err(Failure::Wrong(format!("{name}, in {:?}", since.elapsed())));
    }
    if seen == expected { Ok(()) } else { Err(Failure::Late(format!("{name}: {seen:?}"))) }
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
