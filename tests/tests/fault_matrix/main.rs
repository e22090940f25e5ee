//! Every fault of the simulator with every kind of call: what the call ends with, and what the next ones do.
//!
//! Each cell has a simulated clock of its own: what happens in it depends neither on the machine nor on other cells,
//! and each timeout passes at its exact time.
//!
//! The default run has a fixed part of the cells: every fault and every kind of call in two at least. With
//! `JAKA_RELIABILITY` above 1 all cells are gone through, and then again with other parameters of the faults and random
//! pauses between calls, so often in all.
//!
//! One test, alone in its process, so that threads can be counted. `table.md` has the table that it makes.

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

use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError, mpsc};
use std::thread;
use std::time::{Duration, Instant};

use expect_test::expect_file;
use proptest::test_runner::{RngAlgorithm, TestRng};

use self::cell::{Cell, Kind, LIMIT, Next, Seen};
use self::troubles::Trouble;

/// Number of cells that are gone through at once.
const AT_ONCE: usize = 8;

/// Time in which one of the cells under way must end, on a machine however slow.
const STUCK: Duration = Duration::from_secs(300);

#[test]
fn each_fault_with_each_kind_of_call() {
    let before = threads();
    let troubles = troubles::all();
    let times = jaka_tests::reliability_times();
    let cells = if times > 1 { all_cells(&troubles) } else { some_cells(&troubles) };
    go_through(&cells, || Duration::ZERO);
    landings::go_through(&troubles);
    guarded::go_through(&troubles);
    let rows = troubles.iter().map(|trouble| Kind::ALL.map(|kind| model::expected(trouble, kind)));
    let table = table::table(&troubles, &rows.collect::<Vec<_>>());
    println!("{table}");
    expect_file![table::DOCUMENT].assert_eq(&table::in_document(&table));
    let mut random = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    for round in 1..times {
        println!("round {round}");
        let troubles: Vec<_> = troubles.iter().map(|trouble| trouble.at_random(&mut random)).collect();
        go_through(&all_cells(&troubles), || troubles::pause(&mut random));
    }
    // The kernel may list a thread for a moment after it was joined.
    let since = Instant::now();
    while threads().len() > before.len() {
        assert!(since.elapsed() < LIMIT, "threads are left: {:?}, and {before:?} before", threads());
        thread::yield_now();
    }
}

/// A cell: where it makes a difference, there is one with a next call of another name and one with one of the same
/// name.
type Task<'t> = (&'t Trouble, Kind, Next);

fn all_cells(troubles: &[Trouble]) -> Vec<Task<'_>> {
    troubles.iter().flat_map(|trouble| Kind::ALL.into_iter().flat_map(move |kind| cells(trouble, kind))).collect()
}

fn cells(trouble: &Trouble, kind: Kind) -> impl Iterator<Item = Task<'_>> {
    let has_same = model::expected(trouble, kind).same.is_some();
    [Some(Next::Other), has_same.then_some(Next::Same)].into_iter().flatten().map(move |next| (trouble, kind, next))
}

/// Two kinds of calls for each fault, other ones for the next fault: each kind meets a seventh of the faults, those of
/// replies, of packets and of links.
fn some_cells(troubles: &[Trouble]) -> Vec<Task<'_>> {
    const KINDS: usize = Kind::ALL.len();
    let of_row = |(row, trouble)| [5 * row % KINDS, (5 * row + 6) % KINDS].map(|kind| (trouble, Kind::ALL[kind]));
    let places: Vec<_> = troubles.iter().enumerate().flat_map(of_row).collect();
    for kind in Kind::ALL {
        let met = |is_of: fn(&Trouble) -> bool| {
            places.iter().filter(|(trouble, other)| *other == kind && is_of(trouble)).count()
        };
        let counts = [
            met(Trouble::is_of_replies),
            met(|it| matches!(it, Trouble::Status(_))),
            met(|it| matches!(it, Trouble::Link(_))),
        ];
        assert!(counts.iter().all(|count| *count > 0) && counts.iter().sum::<usize>() >= 2, "{kind:?}: {counts:?}");
    }
    places.into_iter().flat_map(|(trouble, kind)| cells(trouble, kind)).collect()
}

/// Goes through cells, and fails if one of them does.
fn go_through(cells: &[Task<'_>], mut pause: impl FnMut() -> Duration) {
    let tasks: Vec<_> = cells.iter().map(|cell| (*cell, pause())).collect();
    let name = |((trouble, kind, next), _): &(Task<'_>, Duration)| format!("{trouble}, {kind:?}, then {next:?}");
    each(&tasks, name, |((trouble, kind, next), pause)| {
        let cell = Cell::new(trouble, *kind, *next, *pause);
        let expected = Seen { first: cell.expected.first, stop: cell.expected.stop, next: cell.then };
        let seen = cell.run();
        assert_eq!(seen, expected, "{cell}");
    });
}

/// Runs each task, several at once, and fails with the names of those that panicked. If none ends for a long time, says
/// which are stuck and ends the process.
pub(crate) fn each<T: Sync>(tasks: &[T], name: impl Fn(&T) -> String + Sync, run: impl Fn(&T) + Sync) {
    let (place, failed, running) = (AtomicUsize::new(0), Mutex::new(Vec::new()), Mutex::new(BTreeSet::new()));
    let work = |ended: mpsc::Sender<()>| {
        while let Some(task) = tasks.get(place.fetch_add(1, Ordering::SeqCst)) {
            lock(&running).insert(name(task));
            if catch_unwind(AssertUnwindSafe(|| run(task))).is_err() {
                lock(&failed).push(name(task));
            }
            lock(&running).remove(&name(task));
            // Nobody watches any more where the test has failed.
            ended.send(()).ok();
        }
    };
    thread::scope(|scope| {
        let (ended, ends) = mpsc::channel();
        for _ in 0..AT_ONCE {
            let ended = ended.clone();
            let work = &work;
            scope.spawn(move || work(ended));
        }
        drop(ended);
        loop {
            match ends.recv_timeout(STUCK) {
                Ok(()) => {}
                Err(mpsc::RecvTimeoutError::Disconnected) => break,
                Err(mpsc::RecvTimeoutError::Timeout) => {
                    eprintln!("nothing ends for {STUCK:?}: {:#?}", lock(&running));
                    std::process::exit(1);
                }
            }
        }
    });
    let failed = failed.into_inner().unwrap_or_else(PoisonError::into_inner);
    assert!(failed.is_empty(), "{} of {}: {failed:#?}", failed.len(), tasks.len());
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
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
