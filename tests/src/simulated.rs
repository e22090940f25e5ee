//! What tests with a simulated clock share.

mod set_points;

use std::thread;

use jaka_sim::{Controller, SimulatedClock};

pub use self::set_points::{SetPoints, SetPointsSeen};

/// The simulated clock of a controller.
///
/// # Panics
/// It has none.
pub fn clock_of(controller: &Controller) -> &SimulatedClock {
    controller.clock().expect("it was given one")
}

/// Does one thing in this thread, and another in a thread that takes part in the time from the same moment; returns when both are done.
///
/// # Panics
/// The other one does.
pub fn beside<T>(clock: &SimulatedClock, other: impl FnOnce() + Send, act: impl FnOnce() -> T) -> T {
    thread::scope(|scope| {
        let place = clock.participant();
        let other = scope.spawn(|| place.run(other));
        let done = act();
        clock.outside(|| other.join()).expect("it does not panic");
        done
    })
}
