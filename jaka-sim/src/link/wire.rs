//! Connection with the faults of its link.

use std::io::{self, ErrorKind};
use std::net::Shutdown;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};
use std::thread;
use std::time::Duration;

use jaka_clock::{Socket, lock};
use socket2::SockRef;

use super::Links;
use super::queue::{End, Queue, SendStep};
use super::state::LinkStates;
use crate::clock;
use crate::fault::LinkFault;
use crate::{Direction, Port};

/// Connection with the faults of its link.
///
/// One thread writes at a time, and one reads through [`Inbound`](super::Inbound).
#[derive(Debug)]
pub(crate) struct Wire {
    socket: Socket,
    port: Port,
    links: Arc<Links>,
    /// Generations of the links at the time of connecting, by direction.
    generations: [u64; 2],
    closed: AtomicBool,
    /// Whether a thread writes to the socket past the queue.
    is_writing: AtomicBool,
    queue: Mutex<Queue>,
}

/// Returns the write timeout of a port, if there is one. The connection of a status reader holds packets of many
/// seconds.
fn write_timeout(port: Port) -> Option<Duration> {
    match port {
        Port::Command => None,
        Port::Status => Some(Duration::from_secs(1)),
    }
}

/// Milliseconds after which a write counts as blocked by its client.
const WRITE_ENDS_MS: u32 = 1000;

impl Wire {
    pub(crate) fn new(socket: Socket, port: Port, links: &Arc<Links>) -> io::Result<Arc<Self>> {
        socket.system().set_nodelay(true)?;
        socket.set_write_timeout(write_timeout(port))?;
        let generations = if links.are_used() {
            let state = links.state();
            Direction::ALL.map(|direction| state.link(port, direction).generation())
        } else {
            [0; 2]
        };
        let queue = Mutex::new(Queue::new(links.time()));
        let (closed, is_writing) = (AtomicBool::new(false), AtomicBool::new(false));
        Ok(Arc::new(Self { socket, port, links: Arc::clone(links), generations, closed, is_writing, queue }))
    }

    pub(crate) fn socket(&self) -> &Socket {
        &self.socket
    }

    pub(crate) fn links(&self) -> &Links {
        &self.links
    }

    /// Whether the controller has ended the connection. The client may not know yet.
    ///
    /// The thread that ends it locks the state of the links afterwards, and then signals. So a thread that holds the
    /// lock of the state during this check, and then waits with that lock, does not miss the signal.
    pub(super) fn is_closed(&self, _locked: &LinkStates) -> bool {
        self.closed.load(Ordering::SeqCst)
    }

    /// Returns the fault in a direction.
    pub(super) fn fault(&self, state: &LinkStates, direction: Direction) -> LinkFault {
        state.link(self.port, direction).fault(self.generations[direction as usize])
    }

    /// Writes bytes, or queues them if the link has a fault.
    pub(crate) fn send(self: &Arc<Self>, bytes: &[u8]) -> io::Result<()> {
        if !self.begins_to_write() && self.put_off(bytes)? {
            return Ok(());
        }
        let written = self.socket.write_all(bytes, write_timeout(self.port));
        self.is_writing.store(false, Ordering::SeqCst);
        written
    }

    /// Marks a write as begun; returns false if any link has had a fault. The mark precedes the second check of the
    /// links, so that a thread that ends the connection after a fault sees it.
    fn begins_to_write(&self) -> bool {
        if self.links.are_used() {
            return false;
        }
        self.is_writing.store(true, Ordering::SeqCst);
        let begins = !self.links.are_used();
        if !begins {
            self.is_writing.store(false, Ordering::SeqCst);
        }
        begins
    }

    /// Queues bytes; returns false if they can be written at once, and the write is marked as begun.
    fn put_off(self: &Arc<Self>, bytes: &[u8]) -> io::Result<bool> {
        let state = self.links.state();
        let fault = self.fault(&state, Direction::ToClient);
        let mut queue = lock(&self.queue);
        if queue.is_over() {
            return Err(ErrorKind::BrokenPipe.into());
        }
        match fault {
            LinkFault::None if queue.is_idle() => {
                self.is_writing.store(true, Ordering::SeqCst);
                return Ok(false);
            }
            LinkFault::Cut => return Ok(true),
            _ => {}
        }
        if !queue.push(bytes) {
            return Err(io::Error::new(ErrorKind::StorageFull, "too many bytes are pending on a link"));
        }
        drop(state);
        self.have_sender(queue)?;
        self.links.notify();
        Ok(true)
    }

    /// Starts a thread that sends the queued bytes. The state of the links must not be locked, since another connection
    /// may have to end for this.
    fn have_sender(self: &Arc<Self>, mut queue: MutexGuard<'_, Queue>) -> io::Result<()> {
        if !queue.has_sender {
            let this = Arc::clone(self);
            let thread = clock::spawn(self.links.time(), "link", move || this.send_all())?;
            queue.has_sender = true;
            drop(queue);
            self.links.add_sender((Arc::downgrade(self), thread));
        }
        Ok(())
    }

    /// Sends the queued bytes, up to the end of the connection.
    fn send_all(&self) {
        let mut state = self.links.state();
        loop {
            let step = lock(&self.queue).next(self.fault(&state, Direction::ToClient));
            match step {
                SendStep::Send(bytes) => {
                    drop(state);
                    if let Err(error) = self.socket.write_all(&bytes, write_timeout(self.port)) {
                        log::trace!(target: "jaka_sim", "client lost on its link: {error}");
                        lock(&self.queue).lose();
                    }
                    state = self.links.state();
                }
                SendStep::Wait(time) => state = self.links.wait(state, time),
                SendStep::End(End::Close) => return self.shut_down(Shutdown::Both),
                SendStep::End(End::Drop) => return,
            }
        }
    }

    /// Ends the connection; the client sees it when its link passes it. Wakes the thread that reads.
    pub(crate) fn close(self: &Arc<Self>) {
        self.closed.store(true, Ordering::SeqCst);
        if !self.end_later(End::Close) {
            self.shut_down(Shutdown::Both);
        }
        if self.links.are_used() {
            self.links.notify();
        }
    }

    /// Makes the last drop of the connection reset it, and not before its link passes that. The connection must not be
    /// closed before.
    pub(crate) fn reset_on_drop(self: &Arc<Self>) {
        if let Err(error) = SockRef::from(self.socket.system()).set_linger(Some(Duration::ZERO)) {
            log::trace!(target: "jaka_sim", "the connection cannot be reset: {error}");
        }
        self.closed.store(true, Ordering::SeqCst);
        self.end_later(End::Drop);
        if self.links.are_used() {
            self.links.notify();
        }
    }

    /// Leaves the end to the sending thread; returns false without one if nothing has to wait. Also returns false if a
    /// thread still writes past the queue: its client does not read, and only the end of the socket wakes it.
    fn end_later(self: &Arc<Self>, end: End) -> bool {
        if !self.links.are_used() {
            return false;
        }
        self.let_write_end();
        let state = self.links.state();
        let fault = self.fault(&state, Direction::ToClient);
        let mut queue = lock(&self.queue);
        let is_writing = self.is_writing.load(Ordering::SeqCst);
        if queue.is_aborted() || (!queue.has_sender && (is_writing || fault == LinkFault::None)) {
            return false;
        }
        queue.end(end);
        if is_writing {
            return false;
        }
        // This has no effect for the client.
        self.shut_down(Shutdown::Read);
        drop(state);
        self.have_sender(queue).is_ok()
    }

    /// Waits for the end of a write past the queue, unless its client does not read. The client can have the bytes long
    /// before the thread continues.
    fn let_write_end(&self) {
        // Counts sleeps instead of time, so that a pause of the whole process does not count.
        for _ in 0..WRITE_ENDS_MS {
            if !self.is_writing.load(Ordering::SeqCst) {
                return;
            }
            thread::sleep(Duration::from_millis(1));
        }
    }

    /// Ends the connection at once, regardless of link faults.
    pub(crate) fn abort(&self) {
        self.closed.store(true, Ordering::SeqCst);
        lock(&self.queue).abort();
        self.shut_down(Shutdown::Both);
        self.links.notify();
    }

    /// Ends the connection like a thread that locked the state of the links before the caller.
    #[cfg(test)]
    pub(super) fn close_before_others_lock(&self) {
        self.closed.store(true, Ordering::SeqCst);
        self.links.changed.notify_all();
    }

    fn shut_down(&self, how: Shutdown) {
        // An error means that it has already ended.
        self.socket.shutdown(how).ok();
    }
}

#[cfg(test)]
mod tests {
    use std::io::Read;
    use std::net::{TcpListener, TcpStream};

    use jaka_clock::Clock;

    use super::*;
    use crate::link_selector::LinkSelector;

    #[test]
    fn an_end_is_held_where_a_write_is_through_and_its_thread_has_not_gone_on() {
        let time = Clock::default();
        let links = Arc::new(Links::new(&time));
        let listener = TcpListener::bind("127.0.0.1:0").expect("loopback has ports");
        let mut client = TcpStream::connect(listener.local_addr().expect("it is bound")).expect("it listens");
        let (stream, peer) = listener.accept().expect("a client has connected");
        let (socket, _) = Socket::accepted(stream, peer, &time).expect("options can be set");
        let wire = Wire::new(socket, Port::Command, &links).expect("options can be set");
        wire.send(b"reply").expect("it is connected");
        client.read_exact(&mut [0; 5]).expect("the reply");
        links.set(LinkSelector::default(), LinkFault::Hold);

        wire.is_writing.store(true, Ordering::SeqCst);
        let writer = Arc::clone(&wire);
        let writer = thread::spawn(move || {
            thread::sleep(Duration::from_millis(20));
            writer.is_writing.store(false, Ordering::SeqCst);
        });
        wire.close();
        client.set_read_timeout(Some(Duration::from_millis(40))).expect("a timeout can be set");
        let held = client.read(&mut [0]).expect_err("neither bytes nor an end");
        assert!(matches!(held.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut), "{held}");
        writer.join().expect("no panic");
        links.set(LinkSelector::default(), LinkFault::None);
        client.set_read_timeout(None).expect("a timeout can be set");
        assert_eq!(client.read(&mut [0]).expect("the end"), 0);
    }
}
