//! The way out of a connection, and what waits on it.

use std::collections::VecDeque;
use std::io;
use std::sync::{Arc, MutexGuard};
use std::time::{Duration, Instant};

use super::line::Flow;
use crate::answer::Sequel;
use crate::fault::Fault;
use crate::link::Wire;

/// How many replies may be late, and how many bytes may be held back. Without a limit, a client could fill the memory.
const MAX_LATE: usize = 10_000;
const MAX_HELD: usize = 1 << 20;

/// How often to look whether the arm is at rest.
const REST_CHECK: Duration = Duration::from_millis(2);

/// What has not gone out yet.
#[derive(Debug, Default)]
pub(super) struct Kept {
    /// Replies that are held back.
    held: Vec<u8>,
    /// Replies that go out in one write with the next.
    joined: Vec<u8>,
    /// Replies that come later, and those behind them.
    late: VecDeque<Late>,
}

/// A reply that comes later.
#[derive(Debug)]
struct Late {
    due: Due,
    reply: String,
    fault: Fault,
    sequel: Sequel,
}

/// When a late reply goes out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Due {
    At(Instant),
    /// When the arm is at rest, or the controller's time is this, if it is given.
    AtRest(Option<Duration>),
    Never,
}

impl Due {
    fn after(time: Duration) -> Self {
        Instant::now().checked_add(time).map_or(Self::Never, Self::At)
    }
}

/// The right to write on a connection.
#[derive(Debug)]
pub(crate) struct WayOut<'l> {
    wire: &'l Arc<Wire>,
    kept: MutexGuard<'l, Kept>,
}

impl<'l> WayOut<'l> {
    pub(super) fn new(wire: &'l Arc<Wire>, kept: MutexGuard<'l, Kept>) -> Self {
        Self { wire, kept }
    }

    /// Sends a reply, with what is wrong with it, or lets it wait.
    pub(super) fn send_reply(&mut self, reply: &str, fault: Fault, sequel: Sequel) -> Flow {
        let late = |due, fault| Late { due, reply: reply.to_owned(), fault, sequel };
        let flow = match (fault, sequel) {
            (Fault::Delay(time), _) => self.put_off(late(Due::after(time), Fault::None)),
            (fault, Sequel::Rest(by)) => self.put_off(late(Due::AtRest(by), fault)),
            (fault, _) if !self.kept.late.is_empty() => self.put_off(late(Due::after(Duration::ZERO), fault)),
            (fault, _) => self.send_now(reply, &fault, sequel),
        };
        if self.kept.is_full() {
            log::trace!(target: "jaka_sim", "too many replies wait");
            return Flow::Close;
        }
        flow
    }

    /// Sends the replies whose time has come; `is_at_rest` says whether the arm is, or the controller's time has come.
    pub(super) fn send_due(&mut self, is_at_rest: impl Fn(Option<Duration>) -> bool) -> Flow {
        let is_due = |late: &Late| match late.due {
            Due::At(time) => time <= Instant::now(),
            Due::AtRest(by) => is_at_rest(by),
            Due::Never => false,
        };
        while self.kept.late.front().is_some_and(is_due) {
            let Some(late) = self.kept.late.pop_front() else { break };
            let flow = self.send_now(&late.reply, &late.fault, late.sequel);
            if flow != Flow::Stay {
                return flow;
            }
        }
        Flow::Stay
    }

    /// How long to wait before looking again whether a late reply is due; `None` where no time makes one so.
    pub(super) fn wait_for_due(&self) -> Option<Duration> {
        match self.kept.late.front()?.due {
            Due::At(time) => Some(time.saturating_duration_since(Instant::now())),
            Due::AtRest(_) => Some(REST_CHECK),
            Due::Never => None,
        }
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
        self.wire.send(bytes)
    }

    fn put_off(&mut self, late: Late) -> Flow {
        self.kept.late.push_back(late);
        Flow::Stay
    }

    fn send_now(&mut self, reply: &str, fault: &Fault, sequel: Sequel) -> Flow {
        let flow = self.try_send(reply, fault).unwrap_or_else(|error| {
            log::trace!(target: "jaka_sim", "command client lost: {error}");
            Flow::Close
        });
        match (flow, sequel) {
            // A reply that a fault holds back keeps the connection.
            (Flow::Stay, _) if !self.kept.held.is_empty() || !self.kept.joined.is_empty() => flow,
            (Flow::Stay, Sequel::SessionEnd) => Flow::Close,
            (Flow::Stay, Sequel::Shutdown) => Flow::Shutdown,
            _ => flow,
        }
    }

    fn try_send(&mut self, reply: &str, fault: &Fault) -> io::Result<Flow> {
        let bytes = reply.as_bytes();
        match fault {
            Fault::Drop => {}
            Fault::Hold => self.kept.hold(bytes),
            Fault::WithNext => self.kept.joined.extend_from_slice(bytes),
            Fault::Pieces(sizes) => self.send_pieces(bytes, sizes)?,
            Fault::HalfOpen => return Ok(Flow::HalfOpen),
            Fault::Close => return Ok(Flow::Close),
            Fault::CloseAfter(count) => {
                self.send(&bytes[..bytes.len().min(*count)])?;
                return Ok(Flow::Close);
            }
            Fault::Reset => return Ok(Flow::Reset),
            Fault::Takeover => return Ok(Flow::Takeover),
            _ => self.send(&fault.garble(reply))?,
        }
        Ok(Flow::Stay)
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

impl Kept {
    fn hold(&mut self, bytes: &[u8]) {
        self.held.append(&mut self.joined);
        self.held.extend_from_slice(bytes);
    }

    fn is_full(&self) -> bool {
        self.late.len() > MAX_LATE || self.held.len() + self.joined.len() > MAX_HELD
    }
}
