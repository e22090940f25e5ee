//! The connection of a command client.

use std::io;
use std::net::{Shutdown, TcpStream};
use std::sync::{Condvar, Mutex};
use std::time::Duration;

use socket2::SockRef;

use super::way_out::{Kept, WayOut};
use crate::lock::{lock, wait};

/// The connection of a command client.
///
/// One thread reads from it; replies, and what the controller's owner sends, go through [`Line::way_out`].
#[derive(Debug)]
pub(crate) struct Line {
    stream: TcpStream,
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
    pub(super) fn new(stream: TcpStream) -> io::Result<Self> {
        stream.set_nodelay(true)?;
        Ok(Self { stream, kept: Mutex::default(), closed: Mutex::default(), changed: Condvar::new() })
    }

    pub(super) fn stream(&self) -> &TcpStream {
        &self.stream
    }

    /// Waits for whoever writes.
    pub(crate) fn way_out(&self) -> WayOut<'_> {
        WayOut::new(&self.stream, lock(&self.kept))
    }

    /// Ends the connection, and wakes who reads from it or writes to it.
    pub(crate) fn close(&self) {
        // An error says that it has ended already.
        self.stream.shutdown(Shutdown::Both).ok();
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
        if let Err(error) = SockRef::from(&self.stream).set_linger(Some(Duration::ZERO)) {
            log::trace!(target: "jaka_sim", "the connection cannot be reset: {error}");
        }
    }
}
