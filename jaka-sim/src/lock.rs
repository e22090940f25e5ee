//! Locks that outlive a panic of their holder.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Locks. Only a caller's closure can panic under a lock, and a test that has failed there must still end cleanly.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Waits until `done` holds or the time is over; a timeout too long for the clock is no limit.
pub(crate) fn wait<'a, T>(
    condvar: &Condvar,
    guard: MutexGuard<'a, T>,
    timeout: Duration,
    mut done: impl FnMut(&T) -> bool,
) -> MutexGuard<'a, T> {
    let mut guard = guard;
    let deadline = Instant::now().checked_add(timeout);
    while !done(&guard) {
        let Some(deadline) = deadline else {
            guard = condvar.wait(guard).unwrap_or_else(PoisonError::into_inner);
            continue;
        };
        let left = deadline.saturating_duration_since(Instant::now());
        if left.is_zero() {
            break;
        }
        guard = condvar.wait_timeout(guard, left).unwrap_or_else(PoisonError::into_inner).0;
    }
    guard
}
