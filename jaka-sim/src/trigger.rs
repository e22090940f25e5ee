//! Conditions on the state, and their actions.

use std::any::Any;
use std::fmt;
use std::panic::{self, AssertUnwindSafe};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use jaka_clock::{Clock, Signal, lock};

use crate::State;

/// Handle of a condition of [`Controller::when`](crate::Controller::when). It reports the progress; dropping it has no
/// effect.
#[derive(Debug, Clone)]
pub struct Trigger(Arc<Inner>);

#[derive(Debug)]
struct Inner {
    progress: Mutex<TriggerProgress>,
    changed: Signal,
}

#[derive(Debug, Default)]
struct TriggerProgress {
    fired_at: Option<Duration>,
    /// Whether the action has returned, or will never run.
    is_over: bool,
    panic: Option<Box<dyn Any + Send>>,
}

impl Trigger {
    pub(crate) fn new(time: &Clock) -> Self {
        Self(Arc::new(Inner { progress: Mutex::default(), changed: Signal::new(time) }))
    }

    /// Returns the time at which the condition first held, in the controller's time since its start; `None` if it has
    /// not held yet.
    pub fn fired_at(&self) -> Option<Duration> {
        lock(&self.0.progress).fired_at
    }

    /// Waits until the action has returned; returns false on timeout, or if the controller was dropped before the
    /// condition held.
    ///
    /// # Panics
    /// If the condition or the action has panicked: with the same payload, once.
    pub fn wait(&self, timeout: Duration) -> bool {
        let mut progress = self.0.changed.wait_until(&self.0.progress, timeout, |progress| progress.is_over);
        if let Some(payload) = progress.panic.take() {
            drop(progress);
            panic::resume_unwind(payload);
        }
        progress.is_over && progress.fired_at.is_some()
    }

    /// Waits for the condition, up to this time; returns true if it is still pending.
    pub(crate) fn waits(&self, time: Duration) -> bool {
        let is_settled = |progress: &TriggerProgress| progress.fired_at.is_some() || progress.is_over;
        !is_settled(&self.0.changed.wait_until(&self.0.progress, time, is_settled))
    }

    /// Waits until the action has returned, if the condition holds.
    pub(crate) fn wait_for_action(&self) {
        let is_done = |progress: &TriggerProgress| progress.fired_at.is_none() || progress.is_over;
        drop(self.0.changed.wait_until(&self.0.progress, Duration::MAX, is_done));
    }

    /// Discards the condition if it is still pending.
    pub(crate) fn give_up(&self) {
        self.change(|progress| progress.is_over |= progress.fired_at.is_none());
    }

    /// Runs the action if the condition holds.
    pub(crate) fn run(&self, action: impl FnOnce()) {
        if lock(&self.0.progress).is_over {
            return;
        }
        self.end(panic::catch_unwind(AssertUnwindSafe(action)));
    }

    fn end(&self, ended: thread::Result<()>) {
        self.change(|progress| {
            progress.is_over = true;
            progress.panic = ended.err();
        });
    }

    fn change(&self, change: impl FnOnce(&mut TriggerProgress)) {
        change(&mut lock(&self.0.progress));
        self.0.changed.notify_all();
    }
}

/// Pending condition.
pub(crate) struct Condition {
    holds: Box<dyn FnMut(&State) -> bool + Send>,
    trigger: Trigger,
}

impl Condition {
    pub(crate) fn new(holds: impl FnMut(&State) -> bool + Send + 'static, trigger: &Trigger) -> Self {
        Self { holds: Box::new(holds), trigger: trigger.clone() }
    }

    /// Whether the condition is settled: it holds in this state, or its check has panicked.
    pub(crate) fn is_settled(&mut self, state: &State, now: Duration) -> bool {
        match panic::catch_unwind(AssertUnwindSafe(|| (self.holds)(state))) {
            Ok(false) => return false,
            Ok(true) => self.trigger.change(|progress| progress.fired_at = Some(now)),
            Err(payload) => self.trigger.end(Err(payload)),
        }
        true
    }
}

impl fmt::Debug for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Condition").finish_non_exhaustive()
    }
}

/// Conditions of a controller, each with its waiting thread.
#[derive(Debug, Default)]
pub(crate) struct Triggers(Mutex<Vec<(Trigger, JoinHandle<()>)>>);

impl Triggers {
    pub(crate) fn add(&self, trigger: &Trigger, thread: JoinHandle<()>) {
        let mut list = lock(&self.0);
        list.retain(|(_, thread)| !thread.is_finished());
        list.push((trigger.clone(), thread));
    }

    /// Waits until the actions of all conditions that hold have returned.
    pub(crate) fn wait_for_actions(&self) {
        let all: Vec<_> = lock(&self.0).iter().map(|(trigger, _)| trigger.clone()).collect();
        all.iter().for_each(Trigger::wait_for_action);
    }

    /// Discards all pending conditions, and waits for the actions of the others and for the threads.
    pub(crate) fn close(&self) {
        loop {
            let all = std::mem::take(&mut *lock(&self.0));
            if all.is_empty() {
                return;
            }
            for (trigger, _) in &all {
                trigger.give_up();
            }
            // An action may drop the controller.
            let is_other = |thread: &JoinHandle<()>| thread.thread().id() != thread::current().id();
            for (trigger, thread) in all.into_iter().filter(|(_, thread)| is_other(thread)) {
                // A simulated clock advances only for waits that it knows.
                trigger.wait_for_action();
                drop(thread.join());
            }
        }
    }
}
