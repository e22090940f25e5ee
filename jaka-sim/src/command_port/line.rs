//! The connection of a command client.

use std::io;
use std::net::TcpStream;
use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

use super::way_out::{Kept, WayOut};
use crate::Port;
use crate::link::{Links, Wire};
use crate::lock::{lock, wait};

/// The connection of a command client.
///
/// One thread reads from it; replies, and what the controller's owner sends, go through [`Line::way_out`].
#[derive(Debug)]
pub(crate) struct Line {
    wire: Arc<Wire>,
    kept: Mutex<Kept>,
    closed: Mutex<bool>,
    changed: Condvar,
}

/// Whether the connection goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Flow {
    Stay,
    Close,
    Reset,
    /// Nothing is answered any more.
    HalfOpen,
    /// Another client takes the port.
    Takeover,
    /// The controller shuts down.
    Shutdown,
}

impl Line {
    pub(super) fn new(stream: TcpStream, links: &Arc<Links>) -> io::Result<Self> {
        let wire = Wire::new(stream, Port::Command, links)?;
        Ok(Self { wire, kept: Mutex::default(), closed: Mutex::default(), changed: Condvar::new() })
    }

    pub(super) fn wire(&self) -> &Wire {
        &self.wire
    }

    /// Waits for whoever writes.
    pub(crate) fn way_out(&self) -> WayOut<'_> {
        WayOut::new(&self.wire, lock(&self.kept))
    }

    /// Ends the connection, as its link lets it, and wakes who reads from it or writes to it.
    pub(crate) fn close(&self) {
        self.wire.close();
        *lock(&self.closed) = true;
        self.changed.notify_all();
    }

    pub(super) fn wait_until_closed(&self) {
        self.closes_within(Duration::MAX);
    }

    /// Waits so long, and says whether the connection was closed by then.
    pub(super) fn closes_within(&self, time: Duration) -> bool {
        *wait(&self.changed, lock(&self.closed), time, |closed| *closed)
    }

    /// Has the connection reset when it is dropped. It must not be closed before.
    pub(super) fn reset_on_drop(&self) {
        self.wire.reset_on_drop();
    }
}
