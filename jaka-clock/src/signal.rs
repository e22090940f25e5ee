//! Waits for a change of a state that threads share.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use crate::Clock;

/// Condition variable whose waits take the time of a clock.
#[derive(Debug, Default)]
pub struct Signal {
    condvar: Condvar,
    clock: Clock,
}

impl Signal {
    /// Signal for waits in the time of this clock.
    pub fn new(clock: &Clock) -> Self {
        Self { condvar: Condvar::new(), clock: clock.clone() }
    }

    /// Clock whose time the waits take.
    pub fn clock(&self) -> &Clock {
        &self.clock
    }

    /// Wakes all threads that wait.
    pub fn notify_all(&self) {
        #[cfg(feature = "simulated")]
        if let Some(clock) = self.clock.as_simulated() {
            return clock.notify_all(self.address());
        }
        self.condvar.notify_all();
    }

    /// Waits until it is notified, or for so long, or less. The guard is one of the mutex.
    pub fn wait<'m, T>(&self, mutex: &'m Mutex<T>, guard: MutexGuard<'m, T>, time: Duration) -> MutexGuard<'m, T> {
        #[cfg(feature = "simulated")]
        if let Some(clock) = self.clock.as_simulated() {
            return clock.wait_for(self.address(), mutex, guard, Some(time));
        }
        // The system's condition variable knows the mutex by its guard.
        let _ = mutex;
        self.condvar.wait_timeout(guard, time).unwrap_or_else(PoisonError::into_inner).0
    }

    /// Locks the mutex, and waits until this holds of the state or the time is over. A time that is too long for the
    /// clock is no limit.
    pub fn wait_until<'m, T>(
        &self,
        mutex: &'m Mutex<T>,
        time: Duration,
        mut holds: impl FnMut(&T) -> bool,
    ) -> MutexGuard<'m, T> {
        let since = self.clock.stopwatch();
        let mut guard = lock(mutex);
        while !holds(&guard) {
            let left = since.left_of(time);
            if left.is_zero() {
                break;
            }
            guard = self.wait(mutex, guard, left);
        }
        guard
    }

    #[cfg(feature = "simulated")]
    fn address(&self) -> usize {
        std::ptr::from_ref(self).addr()
    }
}

/// Locks a state of which every change is made whole before the lock is left: it can be used on after a panic of
/// another holder.
pub fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
