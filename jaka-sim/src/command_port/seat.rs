//! The one seat of the command port.

use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

use super::line::Line;
use crate::lock::{lock, wait};

/// The connection that has the seat.
#[derive(Debug, Default)]
pub(crate) struct Seat {
    line: Mutex<Option<Arc<Line>>>,
    changed: Condvar,
}

impl Seat {
    /// The connection that has the seat.
    pub(crate) fn line(&self) -> Option<Arc<Line>> {
        lock(&self.line).clone()
    }

    pub(crate) fn is_taken(&self) -> bool {
        lock(&self.line).is_some()
    }

    /// Waits until nobody has the seat; false where somebody still has.
    pub(crate) fn wait_until_free(&self, timeout: Duration) -> bool {
        wait(&self.changed, lock(&self.line), timeout, Option::is_none).is_none()
    }

    pub(super) fn take(&self, line: Arc<Line>) {
        self.put(Some(line));
    }

    /// Frees the seat, if the connection still has it.
    pub(super) fn leave(&self, line: &Arc<Line>) {
        let mut seat = lock(&self.line);
        if seat.as_ref().is_some_and(|current| Arc::ptr_eq(current, line)) {
            *seat = None;
            self.changed.notify_all();
        }
    }

    /// Frees the seat and closes the connection that had it.
    pub(crate) fn vacate(&self) {
        if let Some(line) = self.give_up() {
            line.close();
        }
    }

    /// Frees the seat, and gives the connection that had it.
    pub(super) fn give_up(&self) -> Option<Arc<Line>> {
        self.put(None)
    }

    fn put(&self, line: Option<Arc<Line>>) -> Option<Arc<Line>> {
        let old = std::mem::replace(&mut *lock(&self.line), line);
        self.changed.notify_all();
        old
    }
}
