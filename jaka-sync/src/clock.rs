//! Time: each time that is read, and each wait, goes through here.

#[cfg(not(feature = "simulated-clock"))]
mod absent;

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

#[cfg(feature = "simulated-clock")]
use jaka_clock::{Channel, Participant, SimulatedClock};

#[cfg(not(feature = "simulated-clock"))]
use self::absent::{Channel, Participant, SimulatedClock};

/// What the time is, and how it passes: as the system says, or a simulated clock.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Clock(Option<SimulatedClock>);

impl Clock {
    /// A simulated one.
    #[cfg(feature = "simulated-clock")]
    pub(crate) fn simulated(clock: &SimulatedClock) -> Self {
        Self(Some(clock.clone()))
    }

    /// The simulated one, if it is.
    pub(crate) fn as_simulated(&self) -> Option<&SimulatedClock> {
        self.0.as_ref()
    }

    /// What the time is.
    pub fn now(&self) -> Instant {
        self.0.as_ref().map_or_else(Instant::now, SimulatedClock::now)
    }

    /// The time since then; none where that is yet to come.
    pub fn elapsed(&self, since: Instant) -> Duration {
        self.now().saturating_duration_since(since)
    }

    /// Time since an instant of the system; by a simulated clock, since that clock was made.
    pub(crate) fn elapsed_since_start(&self, started: Instant) -> Duration {
        self.0.as_ref().map_or_else(|| started.elapsed(), SimulatedClock::elapsed)
    }

    /// The time until then; none where that has passed.
    pub fn left(&self, until: Instant) -> Duration {
        until.saturating_duration_since(self.now())
    }

    /// Begins to measure a time.
    pub fn stopwatch(&self) -> Stopwatch {
        Stopwatch { began: self.now(), clock: self.clone() }
    }

    /// Sleeps.
    pub fn sleep(&self, time: Duration) {
        match &self.0 {
            None => std::thread::sleep(time),
            Some(clock) => clock.sleep(time),
        }
    }

    /// Sleeps until then, and spins for the last of it where asked for.
    pub fn sleep_until(&self, due: Instant, busy_wait: Duration) {
        if let Some(clock) = &self.0 {
            return clock.sleep_until(due);
        }
        let asleep = self.left(due).saturating_sub(busy_wait);
        if !asleep.is_zero() {
            std::thread::sleep(asleep);
        }
        while self.now() < due {
            std::hint::spin_loop();
        }
    }

    /// The place of a thread that will be started, and for whose waits time goes on.
    pub fn participant(&self) -> Place {
        Place(self.0.as_ref().map(SimulatedClock::participant))
    }

    /// The place of a thread that will be started, and serves others.
    pub(crate) fn servant(&self) -> Place {
        Place(self.0.as_ref().map(SimulatedClock::servant))
    }

    /// Waits for a thread, or for what it sends, which knows nothing of the clock.
    pub fn outside<T>(&self, wait: impl FnOnce() -> T) -> T {
        match &self.0 {
            None => wait(),
            Some(clock) => clock.outside(wait),
        }
    }
}

/// The time since a moment.
#[derive(Debug, Clone)]
pub struct Stopwatch {
    clock: Clock,
    /// The moment.
    pub began: Instant,
}

impl Stopwatch {
    /// The time since.
    pub fn passed(&self) -> Duration {
        self.clock.elapsed(self.began)
    }

    /// What is left of a time that began at the moment.
    pub fn left_of(&self, time: Duration) -> Duration {
        time.saturating_sub(self.passed())
    }
}

/// The place of a thread in the time of a clock.
#[derive(Debug)]
pub struct Place(Option<Participant>);

impl Place {
    /// What the thread does.
    pub fn run<T>(self, act: impl FnOnce() -> T) -> T {
        match self.0 {
            None => act(),
            Some(participant) => participant.run(act),
        }
    }
}

/// What a connection says to a simulated clock.
pub(crate) type End = Option<Channel>;

/// A condition variable whose waits take the time of a clock.
#[derive(Debug)]
pub(crate) struct Signal {
    condvar: Condvar,
    pub(crate) clock: Clock,
}

impl Signal {
    pub(crate) fn new(clock: &Clock) -> Self {
        Self { condvar: Condvar::new(), clock: clock.clone() }
    }

    pub(crate) fn notify_all(&self) {
        match &self.clock.0 {
            None => self.condvar.notify_all(),
            Some(clock) => clock.notify_all(self.address()),
        }
    }

    /// Waits until it is signalled, or so long, or less. The guard is one of the mutex.
    pub(crate) fn wait<'m, T>(
        &self,
        mutex: &'m Mutex<T>,
        guard: MutexGuard<'m, T>,
        time: Duration,
    ) -> MutexGuard<'m, T> {
        match &self.clock.0 {
            None => self.condvar.wait_timeout(guard, time).unwrap_or_else(PoisonError::into_inner).0,
            Some(clock) => clock.wait_for(self.address(), mutex, guard, Some(time)),
        }
    }

    fn address(&self) -> usize {
        std::ptr::from_ref(self).addr()
    }
}
