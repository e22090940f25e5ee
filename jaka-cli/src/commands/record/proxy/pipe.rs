//! Connection of one client to the robot.

use std::io::{ErrorKind, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use jaka_sync::recording::{Ending, Event};
use socket2::SockRef;

use super::recording_queue::{Direction, Passed, ProxiedConnection, RecordingQueue};

/// Greatest number of bytes passed on in one read and write.
const ROOM: usize = 16 << 10;

/// Passes on the bytes of both directions, unchanged, with the end of each side.
///
/// It passes on any bytes as they come, and a copy goes to the recording, which never delays them. The pipe hands over
/// the copy before the bytes go out, so that the recording has each message before its consequences.
#[derive(Debug)]
pub(super) struct Pipe<'p> {
    pub(super) client: &'p TcpStream,
    pub(super) robot: &'p TcpStream,
    pub(super) connection: &'p Arc<ProxiedConnection>,
    pub(super) queue: &'p RecordingQueue,
}

/// End of a direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum DirectionEnd {
    /// The sender has sent all bytes.
    Eof,
    /// The sender's connection was lost.
    SenderLost,
    /// The receiver's connection was lost.
    ReceiverLost,
}

impl Pipe<'_> {
    /// Passes on both directions until both have ended.
    pub(super) fn run(&self) {
        let client_left = AtomicBool::new(false);
        thread::scope(|scope| {
            let requests = || {
                let end = self.pass(self.client, self.robot, Direction::ToRobot);
                // The other direction reports the loss of the robot's connection.
                if end != DirectionEnd::ReceiverLost {
                    client_left.store(true, Ordering::Release);
                }
                hand_on(end, self.client, self.robot);
            };
            if thread::Builder::new().spawn_scoped(scope, requests).is_err() {
                return;
            }
            let end = self.pass(self.robot, self.client, Direction::ToClient);
            self.closed(end, client_left.load(Ordering::Acquire));
            hand_on(end, self.robot, self.client);
        });
    }

    /// Passes on the bytes of a direction, up to its end.
    fn pass(&self, mut from: &TcpStream, mut to: &TcpStream, direction: Direction) -> DirectionEnd {
        let mut room = vec![0; ROOM];
        let end = loop {
            let bytes = match from.read(&mut room) {
                Ok(0) => break DirectionEnd::Eof,
                Ok(n) => &room[..n],
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                Err(_) => break DirectionEnd::SenderLost,
            };
            self.record(Passed::Bytes(direction, bytes.to_vec()));
            if to.write_all(bytes).is_err() {
                break DirectionEnd::ReceiverLost;
            }
        };
        self.record(Passed::End(direction));
        end
    }

    fn record(&self, passed: Passed) {
        self.queue.take(self.connection, passed);
    }

    fn closed(&self, end: DirectionEnd, client_left: bool) {
        let (by, why) = match end {
            _ if client_left => (Ending::Client, "the client has closed it"),
            DirectionEnd::ReceiverLost => (Ending::Client, "the client's connection was lost"),
            DirectionEnd::Eof => (Ending::Controller, "the controller has closed it"),
            DirectionEnd::SenderLost => (Ending::Failure, "the controller's connection was lost"),
        };
        self.record(Passed::Event(Event::Closed { by, why: why.to_owned() }));
    }
}

/// Ends a direction on the other side in the same way.
fn hand_on(end: DirectionEnd, sender: &TcpStream, receiver: &TcpStream) {
    // An error means that a connection has already ended.
    match end {
        DirectionEnd::Eof => drop(receiver.shutdown(Shutdown::Write)),
        DirectionEnd::SenderLost => reset(receiver),
        DirectionEnd::ReceiverLost => reset(sender),
    }
}

/// Makes the drop of a connection reset it, and wakes the thread that reads from it.
pub(super) fn reset(stream: &TcpStream) {
    drop(SockRef::from(stream).set_linger(Some(Duration::ZERO)));
    drop(stream.shutdown(Shutdown::Read));
}
