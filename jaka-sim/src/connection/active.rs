//! Active client of the command port, of which there is at most one, and the idle other client of a takeover.

use std::io;
use std::net::{SocketAddr, TcpStream};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use jaka_clock::{Clock, Signal, lock};

use super::CommandConnection;
use crate::listener::CONNECT_TIMEOUT;

/// Connection of the active client, if one is connected.
#[derive(Debug)]
pub(crate) struct ActiveClient {
    connection: Mutex<Option<Arc<CommandConnection>>>,
    changed: Signal,
    /// Connection of the other client, at the client's end.
    other: Mutex<Option<TcpStream>>,
}

impl ActiveClient {
    pub(crate) fn new(time: &Clock) -> Self {
        Self { connection: Mutex::default(), changed: Signal::new(time), other: Mutex::default() }
    }

    pub(crate) fn connection(&self) -> Option<Arc<CommandConnection>> {
        lock(&self.connection).clone()
    }

    /// Waits until no client is active; returns false if one is still active after the timeout.
    pub(crate) fn wait_until_none(&self, timeout: Duration) -> bool {
        self.changed.wait_until(&self.connection, timeout, Option::is_none).is_none()
    }

    /// Removes the active client, if it is still this one.
    pub(crate) fn clear(&self, connection: &Arc<CommandConnection>) {
        let mut active = lock(&self.connection);
        if active.as_ref().is_some_and(|current| Arc::ptr_eq(current, connection)) {
            *active = None;
            self.changed.notify_all();
        }
    }

    /// Removes the active client, and closes its connection.
    pub(crate) fn close(&self) {
        if let Some(connection) = self.replace(None) {
            connection.close();
        }
    }

    /// Sets the active client, and returns the connection of the previous one.
    pub(crate) fn replace(&self, connection: Option<Arc<CommandConnection>>) -> Option<Arc<CommandConnection>> {
        let before = std::mem::replace(&mut *lock(&self.connection), connection);
        self.changed.notify_all();
        before
    }

    /// Connects the other client to the command port in place of the active one.
    ///
    /// It connects before the active client sees its end, so a client that reconnects comes after it.
    pub(crate) fn take_over(&self, port: SocketAddr) -> io::Result<()> {
        let before = self.replace(None);
        let stream = TcpStream::connect_timeout(&port, CONNECT_TIMEOUT);
        if let Some(connection) = before {
            connection.close();
        }
        *lock(&self.other) = Some(stream?);
        Ok(())
    }

    /// Ends the connection of the other client, if there is one.
    pub(crate) fn disconnect_other(&self) {
        lock(&self.other).take();
    }
}
