//! What happens at its time.

use std::io;
use std::time::Duration;

use super::World;
use crate::InputScript;
use crate::fault::Happening;

/// What is to happen, in order.
#[derive(Debug, Default)]
pub(super) struct Schedule(Vec<(Duration, Happening)>);

impl Schedule {
    /// When the next of it is due.
    pub(super) fn next_due(&self) -> Option<Duration> {
        self.0.first().map(|(at, _)| *at)
    }

    fn add(&mut self, happenings: impl IntoIterator<Item = (Duration, Happening)>) {
        self.0.extend(happenings);
        // What is for the same time stays in its order.
        self.0.sort_by_key(|(at, _)| *at);
    }
}

impl World {
    /// Has inputs change from now on.
    pub(crate) fn schedule_inputs(&mut self, script: &InputScript) -> io::Result<()> {
        let at = |after: &Duration| self.now.saturating_add(*after);
        self.schedule(script.0.iter().map(|(after, change)| (at(after), Happening::Input(*change))).collect())
    }

    /// Has something happen at these times of the controller, or at once where they have passed.
    pub(crate) fn schedule(&mut self, happenings: Vec<(Duration, Happening)>) -> io::Result<()> {
        happenings.iter().try_for_each(|(_, happening)| happening.check(&self.state))?;
        self.schedule.add(happenings);
        self.run_schedule();
        Ok(())
    }

    /// Has happen what is due.
    pub(super) fn run_schedule(&mut self) {
        let due = self.schedule.0.partition_point(|(at, _)| *at <= self.now);
        if due == 0 {
            return;
        }
        self.schedule.0.drain(..due).for_each(|(_, happening)| happening.make(&mut self.state));
        self.make_consistent();
    }
}
