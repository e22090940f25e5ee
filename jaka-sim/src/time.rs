//! The time in which threads and connections wait: the system's, or a simulated clock's. The controller's own time is made of it.

use std::io;
use std::sync::{Condvar, Mutex, MutexGuard};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use jaka_clock::{Participant, SimulatedClock};

use crate::lock;

/// What the time is, and how it passes.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Time(Option<SimulatedClock>);

impl Time {
    pub(crate) fn simulated(clock: &SimulatedClock) -> Self {
        Self(Some(clock.clone()))
    }

    /// The simulated clock, if it is one.
    pub(crate) fn as_simulated(&self) -> Option<&SimulatedClock> {
        self.0.as_ref()
    }

    pub(crate) fn now(&self) -> Instant {
        self.0.as_ref().map_or_else(Instant::now, SimulatedClock::now)
    }

    /// The time since then; none where that is yet to come.
    pub(crate) fn since(&self, then: Instant) -> Duration {
        self.now().saturating_duration_since(then)
    }

    /// The time until then; none where that has passed.
    pub(crate) fn until(&self, then: Instant) -> Duration {
        then.saturating_duration_since(self.now())
    }

    /// The place of a thread for whose waits time goes on.
    pub(crate) fn participant(&self) -> Place {
        Place(self.0.as_ref().map(SimulatedClock::participant))
    }

    /// Waits for what knows nothing of a simulated clock.
    pub(crate) fn outside<T>(&self, wait: impl FnOnce() -> T) -> T {
        match &self.0 {
            None => wait(),
            Some(clock) => clock.outside(wait),
        }
    }

    /// Starts a thread that serves others.
    pub(crate) fn spawn(&self, name: &str, act: impl FnOnce() + Send + 'static) -> io::Result<JoinHandle<()>> {
        let place = Place(self.0.as_ref().map(SimulatedClock::servant));
        thread::Builder::new().name(format!("jaka-sim {name}")).spawn(move || place.run(act))
    }
}

/// The place of a thread in a simulated time, if there is one.
#[derive(Debug)]
pub(crate) struct Place(Option<Participant>);

impl Place {
    /// What the thread does.
    pub(crate) fn run<T>(self, act: impl FnOnce() -> T) -> T {
        match self.0 {
            None => act(),
            Some(participant) => participant.run(act),
        }
    }
}

/// A condition variable whose waits take this time.
#[derive(Debug, Default)]
pub(crate) struct Signal {
    condvar: Condvar,
    time: Time,
}

impl Signal {
    pub(crate) fn new(time: &Time) -> Self {
        Self { condvar: Condvar::new(), time: time.clone() }
    }

    pub(crate) fn notify_all(&self) {
        match self.time.as_simulated() {
            None => self.condvar.notify_all(),
            Some(clock) => clock.notify_all(self.address()),
        }
    }

    /// Locks, and waits until `done` holds or the time is over; a timeout too long for the clock is no limit.
    pub(crate) fn wait<'m, T>(
        &self,
        mutex: &'m Mutex<T>,
        timeout: Duration,
        done: impl FnMut(&T) -> bool,
    ) -> MutexGuard<'m, T> {
        self.wait_on(mutex, lock::lock(mutex), timeout, done)
    }

    /// The same with the mutex locked.
    pub(crate) fn wait_on<'m, T>(
        &self,
        mutex: &'m Mutex<T>,
        mut guard: MutexGuard<'m, T>,
        timeout: Duration,
        mut done: impl FnMut(&T) -> bool,
    ) -> MutexGuard<'m, T> {
        let Some(clock) = self.time.as_simulated() else {
            return lock::wait(&self.condvar, guard, timeout, done);
        };
        let deadline = clock.now().checked_add(timeout);
        while !done(&guard) {
            let left = deadline.map(|deadline| self.time.until(deadline));
            if left == Some(Duration::ZERO) {
                break;
            }
            guard = clock.wait_for(self.address(), mutex, guard, left);
        }
        guard
    }

    fn address(&self) -> usize {
        std::ptr::from_ref(self).addr()
    }
}
