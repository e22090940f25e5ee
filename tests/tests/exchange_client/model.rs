//! The simplest account of an exchange and of whose each reply is, in lists that are searched from the front.
//!
//! The account follows the rules of an exchange, which knows names alone. It also knows for which request each reply
//! was written: so it can tell when a rule gives a reply to another request, and it claims that this happens only where
//! names cannot tell.

use std::cmp::Ordering;
use std::collections::HashSet;

use jaka_sync::Command;
use jaka_sync::program::{PauseProgram, StopProgram};
use jaka_sync::proto::exchange::{OutOfSync, Support};

use crate::server::{Form, Reply};

/// The command that stop handles send.
pub(crate) const STOP: &str = StopProgram::INFO.name;
/// The other command of which several may be outstanding in a pipeline.
pub(crate) const PAUSE: &str = PauseProgram::INFO.name;
/// The command whose reply is a bare tuple, without a name.
pub(crate) const TUPLE: &str = "get_extio_status";
/// Names of commands. Few, so that equal ones meet.
pub(crate) const NAMES: [&str; 6] = ["query", PAUSE, STOP, TUPLE, "second", "third"];

/// Support of a command by controllers.
pub(crate) fn support(name: &str) -> Support {
    if name == STOP { Support::Everywhere } else { Support::Uncertain }
}

/// Number of owners that post.
pub(crate) const OWNERS: usize = 2;

/// Recipient of a reply.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Recipient {
    /// The thread that waits for it.
    Waiter,
    /// The count of posted requests of an owner.
    Count(usize),
    /// None: the request was given up or abandoned.
    Nobody,
}

/// Outcome of a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Got {
    /// The acceptance that was written for the request with this number.
    Accepted(u32),
    Refused(u32),
    Lost,
    TimedOut,
}

/// A request that is outstanding.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Request {
    pub(crate) number: u32,
    pub(crate) name: &'static str,
    pub(crate) recipient: Recipient,
    /// A reply that completed an older request of the name may have been this one's.
    is_doubtful: bool,
}

/// The exchange as it should be.
#[derive(Debug, Default)]
pub(crate) struct Model {
    pub(crate) outstanding: Vec<Request>,
    /// Outcomes that waiters have not taken.
    pub(crate) outcomes: Vec<(u32, Got)>,
    /// Outcomes of the posted requests of each owner, since they were last taken: how many were accepted, and the
    /// others.
    posted: [(u64, Vec<(&'static str, Got)>); OWNERS],
    /// Requests whose own replies have neither come nor been lost.
    on_their_way: HashSet<u32>,
    /// Requests whose own replies have come.
    delivered: HashSet<u32>,
    /// Names of which a reply was lost, or was held and so given to no request.
    lost: HashSet<&'static str>,
    /// Names by which a request was answered.
    answered: HashSet<&'static str>,
    /// Number of refusals without a name that are held.
    held: usize,
    /// Names of which two replies were waited for at once.
    several: HashSet<&'static str>,
    /// Names of which a reply was discarded.
    discarded: HashSet<&'static str>,
    /// Names whose replies may be mistaken, since a surplus one was taken for that of an outstanding request.
    mistakable: HashSet<&'static str>,
}

impl Model {
    /// Places of the requests with this recipient.
    pub(crate) fn places(&self, recipient: Recipient) -> impl Iterator<Item = usize> {
        (0..self.outstanding.len()).filter(move |place| self.outstanding[*place].recipient == recipient)
    }

    /// True while a reply of this name is waited for.
    pub(crate) fn waits_for(&self, name: &str) -> bool {
        self.outstanding.iter().any(|request| request.name == name && request.recipient != Recipient::Nobody)
    }

    /// The oldest posted request of an owner that is outstanding.
    pub(crate) fn oldest_posted(&self, owner: usize) -> Option<Request> {
        self.places(Recipient::Count(owner)).next().map(|place| self.outstanding[place])
    }

    /// True for a request to which a refusal without a name may belong.
    fn is_candidate(&self, name: &str) -> bool {
        support(name) == Support::Uncertain && !self.answered.contains(name)
    }

    /// Number of requests of a name that may be sent now.
    pub(crate) fn room(&self, name: &str) -> usize {
        let is_waited_for = |request: &Request| request.recipient != Recipient::Nobody;
        let mut candidates = self.outstanding.iter().filter(|request| self.is_candidate(request.name));
        if self.is_candidate(name) { usize::from(!candidates.any(is_waited_for)) } else { usize::MAX }
    }

    /// A request goes out.
    pub(crate) fn send(&mut self, number: u32, name: &'static str, recipient: Recipient) {
        if self.waits_for(name) {
            self.several.insert(name);
        }
        let is_doubtful = self.outstanding.iter().any(|request| request.name == name && request.is_doubtful);
        self.outstanding.push(Request { number, name, recipient, is_doubtful });
        self.on_their_way.insert(number);
    }

    /// The newest request did not go out after all.
    pub(crate) fn withdraw(&mut self, number: u32) -> Result<(), OutOfSync> {
        if self.outstanding.last().is_none_or(|newest| newest.number != number) {
            return Err(OutOfSync::BeforeSent);
        }
        let newest = self.outstanding.pop().expect("it is outstanding");
        if !self.on_their_way.remove(&number) && self.held > 0 {
            // The refusal of what was not sent may be taken for that of another.
            self.mistake_candidates();
            self.mistakable.insert(newest.name);
        }
        Ok(())
    }

    /// The reply to a request is lost.
    pub(crate) fn lose(&mut self, number: u32, name: &'static str) {
        self.on_their_way.remove(&number);
        self.lost.insert(name);
    }

    /// A reply comes: the request that it completes, and the recipient; none for a refusal that is held.
    pub(crate) fn arrive(&mut self, reply: Reply) -> Result<Option<(u32, Recipient)>, OutOfSync> {
        let Reply { number, name, form } = reply;
        let is_own = self.on_their_way.remove(&number);
        let place = match form {
            Form::Nameless if self.outstanding.len() == 1 => 0,
            Form::Nameless => return self.arrive_nameless(reply, is_own),
            Form::Anonymous => return Err(OutOfSync::Nameless),
            Form::Accepted | Form::Refused => {
                let Some(place) = self.outstanding.iter().position(|request| request.name == name) else {
                    assert!(!is_own || self.is_mistakable(name), "{reply:?} belongs to no request: {self:?}");
                    return Err(OutOfSync::Unsolicited { command: name.to_owned() });
                };
                self.answered.insert(name);
                place
            }
        };
        self.held = 0;
        if is_own {
            self.delivered.insert(number);
        }
        let taker = self.outstanding[place];
        let is_spread = taker.number != number && [name, taker.name].iter().any(|name| self.mistakable.contains(name));
        if !is_own || is_spread {
            // A mistake spreads to what is written off by it.
            self.mistakable.extend(self.outstanding[..=place].iter().map(|request| request.name));
        }
        for request in self.outstanding.drain(..=place).take(place).collect::<Vec<_>>() {
            self.write_off(request);
        }
        if taker.recipient == Recipient::Nobody {
            self.discarded.insert(taker.name);
            for request in self.outstanding.iter_mut().filter(|request| request.name == taker.name) {
                request.is_doubtful = true;
            }
        } else {
            let is_right = number == taker.number || self.is_mistakable(taker.name);
            assert!(is_right, "{reply:?} is given to {taker:?}: {self:?}");
        }
        let is_accepted = form == Form::Accepted;
        self.end(taker, if is_accepted { Got::Accepted(number) } else { Got::Refused(number) });
        Ok(Some((taker.number, taker.recipient)))
    }

    /// A refusal without a name comes while several requests are outstanding. The newest candidate is refused once all
    /// are, and those before it were given up.
    fn arrive_nameless(&mut self, reply: Reply, is_own: bool) -> Result<Option<(u32, Recipient)>, OutOfSync> {
        let Reply { number, name, .. } = reply;
        let candidates: Vec<_> =
            self.outstanding.iter().filter(|request| self.is_candidate(request.name)).copied().collect();
        if !is_own || self.mistakable.contains(name) {
            self.mistake_candidates();
        }
        match (self.held + 1).cmp(&candidates.len()) {
            Ordering::Less => {
                self.held += 1;
                self.lost.insert(name);
                return Ok(None);
            }
            Ordering::Equal => {}
            Ordering::Greater => {
                assert!(!is_own || self.is_mistakable(name), "{reply:?} belongs to no request: {self:?}");
                return Err(OutOfSync::Nameless);
            }
        }
        self.held = 0;
        self.outstanding.retain(|request| candidates.iter().all(|candidate| candidate.number != request.number));
        let (taker, older) = candidates.split_last().expect("there is one for each refusal");
        assert!(older.iter().all(|request| request.recipient == Recipient::Nobody), "they were given up: {self:?}");
        let is_right = number == taker.number || self.mistakable.contains(taker.name);
        assert!(is_right, "{reply:?} is given to {taker:?}: {self:?}");
        self.delivered.insert(number);
        self.end(*taker, Got::Refused(number));
        Ok(Some((taker.number, taker.recipient)))
    }

    /// A surplus refusal without a name, or one that comes after another mistake, may be taken for that of each
    /// candidate.
    fn mistake_candidates(&mut self) {
        let names = self.outstanding.iter().map(|request| request.name);
        self.mistakable.extend(names.filter(|name| self.is_candidate(name)).collect::<Vec<_>>());
    }

    /// A later request was answered.
    fn write_off(&mut self, request: Request) {
        let is_lost = self.lost.contains(request.name) || self.is_mistakable(request.name);
        assert!(is_lost, "the reply to {request:?} is still to come: {self:?}");
        self.end(request, Got::Lost);
    }

    /// The deadline of a request passes.
    pub(crate) fn give_up(&mut self, place: usize) -> Result<(), OutOfSync> {
        let request = self.outstanding[place];
        if request.is_doubtful {
            assert!(self.discarded.contains(request.name), "nothing makes {request:?} doubtful: {self:?}");
            return Err(OutOfSync::Ambiguous { command: request.name.to_owned() });
        }
        let has_come = self.delivered.contains(&request.number);
        assert!(!has_come || self.is_mistakable(request.name), "the reply to {request:?} is not missed: {self:?}");
        self.end(request, Got::TimedOut);
        self.outstanding[place].recipient = Recipient::Nobody;
        Ok(())
    }

    /// The reply to a request is not wanted any more.
    pub(crate) fn abandon(&mut self, number: u32) {
        self.outcomes.retain(|(other, _)| *other != number);
        for request in self.outstanding.iter_mut().filter(|request| request.number == number) {
            request.recipient = Recipient::Nobody;
        }
    }

    /// Abandons the posted requests of an owner that are outstanding, and says how many those were.
    pub(crate) fn abandon_posted(&mut self, owner: usize) -> u64 {
        let posted: Vec<_> = self.places(Recipient::Count(owner)).map(|place| self.outstanding[place].number).collect();
        for number in &posted {
            self.abandon(*number);
        }
        posted.len() as u64
    }

    /// Takes the outcome of a request, if it has one.
    pub(crate) fn take(&mut self, number: u32) -> Option<Got> {
        let place = self.outcomes.iter().position(|(other, _)| *other == number)?;
        Some(self.outcomes.remove(place).1)
    }

    /// Takes the first failure of the posted requests of an owner.
    pub(crate) fn tell_posted(&mut self, owner: usize) -> Option<Got> {
        let failed = &mut self.posted[owner].1;
        (!failed.is_empty()).then(|| failed.remove(0).1)
    }

    /// Takes the outcomes of the posted requests of an owner.
    pub(crate) fn take_posted(&mut self, owner: usize) -> (u64, Vec<(&'static str, Got)>) {
        std::mem::take(&mut self.posted[owner])
    }

    /// All that was on its way has come: nobody waits without a reason.
    pub(crate) fn assert_nothing_is_forgotten(&self) {
        let is_excused = |name| self.lost.contains(name) || self.mistakable.contains(name);
        let forgotten =
            self.outstanding.iter().find(|request| request.recipient != Recipient::Nobody && !is_excused(request.name));
        assert!(forgotten.is_none(), "all replies have come, but {forgotten:?}: {self:?}");
    }

    fn end(&mut self, request: Request, got: Got) {
        match (request.recipient, got) {
            (Recipient::Waiter, got) => self.outcomes.push((request.number, got)),
            (Recipient::Count(owner), Got::Accepted(_)) => self.posted[owner].0 += 1,
            (Recipient::Count(owner), got) => self.posted[owner].1.push((request.name, got)),
            (Recipient::Nobody, _) => {}
        }
    }

    /// The two cases in which a name does not tell whose a reply is.
    fn is_mistakable(&self, name: &str) -> bool {
        let one_of_several_is_lost = self.several.contains(name) && self.lost.contains(name);
        one_of_several_is_lost || self.mistakable.contains(name)
    }
}
