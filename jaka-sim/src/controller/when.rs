//! Actions once the state is as a condition says, and the thread for links that change at a time.

use std::io;
use std::sync::Arc;

use super::Controller;
use crate::clock;
use crate::shared::Shared;
use crate::trigger::{Condition, Trigger};
use crate::{Happening, Scheduled, State};

impl Controller {
    /// Does something once, in a thread of its own, when the state first is as the condition says, which may be now.
    ///
    /// The condition is asked in each controller cycle and after each change of the state. Requests wait meanwhile, so
    /// it must not call the controller. The action may do with the controller what its owner may, and take its time:
    /// the arm goes on, except that with a [stepped clock](crate::Builder::stepped_clock) [`advance`](Self::advance)
    /// waits for it, and does nothing within it.
    ///
    /// With a clock of its own the controller is late by as much as the machine is busy; with a stepped or a
    /// [simulated](crate::Builder::clock) one the action begins in the cycle in which the condition holds.
    ///
    /// Dropping the controller gives up what has not happened, and waits for actions that have begun.
    ///
    /// ```
    /// use std::time::Duration;
    ///
    /// use jaka_sim::{Controller, Happening, Level};
    ///
    /// let controller = Controller::builder().stepped_clock().at(Duration::from_secs(2), Happening::Input(3, Level::High)).start()?;
    /// let collision = controller.when(|state| state.digital_inputs[3], |controller| controller.collide())?;
    /// controller.advance(Duration::from_secs(3));
    /// assert_eq!(collision.fired_at(), Some(Duration::from_secs(2)));
    /// assert!(controller.state().protective_stop);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    ///
    /// # Errors
    /// A thread cannot be started.
    pub fn when(
        &self,
        condition: impl FnMut(&State) -> bool + Send + 'static,
        action: impl FnOnce(&Self) + Send + 'static,
    ) -> io::Result<Trigger> {
        let trigger = Trigger::new(self.shared.time());
        let (shared, theirs) = (Arc::clone(&self.shared), trigger.clone());
        let thread = clock::spawn(self.shared.time(), "when", move || watch(&shared, &theirs, action))?;
        self.shared.triggers.add(&trigger, thread);
        self.shared.world().watch(Condition::new(condition, &trigger));
        Ok(trigger)
    }

    /// Has links change at their times where nobody asks the controller for anything then; a stepped clock needs no
    /// thread for it.
    pub(super) fn keep_time(&self, scheduled: &[Scheduled]) -> io::Result<()> {
        let is_of_links = |scheduled: &Scheduled| matches!(scheduled.happening, Happening::Link { .. });
        if self.shared.options.stepped || !scheduled.iter().any(is_of_links) {
            return Ok(());
        }
        let end = Trigger::new(self.shared.time());
        let (shared, theirs) = (Arc::clone(&self.shared), end.clone());
        let keep = move || while shared.until_next_due().is_some_and(|left| theirs.waits(left)) {};
        let thread = clock::spawn(self.shared.time(), "schedule", keep)?;
        self.shared.triggers.add(&end, thread);
        Ok(())
    }
}

/// Waits until the condition holds, and then acts.
fn watch(shared: &Arc<Shared>, trigger: &Trigger, action: impl FnOnce(&Controller)) {
    while trigger.waits(shared.until_next_cycle()) {
        // The condition is asked on the way.
        drop(shared.world());
    }
    let lent = Controller { shared: Arc::clone(shared), commands: None, status: None, is_lent: true };
    trigger.run(|| action(&lent));
}
