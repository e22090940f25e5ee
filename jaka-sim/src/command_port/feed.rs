//! Requests off a socket.

use std::fmt;
use std::io::{self, ErrorKind, Read};
use std::net::TcpStream;

use jaka_proto::framing::{FrameError, Framer};

/// The longest request, in bytes. Real ones have some hundred.
const MAX_REQUEST: usize = 64 << 10;

/// Cuts requests off a socket, and leaves the last bytes unread.
///
/// What completes a request is only peeked at until more is needed. So there is something unread whenever a request has
/// been cut off, and a socket that is dropped then resets the connection.
#[derive(Debug)]
pub(super) struct Feed<'s> {
    stream: &'s TcpStream,
    framer: Framer,
    /// How many bytes the framer has and the kernel has still.
    unread: u64,
}

/// What a client has sent.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Incoming {
    /// Something with the outline of a request.
    Request(String),
    /// The same, but no UTF-8; what cannot be shown is replaced.
    NoText(String),
    /// Bytes that begin no request.
    Garbage,
}

impl<'s> Feed<'s> {
    pub(super) fn new(stream: &'s TcpStream) -> Self {
        Self { stream, framer: Framer::new(MAX_REQUEST), unread: 0 }
    }

    /// Waits for the next request; `None` at the end of the connection, or where no request can be made out.
    pub(super) fn next(&mut self) -> io::Result<Option<Incoming>> {
        loop {
            match self.framer.next_frame() {
                Ok(Some(frame)) => return Ok(Some(Incoming::of(frame))),
                Ok(None) => {}
                Err(FrameError::Garbage { .. }) => {
                    self.framer.resync();
                    return Ok(Some(Incoming::Garbage));
                }
                Err(_) => return Ok(None),
            }
            self.consume()?;
            let peeked = self.peek()?;
            if peeked == 0 {
                return Ok(None);
            }
            self.framer.filled(peeked);
            self.unread = u64::try_from(peeked).unwrap_or(u64::MAX);
        }
    }

    /// Takes from the kernel what the framer has already.
    pub(super) fn consume(&mut self) -> io::Result<()> {
        let unread = std::mem::take(&mut self.unread);
        io::copy(&mut self.stream.take(unread), &mut io::sink()).map(drop)
    }

    fn peek(&mut self) -> io::Result<usize> {
        loop {
            match self.stream.peek(self.framer.spare()) {
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                peeked => return peeked,
            }
        }
    }
}

/// The text, or what stands for it in a log.
impl fmt::Display for Incoming {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Request(text) | Self::NoText(text) => f.write_str(text),
            Self::Garbage => f.write_str("garbage"),
        }
    }
}

impl Incoming {
    fn of(frame: &[u8]) -> Self {
        match std::str::from_utf8(frame) {
            Ok(text) => Self::Request(text.to_owned()),
            Err(_) => Self::NoText(String::from_utf8_lossy(frame).into_owned()),
        }
    }
}
