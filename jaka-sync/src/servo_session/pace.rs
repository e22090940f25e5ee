//! Waking up at absolute times.

use std::time::{Duration, Instant};

/// Length of a controller cycle (4.15).
pub(crate) const CYCLE: Duration = Duration::from_millis(8);

/// A beat: each time is counted from the start, so that lateness does not add up.
#[derive(Debug)]
pub(crate) struct Pace {
    start: Instant,
    period: Duration,
    beats: u32,
    busy_wait: Duration,
}

impl Pace {
    /// The first beat is now.
    pub(crate) fn new(period: Duration, busy_wait: Duration) -> Self {
        Self { start: Instant::now(), period, beats: 0, busy_wait }
    }

    /// The time of the next beat since the start.
    pub(crate) fn time(&self) -> Duration {
        self.period * self.beats
    }

    /// Waits for the next beat, and says by how much it was missed. Beats that have been missed altogether are passed over,
    /// so that the thread does not run after them.
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
        self.beats = self.beats.saturating_add(1 + missed);
        late
    }
}
