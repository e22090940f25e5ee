//! Requests that were sent and have no reply yet, and the attribution of replies to them.

use std::borrow::Cow;
use std::collections::VecDeque;

use super::Owner;
use crate::envelope::Envelope;

/// One request of an exchange. The default is one that no exchange gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct RequestId(u64);

/// A request that is outstanding.
#[derive(Debug)]
pub(crate) struct SentRequest {
    pub(crate) id: RequestId,
    pub(super) owner: Owner,
    pub(crate) command: Cow<'static, str>,
    pub(crate) recipient: Recipient,
}

/// Recipient of the reply to a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Recipient {
    /// The thread that waits for it.
    Waiter,
    /// The count of posted requests.
    Counted,
    /// None: the request was given up or abandoned.
    Nobody,
}

/// The requests that are outstanding, in the order in which they were sent.
#[derive(Debug, Default)]
pub(crate) struct SentRequests {
    /// In the order of their ids.
    outstanding: VecDeque<SentRequest>,
    /// The names of outstanding requests, each once.
    names: Vec<Name>,
    count: u64,
    bare_reply: Option<&'static str>,
}

/// The outstanding requests of one name.
#[derive(Debug)]
struct Name {
    command: Cow<'static, str>,
    outstanding: usize,
    /// A reply of this name completed a request that had been given up; it may have been meant for one that is
    /// outstanding now. As long as one of these is, this holds for those that are sent after it, too.
    doubtful: bool,
}

crate::worded! {
    /// Error for a connection with replies that cannot be attributed to its requests.
    #[derive(Debug, Clone, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum OutOfSync {
        /// A reply came to a command that was not sent, or that was answered already.
        Unsolicited {
            /// `cmdName` of the reply.
            command: String,
        } => "a reply to `{command}` came, but no such request is outstanding",
        /// A reply came to a request before any of it was sent.
        BeforeSent => "a reply came to a request before any of it was sent",
        /// A reply names no command, and is not the refusal of the only request that is outstanding.
        Nameless => "a reply came that names no command",
        /// A request was not answered in time, after a reply of its name was taken for that to an older request: it may
        /// have been its own.
        Ambiguous {
            /// `cmdName` of both.
            command: String,
        } => "one of two replies to `{command}` is lost, and it is not known which",
    }
}

impl SentRequests {
    /// No request is outstanding. `bare_reply` names the command that may be answered by a bare Python tuple.
    pub(crate) fn new(bare_reply: Option<&'static str>) -> Self {
        Self { bare_reply, ..Self::default() }
    }

    pub(super) fn outstanding(&self) -> usize {
        self.outstanding.len()
    }

    /// Enters a request that goes out next.
    pub(crate) fn push(&mut self, owner: Owner, command: Cow<'static, str>, recipient: Recipient) -> RequestId {
        self.count += 1;
        let id = RequestId(self.count);
        match self.names.iter_mut().find(|name| name.command == command) {
            Some(name) => name.outstanding += 1,
            None => self.names.push(Name { command: command.clone(), outstanding: 1, doubtful: false }),
        }
        self.outstanding.push_back(SentRequest { id, owner, command, recipient });
        id
    }

    /// Takes back the newest request.
    pub(super) fn withdraw(&mut self, id: RequestId) -> Result<SentRequest, OutOfSync> {
        if self.outstanding.back().is_none_or(|newest| newest.id != id) {
            return Err(OutOfSync::BeforeSent);
        }
        let newest = self.outstanding.pop_back().ok_or(OutOfSync::BeforeSent)?;
        self.count_off(&newest.command);
        Ok(newest)
    }

    /// The request that is completed by the reply with this envelope, or without one. `lost` is called with each
    /// request before it.
    pub(crate) fn complete_by(
        &mut self,
        envelope: Option<&Envelope<'_>>,
        lost: impl FnMut(SentRequest),
    ) -> Result<SentRequest, OutOfSync> {
        let Some(envelope) = envelope else {
            return self.complete(self.bare_reply.unwrap_or_default(), lost);
        };
        match &envelope.command {
            Some(command) => self.complete(command, lost),
            None if envelope.is_refusal() => self.complete_only(lost),
            None => Err(OutOfSync::Nameless),
        }
    }

    /// The oldest request of this name, which a reply has completed.
    fn complete(&mut self, command: &str, mut lost: impl FnMut(SentRequest)) -> Result<SentRequest, OutOfSync> {
        let unsolicited = || OutOfSync::Unsolicited { command: command.to_owned() };
        if !self.names.iter().any(|name| name.command == command) {
            return Err(unsolicited());
        }
        while let Some(request) = self.outstanding.pop_front() {
            let others = self.count_off(&request.command);
            if request.command == command {
                if let Some(name) = others.filter(|_| request.recipient == Recipient::Nobody) {
                    name.doubtful = true;
                }
                return Ok(request);
            }
            lost(request);
        }
        Err(unsolicited())
    }

    /// The only request that is outstanding: a refusal without a name, as controllers send for a command they do not
    /// know, is its reply.
    fn complete_only(&mut self, lost: impl FnMut(SentRequest)) -> Result<SentRequest, OutOfSync> {
        match self.outstanding.front() {
            Some(only) if self.outstanding.len() == 1 => {
                let command = only.command.clone();
                self.complete(&command, lost)
            }
            _ => Err(OutOfSync::Nameless),
        }
    }

    /// Removes a request from the count of its name; returns the rest.
    fn count_off(&mut self, command: &str) -> Option<&mut Name> {
        let place = self.names.iter().position(|name| name.command == command)?;
        self.names[place].outstanding -= 1;
        if self.names[place].outstanding == 0 {
            self.names.swap_remove(place);
            return None;
        }
        Some(&mut self.names[place])
    }

    fn place(&self, id: RequestId) -> Option<usize> {
        self.outstanding.binary_search_by_key(&id, |request| request.id).ok()
    }

    /// A deadline has passed.
    pub(super) fn give_up(&mut self, id: RequestId) -> Result<(), OutOfSync> {
        let Some(place) = self.place(id) else { return Ok(()) };
        let command = &self.outstanding[place].command;
        if self.names.iter().any(|name| name.doubtful && name.command == *command) {
            return Err(OutOfSync::Ambiguous { command: command.clone().into_owned() });
        }
        self.outstanding[place].recipient = Recipient::Nobody;
        Ok(())
    }

    /// A reply is not wanted any more.
    pub(super) fn abandon(&mut self, id: RequestId) {
        if let Some(place) = self.place(id) {
            self.outstanding[place].recipient = Recipient::Nobody;
        }
    }
}

impl std::error::Error for OutOfSync {}
