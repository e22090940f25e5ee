//! The outcomes of requests, until their waiters ask.

use std::collections::VecDeque;

use super::RequestId;

/// The outcome of a request.
#[derive(Debug)]
pub(super) enum Pending {
    /// The text of the reply.
    Reply(String),
    /// A later request was answered: the reply will not come any more.
    Lost,
}

/// The outcomes of requests whose waiters have not asked yet.
#[derive(Debug, Default)]
pub(super) struct PendingReplies {
    /// In the order of the requests: so they are completed.
    replies: VecDeque<(RequestId, Pending)>,
}

impl PendingReplies {
    pub(super) fn push(&mut self, request: RequestId, pending: Pending) {
        self.replies.push_back((request, pending));
    }

    pub(super) fn take(&mut self, request: RequestId) -> Option<Pending> {
        let place = self.replies.binary_search_by_key(&request, |(owner, _)| *owner).ok()?;
        self.replies.remove(place).map(|(_, pending)| pending)
    }
}
