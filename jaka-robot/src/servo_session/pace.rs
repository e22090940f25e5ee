//! The times at which set-points are due.

use std::time::{Duration, Instant};

use jaka_clock::Clock;

/// Length of a controller cycle (4.15).
pub(super) const CYCLE: Duration = Duration::from_millis(8);

/// Cycle that has begun.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cycle {
    /// Time at which its set-point was due.
    pub(super) due: Instant,
    /// Lateness of its begin.
    pub(super) late: Duration,
}

/// Waits for one cycle after the other.
#[derive(Debug)]
pub(super) struct Pace {
    clock: Clock,
    period: Duration,
    busy_wait: Duration,
    /// Time at which the next cycle is due.
    due: Instant,
    cycles: u32,
}

impl Pace {
    /// The first cycle is due at once.
    pub(super) fn new(clock: &Clock, period: Duration, busy_wait: Duration) -> Self {
        Self { clock: clock.clone(), period, busy_wait, due: clock.now(), cycles: 0 }
    }

    /// The time of the next cycle, by the cycles before it. After a late one, this is less than the clock's time.
    pub(super) fn time(&self) -> Duration {
        self.period.saturating_mul(self.cycles)
    }

    /// Present lateness of the next cycle.
    pub(super) fn late(&self) -> Duration {
        self.clock.elapsed(self.due)
    }

    /// Waits for the next cycle. After one that is late by a period or more all later ones are delayed: none is
    /// skipped, and none comes sooner to catch up.
    pub(super) fn wait(&mut self) -> Cycle {
        self.clock.sleep_until(self.due, self.busy_wait);
        let cycle = Cycle { due: self.due, late: self.late() };
        let delay = if cycle.late >= self.period { cycle.late } else { Duration::ZERO };
        self.due += self.period + delay;
        self.cycles = self.cycles.saturating_add(1);
        cycle
    }

    /// Delays the next cycle after one whose set-point went out this late: by a period or more.
    pub(super) fn went_out(&mut self, cycle: Cycle, late: Duration) {
        if late >= self.period {
            self.due = self.due.max(cycle.due + late + self.period);
        }
    }
}
