//! List of what happens at a time or on a condition.

use std::io;
use std::time::Duration;

use super::World;
use crate::happening::{Happening, Scheduled};
use crate::trigger::Condition;

/// Happenings in the order of their times, and conditions that do not hold yet.
#[derive(Debug, Default)]
pub(super) struct Schedule {
    happenings: Vec<Scheduled>,
    conditions: Vec<Condition>,
}

impl World {
    /// Has something happen at once.
    pub(crate) fn happen(&mut self, happening: &Happening) {
        happening.happen(&mut self.state, &self.links);
        self.make_consistent();
    }

    /// Has something happen at its time, or at once where that has passed.
    pub(crate) fn schedule(&mut self, scheduled: Scheduled) -> io::Result<()> {
        scheduled.happening.check(&self.state)?;
        self.schedule.happenings.push(scheduled);
        // What is for the same time stays in its order.
        self.schedule.happenings.sort_by_key(|scheduled| scheduled.at);
        self.run_schedule();
        Ok(())
    }

    /// Time of what happens next.
    pub(crate) fn next_due(&self) -> Option<Duration> {
        self.schedule.happenings.first().map(|scheduled| scheduled.at)
    }

    /// Has happen what is due.
    pub(super) fn run_schedule(&mut self) {
        let due = self.schedule.happenings.partition_point(|scheduled| scheduled.at <= self.now);
        if due == 0 {
            return;
        }
        for Scheduled { happening, .. } in self.schedule.happenings.drain(..due) {
            happening.happen(&mut self.state, &self.links);
        }
        self.make_consistent();
    }

    /// Waits for a condition, which may hold already.
    pub(crate) fn watch(&mut self, condition: Condition) {
        self.schedule.conditions.push(condition);
        self.ask_conditions();
    }

    /// Number of conditions that do not hold yet.
    pub(super) fn conditions(&self) -> usize {
        self.schedule.conditions.len()
    }

    pub(super) fn ask_conditions(&mut self) {
        self.schedule.conditions.retain_mut(|condition| !condition.is_settled(&self.state, self.now));
    }
}
