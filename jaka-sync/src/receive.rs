//! Reading a socket into a framer, within a deadline.

use std::io::ErrorKind;
use std::time::Duration;

use jaka_clock::Socket;
use jaka_proto::Envelope;
use jaka_proto::framing::Framer;
use jaka_proto::messages::status::RobotStatus;
use jaka_proto::wire::{Decode, Reader};

use crate::Disconnect;
use crate::recorder::Tap;

/// Result of a read.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Chunk {
    /// All bytes that had come by then.
    All,
    /// As many bytes as there was room for. There may be more.
    Part,
    /// Nothing within the time of one read, which may be shorter than requested; or, from a nonblocking socket, nothing
    /// at all.
    TimeUp,
}

/// Current read timeout of the socket, so that it is set only if it must change.
#[derive(Debug, Default)]
pub(crate) struct ReadTimeout(Duration);

/// The shortest timeout: a read ends late by no more than this.
const SHORTEST: Duration = Duration::from_millis(1);

/// The longest timeout: systems do not accept every `Duration`. A thread that waits longer reads again.
const LONGEST: Duration = Duration::from_secs(3600);

impl ReadTimeout {
    /// Sets a timeout that is no longer than the time left, and at least half of it.
    ///
    /// The timeout is a little shorter, so that it also fits the next call, part of whose time is gone before it reads:
    /// a call that is answered makes no system call for its deadline. A thread that waits to the end reads a few times
    /// more.
    fn set(&mut self, stream: &Socket, left: Duration) -> std::io::Result<()> {
        let left = left.clamp(SHORTEST, LONGEST);
        if (left / 2..=left).contains(&self.0) {
            return Ok(());
        }
        let timeout = (left / 8 * 7).max(SHORTEST);
        stream.set_read_timeout(Some(timeout))?;
        self.0 = timeout;
        Ok(())
    }
}

/// Reads once, for at most the time that is left.
pub(crate) fn chunk(
    stream: &Socket,
    tap: &Tap,
    framer: &mut Framer,
    timeout: &mut ReadTimeout,
    left: Duration,
) -> Result<Chunk, Disconnect> {
    if left.is_zero() {
        return Ok(Chunk::TimeUp);
    }
    timeout.set(stream, left).map_err(Disconnect::Read)?;
    arrived(stream, tap, framer, left)
}

/// Fails if the other end of a nonblocking socket has ended the connection, and nothing is left to read.
pub(crate) fn check_end(stream: &Socket, framer: &Framer) -> Result<(), Disconnect> {
    match stream.peek() {
        Ok(0) => Err(Disconnect::Closed { partial: framer.partial().len() }),
        Ok(_) => Ok(()),
        Err(error) => match error.kind() {
            ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted => Ok(()),
            _ => Err(Disconnect::Read(error)),
        },
    }
}

/// Reads once. A nonblocking socket returns the bytes that have come; another one waits for at most its timeout or,
/// with a simulated clock, for `left`.
pub(crate) fn arrived(stream: &Socket, tap: &Tap, framer: &mut Framer, left: Duration) -> Result<Chunk, Disconnect> {
    let room = framer.spare().len();
    match stream.read(framer.spare(), Some(left)) {
        Ok(0) => Err(Disconnect::Closed { partial: framer.partial().len() }),
        Ok(len) => {
            framer.filled(len);
            tap.arrived();
            Ok(if len < room { Chunk::All } else { Chunk::Part })
        }
        Err(error) => match error.kind() {
            ErrorKind::WouldBlock | ErrorKind::TimedOut => Ok(Chunk::TimeUp),
            // A signal interrupted the read.
            ErrorKind::Interrupted => Ok(Chunk::Part),
            _ => Err(Disconnect::Read(error)),
        },
    }
}

/// True for the reply to a command.
pub(crate) fn is_reply(text: &str) -> bool {
    Envelope::read(text).is_ok_and(|envelope| envelope.command.is_some() && envelope.code.is_ok())
}

/// True for a status packet, of which no key is mandatory.
pub(crate) fn is_status(text: &str) -> bool {
    let names_a_command = Envelope::read(text).is_ok_and(|envelope| envelope.command.is_some());
    let status = RobotStatus::decode(&mut Reader::new(text));
    let shows_the_arm = |status: RobotStatus| {
        status.joint_actual_position.is_some() || status.in_position.is_some() || status.enabled.is_some()
    };
    !names_a_command && status.is_ok_and(shows_the_arm)
}

#[cfg(test)]
mod tests {
    use std::net::{TcpListener, TcpStream};

    use super::*;

    #[test]
    fn a_timeout_is_set_only_where_it_must_change() {
        let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has free ports");
        let stream = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
        let stream = Socket::from(stream);
        let mut timeout = ReadTimeout::default();
        let mut set = |left: u64| {
            timeout.set(&stream, Duration::from_millis(left)).expect("the socket is open");
            assert!((left / 2..=left).contains(&u64::try_from(timeout.0.as_millis()).expect("it is short")));
            assert!(stream.system().read_timeout().expect("the socket is open").is_some());
            timeout.0
        };
        let first = set(5000);
        // Up to an eighth of the time may be gone before the read.
        assert!([4999, 5000, 4990, 4500, 4376].into_iter().all(|left| set(left) == first));
        assert!(set(4000) < first);
        assert!(set(1) < set(30_000));
    }
}
