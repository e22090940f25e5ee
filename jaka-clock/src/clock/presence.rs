//! The clocks in whose time a thread takes part.

use std::cell::RefCell;
use std::sync::Arc;

use super::{SimulatedClock, Work};
use crate::seat::Seat;
use crate::state::MovesTime;

thread_local! {
    static PRESENCE: Presence = Presence { seat: Arc::new(Seat::new()), clocks: RefCell::default() };
}

/// This thread's seat, and the clocks in whose time it takes part.
struct Presence {
    seat: Arc<Seat>,
    clocks: RefCell<Vec<Membership>>,
}

/// That a thread takes part in the time of a clock, to its end or until this is dropped.
struct Membership {
    work: Work,
    moves_time: MovesTime,
}

/// This thread's seat; another one where the thread ends.
pub(super) fn seat() -> Arc<Seat> {
    PRESENCE.try_with(|presence| Arc::clone(&presence.seat)).unwrap_or_else(|_| Arc::new(Seat::new()))
}

/// How this thread takes part in the time of a clock, if it does.
pub(super) fn membership(clock: &SimulatedClock) -> Option<MovesTime> {
    let find = |presence: &Presence| {
        let clocks = presence.clocks.borrow();
        clocks.iter().find(|membership| membership.work.clock == *clock).map(|membership| membership.moves_time)
    };
    PRESENCE.try_with(find).ok().flatten()
}

/// From now on this thread takes part, and is at work; not where it is at its end.
pub(super) fn enter(work: Work, moves_time: MovesTime) {
    let membership = Membership { work, moves_time };
    // Where it is not kept, it is dropped, and ends the work.
    let _ = PRESENCE.try_with(|presence| presence.clocks.borrow_mut().push(membership));
}

/// This thread takes part no longer.
pub(super) fn leave(clock: &SimulatedClock) {
    let remove = |presence: &Presence| {
        let mut clocks = presence.clocks.borrow_mut();
        clocks.iter().position(|membership| membership.work.clock == *clock).map(|place| clocks.remove(place))
    };
    // Dropped here, without the list.
    drop(PRESENCE.try_with(remove));
}
