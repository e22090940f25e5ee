//! The exchange on one command connection, without I/O and without a clock.
//!
//! Replies carry no sequence number, only (usually) the name of their command, in the order of the requests. An
//! [`Exchange`] receives the requests, the replies and the expired deadlines. It keeps the outstanding requests,
//! attributes replies, and returns the outcome of each request. If replies can no longer be attributed, the connection
//! is [out of sync](OutOfSync), and must be closed.
//!
//! A request is *sent* ([`Exchange::send`]): a thread waits for its reply, as a [`Waiter`]. Or it is *posted*
//! ([`Exchange::post`]): no thread waits for its reply in particular, and the outcome is counted for its [`Owner`]. A
//! reply is read once, by the thread that reads the socket, as the type that this thread waits for. If it belongs to
//! another thread, it is pending until that thread asks for it.
//!
//! ```
//! use jaka_proto::exchange::{Delivery, Exchange, Owner, Support, TextOnly, Waiter};
//!
//! let (mut exchange, owner) = (Exchange::default(), Owner(1));
//! let first = exchange.send(owner, Support::Everywhere, "get_version".into());
//! let second = exchange.send(owner, Support::Everywhere, "get_robot_state".into());
//!
//! // The thread that sent the second request reads both replies.
//! let (mut text, mut reader) = (String::new(), TextOnly);
//! let mut waiter = Waiter::new(second, &mut text, &mut reader);
//! let replies =
//!     [r#"{"errorCode": "0", "cmdName": "get_version"}"#, r#"{"errorCode": "0", "cmdName": "get_robot_state"}"#];
//! for (reply, delivery) in replies.into_iter().zip([Delivery::Pending, Delivery::Waiter]) {
//!     let envelope = waiter.read(reply)?;
//!     let received = exchange.receive(reply, envelope, &mut waiter)?;
//!     assert_eq!(received.map(|received| received.delivery), Some(delivery));
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

mod owners;
pub(crate) mod sent;
mod waiter;

use std::borrow::Cow;
use std::collections::VecDeque;
use std::time::{Duration, Instant};

use self::owners::Owners;
pub use self::owners::{PostedOutcomes, PostedRequest};
pub use self::sent::{OutOfSync, Owner, RequestId, Support};
use self::sent::{Recipient, SentRequest, SentRequests};
pub use self::waiter::{Failure, ReadReply, TextOnly, TypedReply, Waiter};
use crate::envelope::Envelope;

/// The requests of one command connection, and their outcomes.
///
/// No step's time grows with the number of requests that are outstanding.
#[derive(Debug, Default)]
pub struct Exchange {
    sent: SentRequests,
    owners: Owners,
    /// The outcomes of requests whose waiters have not asked yet, in the order of the requests: so they are completed,
    /// apart from refusals without a name.
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

    /// Number of outstanding requests as [`outstanding`](Self::outstanding), of the owners that a closure selects.
    pub fn outstanding_of(&self, selects: impl Fn(Owner) -> bool) -> usize {
        self.owners.outstanding_of(selects)
    }

    /// Number of outstanding posted requests of an owner, without requests that were given up or abandoned.
    pub fn posted_outstanding(&self, owner: Owner) -> usize {
        self.owners.posted(owner).len()
    }

    /// The oldest outstanding posted request of an owner.
    pub fn oldest_posted(&self, owner: Owner) -> Option<PostedRequest> {
        self.owners.posted(owner).next()
    }

    /// Number of requests of a command that may be entered now. While a request is waited for whose command the
    /// controller may lack, there is none for another of that kind: so a refusal without a name can be told to the
    /// request that it belongs to.
    pub fn room(&self, support: Support, command: &str) -> usize {
        self.sent.room(support, command)
    }

    /// Enters a request that goes out next. A [`Waiter`] will ask for its reply, or [`give_up`](Self::give_up) or
    /// [`abandon`](Self::abandon) will be called.
    pub fn send(&mut self, owner: Owner, support: Support, command: Cow<'static, str>) -> RequestId {
        self.owners.count(owner);
        self.sent.push(owner, support, command, Recipient::Waiter)
    }

    /// Enters a request that goes out next and whose outcome is counted for its owner; `now` is the time.
    pub fn post(&mut self, owner: Owner, support: Support, command: &'static str, now: Instant) -> RequestId {
        let id = self.sent.push(owner, support, command.into(), Recipient::Counted);
        self.owners.count(owner).post(PostedRequest { id, command, sent_at: now });
        id
    }

    /// Takes back the newest request, of which nothing was sent after all.
    ///
    /// # Errors
    /// It is not outstanding any more: a reply has come to what was not sent. Or it is not the newest.
    pub fn withdraw(&mut self, request: RequestId) -> Result<(), OutOfSync> {
        let SentRequest { owner, .. } = self.sent.withdraw(request)?;
        self.owners.withdraw(owner, request);
        Ok(())
    }

    /// Attributes a reply to its request. `waiter` is the thread that has read it by [`Waiter::read`], with its
    /// envelope.
    ///
    /// Requests before one that is answered by name have lost their replies, and fail with [`Failure::Lost`].
    ///
    /// A refusal without a name belongs to the only outstanding request. Of several, it belongs to a candidate: one
    /// whose command the controller may lack ([`Support::Uncertain`]) and has not answered by name on this connection.
    /// If there are more candidates than such refusals, because some were given up, the refusal is held, and the result
    /// is `None`. It is told once there is one for each candidate. A reply with a name ends that: as always, the
    /// requests before its own are lost, and those after it go on waiting.
    ///
    /// # Errors
    /// The reply belongs to no outstanding request, or it is not certain to which.
    pub fn receive(
        &mut self,
        text: &str,
        envelope: Option<Envelope<'_>>,
        waiter: &mut Waiter<'_>,
    ) -> Result<Option<Received>, OutOfSync> {
        let Self { sent, owners, pending } = self;
        let lost = |request: SentRequest| {
            match request.recipient {
                Recipient::Waiter if waiter.is_for(request.id) => waiter.fail(Failure::Lost),
                Recipient::Waiter => keep(pending, request.id, Pending::Lost),
                Recipient::Counted => owners.finish(request.owner, request.id, Err(Failure::Lost)),
                Recipient::Nobody => {}
            }
            owners.count_off(request.owner);
        };
        let Some(completed) = sent.complete_by(envelope.as_ref(), lost)? else { return Ok(None) };
        let SentRequest { id, owner, command, recipient } = completed;
        let delivery = match recipient {
            Recipient::Waiter if waiter.is_for(id) => {
                waiter.complete(text, envelope);
                Delivery::Waiter
            }
            Recipient::Waiter => {
                keep(pending, id, Pending::Reply(text.to_owned()));
                Delivery::Pending
            }
            Recipient::Counted => {
                owners.finish(owner, id, waiter::accepted(envelope));
                Delivery::Counted
            }
            Recipient::Nobody => Delivery::Discarded,
        };
        owners.count_off(owner);
        Ok(Some(Received { request: id, command, delivery }))
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

    /// The deadline of the oldest posted request of an owner has passed, `after` it was sent. It fails with
    /// [`Failure::TimedOut`].
    ///
    /// # Errors
    /// As [`give_up`](Self::give_up).
    pub fn give_up_oldest_posted(&mut self, owner: Owner, after: Duration) -> Result<(), OutOfSync> {
        let Some(oldest) = self.oldest_posted(owner) else { return Ok(()) };
        self.sent.give_up(oldest.id)?;
        self.owners.finish(owner, oldest.id, Err(Failure::TimedOut { after }));
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

    /// Abandons all outstanding posted requests of an owner, which posts no more. Returns their number, and the
    /// outcomes of its other requests since these were last taken.
    pub fn abandon_posted(&mut self, owner: Owner) -> (u64, PostedOutcomes) {
        let mut count = 0;
        for request in self.owners.posted(owner) {
            self.sent.abandon(request.id);
            count += 1;
        }
        (count, self.owners.end_posting(owner))
    }

    /// Takes the outcomes of the posted requests of an owner since this was last called.
    pub fn take_posted_outcomes(&mut self, owner: Owner) -> PostedOutcomes {
        self.owners.take_outcomes(owner)
    }

    fn pending_for(&mut self, request: RequestId) -> Option<Pending> {
        let place = self.pending.binary_search_by_key(&request, |(owner, _)| *owner).ok()?;
        self.pending.remove(place).map(|(_, pending)| pending)
    }
}

/// Keeps the outcome of a request in the order of the requests.
fn keep(pending: &mut VecDeque<(RequestId, Pending)>, request: RequestId, outcome: Pending) {
    let place = pending.partition_point(|(other, _)| *other < request);
    pending.insert(place, (request, outcome));
}
