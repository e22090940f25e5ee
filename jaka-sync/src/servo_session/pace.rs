//! The times at which set-points are due.

use std::time::{Duration, Instant};

/// Length of a controller cycle (4.15).
pub(super) const CYCLE: Duration = Duration::from_millis(8);

/// Waits for one cycle after the other.
#[derive(Debug)]
pub(super) struct Pace {
    period: Duration,
    busy_wait: Duration,
    /// When the next cycle is due.
    due: Instant,
    cycles: u32,
}

impl Pace {
    /// The first cycle is due at once.
    pub(super) fn new(period: Duration, busy_wait: Duration) -> Self {
        Self { period, busy_wait, due: Instant::now(), cycles: 0 }
    }

    /// The time of the next cycle: that of the cycles before it. Where one was late, this is less than the clock says.
    pub(super) fn time(&self) -> Duration {
        self.period.saturating_mul(self.cycles)
    }

    /// How late the next cycle already is.
    pub(super) fn late(&self) -> Duration {
        self.due.elapsed()
    }

    /// Waits for the next cycle, and returns how late it is. After one that is late by a period or more all later ones are delayed:
    /// none is skipped, and none comes sooner to catch up.
    pub(super) fn wait(&mut self) -> Duration {
        let asleep = self.due.saturating_duration_since(Instant::now()).saturating_sub(self.busy_wait);
        if !asleep.is_zero() {
            std::thread::sleep(asleep);
        }
        while Instant::now() < self.due {
            std::hint::spin_loop();
        }
        let late = self.due.elapsed();
        let delay = if late >= self.period { late } else { Duration::ZERO };
        self.due += self.period + delay;
        self.cycles = self.cycles.saturating_add(1);
        late
    }
}
