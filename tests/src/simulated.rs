//! What tests with a simulated clock share.

mod command_wire;
mod forwarded;
mod set_points;

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use jaka_sim::{Controller, SimulatedClock};

pub use self::command_wire::{CommandWire, TimedMessage};
pub use self::set_points::{SetPoints, SetPointsSeen};
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
    let is_done = Mutex::new(false);
    thread::scope(|scope| {
        let place = clock.participant();
        let other = || {
            let _done = Done { clock, is_done: &is_done };
            other();
        };
        let other = scope.spawn(|| place.run(other));
        // Time goes on for the other one also after a panic.
        let acted = catch_unwind(AssertUnwindSafe(act));
        let mut is_other_done = lock(&is_done);
        while !*is_other_done {
            is_other_done = clock.wait_for(address(&is_done), &is_done, is_other_done, None);
        }
        drop(is_other_done);
        let ended = other.join();
        let acted = acted.unwrap_or_else(|panic| resume_unwind(panic));
        ended.unwrap_or_else(|panic| resume_unwind(panic));
        acted
    })
}

/// Says, when it is dropped, that a thread is done.
struct Done<'c> {
    clock: &'c SimulatedClock,
    is_done: &'c Mutex<bool>,
}

impl Drop for Done<'_> {
    fn drop(&mut self) {
        *lock(self.is_done) = true;
        self.clock.notify_all(address(self.is_done));
    }
}

fn lock(is_done: &Mutex<bool>) -> MutexGuard<'_, bool> {
    is_done.lock().unwrap_or_else(PoisonError::into_inner)
}

fn address(is_done: &Mutex<bool>) -> usize {
    std::ptr::from_ref(is_done).addr()
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
