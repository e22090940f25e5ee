//! The times at which set-points are due.

use std::time::{Duration, Instant};

use crate::clock::Clock;

/// Length of a controller cycle (4.15).
pub(super) const CYCLE: Duration = Duration::from_millis(8);

/// Waits for one cycle after the other.
#[derive(Debug)]
pub(super) struct Pace {
    clock: Clock,
    period: Duration,
    busy_wait: Duration,
    /// When the next cycle is due.
    due: Instant,
    cycles: u32,
}

impl Pace {
    /// The first cycle is due at once.
    pub(super) fn new(clock: &Clock, period: Duration, busy_wait: Duration) -> Self {
        Self { clock: clock.clone(), period, busy_wait, due: clock.now(), cycles: 0 }
    }

    /// The time of the next cycle: that of the cycles before it. Where one was late, this is less than the clock says.
    pub(super) fn time(&self) -> Duration {
        self.period.saturating_mul(self.cycles)
    }

    /// How late the next cycle already is.
    pub(super) fn late(&self) -> Duration {
        self.clock.elapsed(self.due)
    }

    /// Waits for the next cycle, and returns how late it is. After one that is late by a period or more all later ones are delayed:
    /// none is skipped, and none comes sooner to catch up.
    pub(super) fn wait(&mut self) -> Duration {
        self.clock.sleep_until(self.due, self.busy_wait);
        let late = self.late();
        let delay = if late >= self.period { late } else { Duration::ZERO };
        self.due += self.period + delay;
        self.cycles = self.cycles.saturating_add(1);
        late
    }
}
