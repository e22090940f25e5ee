//! Time of the system, or of a simulated clock.

use std::time::{Duration, Instant};

#[cfg(feature = "simulated")]
use crate::SimulatedClock;

/// Source of the time, and of waits for it: the system by default, or a simulated clock.
///
/// Its clones have the same source.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Clock {
    #[cfg(feature = "simulated")]
    simulated: Option<SimulatedClock>,
}

impl Clock {
    /// Clock of a simulated time. Needs the feature `simulated`.
    #[cfg(feature = "simulated")]
    pub fn simulated(clock: &SimulatedClock) -> Self {
        Self { simulated: Some(clock.clone()) }
    }

    /// Simulated clock of which this has the time; `None` if that is the system's. Needs the feature `simulated`.
    #[cfg(feature = "simulated")]
    pub fn as_simulated(&self) -> Option<&SimulatedClock> {
        self.simulated.as_ref()
    }

    /// Present time.
    pub fn now(&self) -> Instant {
        #[cfg(feature = "simulated")]
        if let Some(clock) = &self.simulated {
            return clock.now();
        }
        Instant::now()
    }

    /// Time that has passed since then; zero if that is yet to come.
    pub fn elapsed(&self, since: Instant) -> Duration {
        self.now().saturating_duration_since(since)
    }

    /// Time that has passed since an instant of the system; of a simulated clock, since that clock was made.
    pub fn elapsed_since_start(&self, started: Instant) -> Duration {
        #[cfg(feature = "simulated")]
        if let Some(clock) = &self.simulated {
            return clock.elapsed();
        }
        started.elapsed()
    }

    /// Time until then; zero if that has passed.
    pub fn left(&self, until: Instant) -> Duration {
        until.saturating_duration_since(self.now())
    }

    /// Begins to measure a time.
    pub fn stopwatch(&self) -> Stopwatch {
        Stopwatch { began: self.now(), clock: self.clone() }
    }

    /// Sleeps for so long.
    pub fn sleep(&self, time: Duration) {
        #[cfg(feature = "simulated")]
        if let Some(clock) = &self.simulated {
            return clock.sleep(time);
        }
        std::thread::sleep(time);
    }

    /// Sleeps until then, and spins for the last part of that time, `busy_wait`, if the time is the system's.
    pub fn sleep_until(&self, due: Instant, busy_wait: Duration) {
        #[cfg(feature = "simulated")]
        if let Some(clock) = &self.simulated {
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

    /// Returns the work of a thread before its start: a simulated time stands still from now on until that thread
    /// waits, and advances for its waits.
    pub fn participating<T, F: FnOnce() -> T>(&self, work: F) -> impl FnOnce() -> T + use<T, F> {
        #[cfg(feature = "simulated")]
        let participant = self.simulated.as_ref().map(SimulatedClock::participant);
        move || {
            #[cfg(feature = "simulated")]
            if let Some(participant) = participant {
                return participant.run(work);
            }
            work()
        }
    }

    /// Returns the work of a thread that serves others, before its start: a simulated time stands still from now on
    /// until that thread waits, and does not advance for its waits alone.
    pub fn serving<T, F: FnOnce() -> T>(&self, work: F) -> impl FnOnce() -> T + use<T, F> {
        #[cfg(feature = "simulated")]
        let servant = self.simulated.as_ref().map(SimulatedClock::servant);
        move || {
            #[cfg(feature = "simulated")]
            if let Some(servant) = servant {
                return servant.run(work);
            }
            work()
        }
    }

    /// Waits by other means than this clock, such as a `join`: a simulated time may advance meanwhile.
    pub fn outside<T>(&self, wait: impl FnOnce() -> T) -> T {
        #[cfg(feature = "simulated")]
        if let Some(clock) = &self.simulated {
            return clock.outside(wait);
        }
        wait()
    }
}

/// Measure of the time since a moment.
#[derive(Debug, Clone)]
pub struct Stopwatch {
    clock: Clock,
    /// Moment at which it was started.
    pub began: Instant,
}

impl Stopwatch {
    /// Time that has passed.
    pub fn passed(&self) -> Duration {
        self.clock.elapsed(self.began)
    }

    /// Rest of a time that began at the start.
    pub fn left_of(&self, time: Duration) -> Duration {
        time.saturating_sub(self.passed())
    }
}
