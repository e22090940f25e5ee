//! Connections of the command port: that of the active client, its pending replies, and the client of a takeover.

mod active;
mod reply_writer;

use std::io;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use jaka_clock::{Signal, Socket, lock};

pub(crate) use self::active::ActiveClient;
use self::reply_writer::PendingReplies;
pub(crate) use self::reply_writer::ReplyWriter;
use crate::Port;
use crate::link::{Links, Wire};

/// Connection of a command client.
///
/// One thread reads from it. Replies, and bytes that the controller's owner sends, go through
/// [`CommandConnection::writer`].
#[derive(Debug)]
pub(crate) struct CommandConnection {
    wire: Arc<Wire>,
    pending: Mutex<PendingReplies>,
    closed: Mutex<bool>,
    changed: Signal,
}

impl CommandConnection {
    pub(crate) fn new(socket: Socket, links: &Arc<Links>) -> io::Result<Self> {
        let wire = Wire::new(socket, Port::Command, links)?;
        Ok(Self { wire, pending: Mutex::default(), closed: Mutex::default(), changed: Signal::new(links.time()) })
    }

    pub(crate) fn wire(&self) -> &Arc<Wire> {
        &self.wire
    }

    /// Returns the writer, after waiting until no other thread writes.
    pub(crate) fn writer(&self) -> ReplyWriter<'_> {
        ReplyWriter::new(&self.wire, lock(&self.pending))
    }

    /// Ends the connection, subject to its link, and wakes the threads that read from it or write to it.
    pub(crate) fn close(&self) {
        self.wire.close();
        *lock(&self.closed) = true;
        self.changed.notify_all();
    }

    /// Waits for the time, and returns whether the connection was closed by then.
    pub(crate) fn closes_within(&self, time: Duration) -> bool {
        *self.changed.wait_until(&self.closed, time, |closed| *closed)
    }
}

/// Next step on a connection after a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NextStep {
    /// Read the next request.
    Continue,
    Close,
    Reset,
    /// Keep the connection open without further answers.
    HalfOpen,
    /// Let another client take the port.
    Takeover,
    /// Shut down the controller.
    Shutdown,
}
