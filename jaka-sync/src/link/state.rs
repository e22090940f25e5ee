//! What the threads of a connection share.

use std::collections::BTreeMap;
use std::sync::Arc;

use jaka_clock::Socket;
use jaka_proto::Request;
use jaka_proto::exchange::Exchange;

use super::halves::{Inbound, Outbound};
use super::outgoing::{Handle, Reservation};
use crate::Disconnect;

#[derive(Debug)]
pub(super) struct State {
    /// The socket; none once the connection was reset. A thread that reads or writes holds a clone only as long as it
    /// does, so that a reset closes the socket at once.
    pub(super) stream: Option<Arc<Socket>>,
    /// The requests, and their outcomes.
    pub(super) exchange: Exchange,
    /// The sending half; none while a thread sends.
    pub(super) outbound: Option<Box<Outbound>>,
    /// The receiving half; none while a thread reads.
    pub(super) inbound: Option<Box<Inbound>>,
    pub(super) mode: Mode,
    pub(super) broken: Option<Arc<Disconnect>>,
    /// How often commands have gone out that change what poses refer to.
    pub(super) frame_changes: u64,
    /// How many stops have gone out.
    pub(super) stops: u64,
    /// Reservations by their numbers, and the handles that have the connection for themselves.
    pub(super) reservations: Vec<(u64, Handle, Reservation)>,
    /// The last number of a handle or a reservation.
    pub(super) last_number: u64,
    /// Number of commands that may have changed something, of all handles and of each.
    pub(super) changes: u64,
    pub(super) changes_of: BTreeMap<Handle, u64>,
}

/// Whether the socket blocks.
#[derive(Debug, PartialEq, Eq, Clone, Copy)]
pub(super) enum Mode {
    Blocking,
    Nonblocking,
}

impl State {
    pub(super) fn new(stream: Socket, inbound: Inbound) -> Self {
        Self {
            stream: Some(Arc::new(stream)),
            exchange: Exchange::new(Request::bare_reply_command()),
            outbound: Some(Box::default()),
            inbound: Some(Box::new(inbound)),
            mode: Mode::Blocking,
            broken: None,
            frame_changes: 0,
            stops: 0,
            reservations: Vec::new(),
            last_number: 0,
            changes: 0,
            changes_of: BTreeMap::new(),
        }
    }
}
