//! Requests from a connection.

use std::fmt;
use std::io;
use std::time::Duration;

use jaka_proto::Envelope;
use jaka_proto::framing::{FrameError, Framer};

use crate::link::{Inbound, Received, Wire};

/// Maximum length of a request, in bytes. Real requests have some hundred bytes.
const MAX_REQUEST: usize = 64 << 10;

/// Reader of requests from a connection.
#[derive(Debug)]
pub(super) struct RequestReader<'s> {
    inbound: Inbound<'s>,
    framer: Framer,
}

/// Next event on the connection.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum NextRequest {
    Incoming(Incoming),
    /// No request before the timeout.
    Silence,
    /// The connection has ended, or the input cannot be split into requests.
    End,
}

/// Input from a client.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Incoming {
    /// Text with the outline of a request.
    Request(String),
    /// Text with the outline of a request that is not valid UTF-8; invalid bytes are replaced.
    NoText(String),
    /// Bytes that begin no request.
    Garbage,
}

impl<'s> RequestReader<'s> {
    pub(super) fn new(wire: &'s Wire) -> Self {
        Self { inbound: Inbound::new(wire), framer: Framer::new(MAX_REQUEST) }
    }

    /// Waits for the next request, up to the timeout if there is one.
    pub(super) fn next(&mut self, patience: Option<Duration>) -> io::Result<NextRequest> {
        loop {
            match self.framer.next_frame() {
                Ok(Some(frame)) => return Ok(NextRequest::Incoming(Incoming::of(frame))),
                Ok(None) => {}
                Err(FrameError::Garbage { .. }) => {
                    self.framer.resync();
                    return Ok(NextRequest::Incoming(Incoming::Garbage));
                }
                Err(_) => return Ok(NextRequest::End),
            }
            match self.inbound.receive(self.framer.spare(), patience)? {
                Received::Bytes(count) => self.framer.filled(count),
                Received::Silence => return Ok(NextRequest::Silence),
                Received::End => return Ok(NextRequest::End),
            }
        }
    }

    /// Discards about as much input as a connection's buffers can hold, and returns whether the connection has ended.
    pub(super) fn ignore(&mut self) -> io::Result<bool> {
        let mut space = [0; 4096];
        let mut taken = 0;
        while taken < MAX_REQUEST {
            match self.inbound.receive(&mut space, None)? {
                Received::Bytes(count) => taken += count,
                Received::Silence => {}
                Received::End => return Ok(true),
            }
        }
        Ok(false)
    }
}

/// Writes the text, or a placeholder for a log.
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

    /// Returns the command of the request, if it can be read.
    pub(super) fn command(&self) -> Option<String> {
        let (Self::Request(text) | Self::NoText(text)) = self else { return None };
        // Requests have their command under the same key as replies.
        Envelope::read(text).ok()?.command.map(std::borrow::Cow::into_owned)
    }
}
