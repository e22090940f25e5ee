//! What happens at its time.

use std::io;
use std::time::Duration;

use super::World;
use crate::input_script::{InputChange, InputScript};
use crate::{ArmFault, State};

/// What is to happen, in order.
#[derive(Debug, Default)]
pub(super) struct Schedule(Vec<(Duration, Happening)>);

#[derive(Debug, Clone, Copy)]
enum Happening {
    Input(InputChange),
    Arm(ArmFault),
}

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
        script.0.iter().try_for_each(|(_, change)| change.check(&self.state))?;
        let at = |after: &Duration| self.now.saturating_add(*after);
        self.schedule.add(script.0.iter().map(|(after, change)| (at(after), Happening::Input(*change))));
        self.run_schedule();
        Ok(())
    }

    /// Has something happen at this time of the controller, or at once where that has passed.
    pub(crate) fn schedule_fault(&mut self, at: Duration, fault: ArmFault) -> io::Result<()> {
        fault.check(&self.state)?;
        self.schedule.add([(at, Happening::Arm(fault))]);
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

impl Happening {
    fn make(self, state: &mut State) {
        match self {
            Self::Input(change) => change.make(state),
            Self::Arm(fault) => fault.make(state),
        }
    }
}
