//! Time: each time that is read, and each wait, goes through here.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// What the time is, and how it passes.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Clock(());

#[allow(clippy::unused_self, reason = "there is only the system's clock")]
impl Clock {
    /// What the time is.
    pub(crate) fn now(&self) -> Instant {
        Instant::now()
    }

    /// The time since then; none where that is yet to come.
    pub(crate) fn elapsed(&self, since: Instant) -> Duration {
        self.now().saturating_duration_since(since)
    }

    /// The time until then; none where that has passed.
    pub(crate) fn left(&self, until: Instant) -> Duration {
        until.saturating_duration_since(self.now())
    }

    /// Begins to measure a time.
    pub(crate) fn stopwatch(&self) -> Stopwatch {
        Stopwatch { began: self.now(), clock: self.clone() }
    }

    /// Sleeps.
    pub(crate) fn sleep(&self, time: Duration) {
        std::thread::sleep(time);
    }

    /// Sleeps until then, and spins for the last of it where asked for.
    pub(crate) fn sleep_until(&self, due: Instant, busy_wait: Duration) {
        let asleep = self.left(due).saturating_sub(busy_wait);
        if !asleep.is_zero() {
            self.sleep(asleep);
        }
        while self.now() < due {
            std::hint::spin_loop();
        }
    }
}

/// The time since a moment.
#[derive(Debug, Clone)]
pub(crate) struct Stopwatch {
    clock: Clock,
    began: Instant,
}

impl Stopwatch {
    /// The moment.
    pub(crate) fn began(&self) -> Instant {
        self.began
    }

    /// The time since.
    pub(crate) fn passed(&self) -> Duration {
        self.clock.elapsed(self.began)
    }

    /// What is left of a time that began at the moment.
    pub(crate) fn left_of(&self, time: Duration) -> Duration {
        time.saturating_sub(self.passed())
    }
}

/// A condition variable whose waits take the time of a clock.
#[derive(Debug)]
pub(crate) struct Signal {
    condvar: Condvar,
}

impl Signal {
    pub(crate) fn new(_clock: &Clock) -> Self {
        Self { condvar: Condvar::new() }
    }

    pub(crate) fn notify_all(&self) {
        self.condvar.notify_all();
    }

    /// Waits until it is signalled, or so long, or less. The guard is one of the mutex.
    pub(crate) fn wait<'m, T>(
        &self,
        _mutex: &'m Mutex<T>,
        guard: MutexGuard<'m, T>,
        time: Duration,
    ) -> MutexGuard<'m, T> {
        self.condvar.wait_timeout(guard, time).unwrap_or_else(PoisonError::into_inner).0
    }
}
