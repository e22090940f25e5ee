//! The time of an arm: real, or that of a simulated clock.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jaka_sim::SimulatedClock;
use jaka_sync::Config;

/// The time in which the threads of an arm wait: that of a simulated clock, or real time without one.
#[derive(Debug, Clone)]
pub(super) struct Time(pub(super) Option<SimulatedClock>);

impl Time {
    /// Has clients take this time.
    pub(super) fn configure(&self, config: Config) -> Config {
        self.0.iter().fold(config, Config::clock)
    }

    /// Starts a thread that takes part in this time from now on.
    pub(super) fn start<T: Send + 'static>(&self, act: impl FnOnce() -> T + Send + 'static) -> JoinHandle<T> {
        let place = self.0.as_ref().map(SimulatedClock::participant);
        thread::spawn(move || match place {
            Some(place) => place.run(act),
            None => act(),
        })
    }

    /// Waits for something other than this time: it may go on meanwhile.
    pub(super) fn outside<T>(&self, act: impl FnOnce() -> T) -> T {
        match &self.0 {
            Some(clock) => clock.outside(act),
            None => act(),
        }
    }

    pub(super) fn sleep(&self, time: Duration) {
        match &self.0 {
            Some(clock) => clock.sleep(time),
            None => thread::sleep(time),
        }
    }
}

/// A count of orders for a thread, which waits for them in an arm's time.
#[derive(Debug, Clone)]
pub(super) struct Orders {
    time: Time,
    shared: Arc<(Mutex<State>, Condvar)>,
}

#[derive(Debug, Default)]
struct State {
    pending: u32,
    are_closed: bool,
}

impl Orders {
    pub(super) fn new(time: &Time) -> Self {
        Self { time: time.clone(), shared: Arc::default() }
    }

    /// Adds an order.
    pub(super) fn add(&self) {
        self.change(|state| state.pending += 1);
    }

    /// No more orders will come.
    pub(super) fn close(&self) {
        self.change(|state| state.are_closed = true);
    }

    fn change(&self, act: impl FnOnce(&mut State)) {
        let (state, changed) = &*self.shared;
        act(&mut state.lock().unwrap_or_else(PoisonError::into_inner));
        match &self.time.0 {
            Some(clock) => clock.notify_all(self.signal()),
            None => changed.notify_all(),
        }
    }

    /// Waits for the next order and takes it; false once there will be none.
    pub(super) fn take(&self) -> bool {
        let (mutex, changed) = &*self.shared;
        let mut state: MutexGuard<'_, State> = mutex.lock().unwrap_or_else(PoisonError::into_inner);
        while state.pending == 0 {
            if state.are_closed {
                return false;
            }
            state = match &self.time.0 {
                Some(clock) => clock.wait_for(self.signal(), mutex, state, None),
                None => changed.wait(state).unwrap_or_else(PoisonError::into_inner),
            };
        }
        state.pending -= 1;
        true
    }

    fn signal(&self) -> usize {
        Arc::as_ptr(&self.shared) as usize
    }
}
