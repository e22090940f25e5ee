//! Requests whose outcomes are counted: set-points, and the requests of a pipeline.

use std::collections::VecDeque;
use std::time::Instant;

use super::{Failure, RequestId};

/// A posted request that is outstanding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct PostedRequest {
    /// The request.
    pub id: RequestId,
    /// Its `cmdName`.
    pub command: &'static str,
    /// When it was sent.
    pub sent_at: Instant,
}

/// The outcomes of posted requests.
#[derive(Debug, Default)]
#[non_exhaustive]
pub struct PostedOutcomes {
    /// How many were accepted.
    pub accepted: u64,
    /// The others, by `cmdName`, in the order in which it was learnt.
    pub failed: Vec<(&'static str, Failure)>,
}

/// The posted requests.
#[derive(Debug, Default)]
pub(super) struct Posted {
    /// In the order of their ids. Requests are completed, lost and given up from the front, and withdrawn from the back.
    outstanding: VecDeque<PostedRequest>,
    outcomes: PostedOutcomes,
}

impl Posted {
    pub(super) fn push(&mut self, request: PostedRequest) {
        self.outstanding.push_back(request);
    }

    pub(super) fn outstanding(&self) -> usize {
        self.outstanding.len()
    }

    pub(super) fn oldest(&self) -> Option<PostedRequest> {
        self.outstanding.front().copied()
    }

    /// Counts the outcome of a request, which is the oldest as a rule.
    pub(super) fn finish(&mut self, request: RequestId, outcome: Result<(), Failure>) {
        let place = self.outstanding.iter().position(|posted| posted.id == request);
        let Some(finished) = place.and_then(|place| self.outstanding.remove(place)) else { return };
        match outcome {
            Ok(()) => self.outcomes.accepted += 1,
            Err(failure) => self.outcomes.failed.push((finished.command, failure)),
        }
    }

    /// Takes back the newest request, if it is this one.
    pub(super) fn withdraw(&mut self, request: RequestId) {
        if self.outstanding.back().is_some_and(|newest| newest.id == request) {
            self.outstanding.pop_back();
        }
    }

    /// Forgets the oldest request, and says which it was.
    pub(super) fn abandon_oldest(&mut self) -> Option<RequestId> {
        self.outstanding.pop_front().map(|oldest| oldest.id)
    }

    pub(super) fn take_outcomes(&mut self) -> PostedOutcomes {
        std::mem::take(&mut self.outcomes)
    }
}
