//! A connection, with whatever is wrong with its link.

use std::io::{self, ErrorKind};
use std::net::Shutdown;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};
use std::time::Duration;

use jaka_clock::{Socket, lock};
use socket2::SockRef;

use super::Links;
use super::queue::{End, Queue, SendStep};
use super::state::LinkStates;
use crate::clock;
use crate::fault::LinkFault;
use crate::{Direction, Port};

/// A connection, with whatever is wrong with its link.
///
/// One thread writes at a time, and one reads: by [`Inbound`](super::Inbound).
#[derive(Debug)]
pub(crate) struct Wire {
    socket: Socket,
    port: Port,
    links: Arc<Links>,
    /// What the links had gone through when this was connected, by direction.
    generations: [u64; 2],
    closed: AtomicBool,
    /// True while a thread writes to the socket past the queue.
    is_writing: AtomicBool,
    queue: Mutex<Queue>,
}

/// Time that a write of a port may take, if that is limited. The connection of a status reader holds packets of many
/// seconds.
fn write_timeout(port: Port) -> Option<Duration> {
    match port {
        Port::Command => None,
        Port::Status => Some(Duration::from_secs(1)),
    }
}

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
    /// The thread that ends it locks the state of the links afterwards, and then gives the signal. So a thread that has
    /// the state locked while it asks, and waits by that lock, does not miss the signal.
    pub(super) fn is_closed(&self, _locked: &LinkStates) -> bool {
        self.closed.load(Ordering::SeqCst)
    }

    /// What is wrong in a direction.
    pub(super) fn fault(&self, state: &LinkStates, direction: Direction) -> LinkFault {
        state.link(self.port, direction).fault(self.generations[direction as usize])
    }

    /// Writes bytes, or lets them wait where something is wrong.
    pub(crate) fn send(self: &Arc<Self>, bytes: &[u8]) -> io::Result<()> {
        if !self.begins_to_write() && self.put_off(bytes)? {
            return Ok(());
        }
        let written = self.socket.write_all(bytes, write_timeout(self.port));
        self.is_writing.store(false, Ordering::SeqCst);
        written
    }

    /// Marks a write as begun; false where the links have been used. The mark comes before the look at the links: a
    /// thread that ends the connection by links that have been used sees it.
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

    /// Lets bytes wait; false where they can be written at once, and the write is marked as begun.
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

    /// Has a thread send what waits. The state of the links must not be locked: another connection may have to end for this.
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

    /// Sends what waits, to the end of the connection.
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

    /// Ends the connection; the client sees it when its link lets it pass. Wakes the thread that reads.
    pub(crate) fn close(self: &Arc<Self>) {
        self.closed.store(true, Ordering::SeqCst);
        if !self.end_later(End::Close) {
            self.shut_down(Shutdown::Both);
        }
        if self.links.are_used() {
            self.links.notify();
        }
    }

    /// Has the connection reset when the last one drops it, and not before its link lets that pass. It must not be closed
    /// before.
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

    /// Leaves the end to the thread that sends; false where there is none, and nothing to wait for. Also false while a
    /// thread writes past the queue: it may wait for a client that does not read, and only the end of the socket wakes
    /// it.
    fn end_later(self: &Arc<Self>, end: End) -> bool {
        if !self.links.are_used() {
            return false;
        }
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
        // To the client, this is as if nothing had been done.
        self.shut_down(Shutdown::Read);
        drop(state);
        self.have_sender(queue).is_ok()
    }

    /// Ends the connection at once, whatever is wrong with its link.
    pub(crate) fn abort(&self) {
        self.closed.store(true, Ordering::SeqCst);
        lock(&self.queue).abort();
        self.shut_down(Shutdown::Both);
        self.links.notify();
    }

    /// Ends the connection as a thread does that locked the state of the links before the caller did.
    #[cfg(test)]
    pub(super) fn close_before_others_lock(&self) {
        self.closed.store(true, Ordering::SeqCst);
        self.links.changed.notify_all();
    }

    fn shut_down(&self, how: Shutdown) {
        // An error says that it has ended already.
        self.socket.shutdown(how).ok();
    }
}
