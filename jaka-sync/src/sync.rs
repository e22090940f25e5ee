//! Locks and condition variables of the monitor: those of std, or with `--cfg shuttle` those whose interleavings a test goes through.

#[cfg(not(all(test, shuttle)))]
pub(crate) use std::sync::{Condvar, Mutex, MutexGuard};

#[cfg(all(test, shuttle))]
pub(crate) use shuttle::sync::{Condvar, Mutex, MutexGuard};
