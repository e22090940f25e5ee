//! Orders for a thread, which waits for them in the time of an arm.

use std::sync::{Arc, Mutex};
use std::time::Duration;

use jaka_sim::jaka_clock::{Clock, Signal, lock};

/// Count of orders for a thread, which waits for them in the time of an arm.
#[derive(Debug, Clone)]
pub(super) struct Orders(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    state: Mutex<State>,
    changed: Signal,
}

#[derive(Debug, Default)]
struct State {
    pending: u32,
    are_closed: bool,
}

impl Orders {
    pub(super) fn new(clock: &Clock) -> Self {
        Self(Arc::new(Shared { state: Mutex::default(), changed: Signal::new(clock) }))
    }

    /// Adds an order.
    pub(super) fn add(&self) {
        self.change(|state| state.pending += 1);
    }

    /// Ends the orders.
    pub(super) fn close(&self) {
        self.change(|state| state.are_closed = true);
    }

    fn change(&self, act: impl FnOnce(&mut State)) {
        act(&mut lock(&self.0.state));
        self.0.changed.notify_all();
    }

    /// Waits for the next order and takes it; false once there will be none.
    pub(super) fn take(&self) -> bool {
        let is_ready = |state: &State| state.pending > 0 || state.are_closed;
        let mut state = self.0.changed.wait_until(&self.0.state, Duration::MAX, is_ready);
        let is_order = state.pending > 0;
        state.pending = state.pending.saturating_sub(1);
        is_order
    }
}
