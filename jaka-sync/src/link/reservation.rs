//! Connections that one handle has for itself, but for what passes by others.

use std::sync::Arc;

use super::Link;
use super::outgoing::{Handle, Outgoing, Reservation, Right};
use super::state::State;
use crate::{Error, ErrorKind};

/// A reservation, until it is dropped.
#[derive(Debug)]
#[must_use = "a reservation ends when it is dropped"]
pub struct Reserved {
    link: Arc<Link>,
    number: u64,
}

impl Drop for Reserved {
    fn drop(&mut self) {
        self.link.state.lock().reservations.retain(|(number, ..)| *number != self.number);
    }
}

impl Link {
    /// Keeps back what other handles than this one send, but for what passes. Stops of stop handles always do.
    pub fn reserve(self: &Arc<Self>, by: Handle, reservation: Reservation) -> Reserved {
        let mut state = self.state.lock();
        let number = state.next_number();
        state.reservations.push((number, by, reservation));
        Reserved { link: Arc::clone(self), number }
    }

    /// Another handle of the connection.
    pub(crate) fn new_handle(&self) -> Handle {
        Handle(self.state.lock().next_number())
    }

    /// Number of commands that other handles than this one have sent and that may have changed something.
    pub fn changes_but_of(&self, handle: Handle) -> u64 {
        let state = self.state.lock();
        state.changes - state.changes_of.get(&handle).copied().unwrap_or_default()
    }
}

impl State {
    fn next_number(&mut self) -> u64 {
        self.last_number += 1;
        self.last_number
    }

    /// Fails where the reservation of another handle keeps this back.
    pub(super) fn check_reserved(&self, outgoing: &Outgoing<'_>) -> Result<(), Error> {
        let keeps_back = |by: Handle, reservation: &Reservation| {
            outgoing.right != Right::Stop && outgoing.by != by && !(reservation.lets_pass)(outgoing.info)
        };
        match self.reservations.iter().find(|(_, by, reservation)| keeps_back(*by, reservation)) {
            Some((_, _, Reservation { because, .. })) => {
                Err(ErrorKind::KeptBack { command: outgoing.command.to_owned(), because }.into())
            }
            None => Ok(()),
        }
    }

    /// Counts what has been entered.
    pub(super) fn count_change(&mut self, outgoing: &Outgoing<'_>) {
        if !outgoing.is_query() {
            self.changes += 1;
            *self.changes_of.entry(outgoing.by).or_default() += 1;
        }
    }
}
