//! State that threads share, by the locks and signals of std; in tests with `--cfg shuttle` by those of shuttle.
//!
//! The tests of jaka-robot with `--cfg shuttle` include this file, too: shuttle would be in the lock files of all users
//! if it were a dependency of this library.

use std::sync::PoisonError;
use std::sync::TryLockError;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

#[cfg(not(all(test, shuttle)))]
pub(crate) use std::sync::{Mutex, MutexGuard};

#[cfg(all(test, shuttle))]
pub(crate) use shuttle::sync::{Mutex, MutexGuard};

use jaka_clock::Clock;
#[cfg(not(all(test, shuttle)))]
use jaka_clock::Signal;

#[cfg(all(test, shuttle))]
use self::shuttled::Signal;

/// State that threads share. They wait for its changes in the time of a clock.
#[derive(Debug)]
pub struct Watched<T> {
    state: Mutex<T>,
    changed: Signal,
    /// Number of threads that wait. It grows under the lock of the state.
    sleepers: AtomicUsize,
}

impl<T> Watched<T> {
    /// State whose waiters wait in the time of this clock.
    pub fn new(clock: &Clock, state: T) -> Self {
        Self { state: Mutex::new(state), changed: Signal::new(clock), sleepers: AtomicUsize::new(0) }
    }

    /// Locks the state. A panic of a thread that held the lock leaves the state valid: every change is complete.
    pub fn lock(&self) -> MutexGuard<'_, T> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Locks the state unless another thread has it locked.
    pub fn try_lock(&self) -> Option<MutexGuard<'_, T>> {
        match self.state.try_lock() {
            Ok(state) => Some(state),
            Err(TryLockError::Poisoned(poisoned)) => Some(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) => None,
        }
    }

    /// Clock by which threads wait.
    pub fn clock(&self) -> &Clock {
        self.changed.clock()
    }

    /// Waits for a change for at most `time`; may return earlier.
    pub fn wait<'w>(&'w self, state: MutexGuard<'w, T>, time: Duration) -> MutexGuard<'w, T> {
        self.sleepers.fetch_add(1, Ordering::Relaxed);
        let state = self.changed.wait(&self.state, state, time);
        self.sleepers.fetch_sub(1, Ordering::Relaxed);
        state
    }

    /// Number of threads that wait.
    #[cfg(test)]
    pub(crate) fn sleepers(&self) -> usize {
        self.sleepers.load(Ordering::Relaxed)
    }

    /// Waits until `find` finds something in the state; `None` after `time`.
    pub fn wait_for<R>(&self, time: Duration, mut find: impl FnMut(&mut T) -> Option<R>) -> Option<R> {
        let since = self.clock().stopwatch();
        let mut state = self.lock();
        loop {
            if let Some(found) = find(&mut state) {
                return Some(found);
            }
            let left = since.left_of(time);
            if left.is_zero() {
                return None;
            }
            state = self.wait(state, left);
        }
    }

    /// Wakes the threads that wait, after a change under the lock. Usually no thread waits, and the call makes no
    /// system call.
    pub fn wake(&self) {
        if self.sleepers.load(Ordering::Relaxed) > 0 {
            self.changed.notify_all();
        }
    }
}

#[cfg(all(test, shuttle))]
mod shuttled {
    use std::sync::PoisonError;
    use std::time::Duration;

    use shuttle::sync::{Condvar, Mutex, MutexGuard};

    use jaka_clock::Clock;

    /// Signal whose interleavings a test explores.
    #[derive(Debug)]
    pub(crate) struct Signal {
        condvar: Condvar,
        clock: Clock,
    }

    impl Signal {
        pub(crate) fn new(clock: &Clock) -> Self {
            Self { condvar: Condvar::new(), clock: clock.clone() }
        }

        pub(crate) fn clock(&self) -> &Clock {
            &self.clock
        }

        pub(crate) fn notify_all(&self) {
            self.condvar.notify_all();
        }

        pub(crate) fn wait<'m, T>(
            &self,
            _: &'m Mutex<T>,
            guard: MutexGuard<'m, T>,
            time: Duration,
        ) -> MutexGuard<'m, T> {
            self.condvar.wait_timeout(guard, time).unwrap_or_else(PoisonError::into_inner).0
        }
    }
}
