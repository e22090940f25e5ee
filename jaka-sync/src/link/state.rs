//! State that the threads of a connection share.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_clock::{Clock, Socket};
use jaka_proto::Request;
use jaka_proto::exchange::{Exchange, Owner};

use super::Link;
use super::halves::{Inbound, Outbound};
use super::outgoing::{Handle, Outgoing};
use super::stops::Stops;
use crate::Disconnect;

/// Greatest number of outstanding requests beside a session, of all others together. What is queued in a controller
/// delays set-points and stops.
const MOST_BESIDE: usize = 8;

#[derive(Debug)]
pub(super) struct LinkState {
    /// The socket; `None` once the connection was reset. A thread holds a clone only while it reads or writes, so that
    /// a reset closes the socket at once.
    pub(super) stream: Option<Arc<Socket>>,
    /// Requests and their outcomes.
    pub(super) exchange: Exchange,
    /// The sending half; none while a thread sends.
    pub(super) outbound: Option<Box<Outbound>>,
    /// The receiving half; none while a thread reads.
    pub(super) inbound: Option<Box<Inbound>>,
    pub(super) mode: Mode,
    pub(super) broken: Option<Arc<Disconnect>>,
    /// Deadline of the newest command that the controller may lack. Nobody waits for it alone if it was posted or is
    /// polled for.
    pub(super) untried_until: Option<Instant>,
    /// Number of sent commands that change the frames or the tool to which poses refer.
    pub(super) frame_changes: u64,
    /// The last number of a handle, or of another owner.
    pub(super) last_number: u64,
    /// Number of commands that may have changed something, of all handles and of each.
    pub(super) changes: u64,
    pub(super) changes_of: BTreeMap<Handle, u64>,
}

/// Blocking mode of the socket.
#[derive(Debug, PartialEq, Eq, Clone, Copy)]
pub(super) enum Mode {
    Blocking,
    Nonblocking,
}

impl LinkState {
    pub(super) fn new(stream: Socket, inbound: Inbound) -> Self {
        Self {
            stream: Some(Arc::new(stream)),
            exchange: Exchange::new(Request::bare_reply_command()),
            outbound: Some(Box::default()),
            inbound: Some(Box::new(inbound)),
            mode: Mode::Blocking,
            broken: None,
            untried_until: None,
            frame_changes: 0,
            last_number: 0,
            changes: 0,
            changes_of: BTreeMap::new(),
        }
    }

    fn next_number(&mut self) -> u64 {
        self.last_number += 1;
        self.last_number
    }

    /// Number of these commands that may be entered now: a stop always; otherwise one at a time of those that the
    /// controller may lack, and beside a session, of all others together at most [`MOST_BESIDE`].
    pub(super) fn room(&self, outgoing: &Outgoing<'_>, stops: &Stops) -> usize {
        let room = match self.exchange.room(outgoing.support(), &outgoing.name) {
            0 => usize::from(self.untried_until.is_some_and(|deadline| deadline <= stops.clock().now())),
            room => room,
        };
        let leads = match stops.leaders() {
            Some(leads) if !outgoing.is_stop() && !leads.contains(&outgoing.owner) => leads,
            Some(_) | None => return room,
        };
        room.min(MOST_BESIDE.saturating_sub(self.exchange.outstanding_of(|owner| !leads.contains(&owner))))
    }

    /// Time for which a thread may wait for a reply that makes room, until it asks again.
    pub(super) fn until_room(&self, clock: &Clock) -> Duration {
        let until = self.untried_until.map(|deadline| deadline.saturating_duration_since(clock.now()));
        until.filter(|until| !until.is_zero()).unwrap_or(Duration::MAX)
    }

    /// Counts entered commands, unless they are queries.
    pub(super) fn count_changes(&mut self, outgoing: &Outgoing<'_>, count: u64) {
        if !outgoing.is_query() {
            self.changes += count;
            *self.changes_of.entry(outgoing.by).or_default() += count;
        }
        if outgoing.changes_frames() {
            self.frame_changes += count;
        }
    }
}

impl Link {
    /// Creates an owner of posted commands. [`forget_posted`](Self::forget_posted) ends its use.
    pub fn new_owner(&self) -> Owner {
        Owner(self.state.lock().next_number())
    }

    /// Creates another handle of the connection.
    pub(crate) fn new_handle(&self) -> Handle {
        Handle(self.state.lock().next_number())
    }

    /// Number of commands that other handles than this one have sent and that may have changed something.
    pub fn changes_but_of(&self, handle: Handle) -> u64 {
        let state = self.state.lock();
        state.changes - state.changes_of.get(&handle).copied().unwrap_or_default()
    }
}
