//! Owners of requests: their numbers of outstanding requests, and the outcomes of those that they have posted.

use std::collections::{BTreeMap, VecDeque};
use std::time::Instant;

use super::{Failure, Owner, RequestId};

/// A posted request that is outstanding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct PostedRequest {
    /// The request.
    pub id: RequestId,
    /// Its `cmdName`.
    pub command: &'static str,
    /// Time at which it was sent.
    pub sent_at: Instant,
}

/// Outcomes of posted requests.
#[derive(Debug, Default)]
#[non_exhaustive]
pub struct PostedOutcomes {
    /// Number of accepted requests.
    pub accepted: u64,
    /// The others, by `cmdName`, in the order in which it was learnt.
    pub failed: Vec<(&'static str, Failure)>,
}

/// The owners that have outstanding requests, or post.
#[derive(Debug, Default)]
pub(super) struct Owners(BTreeMap<Owner, Account>);

/// The requests of one owner.
#[derive(Debug, Default)]
pub(super) struct Account {
    /// Number of outstanding requests, including requests that were given up or abandoned.
    outstanding: usize,
    /// True from the first posted request until the owner posts no more. The account is kept as long.
    posts: bool,
    /// Outstanding posted requests in the order of their ids. Requests are completed, lost and given up from the front,
    /// and withdrawn from the back.
    posted: VecDeque<PostedRequest>,
    outcomes: PostedOutcomes,
}

impl Owners {
    /// Number of outstanding requests of the owners that a closure selects.
    pub(super) fn outstanding_of(&self, selects: impl Fn(Owner) -> bool) -> usize {
        let selected = self.0.iter().filter(|(owner, _)| selects(**owner));
        selected.map(|(_, account)| account.outstanding).sum()
    }

    /// Outstanding posted requests of an owner, the oldest first.
    pub(super) fn posted(&self, owner: Owner) -> impl ExactSizeIterator<Item = PostedRequest> {
        self.0.get(&owner).map(|account| account.posted.iter()).unwrap_or_default().copied()
    }

    /// Counts another outstanding request of an owner.
    pub(super) fn count(&mut self, owner: Owner) -> &mut Account {
        let account = self.0.entry(owner).or_default();
        account.outstanding += 1;
        account
    }

    /// A request of an owner is outstanding no more.
    pub(super) fn count_off(&mut self, owner: Owner) {
        if let Some(account) = self.0.get_mut(&owner) {
            account.outstanding -= 1;
            if account.is_unused() {
                self.0.remove(&owner);
            }
        }
    }

    /// Takes back the newest request of an owner.
    pub(super) fn withdraw(&mut self, owner: Owner, request: RequestId) {
        if let Some(account) = self.0.get_mut(&owner) {
            if account.posted.back().is_some_and(|newest| newest.id == request) {
                account.posted.pop_back();
            }
        }
        self.count_off(owner);
    }

    /// Counts the outcome of a posted request, which is the oldest as a rule.
    pub(super) fn finish(&mut self, owner: Owner, request: RequestId, outcome: Result<(), Failure>) {
        let Some(account) = self.0.get_mut(&owner) else { return };
        let place = account.posted.iter().position(|posted| posted.id == request);
        let Some(finished) = place.and_then(|place| account.posted.remove(place)) else { return };
        match outcome {
            Ok(()) => account.outcomes.accepted += 1,
            Err(failure) => account.outcomes.failed.push((finished.command, failure)),
        }
    }

    /// Takes the outcomes of an owner.
    pub(super) fn take_outcomes(&mut self, owner: Owner) -> PostedOutcomes {
        self.0.get_mut(&owner).map(|account| std::mem::take(&mut account.outcomes)).unwrap_or_default()
    }

    /// Ends the posting of an owner, and returns its last outcomes.
    pub(super) fn end_posting(&mut self, owner: Owner) -> PostedOutcomes {
        let outcomes = self.take_outcomes(owner);
        if let Some(account) = self.0.get_mut(&owner) {
            account.posts = false;
            account.posted = VecDeque::new();
            if account.is_unused() {
                self.0.remove(&owner);
            }
        }
        outcomes
    }
}

impl Account {
    /// Adds a posted request.
    pub(super) fn post(&mut self, request: PostedRequest) {
        self.posts = true;
        self.posted.push_back(request);
    }

    /// True for an owner that neither has outstanding requests nor posts.
    fn is_unused(&self) -> bool {
        self.outstanding == 0 && !self.posts
    }
}
