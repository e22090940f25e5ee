//! Writes replies to a command client, with their faults, and keeps those that wait.

use std::collections::VecDeque;
use std::io;
use std::sync::{Arc, MutexGuard};
use std::time::{Duration, Instant};

use super::NextStep;
use crate::answer::Sequel;
use crate::fault::Fault;
use crate::link::Wire;

/// How many replies may be late, and how many bytes may be held back. Without a limit, a client could fill the memory.
const MAX_LATE: usize = 10_000;
const MAX_HELD: usize = 1 << 20;

/// How often to check whether the arm is at rest.
const REST_CHECK: Duration = Duration::from_millis(2);

/// Replies that have not been written yet.
#[derive(Debug, Default)]
pub(super) struct PendingReplies {
    /// Replies that are held back.
    held: Vec<u8>,
    /// Replies that go out in one write with the next.
    joined: Vec<u8>,
    /// Replies that are due later, and those after them.
    late: VecDeque<LateReply>,
}

/// A reply that is due later.
#[derive(Debug)]
struct LateReply {
    due: Due,
    reply: String,
    fault: Fault,
    sequel: Sequel,
}

/// When a late reply goes out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Due {
    At(Instant),
    /// When the arm is at rest, or at this controller time if one is given.
    AtRest(Option<Duration>),
    Never,
}

impl Due {
    fn after(time: Duration) -> Self {
        Instant::now().checked_add(time).map_or(Self::Never, Self::At)
    }
}

/// Writes on a connection, one thread at a time.
#[derive(Debug)]
pub(crate) struct ReplyWriter<'l> {
    wire: &'l Arc<Wire>,
    pending: MutexGuard<'l, PendingReplies>,
}

impl<'l> ReplyWriter<'l> {
    pub(super) fn new(wire: &'l Arc<Wire>, pending: MutexGuard<'l, PendingReplies>) -> Self {
        Self { wire, pending }
    }

    /// Sends a reply with its fault, or lets it wait.
    pub(crate) fn send_reply(&mut self, reply: &str, fault: Fault, sequel: Sequel) -> NextStep {
        let late = |due, fault| LateReply { due, reply: reply.to_owned(), fault, sequel };
        let next = match (fault, sequel) {
            (Fault::Delay(time), _) => self.put_off(late(Due::after(time), Fault::None)),
            (fault, Sequel::Rest(by)) => self.put_off(late(Due::AtRest(by), fault)),
            (fault, _) if !self.pending.late.is_empty() => self.put_off(late(Due::after(Duration::ZERO), fault)),
            (fault, _) => self.send_now(reply, &fault, sequel),
        };
        if self.pending.is_full() {
            log::trace!(target: "jaka_sim", "too many replies wait");
            return NextStep::Close;
        }
        next
    }

    /// Sends the replies that are due; `is_at_rest` says whether the arm is at rest, or the controller's time is the given one.
    pub(crate) fn send_due(&mut self, is_at_rest: impl Fn(Option<Duration>) -> bool) -> NextStep {
        let is_due = |late: &LateReply| match late.due {
            Due::At(time) => time <= Instant::now(),
            Due::AtRest(by) => is_at_rest(by),
            Due::Never => false,
        };
        while self.pending.late.front().is_some_and(is_due) {
            let Some(late) = self.pending.late.pop_front() else { break };
            let next = self.send_now(&late.reply, &late.fault, late.sequel);
            if next != NextStep::Continue {
                return next;
            }
        }
        NextStep::Continue
    }

    /// How long to wait until the next check whether a late reply is due; `None` if no time makes one due.
    pub(crate) fn wait_for_due(&self) -> Option<Duration> {
        match self.pending.late.front()?.due {
            Due::At(time) => Some(time.saturating_duration_since(Instant::now())),
            Due::AtRest(_) => Some(REST_CHECK),
            Due::Never => None,
        }
    }

    /// Sends the replies that are held back.
    pub(crate) fn release(&mut self) -> io::Result<()> {
        let held = std::mem::take(&mut self.pending.held);
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

    fn put_off(&mut self, late: LateReply) -> NextStep {
        self.pending.late.push_back(late);
        NextStep::Continue
    }

    fn send_now(&mut self, reply: &str, fault: &Fault, sequel: Sequel) -> NextStep {
        let next = self.try_send(reply, fault).unwrap_or_else(|error| {
            log::trace!(target: "jaka_sim", "command client lost: {error}");
            NextStep::Close
        });
        match (next, sequel) {
            // A reply that a fault holds back keeps the connection open.
            (NextStep::Continue, _) if !self.pending.held.is_empty() || !self.pending.joined.is_empty() => next,
            (NextStep::Continue, Sequel::SessionEnd) => NextStep::Close,
            (NextStep::Continue, Sequel::Shutdown) => NextStep::Shutdown,
            _ => next,
        }
    }

    fn try_send(&mut self, reply: &str, fault: &Fault) -> io::Result<NextStep> {
        let bytes = reply.as_bytes();
        match fault {
            Fault::Drop => {}
            Fault::Hold => self.pending.hold(bytes),
            Fault::WithNext => self.pending.joined.extend_from_slice(bytes),
            Fault::Pieces(sizes) => self.send_pieces(bytes, sizes)?,
            Fault::HalfOpen => return Ok(NextStep::HalfOpen),
            Fault::Close => return Ok(NextStep::Close),
            Fault::CloseAfter(count) => {
                self.send(&bytes[..bytes.len().min(*count)])?;
                return Ok(NextStep::Close);
            }
            Fault::Reset => return Ok(NextStep::Reset),
            Fault::Takeover => return Ok(NextStep::Takeover),
            _ => self.send(&fault.garble(reply))?,
        }
        Ok(NextStep::Continue)
    }

    /// Sends the replies that are held back, and then these bytes in one write with those that wait for them.
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
        let mut all = std::mem::take(&mut self.pending.joined);
        all.extend_from_slice(bytes);
        Ok(all)
    }
}

impl PendingReplies {
    fn hold(&mut self, bytes: &[u8]) {
        self.held.append(&mut self.joined);
        self.held.extend_from_slice(bytes);
    }

    fn is_full(&self) -> bool {
        self.late.len() > MAX_LATE || self.held.len() + self.joined.len() > MAX_HELD
    }
}
