//! Whose reply is it: the queue of replies that a connection is owed.
//!
//! Replies carry no sequence number, only (usually) the name of their command, in the order of the requests. The ledger
//! keeps what was sent and not yet answered, and tells for each reply whom it belongs to. It does no I/O and knows no
//! time; a client tells it what it sent, what came, and whose deadline passed.

use std::borrow::Cow;
use std::collections::VecDeque;
use std::fmt;

use crate::text::Visible;
use crate::{Envelope, Request};

/// One command that was sent. The default is none that any ledger gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
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
    /// A reply came to a command of which nothing had been sent.
    Unsent,
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
            Self::Unasked { command } => write!(f, "a reply to `{}` came that nobody is owed", Visible(command)),
            Self::Unsent => f.write_str("a reply came to a command of which nothing had been sent"),
            Self::Nameless => f.write_str("a reply came that names no command"),
            Self::Ambiguous { command } => {
                write!(f, "one of two replies to `{command}` is lost, and it cannot be told which")
            }
        }
    }
}

impl std::error::Error for Mistrust {}

/// The replies that a connection is owed, in the order of the requests.
///
/// Each of its steps takes a time that does not grow with the number of replies that are owed.
#[derive(Debug, Default)]
pub struct Ledger {
    /// In the order of their tickets.
    owed: VecDeque<Debt>,
    /// The names of what is owed, each once.
    names: Vec<Name>,
    sent: u64,
}

#[derive(Debug)]
struct Debt {
    ticket: Ticket,
    command: Cow<'static, str>,
    awaited: bool,
}

/// The commands of one name that are owed a reply.
#[derive(Debug)]
struct Name {
    command: Cow<'static, str>,
    owed: usize,
    /// A reply of this name settled a debt whose caller had given up; it may have been meant for one of those that are owed now. As
    /// long as one of them is owed, this holds for those that are sent behind it, too.
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
        self.place(ticket).is_some_and(|place| self.owed[place].awaited)
    }

    /// A command goes out.
    pub fn sent(&mut self, command: Cow<'static, str>) -> Ticket {
        self.sent += 1;
        let ticket = Ticket(self.sent);
        match self.names.iter_mut().find(|name| name.command == command) {
            Some(name) => name.owed += 1,
            None => self.names.push(Name { command: command.clone(), owed: 1, doubtful: false }),
        }
        self.owed.push_back(Debt { ticket, command, awaited: true });
        ticket
    }

    /// The command that was entered last did not go out after all, not even in part.
    ///
    /// # Errors
    /// A reply to it has come already, which nobody was owed; or it is not the last.
    pub fn withdraw(&mut self, ticket: Ticket) -> Result<(), Mistrust> {
        if self.owed.back().is_none_or(|debt| debt.ticket != ticket) {
            return Err(Mistrust::Unsent);
        }
        if let Some(debt) = self.owed.pop_back() {
            self.settled(&debt.command);
        }
        Ok(())
    }

    /// A reply came that names `command`.
    ///
    /// # Errors
    /// Nobody is owed this reply.
    pub fn arrived(&mut self, command: &str) -> Result<Arrival, Mistrust> {
        if !self.names.iter().any(|name| name.command == command) {
            return Err(Mistrust::Unasked { command: command.to_owned() });
        }
        let mut lost = Vec::new();
        while let Some(debt) = self.owed.pop_front() {
            let doubtful = self.settled(&debt.command);
            if debt.command == command {
                if let Some(name) = doubtful.filter(|_| !debt.awaited) {
                    name.doubtful = true;
                }
                return Ok(Arrival { ticket: debt.ticket, command: debt.command, awaited: debt.awaited, lost });
            }
            if debt.awaited {
                lost.push(debt.ticket);
            }
        }
        Err(Mistrust::Unasked { command: command.to_owned() })
    }

    /// Takes a debt off the account of its name; what is left of that account.
    fn settled(&mut self, command: &str) -> Option<&mut Name> {
        let place = self.names.iter().position(|name| name.command == command)?;
        self.names[place].owed -= 1;
        if self.names[place].owed == 0 {
            self.names.swap_remove(place);
            return None;
        }
        Some(&mut self.names[place])
    }

    fn place(&self, ticket: Ticket) -> Option<usize> {
        self.owed.binary_search_by_key(&ticket, |debt| debt.ticket).ok()
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

    /// A caller's deadline has passed: its reply, when it comes, belongs to nobody.
    ///
    /// # Errors
    /// The reply may have come already and settled an older debt of the same name; whatever comes now may be one behind.
    pub fn give_up(&mut self, ticket: Ticket) -> Result<(), Mistrust> {
        let Some(place) = self.place(ticket) else { return Ok(()) };
        let command = &self.owed[place].command;
        if self.names.iter().any(|name| name.doubtful && name.command == *command) {
            return Err(Mistrust::Ambiguous { command: command.clone().into_owned() });
        }
        self.owed[place].awaited = false;
        Ok(())
    }

    /// A caller does not want its reply any more, though there was time for it: when it comes, it belongs to nobody.
    ///
    /// This is no evidence that a reply is lost. What is doubtful remains so for those whose deadline passes.
    pub fn abandon(&mut self, ticket: Ticket) {
        if let Some(place) = self.place(ticket) {
            self.owed[place].awaited = false;
        }
    }
}
