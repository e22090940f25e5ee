//! Writer of replies to a command client, with their faults and the pending replies.

use std::collections::VecDeque;
use std::io;
use std::sync::{Arc, MutexGuard};
use std::time::{Duration, Instant};

use jaka_clock::Clock;

use super::NextStep;
use crate::answer::Sequel;
use crate::fault::Delivery;
use crate::link::Wire;
use crate::world::Wait;

/// Greatest number of delayed replies, and of bytes held back. Without a limit, a client could fill the memory.
const MAX_LATE: usize = 10_000;
const MAX_HELD: usize = 1 << 20;

/// Interval of the checks whether the wait for the arm is over.
const WAIT_CHECK: Duration = Duration::from_millis(2);

/// Replies not written yet.
#[derive(Debug, Default)]
pub(super) struct PendingReplies {
    /// Replies held back.
    held: Vec<u8>,
    /// Replies for one write with the next reply.
    joined: Vec<u8>,
    /// Delayed replies, and those after them.
    late: VecDeque<LateReply>,
}

/// Delayed reply.
#[derive(Debug)]
struct LateReply {
    due: Due,
    delivery: Delivery,
    sequel: Sequel,
}

/// Due time of a delayed reply.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Due {
    At(Instant),
    After(Wait),
    Never,
}

impl Due {
    fn after(delay: Duration, time: &Clock) -> Self {
        time.now().checked_add(delay).map_or(Self::Never, Self::At)
    }
}

/// Writer on a connection, for one thread at a time.
#[derive(Debug)]
pub(crate) struct ReplyWriter<'l> {
    wire: &'l Arc<Wire>,
    pending: MutexGuard<'l, PendingReplies>,
}

impl<'l> ReplyWriter<'l> {
    pub(super) fn new(wire: &'l Arc<Wire>, pending: MutexGuard<'l, PendingReplies>) -> Self {
        Self { wire, pending }
    }

    fn time(&self) -> &Clock {
        self.wire.links().time()
    }

    /// Sends or delays a reply.
    pub(crate) fn send_reply(&mut self, delivery: Delivery, sequel: Sequel) -> NextStep {
        let due = match (&delivery, sequel) {
            (Delivery::Later(time, _), _) => Some(Due::after(*time, self.time())),
            (_, Sequel::Wait(wait)) => Some(Due::After(wait)),
            _ => (!self.pending.late.is_empty()).then(|| Due::after(Duration::ZERO, self.time())),
        };
        let next = match due {
            Some(due) => {
                self.pending.late.push_back(LateReply { due, delivery, sequel });
                NextStep::Continue
            }
            None => self.send_now(delivery, sequel),
        };
        if self.pending.is_full() {
            log::trace!(target: "jaka_sim", "too many replies are pending");
            return NextStep::Close;
        }
        next
    }

    /// Sends the replies that are due; `is_over` returns whether a wait is over.
    pub(crate) fn send_due(&mut self, is_over: impl Fn(Wait) -> bool) -> NextStep {
        let now = self.time().now();
        let is_due = |late: &LateReply| match late.due {
            Due::At(time) => time <= now,
            Due::After(wait) => is_over(wait),
            Due::Never => false,
        };
        while self.pending.late.front().is_some_and(is_due) {
            let Some(late) = self.pending.late.pop_front() else { break };
            let next = self.send_now(late.delivery, late.sequel);
            if next != NextStep::Continue {
                return next;
            }
        }
        NextStep::Continue
    }

    /// Returns the time until the next check for a due reply; `None` if time makes none due.
    pub(crate) fn wait_for_due(&self) -> Option<Duration> {
        match self.pending.late.front()?.due {
            Due::At(time) => Some(self.time().left(time)),
            Due::After(_) => Some(WAIT_CHECK),
            Due::Never => None,
        }
    }

    /// Sends the replies held back.
    pub(crate) fn release(&mut self) -> io::Result<()> {
        let held = std::mem::take(&mut self.pending.held);
        self.write(&held)
    }

    /// Writes bytes unchanged.
    pub(crate) fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        if bytes.is_empty() {
            return Ok(());
        }
        log::trace!(target: "jaka_sim", "sends {}", String::from_utf8_lossy(bytes));
        self.wire.send(bytes)
    }

    fn send_now(&mut self, delivery: Delivery, sequel: Sequel) -> NextStep {
        let next = self.deliver(delivery).unwrap_or_else(|error| {
            log::trace!(target: "jaka_sim", "command client lost: {error}");
            NextStep::Close
        });
        match (next, sequel) {
            // A reply held back by a fault keeps the connection open.
            (NextStep::Continue, _) if !self.pending.held.is_empty() || !self.pending.joined.is_empty() => next,
            (NextStep::Continue, Sequel::SessionEnd) => NextStep::Close,
            (NextStep::Continue, Sequel::Shutdown) => NextStep::Shutdown,
            _ => next,
        }
    }

    fn deliver(&mut self, delivery: Delivery) -> io::Result<NextStep> {
        match delivery {
            Delivery::Nothing => {}
            Delivery::Write(bytes, sizes) => self.send(&bytes, &sizes)?,
            // The delay has passed.
            Delivery::Later(_, bytes) => self.send(&bytes, &[])?,
            Delivery::Hold(bytes) => self.pending.hold(&bytes),
            Delivery::WithNext(bytes) => self.pending.joined.extend_from_slice(&bytes),
            Delivery::WriteAndClose(bytes) => {
                self.send(&bytes, &[])?;
                return Ok(NextStep::Close);
            }
            Delivery::HalfOpen => return Ok(NextStep::HalfOpen),
            Delivery::Close => return Ok(NextStep::Close),
            Delivery::Reset => return Ok(NextStep::Reset),
            Delivery::Takeover => return Ok(NextStep::Takeover),
        }
        Ok(NextStep::Continue)
    }

    /// Sends the replies held back, and then these bytes together with the joined replies, in pieces of these sizes and
    /// the rest as the last piece.
    fn send(&mut self, bytes: &[u8], sizes: &[usize]) -> io::Result<()> {
        self.release()?;
        let mut all = std::mem::take(&mut self.pending.joined);
        all.extend_from_slice(bytes);
        let mut rest = &*all;
        for size in sizes {
            let (piece, more) = rest.split_at(rest.len().min(*size));
            self.write(piece)?;
            rest = more;
        }
        self.write(rest)
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
