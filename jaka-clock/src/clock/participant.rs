//! Places for threads that will take part.

use super::{SimulatedClock, Work, presence};
use crate::state::MovesTime;

/// A place in the time of a clock for a thread that will be started, from [`SimulatedClock::participant`]. Time stands still until it is used or dropped.
#[derive(Debug)]
#[must_use = "dropped, nobody takes part by it"]
pub struct Participant {
    work: Work,
    moves_time: MovesTime,
}

impl Participant {
    pub(super) fn new(clock: &SimulatedClock, moves_time: MovesTime) -> Self {
        Self { work: clock.work(), moves_time }
    }

    /// Has this thread take part while it does this.
    pub fn run<T>(self, act: impl FnOnce() -> T) -> T {
        let Self { work, moves_time } = self;
        let clock = work.clock.clone();
        if presence::membership(&clock).is_some() {
            drop(work);
            return act();
        }
        presence::enter(work, moves_time);
        let _leaves = Leaves(clock);
        act()
    }
}

/// The thread takes part no longer when this is dropped.
struct Leaves(SimulatedClock);

impl Drop for Leaves {
    fn drop(&mut self) {
        presence::leave(&self.0);
    }
}
