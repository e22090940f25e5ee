//! The socket of a connection, whose reads and writes take the time of a clock.

use std::io::{self, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpStream};
use std::time::Duration;

use crate::clock::{Clock, End};

/// The socket of a connection.
#[derive(Debug)]
pub(crate) struct Socket {
    stream: TcpStream,
    /// Where a simulated clock is told of it: it waits in place of the system. Dropped after the socket.
    end: End,
}

impl Socket {
    /// Of a connection that was just made.
    pub(crate) fn new(stream: TcpStream, clock: &Clock) -> io::Result<Self> {
        let end = clock.as_simulated().map(|clock| clock.connected(&stream)).transpose()?;
        Ok(Self { stream, end })
    }

    /// What options of the system are set on.
    pub(crate) fn system(&self) -> &TcpStream {
        &self.stream
    }

    pub(crate) fn peer_addr(&self) -> io::Result<SocketAddr> {
        self.stream.peer_addr()
    }

    /// Reads once. How long it waits, the read timeout says, or, by a simulated clock, `left`.
    pub(crate) fn read(&self, space: &mut [u8], left: Duration) -> io::Result<usize> {
        match &self.end {
            None => (&self.stream).read(space),
            Some(end) => end.read(&self.stream, space, Some(left)),
        }
    }

    /// How many bytes a read would bring at least, without reading or waiting: 0 at the end. The socket must not block, and no thread may read or write.
    pub(crate) fn peek(&self) -> io::Result<usize> {
        match &self.end {
            None => self.stream.peek(&mut [0]),
            Some(end) => end.peek(&self.stream),
        }
    }

    /// Writes once. How long it waits, the write timeout says, or, by a simulated clock, `left`.
    pub(crate) fn write(&self, bytes: &[u8], left: Duration) -> io::Result<usize> {
        match &self.end {
            None => (&self.stream).write(bytes),
            Some(end) => end.write(&self.stream, bytes, Some(left)),
        }
    }

    pub(crate) fn set_read_timeout(&self, time: Duration) -> io::Result<()> {
        if self.end.is_none() { self.stream.set_read_timeout(Some(time)) } else { Ok(()) }
    }

    pub(crate) fn set_write_timeout(&self, time: Duration) -> io::Result<()> {
        if self.end.is_none() { self.stream.set_write_timeout(Some(time)) } else { Ok(()) }
    }

    pub(crate) fn set_nonblocking(&self, is_nonblocking: bool) -> io::Result<()> {
        match &self.end {
            None => self.stream.set_nonblocking(is_nonblocking),
            Some(end) => {
                end.set_nonblocking(is_nonblocking);
                Ok(())
            }
        }
    }

    pub(crate) fn shutdown(&self, how: Shutdown) -> io::Result<()> {
        match &self.end {
            None => self.stream.shutdown(how),
            Some(end) => end.shutdown(&self.stream, how),
        }
    }
}

/// By the system's clock.
impl From<TcpStream> for Socket {
    fn from(stream: TcpStream) -> Self {
        Self { stream, end: None }
    }
}
