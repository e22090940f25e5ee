//! Shared code of tests with a simulated clock.

mod command_wire;
mod forwarded;
mod set_points;
mod tagged_wire;

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Mutex;
use std::thread;
use std::time::Duration;

use jaka_sim::jaka_clock::{Clock, Signal, lock};
use jaka_sim::{Controller, SimulatedClock};

pub use self::command_wire::{CommandWire, TimedMessage};
pub use self::set_points::{SetPoints, SetPointsSeen};
pub use self::tagged_wire::{Exchanged, TaggedWire};
use crate::LONG;

/// The simulated clock of a controller.
///
/// # Panics
/// It has none.
pub fn clock_of(controller: &Controller) -> &SimulatedClock {
    controller.clock().expect("it was given one")
}

/// Does one thing in this thread, and another in a thread that takes part in the time from the same moment; returns
/// when both are done.
///
/// # Panics
/// One of them does, once the other is done.
pub fn beside<T>(clock: &SimulatedClock, other: impl FnOnce() + Send, act: impl FnOnce() -> T) -> T {
    let (is_done, ended) = (Mutex::new(false), Signal::new(&Clock::simulated(clock)));
    thread::scope(|scope| {
        let other = || {
            let _done = Done { is_done: &is_done, ended: &ended };
            other();
        };
        let other = scope.spawn(ended.clock().participating(other));
        // Time goes on for the other one also after a panic.
        let acted = catch_unwind(AssertUnwindSafe(act));
        drop(ended.wait_until(&is_done, Duration::MAX, |is_done| *is_done));
        let ended = other.join();
        let acted = acted.unwrap_or_else(|panic| resume_unwind(panic));
        ended.unwrap_or_else(|panic| resume_unwind(panic));
        acted
    })
}

/// Signals the end of a thread when it is dropped.
struct Done<'c> {
    is_done: &'c Mutex<bool>,
    ended: &'c Signal,
}

impl Drop for Done<'_> {
    fn drop(&mut self) {
        *lock(self.is_done) = true;
        self.ended.notify_all();
    }
}

/// Waits until something is so, and looks each millisecond of the time.
///
/// # Panics
/// It is not so after a minute of the time.
#[track_caller]
pub fn until(clock: &SimulatedClock, mut is_so: impl FnMut() -> bool) {
    let since = clock.elapsed();
    while !is_so() {
        assert!(clock.elapsed().saturating_sub(since) < LONG, "it is not so after {LONG:?}");
        clock.sleep(Duration::from_millis(1));
    }
}

/// Does several things, each in a thread that takes part in the time from the same moment; returns when all are done.
///
/// # Panics
/// One of them does.
pub fn side_by_side(clock: &SimulatedClock, acts: impl IntoIterator<Item = impl FnOnce() + Send>) {
    let acts: Vec<_> = acts.into_iter().map(|act| (clock.participant(), act)).collect();
    clock.outside(|| {
        thread::scope(|scope| {
            for (place, act) in acts {
                scope.spawn(|| place.run(act));
            }
        });
    });
}
