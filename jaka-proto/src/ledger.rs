//! Whose reply is it: the queue of replies that a connection is owed.
//!
//! Replies carry no sequence number, only (usually) the name of their command, in the order of the requests. The ledger
//! keeps what was sent and not yet answered, and tells for each reply whom it belongs to. It does no I/O and knows no
//! time; a client tells it what it sent, what came, and whose deadline passed.

use std::borrow::Cow;
use std::collections::VecDeque;
use std::fmt;

use crate::{Envelope, Request};

/// One command that was sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Ticket(u64);

/// What a reply settles.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Arrival {
    /// The command that was answered.
    pub ticket: Ticket,
    /// Its `cmdName`.
    pub command: Cow<'static, str>,
    /// False where its caller has given up: the reply belongs to nobody.
    pub awaited: bool,
    /// Commands before it that somebody waits for and whose replies will not come any more.
    pub lost: Vec<Ticket>,
}

/// Why the replies of a connection can no longer be attributed.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Mistrust {
    /// A reply came to a command that was not sent, or that was answered already.
    Unasked {
        /// `cmdName` of the reply.
        command: String,
    },
    /// A reply names no command, and it is not the refusal of the only command that is owed one.
    Nameless,
    /// A command was not answered in time, after an earlier one of the same name was: the answer may have been its own.
    Ambiguous {
        /// `cmdName` of both.
        command: String,
    },
}

impl fmt::Display for Mistrust {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unasked { command } => write!(f, "a reply to `{command}` came that nobody is owed"),
            Self::Nameless => f.write_str("a reply came that names no command"),
            Self::Ambiguous { command } => {
                write!(f, "one of two replies to `{command}` is lost, and it cannot be told which")
            }
        }
    }
}

impl std::error::Error for Mistrust {}

/// The replies that a connection is owed, in the order of the requests.
#[derive(Debug, Default)]
pub struct Ledger {
    owed: VecDeque<Debt>,
    sent: u64,
}

#[derive(Debug)]
struct Debt {
    ticket: Ticket,
    command: Cow<'static, str>,
    awaited: bool,
    /// A reply of this name settled an older debt whose caller had given up; it may have been meant for this one.
    doubtful: bool,
}

impl Ledger {
    /// Nothing is owed.
    pub fn new() -> Self {
        Self::default()
    }

    /// How many replies are owed.
    pub fn outstanding(&self) -> usize {
        self.owed.len()
    }

    /// True if somebody still waits for this command.
    pub fn awaits(&self, ticket: Ticket) -> bool {
        self.owed.iter().any(|debt| debt.ticket == ticket && debt.awaited)
    }

    /// A command goes out.
    pub fn sent(&mut self, command: Cow<'static, str>) -> Ticket {
        self.sent += 1;
        let ticket = Ticket(self.sent);
        let doubtful = self.owed.iter().any(|debt| debt.doubtful && debt.command == command);
        self.owed.push_back(Debt { ticket, command, awaited: true, doubtful });
        ticket
    }

    /// A reply came that names `command`.
    ///
    /// # Errors
    /// Nobody is owed this reply.
    pub fn arrived(&mut self, command: &str) -> Result<Arrival, Mistrust> {
        let place = self.owed.iter().position(|debt| debt.command == command);
        let place = place.ok_or_else(|| Mistrust::Unasked { command: command.to_owned() })?;
        let lost = self.owed.drain(..place).filter(|debt| debt.awaited).map(|debt| debt.ticket).collect();
        let debt = self.owed.pop_front().ok_or(Mistrust::Nameless)?;
        if !debt.awaited {
            for other in self.owed.iter_mut().filter(|other| other.command == debt.command) {
                other.doubtful = true;
            }
        }
        Ok(Arrival { ticket: debt.ticket, command: debt.command, awaited: debt.awaited, lost })
    }

    /// A refusal came that names no command, as controllers send for a command they do not know.
    ///
    /// # Errors
    /// Not exactly one reply is owed, so it cannot be told whose it is.
    pub fn arrived_nameless(&mut self) -> Result<Arrival, Mistrust> {
        match self.owed.front() {
            Some(debt) if self.owed.len() == 1 => {
                let command = debt.command.clone();
                self.arrived(&command)
            }
            _ => Err(Mistrust::Nameless),
        }
    }

    /// A reply came, with this envelope; with none where it is the bare Python tuple of the one command that can be answered so.
    ///
    /// # Errors
    /// As [`arrived`](Self::arrived) and [`arrived_nameless`](Self::arrived_nameless); a reply without a name that is no
    /// refusal belongs to nobody.
    pub fn arrived_reply(&mut self, envelope: Option<&Envelope<'_>>) -> Result<Arrival, Mistrust> {
        let Some(envelope) = envelope else {
            let bare = Request::COMMANDS.iter().find(|info| info.bare_reply.is_some());
            return self.arrived(bare.map_or("", |info| info.name));
        };
        match &envelope.command {
            Some(command) => self.arrived(command),
            None if envelope.refusal().is_some() => self.arrived_nameless(),
            None => Err(Mistrust::Nameless),
        }
    }

    /// A caller gives up: its reply, when it comes, belongs to nobody.
    ///
    /// # Errors
    /// The reply may have come already and settled an older debt of the same name; whatever comes now may be one behind.
    pub fn give_up(&mut self, ticket: Ticket) -> Result<(), Mistrust> {
        match self.owed.iter_mut().find(|debt| debt.ticket == ticket) {
            Some(debt) if debt.doubtful => Err(Mistrust::Ambiguous { command: debt.command.clone().into_owned() }),
            Some(debt) => {
                debt.awaited = false;
                Ok(())
            }
            None => Ok(()),
        }
    }
}
