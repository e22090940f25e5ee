//! Whose turn it is to send.

use std::sync::MutexGuard;
use std::sync::atomic::Ordering;

use super::Link;
use super::failure::{Progress, disconnected};
use super::outbound::Outbound;
use super::outgoing::{Outgoing, Right};
use super::state::State;
use crate::Error;

/// The turn to send, which the next one has when this is dropped.
#[derive(Debug)]
pub(super) struct Turn<'l> {
    link: &'l Link,
    pub(super) outbound: Option<Box<Outbound>>,
}

/// The lock must not be held when the turn is dropped: declare the lock's guard after it.
impl Drop for Turn<'_> {
    fn drop(&mut self) {
        if let Some(outbound) = self.outbound.take() {
            let mut state = self.link.lock();
            state.outbound = Some(outbound);
            self.link.wake(&state);
        }
    }
}

/// A stop that is on its way: until it is dropped, no other command begins to go out.
#[derive(Debug)]
pub(super) struct Passing<'l>(&'l Link);

impl<'l> Passing<'l> {
    pub(super) fn new(link: &'l Link) -> Self {
        link.stops.fetch_add(1, Ordering::SeqCst);
        Self(link)
    }
}

impl Drop for Passing<'_> {
    fn drop(&mut self) {
        self.0.stops.fetch_sub(1, Ordering::SeqCst);
        self.0.wake(&self.0.lock());
    }
}

impl Link {
    /// Waits until no other thread sends, and no stop waits to.
    pub(super) fn take_turn<'l>(&'l self, outgoing: &Outgoing<'_>) -> Result<(Turn<'l>, MutexGuard<'l, State>), Error> {
        let mut state = self.lock();
        loop {
            // None of what has been read and not attributed is a reply to a command that goes out now.
            if let Err(cause) = self.attribute_read(&mut state) {
                self.break_off(&mut state, cause);
            }
            if let Some(cause) = state.broken.clone() {
                return Err(self.attach(disconnected(outgoing.command, Progress::NotSent, cause)));
            }
            let lets_pass = outgoing.right == Right::Usual && self.stops.load(Ordering::SeqCst) > 0;
            if !lets_pass && state.outbound.is_some() {
                return Ok((Turn { link: self, outbound: state.outbound.take() }, state));
            }
            let left = outgoing.left();
            if left.is_zero() {
                return Err(self.attach(outgoing.not_sent()));
            }
            state = self.sleep(state, left);
        }
    }
}
