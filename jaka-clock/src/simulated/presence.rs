//! Participation of threads in the time of clocks.

use std::cell::RefCell;
use std::sync::Arc;

use super::parker::Parker;
use super::state::MovesTime;
use super::{SimulatedClock, Work};

thread_local! {
    static PRESENCE: Presence = Presence { parker: Arc::new(Parker::new()), clocks: RefCell::default() };
}

/// Parker of this thread, and the clocks in whose time it takes part.
struct Presence {
    parker: Arc<Parker>,
    clocks: RefCell<Vec<Membership>>,
}

/// Membership of a thread in the time of a clock, to the end of the thread or until this is dropped.
struct Membership {
    work: Work,
    moves_time: MovesTime,
}

/// Participation of a thread that will be started, from [`SimulatedClock::participant`]. Time stands still until it is
/// used or dropped.
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

    /// Makes this thread take part while it does this.
    pub fn run<T>(self, act: impl FnOnce() -> T) -> T {
        let Self { work, moves_time } = self;
        let clock = work.clock.clone();
        if membership(&clock).is_some() {
            drop(work);
            return act();
        }
        enter(work, moves_time);
        let _leaves = Leaves(clock);
        act()
    }
}

/// Ends the part of the thread when it is dropped.
struct Leaves(SimulatedClock);

impl Drop for Leaves {
    fn drop(&mut self) {
        leave(&self.0);
    }
}

/// Parker of this thread; another one at the end of the thread.
pub(super) fn parker() -> Arc<Parker> {
    PRESENCE.try_with(|presence| Arc::clone(&presence.parker)).unwrap_or_else(|_| Arc::new(Parker::new()))
}

/// Kind of this thread's part in the time of a clock; none if it takes no part.
pub(super) fn membership(clock: &SimulatedClock) -> Option<MovesTime> {
    let find = |presence: &Presence| {
        let clocks = presence.clocks.borrow();
        clocks.iter().find(|membership| membership.work.clock == *clock).map(|membership| membership.moves_time)
    };
    PRESENCE.try_with(find).ok().flatten()
}

/// Makes this thread take part, at work, from now on; not at the end of the thread.
pub(super) fn enter(work: Work, moves_time: MovesTime) {
    let membership = Membership { work, moves_time };
    // Where it is not kept, it is dropped, and ends the work.
    let _ = PRESENCE.try_with(|presence| presence.clocks.borrow_mut().push(membership));
}

/// Ends the part of this thread.
pub(super) fn leave(clock: &SimulatedClock) {
    let remove = |presence: &Presence| {
        let mut clocks = presence.clocks.borrow_mut();
        clocks.iter().position(|membership| membership.work.clock == *clock).map(|place| clocks.remove(place))
    };
    // Dropped here, without the list.
    drop(PRESENCE.try_with(remove));
}
