//! Schedule of events and conditions.

use std::io;
use std::time::Duration;

use super::World;
use crate::happening::{Happening, Scheduled};
use crate::trigger::Condition;

/// Events in the order of their times, and conditions that do not hold yet.
#[derive(Debug, Default)]
pub(super) struct Schedule {
    happenings: Vec<Scheduled>,
    conditions: Vec<Condition>,
}

impl World {
    /// Applies an event at once.
    pub(crate) fn happen(&mut self, happening: &Happening) {
        happening.happen(&mut self.state, &self.links);
        self.make_consistent();
    }

    /// Schedules an event for its time; at once if that has passed.
    pub(crate) fn schedule(&mut self, scheduled: Scheduled) -> io::Result<()> {
        scheduled.happening.check(&self.state)?;
        self.schedule.happenings.push(scheduled);
        // The sort is stable: events of the same time keep their order.
        self.schedule.happenings.sort_by_key(|scheduled| scheduled.at);
        self.run_schedule();
        Ok(())
    }

    /// Returns the time of the next event.
    pub(crate) fn next_due(&self) -> Option<Duration> {
        self.schedule.happenings.first().map(|scheduled| scheduled.at)
    }

    /// Applies the events that are due.
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

    /// Adds a condition, which may hold already.
    pub(crate) fn watch(&mut self, condition: Condition) {
        self.schedule.conditions.push(condition);
        self.ask_conditions();
    }

    /// Returns the number of conditions that do not hold yet.
    pub(super) fn conditions(&self) -> usize {
        self.schedule.conditions.len()
    }

    pub(super) fn ask_conditions(&mut self) {
        self.schedule.conditions.retain_mut(|condition| !condition.is_settled(&self.state, self.now));
    }
}
