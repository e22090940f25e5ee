//! Calls for each packet.

use std::fmt;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use super::Snapshot;

type Call<S> = Box<dyn FnMut(&Arc<Snapshot<S>>) -> ControlFlow<()> + Send>;

/// What is called for each packet.
pub(super) struct Observers<S>(Vec<Call<S>>);

impl<S> Observers<S> {
    pub(super) fn add(&mut self, call: impl FnMut(&Arc<Snapshot<S>>) -> ControlFlow<()> + Send + 'static) {
        self.0.push(Box::new(call));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Calls all of them, and forgets those that break or panic.
    pub(super) fn call(&mut self, snapshot: &Arc<Snapshot<S>>) {
        // What a panic leaves half done is the call's own, and goes with it.
        self.0
            .retain_mut(|call| catch_unwind(AssertUnwindSafe(|| call(snapshot))).is_ok_and(|flow| flow.is_continue()));
    }

    /// Takes those that others have been put aside for.
    pub(super) fn join(&mut self, others: Self) {
        self.0.extend(others.0);
    }
}

impl<S> Default for Observers<S> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<S> fmt::Debug for Observers<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} observers", self.0.len())
    }
}
