//! Calls for each packet, and for other news of the port.

use std::fmt;
use std::mem;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use jaka_proto::wire::DecodeError;

use crate::{Disconnect, Snapshot};

/// News of a status port, in their order of arrival.
#[derive(Debug)]
pub enum StatusNews<'n, S> {
    /// A packet.
    Packet {
        /// The packet.
        packet: &'n Arc<Snapshot<S>>,
        /// False if a newer packet had come before this one could be passed on.
        is_newest: bool,
    },
    /// The monitor shows the news from now on: a slow listener does its work now.
    Shown,
    /// The newest packet cannot be decoded.
    Unreadable(&'n DecodeError),
    /// The connection is lost, and the monitor reconnects.
    Reconnecting,
    /// The connection has ended for good.
    Ended(&'n Arc<Disconnect>),
}

impl<S> Clone for StatusNews<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S> Copy for StatusNews<'_, S> {}

/// Call of another layer for each piece of news.
pub(super) type Listener<S> = Box<dyn FnMut(StatusNews<'_, S>) -> ControlFlow<()> + Send>;

pub(super) type UserCallback<S> = Box<dyn FnMut(&Arc<Snapshot<S>>) -> ControlFlow<()> + Send>;

/// Listeners and observers.
pub(super) struct Observers<S> {
    /// Listeners of another layer, which are short and keep the arm from moving: an observer of the user must not delay
    /// them.
    pub(super) listeners: Vec<Listener<S>>,
    pub(super) users: Vec<UserCallback<S>>,
}

impl<S> Observers<S> {
    pub(super) fn is_empty(&self) -> bool {
        self.listeners.is_empty() && self.users.is_empty()
    }

    /// Calls the listeners, and removes those that break. A panic of a listener leaves no state incomplete.
    pub(super) fn tell(&mut self, news: StatusNews<'_, S>) {
        let flow = |listener: &mut Listener<S>| catch_unwind(AssertUnwindSafe(|| listener(news)));
        self.listeners.retain_mut(|listener| flow(listener).map_or(true, |flow| flow.is_continue()));
    }

    /// Calls the user's observers, and removes those that break or panic.
    pub(super) fn call(&mut self, snapshot: &Arc<Snapshot<S>>) {
        // A panic can leave only the observer's own state incomplete.
        let flow = |call: &mut UserCallback<S>| catch_unwind(AssertUnwindSafe(|| call(snapshot)));
        self.users.retain_mut(|call| flow(call).is_ok_and(|flow| flow.is_continue()));
    }

    /// Takes the listeners out.
    pub(super) fn take_listeners(&mut self) -> Self {
        Self { listeners: mem::take(&mut self.listeners), users: Vec::new() }
    }

    /// Takes the user's observers out.
    pub(super) fn take_users(&mut self) -> Self {
        Self { listeners: Vec::new(), users: mem::take(&mut self.users) }
    }

    /// Adds the observers of another list.
    pub(super) fn join(&mut self, others: Self) {
        self.listeners.extend(others.listeners);
        self.users.extend(others.users);
    }
}

impl<S> Default for Observers<S> {
    fn default() -> Self {
        Self { listeners: Vec::new(), users: Vec::new() }
    }
}

impl<S> fmt::Debug for Observers<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} observers", self.listeners.len() + self.users.len())
    }
}
