//! Socket of a connection, whose reads and writes take the time of a clock.

use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::Duration;

use crate::Clock;
#[cfg(feature = "simulated")]
use crate::simulated::{Channel, Work};

/// Socket of a connection, whose reads and writes take the time of a clock.
///
/// A read or write of the system's time lasts as long as the socket's timeout says, and one of a simulated time as long
/// as its caller says. The caller sets the timeout, so that it costs no system call where it stays.
#[derive(Debug)]
pub struct Socket {
    stream: TcpStream,
    /// End of the connection in a simulated time. Dropped after the stream.
    #[cfg(feature = "simulated")]
    channel: Option<Channel>,
}

impl Socket {
    /// Socket of a connection that was made just now.
    ///
    /// # Errors
    /// In a simulated time, those of the system: the options of the socket cannot be set, or its addresses are not
    /// known.
    pub fn connected(stream: TcpStream, clock: &Clock) -> io::Result<Self> {
        #[cfg(feature = "simulated")]
        if let Some(clock) = clock.as_simulated() {
            let channel = Some(clock.connected(&stream)?);
            return Ok(Self { stream, channel });
        }
        let _ = clock;
        Ok(stream.into())
    }

    /// Socket of a connection from `peer` that was accepted just now. A simulated time stands still until the work is
    /// dropped. Needs the feature `simulated`.
    ///
    /// # Errors
    /// As [`connected`](Self::connected).
    #[cfg(feature = "simulated")]
    pub fn accepted(stream: TcpStream, peer: std::net::SocketAddr, clock: &Clock) -> io::Result<(Self, Option<Work>)> {
        let accepted = clock.as_simulated().map(|clock| clock.accepted(&stream, peer)).transpose()?;
        let (channel, work) = accepted.unzip();
        Ok((Self { stream, channel }, work))
    }

    /// Socket of the system, for its addresses and options.
    pub fn system(&self) -> &TcpStream {
        &self.stream
    }

    /// Reads once, and waits for as long as the read timeout says; in a simulated time for `patience`, without end if
    /// that is none.
    ///
    /// # Errors
    /// [`WouldBlock`](io::ErrorKind::WouldBlock) or [`TimedOut`](io::ErrorKind::TimedOut) if nothing has come in time;
    /// those of the system.
    pub fn read(&self, space: &mut [u8], patience: Option<Duration>) -> io::Result<usize> {
        #[cfg(feature = "simulated")]
        if let Some(channel) = &self.channel {
            return channel.read(&self.stream, space, patience);
        }
        let _ = patience;
        (&self.stream).read(space)
    }

    /// Number of bytes that a read would bring at least, without reading or waiting: 0 at the end. The socket must not
    /// block, and no other thread may read or write.
    ///
    /// # Errors
    /// [`WouldBlock`](io::ErrorKind::WouldBlock) if a read would wait; those of the system.
    pub fn peek(&self) -> io::Result<usize> {
        #[cfg(feature = "simulated")]
        if let Some(channel) = &self.channel {
            return channel.peek(&self.stream);
        }
        self.stream.peek(&mut [0])
    }

    /// Writes once, and waits for as long as the write timeout says; in a simulated time for `patience`, without end if
    /// that is none.
    ///
    /// # Errors
    /// [`WouldBlock`](io::ErrorKind::WouldBlock) or [`TimedOut`](io::ErrorKind::TimedOut) if there was no room in time;
    /// those of the system.
    pub fn write(&self, bytes: &[u8], patience: Option<Duration>) -> io::Result<usize> {
        #[cfg(feature = "simulated")]
        if let Some(channel) = &self.channel {
            return channel.write(&self.stream, bytes, patience);
        }
        let _ = patience;
        (&self.stream).write(bytes)
    }

    /// Writes all bytes, with writes that each wait as [`write`](Self::write).
    ///
    /// # Errors
    /// As [`write`](Self::write); a part may have been written.
    pub fn write_all(&self, bytes: &[u8], patience: Option<Duration>) -> io::Result<()> {
        #[cfg(feature = "simulated")]
        if let Some(channel) = &self.channel {
            return channel.write_all(&self.stream, bytes, patience);
        }
        let _ = patience;
        (&self.stream).write_all(bytes)
    }

    /// Sets the time that a read may take; none for one that waits without end. No effect in a simulated time.
    ///
    /// # Errors
    /// The system's errors, and an error for a time of zero.
    pub fn set_read_timeout(&self, patience: Option<Duration>) -> io::Result<()> {
        if self.is_simulated() { Ok(()) } else { self.stream.set_read_timeout(patience) }
    }

    /// Sets the time that a write may take; none for one that waits without end. No effect in a simulated time.
    ///
    /// # Errors
    /// The system's errors, and an error for a time of zero.
    pub fn set_write_timeout(&self, patience: Option<Duration>) -> io::Result<()> {
        if self.is_simulated() { Ok(()) } else { self.stream.set_write_timeout(patience) }
    }

    /// Sets whether reads and writes return at once in place of waiting.
    ///
    /// # Errors
    /// The system's errors.
    pub fn set_nonblocking(&self, is_nonblocking: bool) -> io::Result<()> {
        #[cfg(feature = "simulated")]
        if let Some(channel) = &self.channel {
            channel.set_nonblocking(is_nonblocking);
            return Ok(());
        }
        self.stream.set_nonblocking(is_nonblocking)
    }

    /// Ends the connection in a direction or both, and wakes the threads that wait for it.
    ///
    /// # Errors
    /// The system's errors: it has ended already.
    pub fn shutdown(&self, how: Shutdown) -> io::Result<()> {
        #[cfg(feature = "simulated")]
        if let Some(channel) = &self.channel {
            return channel.shutdown(&self.stream, how);
        }
        self.stream.shutdown(how)
    }

    #[cfg(feature = "simulated")]
    fn is_simulated(&self) -> bool {
        self.channel.is_some()
    }

    #[cfg(not(feature = "simulated"))]
    #[allow(clippy::unused_self, reason = "the form of the one with the feature")]
    fn is_simulated(&self) -> bool {
        false
    }
}

/// Socket in the time of the system.
impl From<TcpStream> for Socket {
    fn from(stream: TcpStream) -> Self {
        Self {
            stream,
            #[cfg(feature = "simulated")]
            channel: None,
        }
    }
}
