//! How late the cycles of a session begin on this machine.

use std::time::Duration;

use jaka_clock::Clock;

use super::ServoConfig;
use super::enter::check_step_count;
use super::pace::Pace;
use crate::Error;

impl ServoConfig {
    /// Waits for cycles as a [`ServoSession`](super::ServoSession) does, for as long as this, and returns how late each
    /// of them began. Sends nothing: it is about this machine alone.
    ///
    /// At least one cycle, in the calling thread, with the period, the [`busy_wait`](Self::busy_wait) and the real-time
    /// priority of this configuration. `jaka jitter` prints it.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption), and `ErrorKind::RealtimePriority` if the system
    /// does not allow the priority.
    pub fn measure_lateness(&self, time: Duration) -> Result<Vec<Duration>, Error> {
        check_step_count(self)?;
        let _priority = self.take_priority()?;
        let clock = Clock::default();
        let mut pace = Pace::new(&clock, self.period(), self.busy_wait);
        // The first one is due at once.
        pace.wait();
        let (since, mut lateness) = (clock.stopwatch(), Vec::new());
        loop {
            lateness.push(pace.wait().late);
            if since.passed() >= time {
                return Ok(lateness);
            }
        }
    }
}
