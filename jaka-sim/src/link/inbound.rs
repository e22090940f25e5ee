//! Input from a client, subject to its link.

use std::collections::VecDeque;
use std::io::{self, ErrorKind};
use std::time::{Duration, Instant};

use super::Wire;
use super::queue::Pace;
use crate::Direction;
use crate::fault::{LinkFault, Passage};

/// Shortest possible wait for a socket.
const LEAST_WAIT: Duration = Duration::from_millis(1);

/// Longest wait for a socket while a link change may be due.
const MOST_WAIT: Duration = Duration::from_millis(10);

/// Greatest number of bytes in transit on a slow link. The client's system keeps the others.
const MOST: usize = 4 << 20;

/// Reader of a connection, subject to its link.
#[derive(Debug)]
pub(crate) struct Inbound<'w> {
    wire: &'w Wire,
    /// Bytes read from the socket that have not passed the link yet, with their times. An empty entry is the end.
    waiting: VecDeque<(Instant, Vec<u8>)>,
    bytes: usize,
    /// Whether the end was read from the socket.
    ended: bool,
    pace: Pace,
    /// Whether the socket has a read timeout.
    hurried: bool,
}

/// Result of a wait for input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Received {
    Bytes(usize),
    /// No input before the timeout.
    Silence,
    End,
}

/// Next step on a link that has or had a fault.
#[derive(Debug, PartialEq, Eq)]
enum ReceiveStep {
    /// Bytes arrive, up to this number.
    Take(usize),
    /// Waits for the socket, up to a timeout if there is one.
    Read(Option<Duration>),
    /// Waits for a change of the link, up to a timeout if there is one.
    Wait(Option<Duration>),
}

impl<'w> Inbound<'w> {
    pub(crate) fn new(wire: &'w Wire) -> Self {
        Self { wire, waiting: VecDeque::new(), bytes: 0, ended: false, pace: Pace::default(), hurried: false }
    }

    /// Waits for bytes, up to a timeout if there is one.
    pub(crate) fn receive(&mut self, space: &mut [u8], patience: Option<Duration>) -> io::Result<Received> {
        let links = self.wire.links();
        if !links.are_used() {
            let received = self.read(space, patience)?;
            // A fault that began during the wait applies to the received bytes.
            if !links.are_used() || received == Received::Silence {
                return Ok(received);
            }
            self.keep(received, space);
        }
        self.receive_late(space, patience)
    }

    fn receive_late(&mut self, space: &mut [u8], patience: Option<Duration>) -> io::Result<Received> {
        let links = self.wire.links();
        let time = links.time();
        let deadline = patience.and_then(|patience| time.now().checked_add(patience));
        let left = || deadline.map(|deadline| time.left(deadline));
        loop {
            let state = links.state();
            if self.wire.is_closed(&state) {
                return Ok(Received::End);
            }
            let fault = self.wire.fault(&state, Direction::ToController);
            match self.next(fault) {
                ReceiveStep::Take(most) => {
                    let received = self.take(space, most);
                    if let (LinkFault::Slow(per_second), Received::Bytes(count)) = (fault, received) {
                        self.pace.passed(count, per_second, time.now());
                    }
                    return Ok(received);
                }
                _ if left() == Some(Duration::ZERO) => return Ok(Received::Silence),
                ReceiveStep::Wait(most) => drop(links.wait(state, shorter(most, left()))),
                ReceiveStep::Read(most) => {
                    drop(state);
                    let received = self.read(space, shorter(most, left())).unwrap_or_else(|error| {
                        log::trace!(target: "jaka_sim", "client lost on its link: {error}");
                        Received::End
                    });
                    self.keep(received, space);
                }
            }
        }
    }

    fn next(&self, fault: LinkFault) -> ReceiveStep {
        let time = self.wire.links().time();
        let first = self.waiting.front().map(|(came, _)| time.elapsed(*came));
        match fault.passage(first.unwrap_or_default()) {
            Passage::Held | Passage::Lost => ReceiveStep::Wait(None),
            _ if first.is_none() => ReceiveStep::Read(None),
            Passage::Now => ReceiveStep::Take(usize::MAX),
            Passage::After(left) if self.ended || self.bytes >= MOST => ReceiveStep::Wait(Some(left)),
            Passage::After(left) => ReceiveStep::Read(Some(left.min(MOST_WAIT))),
            Passage::Paced(per_second) => {
                let portion = ReceiveStep::Take(Pace::portion(per_second));
                self.pace.left(time.now()).map_or(portion, |left| ReceiveStep::Wait(Some(left)))
            }
        }
    }

    fn keep(&mut self, received: Received, space: &[u8]) {
        let now = self.wire.links().time().now();
        match received {
            Received::Bytes(count) => {
                self.bytes += count;
                self.waiting.push_back((now, space[..count].to_vec()));
            }
            Received::End => {
                self.ended = true;
                self.waiting.push_back((now, Vec::new()));
            }
            Received::Silence => {}
        }
    }

    /// Takes the first waiting bytes.
    fn take(&mut self, space: &mut [u8], most: usize) -> Received {
        let Some((came, mut bytes)) = self.waiting.pop_front() else { return Received::Silence };
        if bytes.is_empty() {
            return Received::End;
        }
        let count = bytes.len().min(space.len()).min(most);
        space[..count].copy_from_slice(&bytes[..count]);
        self.bytes -= count;
        if count < bytes.len() {
            self.waiting.push_front((came, bytes.split_off(count)));
        }
        Received::Bytes(count)
    }

    fn read(&mut self, space: &mut [u8], patience: Option<Duration>) -> io::Result<Received> {
        self.set_patience(patience)?;
        loop {
            return match self.wire.socket().read(space, patience) {
                Ok(0) => Ok(Received::End),
                Ok(count) => Ok(Received::Bytes(count)),
                Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                // Systems differ in the error kind.
                Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {
                    Ok(Received::Silence)
                }
                Err(error) => Err(error),
            };
        }
    }

    fn set_patience(&mut self, patience: Option<Duration>) -> io::Result<()> {
        if self.hurried || patience.is_some() {
            self.wire.socket().set_read_timeout(patience.map(|time| time.max(LEAST_WAIT)))?;
        }
        self.hurried = patience.is_some();
        Ok(())
    }
}

/// Returns the shorter of two optional times; `None` is unlimited.
fn shorter(a: Option<Duration>, b: Option<Duration>) -> Option<Duration> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

#[cfg(test)]
mod tests {
    use std::net::{TcpListener, TcpStream};
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::thread;

    use jaka_clock::{Clock, SimulatedClock, Socket};

    use super::*;
    use crate::link::Links;
    use crate::link_selector::LinkSelector;
    use crate::{Port, clock};

    #[test]
    fn a_connection_that_closes_while_a_reader_is_about_to_wait_for_its_link_ends() {
        let simulated = SimulatedClock::new();
        let time = Clock::simulated(&simulated);
        let links = Arc::new(Links::new(&time));
        links.set(LinkSelector::default(), LinkFault::Hold);
        let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has ports");
        // One attempt finds the defect if the reader reaches the lock meanwhile.
        for _ in 0..20 {
            let _client = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
            let (stream, peer) = listener.accept().expect("a client has connected");
            let (socket, _) = Socket::accepted(stream, peer, &time).expect("options can be set");
            let wire = Wire::new(socket, Port::Command, &links).expect("options can be set");
            let has_ended = Arc::new(AtomicBool::new(false));
            let (theirs, ended) = (Arc::clone(&wire), Arc::clone(&has_ended));

            let state = links.state();
            let read = move || {
                let received = Inbound::new(&theirs).receive(&mut [0; 8], None);
                ended.store(matches!(received, Ok(Received::End)), Ordering::SeqCst);
            };
            let reader = clock::spawn(&time, "test", read).expect("threads can be started");
            thread::sleep(Duration::from_millis(5));
            wire.close_before_others_lock();
            drop(state);

            // Time advances once the reader waits or has ended.
            simulated.sleep(Duration::from_secs(1));
            assert!(has_ended.load(Ordering::SeqCst), "the reader waits for the link of a connection that has closed");
            drop(reader.join());
        }
    }
}
