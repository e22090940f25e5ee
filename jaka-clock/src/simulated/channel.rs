//! End of a connection, with reads and writes in the time of a clock.
//!
//! Between two ends that take part, the clock counts the bytes on their way: the bytes of a read or a write, and their
//! time, depend on nothing else. The system carries the bytes, however long that takes it in real time. Of an end
//! that does not take part only the system knows.

use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpStream};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::state::{ClockState, Found, Reason, Room, Way};
use super::{SimulatedClock, Work};

/// End of a connection that takes part in the time of a clock. It knows which bytes are on their way if the other end
/// takes part, too.
///
/// Up to 1 MiB is on its way to an end that takes part and does not read; then a write waits. The stream blocks. All
/// its reads, writes and ends go through here. It is dropped before the channel.
#[derive(Debug)]
pub(crate) struct Channel {
    clock: SimulatedClock,
    local: SocketAddr,
    peer: SocketAddr,
    is_nonblocking: AtomicBool,
}

/// Longest wait of one call of the system, in real time.
const SLICE: Duration = Duration::from_millis(2);

/// Most that counts of one call of the system, which may return late: on a busy machine, or after the process was
/// stopped.
const LONGEST_SLICE: Duration = Duration::from_millis(10);

/// Real time within which the system carries bytes and makes the room that it has. It takes microseconds.
const TRANSPORT: Duration = Duration::from_secs(5);

impl SimulatedClock {
    /// Announces that a thread of this process accepts connections to this address, and makes sockets of them by
    /// [`Socket::accepted`](crate::Socket::accepted).
    pub fn listen(&self, address: SocketAddr) {
        self.lock().listeners.insert(address);
    }

    /// Announces that they are not accepted any more.
    pub fn stop_listening(&self, address: SocketAddr) {
        self.lock().stop_listening(address);
    }

    /// End of a connection for the program that has made it just now.
    pub(crate) fn connected(&self, stream: &TcpStream) -> io::Result<Channel> {
        let (local, peer) = (stream.local_addr()?, stream.peer_addr()?);
        self.take_part();
        self.lock().connected(local, peer);
        Channel::new(self, stream, local, peer)
    }

    /// End of a connection for the program that has accepted it from `peer` just now, and the program's work with it.
    pub(crate) fn accepted(&self, stream: &TcpStream, peer: SocketAddr) -> io::Result<(Channel, Work)> {
        let local = stream.local_addr()?;
        self.lock().accepted(local, peer);
        let work = Work::new(self);
        Ok((Channel::new(self, stream, local, peer)?, work))
    }
}

impl Channel {
    fn new(clock: &SimulatedClock, stream: &TcpStream, local: SocketAddr, peer: SocketAddr) -> io::Result<Self> {
        let channel = Self { clock: clock.clone(), local, peer, is_nonblocking: AtomicBool::new(false) };
        stream.set_read_timeout(Some(SLICE))?;
        stream.set_write_timeout(Some(SLICE))?;
        Ok(channel)
    }

    /// Sets whether reads and writes return at once in place of waiting.
    pub(crate) fn set_nonblocking(&self, is_nonblocking: bool) {
        self.is_nonblocking.store(is_nonblocking, Ordering::SeqCst);
    }

    /// Reads once, and waits for bytes for at most so long, if a time is given. It fails with [`ErrorKind::WouldBlock`]
    /// then.
    pub(crate) fn read(
        &self,
        mut stream: &TcpStream,
        space: &mut [u8],
        patience: Option<Duration>,
    ) -> io::Result<usize> {
        let until = self.clock.deadline(patience);
        let way = self.inbound();
        let count = loop {
            let mut state = self.clock.lock();
            match state.found(way) {
                Found::Bytes(count) => {
                    drop(state);
                    let end = count.min(space.len());
                    break self.on_its_way(count, || stream.read(&mut space[..end]))?;
                }
                Found::End => {
                    drop(state);
                    break self.on_its_way(0, || stream.read(space))?;
                }
                Found::Stranger => {
                    drop(state);
                    let is_stranger = |state: &mut ClockState| state.found(way) == Found::Stranger;
                    match self.ask_system(Reason::Readable(way), until, is_stranger, || stream.read(space)) {
                        Some(read) => break read?,
                        None => self.fail_if_over(&self.clock.lock(), until)?,
                    }
                }
                Found::Nothing => {
                    self.fail_if_over(&state, until)?;
                    self.clock.wait(state, Reason::Readable(way), until, || ());
                }
            }
        };
        self.clock.lock().read(way, count);
        Ok(count)
    }

    /// Number of bytes that a read would bring at least, without reading or waiting: 0 at the end.
    pub(crate) fn peek(&self, stream: &TcpStream) -> io::Result<usize> {
        let found = self.clock.lock().found(self.inbound());
        match found {
            Found::Nothing => Err(ErrorKind::WouldBlock.into()),
            Found::Bytes(count) => self.on_its_way(count, || stream.peek(&mut [0])),
            Found::End => self.on_its_way(0, || stream.peek(&mut [0])),
            Found::Stranger => stream.peek(&mut [0]),
        }
    }

    /// Writes once, and waits for room for at most so long, if a time is given. It fails with
    /// [`ErrorKind::WouldBlock`] then.
    pub(crate) fn write(&self, mut stream: &TcpStream, bytes: &[u8], patience: Option<Duration>) -> io::Result<usize> {
        let until = self.clock.deadline(patience);
        let way = self.outbound();
        let count = loop {
            let mut state = self.clock.lock();
            let room = state.room(way);
            match room {
                Room::Bytes(count) => {
                    drop(state);
                    let written = write_into_room(stream, &bytes[..count.min(bytes.len())])?;
                    if written > 0 || bytes.is_empty() {
                        break written;
                    }
                    // The system has less room than the clock knows of: it gets some when the other end reads.
                    let mut state = self.clock.lock();
                    self.fail_if_over(&state, until)?;
                    if state.room(way) == room {
                        self.clock.wait(state, Reason::Writable(way), until, || ());
                    }
                }
                Room::Nothing => {
                    self.fail_if_over(&state, until)?;
                    self.clock.wait(state, Reason::Writable(way), until, || ());
                }
                Room::Stranger => {
                    drop(state);
                    let is_stranger = |state: &mut ClockState| state.room(way) == Room::Stranger;
                    match self.ask_system(Reason::Writable(way), until, is_stranger, || stream.write(bytes)) {
                        Some(written) => break written?,
                        None => self.fail_if_over(&self.clock.lock(), until)?,
                    }
                }
            }
        };
        self.clock.lock().wrote(way, count);
        Ok(count)
    }

    /// Writes all.
    pub(crate) fn write_all(&self, stream: &TcpStream, bytes: &[u8], patience: Option<Duration>) -> io::Result<()> {
        let mut rest = bytes;
        while !rest.is_empty() {
            match self.write(stream, rest, patience)? {
                0 => return Err(ErrorKind::WriteZero.into()),
                count => rest = &rest[count..],
            }
        }
        Ok(())
    }

    /// Ends the connection in a direction or both, and wakes the threads that wait for it.
    pub(crate) fn shutdown(&self, stream: &TcpStream, how: Shutdown) -> io::Result<()> {
        let done = stream.shutdown(how);
        let mut state = self.clock.lock();
        if how != Shutdown::Write {
            state.close(self.inbound());
        }
        if how != Shutdown::Read {
            state.close(self.outbound());
        }
        done
    }

    fn inbound(&self) -> Way {
        (self.peer, self.local)
    }

    fn outbound(&self) -> Way {
        (self.local, self.peer)
    }

    fn is_nonblocking(&self) -> bool {
        self.is_nonblocking.load(Ordering::SeqCst)
    }

    /// Fails if a wait until then is over, or none is wanted.
    fn fail_if_over(&self, state: &ClockState, until: Option<Duration>) -> io::Result<()> {
        let is_over = self.is_nonblocking() || until.is_some_and(|until| until <= state.now);
        if is_over { Err(ErrorKind::WouldBlock.into()) } else { Ok(()) }
    }

    /// Reads what the other end has written, so many bytes, or its end: the system has it, or is about to.
    fn on_its_way(&self, count: usize, read: impl FnMut() -> io::Result<usize>) -> io::Result<usize> {
        transported(read).unwrap_or_else(|| {
            log::warn!(target: "jaka_clock", "what was written on a connection has not come for {TRANSPORT:?}");
            // It is waited for no longer.
            self.clock.lock().read(self.inbound(), count);
            Err(ErrorKind::WouldBlock.into())
        })
    }

    /// Asks the system for bytes or room that only it knows, at first while time stands still; `None` if the time is
    /// over, or the clock knows of them now.
    fn ask_system<T>(
        &self,
        reason: Reason,
        until: Option<Duration>,
        is_stranger: impl Fn(&mut ClockState) -> bool,
        mut attempt: impl FnMut() -> io::Result<T>,
    ) -> Option<io::Result<T>> {
        let mut ask = || match attempt() {
            Err(error) if is_time_up(&error) => (!is_stranger(&mut self.clock.lock())).then_some(None),
            done => Some(Some(done)),
        };
        let grace = if self.is_nonblocking() { Duration::ZERO } else { self.clock.grace() };
        let answer = for_long(grace, &mut ask);
        answer.or_else(|| if self.is_nonblocking() { None } else { self.clock.poll(reason, until, ask) })?
    }
}

impl Drop for Channel {
    fn drop(&mut self) {
        self.clock.lock().drop_end(self.local, self.peer);
    }
}

/// Writes into room that the system has, or is about to have; less where it has less.
fn write_into_room(mut stream: &TcpStream, bytes: &[u8]) -> io::Result<usize> {
    let mut written = 0;
    while written < bytes.len() {
        match transported(|| stream.write(&bytes[written..])) {
            Some(Ok(count)) if count > 0 => written += count,
            // The next write has the error again.
            Some(Err(error)) if written == 0 => return Err(error),
            _ => break,
        }
    }
    Ok(written)
}

/// Outcome of a call of the system that is about to have one.
fn transported<T>(mut call: impl FnMut() -> io::Result<T>) -> Option<io::Result<T>> {
    for_long(TRANSPORT, || Some(call()).filter(|outcome| !outcome.as_ref().is_err_and(is_time_up)))
}

/// Attempts once, and again until so much time has passed, of which a stop of the process or a late return takes
/// little.
fn for_long<T>(time: Duration, mut attempt: impl FnMut() -> Option<T>) -> Option<T> {
    let mut left = time;
    loop {
        let since = Instant::now();
        let found = attempt();
        left = left.saturating_sub(since.elapsed().min(LONGEST_SLICE));
        if found.is_some() || left.is_zero() {
            return found;
        }
    }
}

/// True if a call only waited. Systems differ in what they call it, and interrupt a call when the process is
/// stopped.
fn is_time_up(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted)
}
