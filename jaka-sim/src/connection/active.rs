//! The active client of the command port: there is at most one.

use std::sync::{Arc, Mutex};
use std::time::Duration;

use super::CommandConnection;
use crate::lock::lock;
use crate::time::{Signal, Time};

/// The connection of the active client, if one is connected.
#[derive(Debug)]
pub(crate) struct ActiveClient {
    connection: Mutex<Option<Arc<CommandConnection>>>,
    changed: Signal,
}

impl ActiveClient {
    pub(crate) fn new(time: &Time) -> Self {
        Self { connection: Mutex::default(), changed: Signal::new(time) }
    }

    pub(crate) fn connection(&self) -> Option<Arc<CommandConnection>> {
        lock(&self.connection).clone()
    }

    pub(crate) fn is_connected(&self) -> bool {
        lock(&self.connection).is_some()
    }

    /// Waits until no client is active; false if one still is after the timeout.
    pub(crate) fn wait_until_none(&self, timeout: Duration) -> bool {
        self.changed.wait(&self.connection, timeout, Option::is_none).is_none()
    }

    pub(crate) fn set(&self, connection: Arc<CommandConnection>) {
        self.replace(Some(connection));
    }

    /// Makes no client active, if this one still is.
    pub(crate) fn clear(&self, connection: &Arc<CommandConnection>) {
        let mut active = lock(&self.connection);
        if active.as_ref().is_some_and(|current| Arc::ptr_eq(current, connection)) {
            *active = None;
            self.changed.notify_all();
        }
    }

    /// Makes no client active, and closes the connection of the one that was.
    pub(crate) fn close(&self) {
        if let Some(connection) = self.replace(None) {
            connection.close();
        }
    }

    /// Sets the active client, and gives the connection of the one before.
    pub(super) fn replace(&self, connection: Option<Arc<CommandConnection>>) -> Option<Arc<CommandConnection>> {
        let before = std::mem::replace(&mut *lock(&self.connection), connection);
        self.changed.notify_all();
        before
    }
}
