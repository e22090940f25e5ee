//! One end of a connection, whose reads and writes wait in the time of a clock.

use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpStream};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::state::{Found, Reason, Way};
use crate::{SimulatedClock, Work};

/// One end of a connection that takes part in the time of a clock: it knows which bytes are on their way, if the other end takes part, too.
///
/// The socket stays its owner's, and blocks. All its reads, writes and ends go through here. It is dropped after the socket.
#[derive(Debug)]
pub struct Channel {
    clock: SimulatedClock,
    local: SocketAddr,
    peer: SocketAddr,
    is_nonblocking: AtomicBool,
}

/// How long bytes may take that were written.
const ARRIVAL: Duration = Duration::from_secs(1);

/// How long the system may take to make room for bytes, before this waits for the other end to read.
const ROOM: Duration = Duration::from_millis(5);

/// How long to look at a connection whose other end does not take part, before this looks at the clock again.
const SLICE: Duration = Duration::from_millis(2);

/// How long time stands still, in real time, for bytes of an end that does not take part.
const GRACE: Duration = Duration::from_millis(100);

impl SimulatedClock {
    /// Connections to this address are accepted by a thread of this process, which then calls [`accepted`](Self::accepted).
    pub fn listen(&self, address: SocketAddr) {
        self.lock().listeners.insert(address);
    }

    /// They are not accepted any more.
    pub fn stop_listening(&self, address: SocketAddr) {
        self.lock().stop_listening(address);
    }

    /// The end of the program that has made a connection. Call it before anything else.
    ///
    /// # Errors
    /// The socket's options cannot be set, or its addresses are not known.
    pub fn connected(&self, stream: &TcpStream) -> io::Result<Channel> {
        let (local, peer) = (stream.local_addr()?, stream.peer_addr()?);
        self.take_part();
        self.lock().connected(local, peer);
        Channel::new(self, stream, local, peer)
    }

    /// The end of the program that has accepted a connection from `peer`, and that it is at work with it. Call it before anything else.
    ///
    /// # Errors
    /// The socket's options cannot be set, or its address is not known.
    pub fn accepted(&self, stream: &TcpStream, peer: SocketAddr) -> io::Result<(Channel, Work)> {
        let local = stream.local_addr()?;
        self.lock().accepted(local, peer);
        let work = Work::new(self);
        Ok((Channel::new(self, stream, local, peer)?, work))
    }
}

/// How long, in real time, until the system is asked again for room that it is about to give.
const MOMENT: Duration = Duration::from_micros(20);

impl Channel {
    /// Of an end that takes part already.
    fn new(clock: &SimulatedClock, stream: &TcpStream, local: SocketAddr, peer: SocketAddr) -> io::Result<Self> {
        let channel = Self { clock: clock.clone(), local, peer, is_nonblocking: AtomicBool::new(false) };
        stream.set_read_timeout(Some(ARRIVAL))?;
        stream.set_write_timeout(Some(ROOM))?;
        Ok(channel)
    }

    /// Has reads and writes wait, or not.
    pub fn set_nonblocking(&self, is_nonblocking: bool) {
        self.is_nonblocking.store(is_nonblocking, Ordering::SeqCst);
    }

    /// Reads once, and waits for bytes for at most so long, if a time is given.
    ///
    /// # Errors
    /// [`ErrorKind::WouldBlock`] if nothing has come in time; what the socket reports.
    pub fn read(&self, stream: &TcpStream, space: &mut [u8], patience: Option<Duration>) -> io::Result<usize> {
        let until = self.clock.deadline(patience);
        let way = self.inbound();
        loop {
            let mut state = self.clock.lock();
            match state.found(way) {
                Found::Something => {
                    let announced = state.pipe(way).unread;
                    drop(state);
                    return self.read_announced(stream, space, announced);
                }
                Found::Stranger => {
                    drop(state);
                    return self.read_from_stranger(stream, space, until);
                }
                Found::Nothing if self.is_nonblocking() || until.is_some_and(|until| until <= state.now) => {
                    return Err(ErrorKind::WouldBlock.into());
                }
                Found::Nothing => self.clock.wait(state, Reason::Readable(way), until, || ()),
            }
        }
    }

    /// Writes once, and waits for room for at most so long, if a time is given.
    ///
    /// # Errors
    /// [`ErrorKind::WouldBlock`] if there was no room in time; what the socket reports.
    pub fn write(&self, mut stream: &TcpStream, bytes: &[u8], patience: Option<Duration>) -> io::Result<usize> {
        let until = self.clock.deadline(patience);
        let way = self.outbound();
        loop {
            let reads = self.clock.lock().pipe(way).reads;
            match stream.write(bytes) {
                Ok(count) => {
                    self.clock.lock().wrote(way, count);
                    return Ok(count);
                }
                Err(error) if !is_time_up(&error) => return Err(error),
                Err(_) => {}
            }
            let mut state = self.clock.lock();
            if self.is_nonblocking() || until.is_some_and(|until| until <= state.now) {
                return Err(ErrorKind::WouldBlock.into());
            }
            if !state.pipe(way).has_reader {
                drop(state);
                return self.write_to_stranger(stream, bytes, until);
            }
            if state.pipe(way).unread == 0 {
                // All has been read: the system gives the room in a moment, which takes no time of the clock.
                drop(state);
                std::thread::sleep(MOMENT);
            } else if state.pipe(way).reads == reads {
                self.clock.wait(state, Reason::Writable(way), until, || ());
            }
        }
    }

    /// Writes all.
    ///
    /// # Errors
    /// [`ErrorKind::WouldBlock`] if there was no room for so long, if a time is given; what the socket reports.
    pub fn write_all(&self, stream: &TcpStream, bytes: &[u8], patience: Option<Duration>) -> io::Result<()> {
        let mut rest = bytes;
        while !rest.is_empty() {
            match self.write(stream, rest, patience) {
                Ok(0) => return Err(ErrorKind::WriteZero.into()),
                Ok(count) => rest = &rest[count..],
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }

    /// Ends the connection in a direction or both, and wakes who waits for it.
    ///
    /// # Errors
    /// What the socket reports: it has ended already.
    pub fn shutdown(&self, stream: &TcpStream, how: Shutdown) -> io::Result<()> {
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

    /// Reads what the other end has written: the system has it, or is about to.
    fn read_announced(&self, stream: &TcpStream, space: &mut [u8], announced: i64) -> io::Result<usize> {
        let read = self.read_once(stream, space);
        if read.as_ref().is_err_and(is_time_up) {
            // It was lost on the way: it is waited for no longer.
            self.clock.lock().pipe(self.inbound()).unread -= announced;
        }
        read
    }

    fn read_once(&self, mut stream: &TcpStream, space: &mut [u8]) -> io::Result<usize> {
        let read = stream.read(space);
        if let Ok(count) = &read {
            self.clock.lock().read(self.inbound(), *count);
        }
        read
    }

    fn read_from_stranger(&self, stream: &TcpStream, space: &mut [u8], until: Option<Duration>) -> io::Result<usize> {
        let way = self.inbound();
        let read = with_slices(stream, || {
            let mut attempt = || {
                let read = self.read_once(stream, space);
                if read.as_ref().is_err_and(is_time_up) { None } else { Some(read) }
            };
            let since = Instant::now();
            let grace = if self.is_nonblocking() { Duration::ZERO } else { GRACE };
            loop {
                if let Some(read) = attempt() {
                    return Some(read);
                }
                let knows_it_now = self.clock.lock().found(way) != Found::Stranger;
                if knows_it_now || self.is_nonblocking() {
                    return None;
                }
                if since.elapsed() >= grace {
                    return self.clock.poll(Reason::Readable(way), until, attempt);
                }
            }
        })?;
        read.unwrap_or_else(|| Err(ErrorKind::WouldBlock.into()))
    }

    fn write_to_stranger(&self, mut stream: &TcpStream, bytes: &[u8], until: Option<Duration>) -> io::Result<usize> {
        let written = self.clock.poll(Reason::Writable(self.outbound()), until, || {
            let written = stream.write(bytes);
            if written.as_ref().is_err_and(is_time_up) { None } else { Some(written) }
        });
        if let Some(Ok(count)) = &written {
            self.clock.lock().wrote(self.outbound(), *count);
        }
        written.unwrap_or_else(|| Err(ErrorKind::WouldBlock.into()))
    }
}

impl Drop for Channel {
    fn drop(&mut self) {
        self.clock.lock().drop_end(self.local, self.peer);
    }
}

/// Systems differ in what they call it.
fn is_time_up(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut)
}

/// Reads that end soon.
fn with_slices<T>(stream: &TcpStream, act: impl FnOnce() -> T) -> io::Result<T> {
    stream.set_read_timeout(Some(SLICE))?;
    let done = act();
    stream.set_read_timeout(Some(ARRIVAL))?;
    Ok(done)
}
