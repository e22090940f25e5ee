//! The connection of a command client, and the way out of it.

use std::io::{self, Write};
use std::net::{Shutdown, TcpStream};
use std::sync::{Mutex, MutexGuard};

use crate::fault::Fault;
use crate::lock::lock;

/// The connection of a command client.
///
/// One thread reads from it; replies, and what the controller's owner sends, go through [`Line::way_out`].
#[derive(Debug)]
pub(crate) struct Line {
    stream: TcpStream,
    kept: Mutex<Kept>,
}

/// What has not gone out yet.
#[derive(Debug, Default)]
struct Kept {
    /// Replies that are held back.
    held: Vec<u8>,
    /// Replies that go out in one write with the next.
    joined: Vec<u8>,
}

/// Whether the connection goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Flow {
    Stay,
    Close,
    Reset,
}

impl Line {
    pub(super) fn new(stream: TcpStream) -> io::Result<Self> {
        stream.set_nodelay(true)?;
        Ok(Self { stream, kept: Mutex::default() })
    }

    pub(super) fn stream(&self) -> &TcpStream {
        &self.stream
    }

    /// Waits for whoever writes.
    pub(crate) fn way_out(&self) -> WayOut<'_> {
        WayOut { stream: &self.stream, kept: lock(&self.kept) }
    }

    /// Ends the connection, and wakes who reads from it or writes to it.
    pub(crate) fn close(&self) {
        // An error says that it has ended already.
        self.stream.shutdown(Shutdown::Both).ok();
    }
}

/// The right to write on a connection.
#[derive(Debug)]
pub(crate) struct WayOut<'l> {
    stream: &'l TcpStream,
    kept: MutexGuard<'l, Kept>,
}

impl WayOut<'_> {
    /// Sends a reply, with what is wrong with it.
    pub(super) fn send_reply(&mut self, reply: &str, fault: &Fault) -> Flow {
        self.try_send_reply(reply, fault).unwrap_or_else(|error| {
            log::trace!(target: "jaka_sim", "command client lost: {error}");
            Flow::Close
        })
    }

    fn try_send_reply(&mut self, reply: &str, fault: &Fault) -> io::Result<Flow> {
        let bytes = reply.as_bytes();
        match fault {
            Fault::Drop => {}
            Fault::Hold => self.hold(bytes),
            Fault::WithNext => self.kept.joined.extend_from_slice(bytes),
            Fault::Pieces(sizes) => self.send_pieces(bytes, sizes)?,
            Fault::Close => return Ok(Flow::Close),
            Fault::CloseAfter(count) => {
                self.send(&bytes[..bytes.len().min(*count)])?;
                return Ok(Flow::Close);
            }
            Fault::Reset => return Ok(Flow::Reset),
            _ => self.send(&fault.garble(reply))?,
        }
        Ok(Flow::Stay)
    }

    /// Sends the replies that are held back.
    pub(crate) fn release(&mut self) -> io::Result<()> {
        let held = std::mem::take(&mut self.kept.held);
        self.write(&held)
    }

    /// Writes bytes as they are.
    pub(crate) fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        if bytes.is_empty() {
            return Ok(());
        }
        log::trace!(target: "jaka_sim", "sends {}", String::from_utf8_lossy(bytes));
        self.stream.write_all(bytes)?;
        self.stream.flush()
    }

    fn hold(&mut self, bytes: &[u8]) {
        let kept = &mut *self.kept;
        kept.held.append(&mut kept.joined);
        kept.held.extend_from_slice(bytes);
    }

    /// Sends bytes after the replies that are held back, and together with those that wait for them.
    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        let all = self.join(bytes)?;
        self.write(&all)
    }

    fn send_pieces(&mut self, bytes: &[u8], sizes: &[usize]) -> io::Result<()> {
        let all = self.join(bytes)?;
        let mut rest = &*all;
        for size in sizes {
            let (piece, more) = rest.split_at(rest.len().min(*size));
            self.write(piece)?;
            rest = more;
        }
        self.write(rest)
    }

    fn join(&mut self, bytes: &[u8]) -> io::Result<Vec<u8>> {
        self.release()?;
        let mut all = std::mem::take(&mut self.kept.joined);
        all.extend_from_slice(bytes);
        Ok(all)
    }
}
