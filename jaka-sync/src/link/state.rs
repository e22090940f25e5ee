//! What the threads of a connection share.

use std::net::TcpStream;
use std::sync::Arc;

use jaka_proto::{Arrival, Ledger, Mistrust, Ticket};

use super::answer::{Answer, Caller, lost};
use super::inbound::Inbound;
use super::outbound::Outbound;
use super::posted::Posted;
use crate::Disconnect;
use crate::reply::Reply;

#[derive(Debug)]
pub(super) struct State {
    /// The socket; none once the connection was reset. Whoever reads or writes holds a clone only as long as it does, so that
    /// a reset closes the socket at once.
    pub(super) stream: Option<Arc<TcpStream>>,
    pub(super) ledger: Ledger,
    /// The sending half; none while a thread sends.
    pub(super) outbound: Option<Box<Outbound>>,
    /// The receiving half; none while a thread reads.
    pub(super) inbound: Option<Box<Inbound>>,
    pub(super) mode: Mode,
    pub(super) sleepers: usize,
    /// Commands whose replies are counted.
    pub(super) posted: Posted,
    /// What became of commands that are waited for, as far as their waiters have not looked.
    aside: Vec<(Ticket, Answer)>,
    pub(super) broken: Option<Arc<Disconnect>>,
    /// How often commands have gone out that change what poses refer to.
    pub(super) frame_changes: u64,
}

/// Whether the socket blocks.
#[derive(Debug, PartialEq, Eq, Clone, Copy)]
pub(super) enum Mode {
    Blocking,
    Nonblocking,
}

impl State {
    pub(super) fn new(stream: TcpStream, inbound: Inbound) -> Self {
        Self {
            stream: Some(Arc::new(stream)),
            ledger: Ledger::new(),
            outbound: Some(Box::default()),
            inbound: Some(Box::new(inbound)),
            mode: Mode::Blocking,
            sleepers: 0,
            posted: Posted::default(),
            aside: Vec::new(),
            broken: None,
            frame_changes: 0,
        }
    }

    /// What was put aside for a command.
    pub(super) fn take(&mut self, ticket: Ticket) -> Option<Answer> {
        let place = self.aside.iter().position(|(owner, _)| *owner == ticket)?;
        Some(self.aside.swap_remove(place).1)
    }

    /// Settles the debt that a reply belongs to: gives it to the caller, counts it, or puts it aside for another thread.
    pub(super) fn settle(&mut self, text: &str, caller: &mut Caller<'_, '_>) -> Result<(), Disconnect> {
        let reply = caller.read(text).map_err(Disconnect::NotJson)?;
        let arrival = self.arrived(&reply).map_err(Disconnect::Mistrust)?;
        for ticket in &arrival.lost {
            if caller.is(*ticket) {
                caller.take(Answer::Lost);
            } else if !self.posted.fail(*ticket, lost) {
                self.aside.push((*ticket, Answer::Lost));
            }
        }
        if !arrival.awaited {
            log::debug!(target: "jaka_sync::wire", "late reply to `{}` dropped", arrival.command);
        } else if caller.is(arrival.ticket) {
            caller.answered(text, reply);
        } else if let Some(command) = self.posted.settle(arrival.ticket) {
            self.posted.answered(reply.accepted(command));
        } else {
            self.aside.push((arrival.ticket, Answer::Reply(text.to_owned())));
        }
        Ok(())
    }

    /// Whose reply this is.
    fn arrived(&mut self, reply: &Reply<'_>) -> Result<Arrival, Mistrust> {
        self.ledger.arrived_reply(match reply {
            Reply::Json(envelope) => Some(envelope),
            Reply::Bare => None,
        })
    }
}
