//! Reading a socket into a framer, within a deadline.

use std::io::{ErrorKind, Read};
use std::net::TcpStream;
use std::time::Duration;

use jaka_proto::framing::Framer;

use crate::Disconnect;
use crate::recorder::Tap;

/// What a read brought.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Chunk {
    /// Some bytes.
    Some,
    /// Nothing within the time.
    TimeUp,
}

/// The read timeout that the socket has, so that it is set only where it must change.
#[derive(Debug, Default)]
pub(crate) struct Timeout(Duration);

/// A timeout that is longer than the time left by less than this is left as it is.
const SLACK: Duration = Duration::from_millis(1);

impl Timeout {
    fn set(&mut self, stream: &TcpStream, left: Duration) -> std::io::Result<()> {
        let left = left.max(SLACK);
        if self.0.checked_sub(left).is_some_and(|longer| longer < SLACK) {
            return Ok(());
        }
        stream.set_read_timeout(Some(left))?;
        self.0 = left;
        Ok(())
    }
}

/// Reads once.
pub(crate) fn chunk(
    mut stream: &TcpStream,
    tap: &Tap,
    framer: &mut Framer,
    timeout: &mut Timeout,
    left: Duration,
) -> Result<Chunk, Disconnect> {
    if left.is_zero() {
        return Ok(Chunk::TimeUp);
    }
    timeout.set(stream, left).map_err(Disconnect::Read)?;
    match stream.read(framer.spare()) {
        Ok(0) => Err(Disconnect::Closed { partial: framer.partial().len() }),
        Ok(len) => {
            framer.filled(len);
            tap.arrived();
            Ok(Chunk::Some)
        }
        Err(error) => match error.kind() {
            ErrorKind::WouldBlock | ErrorKind::TimedOut => Ok(Chunk::TimeUp),
            ErrorKind::Interrupted => Ok(Chunk::Some),
            _ => Err(Disconnect::Read(error)),
        },
    }
}
