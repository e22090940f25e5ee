//! Waking up at absolute times.

use std::time::{Duration, Instant};

/// Length of a controller cycle (4.15).
pub(crate) const CYCLE: Duration = Duration::from_millis(8);

/// Periodic wake-ups: each time is counted from the start, so that lateness does not add up.
#[derive(Debug)]
pub(crate) struct Pace {
    start: Instant,
    period: Duration,
    cycles: u32,
    busy_wait: Duration,
}

impl Pace {
    /// The first cycle is now.
    pub(crate) fn new(period: Duration, busy_wait: Duration) -> Self {
        Self { start: Instant::now(), period, cycles: 0, busy_wait }
    }

    /// The time of the next cycle since the start.
    pub(crate) fn time(&self) -> Duration {
        self.period * self.cycles
    }

    /// Waits for the next cycle, and returns how late it is. Cycles that have been missed completely are skipped.
    pub(crate) fn wait(&mut self) -> Duration {
        let due = self.start + self.time();
        let asleep = due.saturating_duration_since(Instant::now()).saturating_sub(self.busy_wait);
        if !asleep.is_zero() {
            std::thread::sleep(asleep);
        }
        while Instant::now() < due {
            std::hint::spin_loop();
        }
        let late = due.elapsed();
        let missed = u32::try_from(late.as_nanos() / self.period.as_nanos()).unwrap_or(0);
        self.cycles = self.cycles.saturating_add(1 + missed);
        late
    }
}
