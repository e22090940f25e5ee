//! State of a clock: the time, the number of threads at work, and the waits.

use std::collections::{HashMap, HashSet};
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use super::parker::Parker;

/// Direction of bytes: from one address to another.
pub(super) type Way = (SocketAddr, SocketAddr);

/// Reason of a wait, other than a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reason {
    /// Nothing.
    Time,
    /// A signal, by its address.
    Signal(usize),
    /// Bytes that have come.
    Readable(Way),
    /// Room for bytes.
    Writable(Way),
}

/// State of a clock: the time, and the work that keeps it from going on.
#[derive(Debug, Default)]
pub(super) struct ClockState {
    /// Since the clock was made.
    pub(super) now: Duration,
    /// Number of threads and promises at work. Time stands still while there are some.
    at_work: usize,
    /// In the order in which they began to wait.
    waiters: Vec<Waiter>,
    last: u64,
    pipes: HashMap<Way, Pipe>,
    /// Addresses at which a participant accepts connections.
    pub(super) listeners: HashSet<SocketAddr>,
    /// Connections that were made, and that the other end has not accepted yet.
    coming: HashSet<Way>,
    /// Connections that were accepted, and whose programs have not announced them: these may be held up, or take no
    /// part.
    accepted: HashSet<Way>,
}

/// Wait of a thread.
#[derive(Debug)]
struct Waiter {
    number: u64,
    reason: Reason,
    until: Option<Duration>,
    parker: Arc<Parker>,
    moves_time: MovesTime,
}

/// Effect of a waiting thread on the simulated time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum MovesTime {
    Yes,
    /// Time advances only for the wait of another thread: a thread that serves others has no end of its own.
    No,
}

/// Bytes on their way from one end of a connection to the other.
#[derive(Debug, Default)]
pub(super) struct Pipe {
    /// Number of bytes that were written and not read. Below zero where a read overtakes the writer, which says so
    /// after its write.
    pub(super) unread: i64,
    /// No bytes come after those that are unread.
    is_closed: bool,
    has_reader: bool,
    has_writer: bool,
}

/// Bytes that a reader finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Found {
    /// So many were written and not read.
    Bytes(usize),
    Nothing,
    /// The writer is gone, and all its bytes were read.
    End,
    /// The other end does not take part: the system alone knows.
    Stranger,
}

/// Room that a writer finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Room {
    /// For so many bytes.
    Bytes(usize),
    Nothing,
    /// The other end does not take part, or is gone: the system alone knows.
    Stranger,
}

/// Number of bytes that can be on their way to a participant. Less than the room that systems have for a connection on
/// loopback, so that what a write takes depends on the reader alone.
pub(super) const WINDOW: i64 = 1 << 20;

impl ClockState {
    pub(super) fn begin_work(&mut self) {
        self.at_work += 1;
    }

    pub(super) fn end_work(&mut self) {
        self.at_work = self.at_work.saturating_sub(1);
        self.go_on();
    }

    /// True if this wait is one for which time should go on, and does not since somebody is at work.
    pub(super) fn is_kept_from(&self, number: u64) -> bool {
        let moves_time = |waiter: &Waiter| waiter.number == number && waiter.moves_time == MovesTime::Yes;
        self.at_work > 0 && self.waiters.iter().any(moves_time)
    }

    /// Begins a wait of a participant. Returns its number.
    pub(super) fn wait(
        &mut self,
        reason: Reason,
        until: Option<Duration>,
        parker: &Arc<Parker>,
        moves_time: MovesTime,
    ) -> u64 {
        self.last += 1;
        self.waiters.push(Waiter { number: self.last, reason, until, parker: Arc::clone(parker), moves_time });
        let number = self.last;
        self.end_work();
        number
    }

    /// Ends a wait that was begun, if nothing has ended it.
    pub(super) fn resume(&mut self, number: u64) {
        if let Some(place) = self.waiters.iter().position(|waiter| waiter.number == number) {
            self.wake(place);
        }
    }

    /// Ends all waits for this. Their threads are at work from now on.
    pub(super) fn signal(&mut self, reason: Reason) {
        while let Some(place) = self.waiters.iter().position(|waiter| waiter.reason == reason) {
            self.wake(place);
        }
    }

    fn wake(&mut self, place: usize) {
        self.at_work += 1;
        self.waiters.remove(place).parker.wake();
    }

    /// Goes on to the first time for which a thread waits, if none is at work. Of several, the one that began to wait
    /// first goes on alone: the next one follows when it waits again.
    fn go_on(&mut self) {
        if self.at_work > 0 || self.waiters.iter().all(|waiter| waiter.moves_time == MovesTime::No) {
            return;
        }
        let times =
            self.waiters.iter().enumerate().filter_map(|(place, waiter)| Some((waiter.until?, waiter.number, place)));
        if let Some((until, _, place)) = times.min() {
            self.now = self.now.max(until);
            self.wake(place);
        }
    }

    pub(super) fn pipe(&mut self, way: Way) -> &mut Pipe {
        self.pipes.entry(way).or_default()
    }

    /// Records that an end of a connection takes part.
    fn open(&mut self, local: SocketAddr, peer: SocketAddr) {
        self.pipe((local, peer)).has_writer = true;
        self.pipe((peer, local)).has_reader = true;
    }

    /// Records that an end of a connection that took part is gone.
    pub(super) fn drop_end(&mut self, local: SocketAddr, peer: SocketAddr) {
        self.pipe((local, peer)).has_writer = false;
        self.pipe((peer, local)).has_reader = false;
        for way in [(local, peer), (peer, local)] {
            self.close(way);
            if !(self.pipe(way).has_reader || self.pipe(way).has_writer) {
                self.pipes.remove(&way);
            }
        }
    }

    /// Records that no more bytes come in this direction.
    pub(super) fn close(&mut self, way: Way) {
        self.pipe(way).is_closed = true;
        self.signal(Reason::Readable(way));
        self.signal(Reason::Writable(way));
    }

    pub(super) fn wrote(&mut self, way: Way, count: usize) {
        self.pipe(way).unread += signed(count);
        self.signal(Reason::Readable(way));
    }

    pub(super) fn read(&mut self, way: Way, count: usize) {
        self.pipe(way).unread -= signed(count);
        self.signal(Reason::Writable(way));
    }

    pub(super) fn found(&mut self, way: Way) -> Found {
        let pipe = self.pipe(way);
        match pipe {
            Pipe { unread: 1.., .. } => Found::Bytes(usize::try_from(pipe.unread).unwrap_or(usize::MAX)),
            Pipe { is_closed: true, .. } => Found::End,
            Pipe { has_writer: true, .. } => Found::Nothing,
            _ => Found::Stranger,
        }
    }

    pub(super) fn room(&mut self, way: Way) -> Room {
        let pipe = self.pipe(way);
        if pipe.is_closed || !pipe.has_reader {
            return Room::Stranger;
        }
        match usize::try_from(WINDOW.saturating_sub(pipe.unread)) {
            Ok(count @ 1..) => Room::Bytes(count),
            _ => Room::Nothing,
        }
    }

    /// Records that no participant accepts connections there any more.
    pub(super) fn stop_listening(&mut self, address: SocketAddr) {
        self.listeners.remove(&address);
        self.accepted.retain(|(_, server)| !is_at(address, *server));
        let lost: Vec<_> = self.coming.iter().copied().filter(|(_, server)| is_at(address, *server)).collect();
        for (client, server) in lost {
            self.coming.remove(&(client, server));
            // Its end is on its way.
            self.drop_end(server, client);
            self.end_work();
        }
    }

    /// Records that an end of a connection that was made takes part. Where a participant accepts it, its other end
    /// takes part, too, and time stands still until it is accepted.
    pub(super) fn connected(&mut self, local: SocketAddr, peer: SocketAddr) {
        self.open(local, peer);
        // Its other end may be gone again by now.
        let is_accepted = self.accepted.remove(&(local, peer));
        if !is_accepted && self.listeners.iter().any(|listener| is_at(*listener, peer)) {
            self.open(peer, local);
            self.coming.insert((local, peer));
            self.begin_work();
        }
    }

    /// Records that an end of a connection that was accepted takes part. Its acceptor is at work from now on.
    pub(super) fn accepted(&mut self, local: SocketAddr, peer: SocketAddr) {
        self.open(local, peer);
        if !self.coming.remove(&(peer, local)) {
            self.accepted.insert((peer, local));
            self.begin_work();
        }
    }
}

/// True if an address is one of a listener, which may listen at all addresses of the machine.
fn is_at(listener: SocketAddr, address: SocketAddr) -> bool {
    listener.port() == address.port() && (listener.ip() == address.ip() || listener.ip().is_unspecified())
}

fn signed(count: usize) -> i64 {
    i64::try_from(count).unwrap_or(i64::MAX)
}
