//! Locks and signals of the monitor: those of std, or with `--cfg shuttle` those whose interleavings a test goes through.

#[cfg(not(all(test, shuttle)))]
pub(crate) use std::sync::{Mutex, MutexGuard};

#[cfg(all(test, shuttle))]
pub(crate) use shuttle::sync::{Mutex, MutexGuard};

#[cfg(not(all(test, shuttle)))]
pub(crate) use crate::clock::Signal;

#[cfg(all(test, shuttle))]
pub(crate) use self::shuttled::Signal;

#[cfg(all(test, shuttle))]
mod shuttled {
    use std::sync::PoisonError;
    use std::time::Duration;

    use shuttle::sync::{Condvar, Mutex, MutexGuard};

    use crate::clock::Clock;

    /// A signal whose interleavings a test goes through.
    #[derive(Debug)]
    pub(crate) struct Signal(Condvar);

    impl Signal {
        pub(crate) fn new(_clock: &Clock) -> Self {
            Self(Condvar::new())
        }

        pub(crate) fn notify_all(&self) {
            self.0.notify_all();
        }

        pub(crate) fn wait<'m, T>(
            &self,
            _: &'m Mutex<T>,
            guard: MutexGuard<'m, T>,
            time: Duration,
        ) -> MutexGuard<'m, T> {
            self.0.wait_timeout(guard, time).unwrap_or_else(PoisonError::into_inner).0
        }
    }
}
