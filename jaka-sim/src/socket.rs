//! The socket of a connection that was accepted.

use std::io::{self, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpStream};
use std::time::Duration;

use jaka_clock::{Channel, Work};

use crate::time::Time;

/// The socket of a connection that was accepted, whose reads and writes wait in the controller's time.
#[derive(Debug)]
pub(crate) struct Socket {
    stream: TcpStream,
    /// How long a write may take.
    write_timeout: Option<Duration>,
    /// Where a simulated clock is told of it. Dropped after the socket.
    channel: Option<Channel>,
}

impl Socket {
    /// Of a connection that was accepted just now. A simulated time stands still until the work is dropped.
    pub(crate) fn accepted(stream: TcpStream, peer: SocketAddr, time: &Time) -> io::Result<(Self, Option<Work>)> {
        let accepted = time.as_simulated().map(|clock| clock.accepted(&stream, peer)).transpose()?;
        let (channel, work) = accepted.unzip();
        Ok((Self { stream, write_timeout: None, channel }, work))
    }

    /// What options of the system are set on.
    pub(crate) fn system(&self) -> &TcpStream {
        &self.stream
    }

    /// Sets how long a write may take.
    pub(crate) fn set_write_timeout(&mut self, time: Duration) -> io::Result<()> {
        self.write_timeout = Some(time);
        if self.channel.is_none() { self.stream.set_write_timeout(Some(time)) } else { Ok(()) }
    }

    /// Sets how long a read waits, which a simulated clock is told with each.
    pub(crate) fn set_read_timeout(&self, patience: Option<Duration>) -> io::Result<()> {
        if self.channel.is_none() { self.stream.set_read_timeout(patience) } else { Ok(()) }
    }

    /// Reads once, for so long as the read timeout says, which is `patience`.
    pub(crate) fn read(&self, space: &mut [u8], patience: Option<Duration>) -> io::Result<usize> {
        match &self.channel {
            None => (&self.stream).read(space),
            Some(channel) => channel.read(&self.stream, space, patience),
        }
    }

    pub(crate) fn write_all(&self, bytes: &[u8]) -> io::Result<()> {
        match &self.channel {
            None => (&self.stream).write_all(bytes),
            Some(channel) => channel.write_all(&self.stream, bytes, self.write_timeout),
        }
    }

    pub(crate) fn shutdown(&self, how: Shutdown) -> io::Result<()> {
        match &self.channel {
            None => self.stream.shutdown(how),
            Some(channel) => channel.shutdown(&self.stream, how),
        }
    }
}
