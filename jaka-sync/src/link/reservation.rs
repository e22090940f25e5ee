//! Connections that a part of the program has for itself, but for what it lets pass.

use std::sync::Arc;

use super::Link;
use super::outgoing::{Handle, Outgoing, Reservation};
use super::state::State;
use crate::{Error, ErrorKind};

/// A reservation, until it is dropped.
#[derive(Debug)]
#[must_use = "a reservation ends when it is dropped"]
pub struct Reserved(Arc<Link>);

impl Drop for Reserved {
    fn drop(&mut self) {
        self.0.state.lock().reservation = None;
    }
}

impl Link {
    /// Keeps back what other handles send, but for what passes. Stops of handles always do.
    pub fn reserve(self: &Arc<Self>, reservation: Reservation) -> Reserved {
        self.state.lock().reservation = Some(reservation);
        Reserved(Arc::clone(self))
    }

    /// Number of commands that other handles have sent and that may have changed something.
    pub fn changes_by_others(&self) -> u64 {
        self.state.lock().changes_by_others
    }
}

impl State {
    /// Fails where a reservation keeps this back.
    pub(super) fn check_reserved(&self, outgoing: &Outgoing<'_>) -> Result<(), Error> {
        match &self.reservation {
            Some(Reservation { because, lets_pass })
                if outgoing.by == Handle::Other && !lets_pass(outgoing.command) =>
            {
                Err(ErrorKind::KeptBack { command: outgoing.command.to_owned(), because }.into())
            }
            _ => Ok(()),
        }
    }

    /// Counts what has been entered.
    pub(super) fn count_change(&mut self, outgoing: &Outgoing<'_>) {
        self.changes_by_others += u64::from(outgoing.by == Handle::Other && !outgoing.is_query);
    }
}
