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
    pub(super) outstanding: VecDeque<PostedRequest>,
    pub(super) outcomes: PostedOutcomes,
}

impl Posted {
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
}
