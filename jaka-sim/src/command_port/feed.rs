//! Requests off a socket.

use std::fmt;
use std::io::{self, ErrorKind, Read};
use std::net::TcpStream;
use std::time::Duration;

use jaka_proto::Envelope;
use jaka_proto::framing::{FrameError, Framer};

/// The longest request, in bytes. Real ones have some hundred.
const MAX_REQUEST: usize = 64 << 10;

/// The least time that a socket can be waited for.
const LEAST_WAIT: Duration = Duration::from_millis(1);

/// Cuts requests off a socket.
#[derive(Debug)]
pub(super) struct Feed<'s> {
    stream: &'s TcpStream,
    framer: Framer,
    /// Whether the socket waits for a time only.
    hurried: bool,
}

/// What comes next.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Next {
    Incoming(Incoming),
    /// Nothing has come in time.
    Silence,
    /// The connection has ended, or no request can be made out any more.
    End,
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
        Self { stream, framer: Framer::new(MAX_REQUEST), hurried: false }
    }

    /// Waits for the next request; at most so long, if a time is given.
    pub(super) fn next(&mut self, patience: Option<Duration>) -> io::Result<Next> {
        loop {
            match self.framer.next_frame() {
                Ok(Some(frame)) => return Ok(Next::Incoming(Incoming::of(frame))),
                Ok(None) => {}
                Err(FrameError::Garbage { .. }) => {
                    self.framer.resync();
                    return Ok(Next::Incoming(Incoming::Garbage));
                }
                Err(_) => return Ok(Next::End),
            }
            self.set_patience(patience)?;
            match self.stream.read(self.framer.spare()) {
                Ok(0) => return Ok(Next::End),
                Ok(count) => self.framer.filled(count),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                // Systems differ in what they call it.
                Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {
                    return Ok(Next::Silence);
                }
                Err(error) => return Err(error),
            }
        }
    }

    /// Takes about as much as a connection's buffers would, up to its end, and says whether that has come.
    pub(super) fn ignore(&mut self) -> io::Result<bool> {
        self.set_patience(None)?;
        let most = u64::try_from(MAX_REQUEST).unwrap_or(u64::MAX);
        Ok(io::copy(&mut self.stream.take(most), &mut io::sink())? < most)
    }

    fn set_patience(&mut self, patience: Option<Duration>) -> io::Result<()> {
        if self.hurried || patience.is_some() {
            self.stream.set_read_timeout(patience.map(|time| time.max(LEAST_WAIT)))?;
        }
        self.hurried = patience.is_some();
        Ok(())
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

    /// The command that is asked for, where one can be made out.
    pub(super) fn command(&self) -> Option<String> {
        let (Self::Request(text) | Self::NoText(text)) = self else { return None };
        // Requests name their command under the key under which replies do.
        Envelope::read(text).ok()?.command.map(std::borrow::Cow::into_owned)
    }
}
