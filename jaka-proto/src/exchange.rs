//! The exchange on one command connection, without I/O and without a clock.
//!
//! Replies carry no sequence number, only (usually) the name of their command, in the order of the requests. An
//! [`Exchange`] receives the requests, the replies and the expired deadlines. It keeps the outstanding requests,
//! attributes replies, and returns the outcome of each request. If replies can no longer be attributed, the connection
//! is [out of sync](OutOfSync), and must be closed.
//!
//! A request is *sent* ([`Exchange::send`]): a thread waits for its reply, as a [`Waiter`]. Or it is *posted*
//! ([`Exchange::post`]): no thread waits for its reply in particular, and the outcome is counted. A reply is read once,
//! by the thread that reads the socket, as the type that this thread waits for. If it belongs to another thread, it is
//! pending until that thread asks for it.
//!
//! ```
//! use jaka_proto::exchange::{Delivery, Exchange, TextOnly, Waiter};
//!
//! let mut exchange = Exchange::default();
//! let first = exchange.send("get_version".into());
//! let second = exchange.send("get_robot_state".into());
//!
//! // The thread that sent the second request reads both replies.
//! let (mut text, mut reader) = (String::new(), TextOnly);
//! let mut waiter = Waiter::new(second, &mut text, &mut reader);
//! let replies =
//!     [r#"{"errorCode": "0", "cmdName": "get_version"}"#, r#"{"errorCode": "0", "cmdName": "get_robot_state"}"#];
//! for (reply, delivery) in replies.into_iter().zip([Delivery::Pending, Delivery::Waiter]) {
//!     let envelope = waiter.read(reply)?;
//!     assert_eq!(exchange.receive(reply, envelope, &mut waiter)?.delivery, delivery);
//! }
//! assert_eq!(waiter.take_outcome(), Some(Ok(())));
//! assert_eq!(text, replies[1]);
//!
//! // The other thread finds its reply.
//! let mut waiter = Waiter::new(first, &mut text, &mut reader);
//! exchange.take_pending(&mut waiter);
//! assert_eq!(waiter.take_outcome(), Some(Ok(())));
//! assert_eq!(text, replies[0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub(crate) mod sent;
mod waiter;

use std::borrow::Cow;
use std::collections::VecDeque;
use std::time::{Duration, Instant};

pub use self::sent::OutOfSync;
pub use self::sent::RequestId;
use self::sent::{Recipient, SentRequest, SentRequests};
pub use self::waiter::{Failure, ReadReply, TextOnly, TypedReply, Waiter};
use crate::envelope::Envelope;

/// The requests of one command connection, and their outcomes.
///
/// No step's time grows with the number of requests that are outstanding.
#[derive(Debug, Default)]
pub struct Exchange {
    sent: SentRequests,
    posted: Posted,
    /// The outcomes of requests whose waiters have not asked yet, in the order of the requests: so they are completed.
    pending: VecDeque<(RequestId, Pending)>,
}

/// The outcome of a request, until its waiter asks.
#[derive(Debug)]
enum Pending {
    /// The text of the reply.
    Reply(String),
    /// A later request was answered: the reply will not come any more.
    Lost,
}

/// A reply that was attributed.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Received {
    /// The request that it completes.
    pub request: RequestId,
    /// `cmdName` of the request.
    pub command: Cow<'static, str>,
    /// Destination of the reply.
    pub delivery: Delivery,
}

/// Destination of a reply.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Delivery {
    /// The waiter that read the reply.
    Waiter,
    /// Another waiter, for which the reply is pending.
    Pending,
    /// The request was posted: its outcome is counted.
    Counted,
    /// The request was given up or abandoned: the reply is discarded.
    Discarded,
}

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

/// The outcomes of posted requests.
#[derive(Debug, Default)]
#[non_exhaustive]
pub struct PostedOutcomes {
    /// Number of accepted requests.
    pub accepted: u64,
    /// The others, by `cmdName`, in the order in which it was learnt.
    pub failed: Vec<(&'static str, Failure)>,
}

/// The posted requests.
#[derive(Debug, Default)]
struct Posted {
    /// In the order of their ids. Requests are completed, lost and given up from the front, and withdrawn from the
    /// back.
    outstanding: VecDeque<PostedRequest>,
    outcomes: PostedOutcomes,
}

impl Exchange {
    /// No request is outstanding. `bare_reply` names the command that may be answered by a bare Python tuple, which
    /// names none.
    pub fn new(bare_reply: Option<&'static str>) -> Self {
        Self { sent: SentRequests::new(bare_reply), ..Self::default() }
    }

    /// Number of outstanding requests, including requests that were given up or abandoned.
    pub fn outstanding(&self) -> usize {
        self.sent.outstanding()
    }

    /// Number of outstanding posted requests, without requests that were given up or abandoned.
    pub fn posted_outstanding(&self) -> usize {
        self.posted.outstanding.len()
    }

    /// The oldest of the posted requests that are outstanding.
    pub fn oldest_posted(&self) -> Option<PostedRequest> {
        self.posted.outstanding.front().copied()
    }

    /// Enters a request that goes out next. A [`Waiter`] will ask for its reply, or [`give_up`](Self::give_up) or
    /// [`abandon`](Self::abandon) will be called.
    pub fn send(&mut self, command: Cow<'static, str>) -> RequestId {
        self.sent.push(command, Recipient::Waiter)
    }

    /// Enters a request that goes out next and whose outcome is counted; `now` is the time.
    pub fn post(&mut self, command: &'static str, now: Instant) -> RequestId {
        let id = self.sent.push(command.into(), Recipient::Counted);
        self.posted.outstanding.push_back(PostedRequest { id, command, sent_at: now });
        id
    }

    /// Takes back the newest request, of which nothing was sent after all.
    ///
    /// # Errors
    /// It is not outstanding any more: a reply has come to what was not sent. Or it is not the newest.
    pub fn withdraw(&mut self, request: RequestId) -> Result<(), OutOfSync> {
        self.sent.withdraw(request)?;
        self.posted.withdraw(request);
        Ok(())
    }

    /// Attributes a reply to its request. `waiter` is the thread that has read it by [`Waiter::read`], with its
    /// envelope.
    ///
    /// Requests before the answered one have lost their replies, and fail with [`Failure::Lost`].
    ///
    /// # Errors
    /// The reply belongs to no outstanding request, or it is not certain to which.
    pub fn receive(
        &mut self,
        text: &str,
        envelope: Option<Envelope<'_>>,
        waiter: &mut Waiter<'_>,
    ) -> Result<Received, OutOfSync> {
        let Self { sent, posted, pending } = self;
        let lost = |request: SentRequest| match request.recipient {
            Recipient::Waiter if waiter.is_for(request.id) => waiter.fail(Failure::Lost),
            Recipient::Waiter => pending.push_back((request.id, Pending::Lost)),
            Recipient::Counted => posted.finish(request.id, Err(Failure::Lost)),
            Recipient::Nobody => {}
        };
        let SentRequest { id, command, recipient } = sent.complete_by(envelope.as_ref(), lost)?;
        let delivery = match recipient {
            Recipient::Waiter if waiter.is_for(id) => {
                waiter.complete(text, envelope);
                Delivery::Waiter
            }
            Recipient::Waiter => {
                pending.push_back((id, Pending::Reply(text.to_owned())));
                Delivery::Pending
            }
            Recipient::Counted => {
                posted.finish(id, waiter::accepted(envelope));
                Delivery::Counted
            }
            Recipient::Nobody => Delivery::Discarded,
        };
        Ok(Received { request: id, command, delivery })
    }

    /// Gives a waiter its pending outcome, if there is one.
    pub fn take_pending(&mut self, waiter: &mut Waiter<'_>) {
        if let Some(pending) = waiter.request().and_then(|request| self.pending_for(request)) {
            waiter.take(pending);
        }
    }

    /// Drops the pending outcome of a request, if there is one: the thread that waited for it has ended.
    pub fn discard_pending(&mut self, request: RequestId) {
        self.pending_for(request);
    }

    /// The deadline of a request that was sent has passed. Its reply, if it comes, will be discarded. The caller must
    /// have taken a pending outcome before.
    ///
    /// # Errors
    /// The reply may have come already, and been taken for that to an older request of the same name: whatever comes
    /// now may be one behind.
    pub fn give_up(&mut self, request: RequestId) -> Result<(), OutOfSync> {
        self.sent.give_up(request)
    }

    /// The deadline of the oldest posted request has passed, `after` it was sent. It fails with [`Failure::TimedOut`].
    ///
    /// # Errors
    /// As [`give_up`](Self::give_up).
    pub fn give_up_oldest_posted(&mut self, after: Duration) -> Result<(), OutOfSync> {
        let Some(oldest) = self.oldest_posted() else { return Ok(()) };
        self.sent.give_up(oldest.id)?;
        self.posted.finish(oldest.id, Err(Failure::TimedOut { after }));
        Ok(())
    }

    /// The reply to a request is no longer wanted, though there was time for it: it will be discarded, or is if it is
    /// pending.
    ///
    /// This does not suggest a lost reply. If the request of a reply is in doubt, requests with an expired deadline are
    /// still affected.
    pub fn abandon(&mut self, request: RequestId) {
        if self.pending_for(request).is_none() {
            self.sent.abandon(request);
        }
    }

    /// Abandons all outstanding posted requests, and returns their number.
    pub fn abandon_posted(&mut self) -> u64 {
        let mut count = 0;
        while let Some(request) = self.posted.outstanding.pop_front() {
            self.sent.abandon(request.id);
            count += 1;
        }
        count
    }

    /// The outcomes of posted requests since this was last asked.
    pub fn take_posted_outcomes(&mut self) -> PostedOutcomes {
        std::mem::take(&mut self.posted.outcomes)
    }

    fn pending_for(&mut self, request: RequestId) -> Option<Pending> {
        let place = self.pending.binary_search_by_key(&request, |(owner, _)| *owner).ok()?;
        self.pending.remove(place).map(|(_, pending)| pending)
    }
}

impl Posted {
    /// Counts the outcome of a request, which is the oldest as a rule.
    fn finish(&mut self, request: RequestId, outcome: Result<(), Failure>) {
        let place = self.outstanding.iter().position(|posted| posted.id == request);
        let Some(finished) = place.and_then(|place| self.outstanding.remove(place)) else { return };
        match outcome {
            Ok(()) => self.outcomes.accepted += 1,
            Err(failure) => self.outcomes.failed.push((finished.command, failure)),
        }
    }

    /// Takes back the newest request, if it is this one.
    fn withdraw(&mut self, request: RequestId) {
        if self.outstanding.back().is_some_and(|newest| newest.id == request) {
            self.outstanding.pop_back();
        }
    }
}
