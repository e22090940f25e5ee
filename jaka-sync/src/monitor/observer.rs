//! Calls for each packet.

use std::fmt;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use crate::Snapshot;

pub(super) type Call<S> = Box<dyn FnMut(&Arc<Snapshot<S>>) -> ControlFlow<()> + Send>;

/// What is called for each packet.
pub(super) struct Observers<S> {
    /// This crate's own, which are short and keep the arm from moving: no user's observer may hold them up.
    pub(super) own: Vec<Call<S>>,
    pub(super) users: Vec<Call<S>>,
}

impl<S> Observers<S> {
    pub(super) fn is_empty(&self) -> bool {
        self.own.is_empty() && self.users.is_empty()
    }

    /// Calls all of them, and forgets those that break; of the users' those that panic, too.
    pub(super) fn call(&mut self, snapshot: &Arc<Snapshot<S>>) {
        // What a panic leaves half done is the call's own. Those of this crate leave nothing so.
        let flow = |call: &mut Call<S>| catch_unwind(AssertUnwindSafe(|| call(snapshot)));
        self.own.retain_mut(|call| flow(call).map_or(true, |flow| flow.is_continue()));
        self.users.retain_mut(|call| flow(call).is_ok_and(|flow| flow.is_continue()));
    }

    /// Takes over the observers of another list.
    pub(super) fn join(&mut self, others: Self) {
        self.own.extend(others.own);
        self.users.extend(others.users);
    }
}

impl<S> Default for Observers<S> {
    fn default() -> Self {
        Self { own: Vec::new(), users: Vec::new() }
    }
}

impl<S> fmt::Debug for Observers<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} observers", self.own.len() + self.users.len())
    }
}
