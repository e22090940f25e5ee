//! Whose turn it is to send.

#[cfg(test)]
mod tests;

use std::sync::atomic::Ordering;

use super::Link;
use super::failure::Progress;
use super::halves::Outbound;
use super::outgoing::{Outgoing, Right};
use super::state::State;
use crate::Error;
use crate::sync::MutexGuard;

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
            self.link.state.lock().outbound = Some(outbound);
            self.link.state.wake();
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
        // With the lock, so that no thread is between checking and waiting.
        let _state = self.0.state.lock();
        self.0.state.wake();
    }
}

impl Link {
    /// Waits until no other thread sends, and no stop waits to.
    pub(super) fn take_turn<'l>(&'l self, outgoing: &Outgoing<'_>) -> Result<(Turn<'l>, MutexGuard<'l, State>), Error> {
        let mut state = self.state.lock();
        loop {
            // None of what has been read and not attributed is a reply to a command that goes out now.
            if let Err(cause) = self.attribute_read(&mut state) {
                self.break_off(&mut state, cause);
            }
            self.check(&state, outgoing.command, Progress::NotSent)?;
            let lets_pass = outgoing.right == Right::Usual && self.stops.load(Ordering::SeqCst) > 0;
            if !lets_pass && state.outbound.is_some() {
                return Ok((Turn { link: self, outbound: state.outbound.take() }, state));
            }
            let left = outgoing.left();
            if left.is_zero() {
                return Err(self.attach(outgoing.not_sent()));
            }
            state = self.state.wait(state, left);
        }
    }
}
