//! The connections of the command port: the active client's, what waits to be written to it, and the client of a takeover.

mod active;
mod next_step;
mod reply_writer;
mod takeover;

use std::io;
use std::net::TcpStream;
use std::sync::{Arc, Condvar, Mutex};
use std::time::Duration;

pub(crate) use self::active::ActiveClient;
pub(crate) use self::next_step::NextStep;
use self::reply_writer::PendingReplies;
pub(crate) use self::reply_writer::ReplyWriter;
pub(crate) use self::takeover::TakeoverClient;
use crate::Port;
use crate::link::{Links, Wire};
use crate::lock::{lock, wait};

/// The connection of a command client.
///
/// One thread reads from it. Replies, and what the controller's owner sends, go through [`CommandConnection::writer`].
#[derive(Debug)]
pub(crate) struct CommandConnection {
    wire: Arc<Wire>,
    pending: Mutex<PendingReplies>,
    closed: Mutex<bool>,
    changed: Condvar,
}

impl CommandConnection {
    pub(crate) fn new(stream: TcpStream, links: &Arc<Links>) -> io::Result<Self> {
        let wire = Wire::new(stream, Port::Command, links)?;
        Ok(Self { wire, pending: Mutex::default(), closed: Mutex::default(), changed: Condvar::new() })
    }

    pub(crate) fn wire(&self) -> &Wire {
        &self.wire
    }

    /// Waits until no other thread writes.
    pub(crate) fn writer(&self) -> ReplyWriter<'_> {
        ReplyWriter::new(&self.wire, lock(&self.pending))
    }

    /// Ends the connection, as its link lets it, and wakes the threads that read from it or write to it.
    pub(crate) fn close(&self) {
        self.wire.close();
        *lock(&self.closed) = true;
        self.changed.notify_all();
    }

    pub(crate) fn wait_until_closed(&self) {
        self.closes_within(Duration::MAX);
    }

    /// Waits for the time, and says whether the connection was closed by then.
    pub(crate) fn closes_within(&self, time: Duration) -> bool {
        *wait(&self.changed, lock(&self.closed), time, |closed| *closed)
    }

    /// Has the connection reset when it is dropped. It must not be closed before.
    pub(crate) fn reset_on_drop(&self) {
        self.wire.reset_on_drop();
    }
}
