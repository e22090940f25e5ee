//! Requests that were sent and have no reply yet, and the attribution of replies to them.
//!
//! Controllers refuse a command that they do not have without its name. Such a refusal is the reply to the only
//! outstanding request. Of several, it is that to a *candidate*: a request of a command that this connection has not
//! seen answered by name, unless [every controller has it](Support::Everywhere). While there are more candidates than
//! refusals, the refusals are held: a candidate is not told that it was refused while it may have been accepted. A
//! reply with a name ends that, since replies come in order.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::collections::{HashMap, VecDeque};

use crate::envelope::Envelope;
use crate::messages::Role;

/// One request of an exchange. The default is one that no exchange gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub struct RequestId(u64);

/// Owner of requests, such as a pipeline, a servo session, or a handle with its calls. Whoever enters the requests
/// gives the numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Owner(pub u64);

/// Support of a command by controllers, which refuse a command that they lack without its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Support {
    /// Every controller has the command.
    Everywhere,
    /// A controller may lack the command until it has answered it by name.
    Uncertain,
}

impl Support {
    /// Support of a request by its role: every controller has stops, set-points and servo mode.
    pub fn of(role: Option<Role>) -> Self {
        match role {
            Some(Role::Stop | Role::StopAxis | Role::SetPoint | Role::ServoMode | Role::LeaveServoMode) => {
                Self::Everywhere
            }
            Some(Role::Start | Role::Pause | Role::Resume | Role::Output | Role::State) | None => Self::Uncertain,
        }
    }
}

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
    /// The names of outstanding requests, and those by which a request was answered.
    names: HashMap<Cow<'static, str>, Name>,
    /// Outstanding requests to which a refusal without a name may belong, in the order of their ids.
    candidates: VecDeque<RequestId>,
    /// Number of refusals without a name that belong to candidates, while it is not known to which.
    held: usize,
    count: u64,
    bare_reply: Option<&'static str>,
}

/// The requests of one name.
#[derive(Debug, Default)]
struct Name {
    outstanding: usize,
    /// A reply with this name has come.
    is_answered: bool,
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
        /// A reply names no command, and is not the refusal of the only outstanding request or of a command that the
        /// controller may lack.
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

    /// Number of requests of a command that may be sent now: one at a time of those that may be candidates, so that a
    /// refusal without a name has one candidate that is waited for.
    pub(super) fn room(&self, support: Support, command: &str) -> usize {
        if !self.may_lack(support, command) {
            return usize::MAX;
        }
        let newest = self.candidates.back().and_then(|newest| self.place(*newest));
        let is_awaited = newest.is_some_and(|place| self.outstanding[place].recipient != Recipient::Nobody);
        usize::from(!is_awaited)
    }

    /// True if the controller may lack the command.
    fn may_lack(&self, support: Support, command: &str) -> bool {
        support == Support::Uncertain && !self.names.get(command).is_some_and(|name| name.is_answered)
    }

    /// Enters a request that goes out next.
    pub(crate) fn push(
        &mut self,
        owner: Owner,
        support: Support,
        command: Cow<'static, str>,
        recipient: Recipient,
    ) -> RequestId {
        self.count += 1;
        let id = RequestId(self.count);
        let is_answered = if let Some(name) = self.names.get_mut(&command) {
            name.outstanding += 1;
            name.is_answered
        } else {
            self.names.insert(command.clone(), Name { outstanding: 1, ..Name::default() });
            false
        };
        if support == Support::Uncertain && !is_answered {
            self.candidates.push_back(id);
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
        self.candidates.retain(|candidate| *candidate != id);
        Ok(newest)
    }

    /// The request that is completed by the reply with this envelope, or without one; `None` for a refusal that is
    /// held. `lost` is called with each request whose reply will not come any more.
    pub(crate) fn complete_by(
        &mut self,
        envelope: Option<&Envelope<'_>>,
        lost: impl FnMut(SentRequest),
    ) -> Result<Option<SentRequest>, OutOfSync> {
        let Some(envelope) = envelope else {
            return self.complete(self.bare_reply.unwrap_or_default(), lost).map(Some);
        };
        match &envelope.command {
            Some(command) => self.complete(command, lost).map(Some),
            None if envelope.is_refusal() => self.complete_nameless(lost),
            None => Err(OutOfSync::Nameless),
        }
    }

    /// The oldest request of this name, which a reply has completed.
    fn complete(&mut self, command: &str, mut lost: impl FnMut(SentRequest)) -> Result<SentRequest, OutOfSync> {
        let unsolicited = || OutOfSync::Unsolicited { command: command.to_owned() };
        let name = self.names.get_mut(command).filter(|name| name.outstanding > 0).ok_or_else(unsolicited)?;
        let is_first = !std::mem::replace(&mut name.is_answered, true);
        // They belong to requests before this one.
        self.held = 0;
        while let Some(request) = self.outstanding.pop_front() {
            if self.candidates.front() == Some(&request.id) {
                self.candidates.pop_front();
            }
            let has_others = self.count_off(&request.command);
            if request.command != command {
                lost(request);
                continue;
            }
            if has_others && request.recipient == Recipient::Nobody {
                if let Some(name) = self.names.get_mut(command) {
                    name.doubtful = true;
                }
            }
            if is_first {
                let mut candidates = std::mem::take(&mut self.candidates);
                candidates.retain(|id| self.place(*id).is_some_and(|place| self.outstanding[place].command != command));
                self.candidates = candidates;
            }
            return Ok(request);
        }
        Err(unsolicited())
    }

    /// The request that is completed by a refusal without a name: the only outstanding one, or the newest candidate
    /// once there is a refusal for each. The older candidates were given up, as a rule.
    fn complete_nameless(&mut self, lost: impl FnMut(SentRequest)) -> Result<Option<SentRequest>, OutOfSync> {
        let completed = match (self.outstanding.len(), (self.held + 1).cmp(&self.candidates.len())) {
            (1, _) => self.outstanding.front().map(|only| only.id),
            (_, Ordering::Less) => {
                self.held += 1;
                return Ok(None);
            }
            (_, Ordering::Equal) => self.candidates.pop_back(),
            (_, Ordering::Greater) => None,
        };
        let completed = completed.ok_or(OutOfSync::Nameless)?;
        self.held = 0;
        let older = std::mem::take(&mut self.candidates);
        older.into_iter().filter(|id| *id != completed).filter_map(|id| self.remove(id)).for_each(lost);
        Ok(self.remove(completed))
    }

    /// Removes a request, which has had its reply. Those before it may have theirs yet. It is at the front as a rule.
    fn remove(&mut self, id: RequestId) -> Option<SentRequest> {
        let request = self.place(id).and_then(|place| self.outstanding.remove(place))?;
        self.count_off(&request.command);
        Some(request)
    }

    /// Removes a request from the count of its name; true if others are outstanding.
    fn count_off(&mut self, command: &str) -> bool {
        let Some(name) = self.names.get_mut(command) else { return false };
        name.outstanding -= 1;
        if name.outstanding > 0 {
            return true;
        }
        name.doubtful = false;
        if !name.is_answered {
            self.names.remove(command);
        }
        false
    }

    fn place(&self, id: RequestId) -> Option<usize> {
        self.outstanding.binary_search_by_key(&id, |request| request.id).ok()
    }

    /// A deadline has passed.
    pub(super) fn give_up(&mut self, id: RequestId) -> Result<(), OutOfSync> {
        let Some(place) = self.place(id) else { return Ok(()) };
        let command = &self.outstanding[place].command;
        if self.names.get(command).is_some_and(|name| name.doubtful) {
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
