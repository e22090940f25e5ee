//! Position of the arm, by queries without a deadline of their own.
//!
//! At most one is outstanding. The wait that sent it may end before the answer comes; then the next caller waits for
//! that answer. With a second query of the same name after a timeout, it could be uncertain which of the two was
//! answered; that would break the connection, on which a stop may have to go out.

use std::mem;
use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_clock::Clock;
use jaka_proto::exchange::TypedReply;
use jaka_proto::messages::kinematics::{GetJointPos, GetJointPosReply, GetTcpPos, GetTcpPosReply};
use jaka_proto::messages::types::Pose;
use jaka_proto::wire::Fields;
use jaka_proto::{Command, CommandInfo};
use jaka_sync::layer::{ClientParts as _, Handle, Link, Sent, unexpected};

use crate::error::Attach as _;
use crate::place::{Place, Quantity};
use crate::{Client, Error};

/// Timeout for the news that settles the cause of an end: the next packet, or the end of the other connection.
pub(crate) const SETTLING: Duration = Duration::from_millis(250);

/// The shortest time between two queries.
pub(crate) const QUERY_PERIOD: Duration = Duration::from_millis(100);

/// Queries of the position of the arm on one connection.
#[derive(Debug)]
pub(crate) struct Position {
    link: Arc<Link>,
    handle: Handle,
    /// Longest wait for an answer.
    reply_timeout: Duration,
    /// The query that has not been answered.
    query: Option<Query>,
    /// Number of the changes by other handles when a wait saw the arm at rest by the controller's answers, if nothing
    /// was sent since by this one.
    rests: Option<u64>,
}

/// A query without an answer yet.
#[derive(Debug)]
pub(crate) struct Query {
    question: Sent<'static>,
    quantity: Quantity,
    at: Instant,
}

/// The answer to a query.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) place: Result<Place, Error>,
    /// Time at which the query was sent; the answer is later.
    pub(crate) asked: Instant,
}

impl Position {
    pub(super) fn new(client: &Client) -> Self {
        let (link, handle) = (Arc::clone(client.link()), client.handle());
        Self { link, handle, reply_timeout: client.reply_timeout(), query: None, rests: None }
    }

    /// Hands the queries over to another thread, which ends before this object is dropped. The outstanding query and
    /// the rest that was noted go with them.
    pub(super) fn lent(&mut self) -> Self {
        let link = Arc::clone(&self.link);
        Self { link, query: self.query.take(), rests: mem::take(&mut self.rests), ..*self }
    }

    /// Notes whether the arm was seen at rest by answers. A command that is sent ends that.
    pub(crate) fn note_rest(&mut self, is_at_rest: bool) {
        self.rests = is_at_rest.then(|| self.link.changes_but_of(self.handle));
    }

    /// True while a query is outstanding.
    pub(crate) fn is_asked(&self) -> bool {
        self.query.is_some()
    }

    fn clock(&self) -> &Clock {
        &self.link.clock
    }

    /// Asks for the arm's position, unless a query is outstanding.
    pub(crate) fn ask(&mut self, quantity: Quantity) -> Result<(), Error> {
        if self.query.is_some() {
            return Ok(());
        }
        let at = self.clock().now();
        let link = &self.link;
        let of = |info: &'static CommandInfo| (info, info.role, self.handle);
        let question = match quantity {
            Quantity::Joints => link.ask(of(GetJointPos::INFO), &mut |out| GetJointPos::new().write_request(out)),
            Quantity::Pose => link.ask(of(GetTcpPos::INFO), &mut |out| GetTcpPos::new().write_request(out)),
        }?;
        self.query = Some(Query { question, quantity, at });
        Ok(())
    }

    /// Waits for the answer to the outstanding query, for at most `time`.
    pub(crate) fn answer(&mut self, time: Duration) -> Option<Answer> {
        let query = self.query.take()?;
        let (question, info) = (&query.question, query.quantity.info());
        let place = match query.quantity {
            Quantity::Joints => {
                self.poll(question, info, time, |reply: GetJointPosReply| Place::Joints(reply.joint_position))
            }
            Quantity::Pose => self.poll(question, info, time, |reply: GetTcpPosReply| Place::Pose(reply.pose)),
        };
        let Some(place) = place.transpose() else {
            self.query = Some(query);
            return None;
        };
        Some(Answer { place, asked: query.at })
    }

    fn poll<R: Fields>(
        &self,
        question: &Sent<'_>,
        info: &'static CommandInfo,
        time: Duration,
        place: impl Fn(R) -> Place,
    ) -> Result<Option<Place>, Error> {
        let link = &self.link;
        let (mut text, mut reader) = (String::new(), TypedReply::of_firmware(info, link.firmware()));
        if !link.poll(question, time, &mut text, &mut reader)? {
            return Ok(None);
        }
        let reply = reader.take(&text).map_err(|source| link.attach(unexpected(info.name, source).into()))?;
        Ok(Some(place(reply)))
    }

    /// The arm's position now; `None` if the controller does not report it. Waits no longer than for any reply.
    pub(crate) fn place(&mut self, quantity: Quantity, timeout: Duration) -> Result<Option<Place>, Error> {
        let (since, timeout) = (self.clock().stopwatch(), timeout.min(self.reply_timeout));
        loop {
            self.ask(quantity)?;
            let left = since.left_of(timeout);
            match self.answer(left) {
                None if left.is_zero() => return Err(self.no_position(quantity, timeout)),
                Some(Answer { place: Ok(place), asked }) if asked >= since.began && place.quantity() == quantity => {
                    return Ok(Some(place));
                }
                Some(Answer { place: Err(error), asked }) if asked >= since.began => {
                    return if error.is_disconnected() { Err(error) } else { Ok(None) };
                }
                _ => {}
            }
        }
    }

    /// The pose of the tool centre point now; `None` if the controller does not report it.
    pub(crate) fn tcp_pose(&mut self, timeout: Duration) -> Result<Option<Pose>, Error> {
        let place = self.place(Quantity::Pose, timeout)?;
        Ok(place.and_then(|place| if let Place::Pose(pose) = place { Some(pose) } else { None }))
    }

    /// Place of the arm at rest, by two answers that agree, or by one if the arm was at rest before and nothing was
    /// sent since; `None` if the controller does not report it, or the arm moves.
    pub(crate) fn place_at_rest(&mut self, quantity: Quantity, timeout: Duration) -> Result<Option<Place>, Error> {
        if self.rests == Some(self.link.changes_but_of(self.handle)) {
            self.place(quantity, timeout)
        } else {
            self.place_still_for(quantity, QUERY_PERIOD, timeout)
        }
    }

    /// Place of the arm, by two answers that agree with this time between them; `None` if the controller does not
    /// report it, or the arm moves.
    pub(crate) fn place_still_for(
        &mut self,
        quantity: Quantity,
        apart: Duration,
        timeout: Duration,
    ) -> Result<Option<Place>, Error> {
        let since = self.clock().stopwatch();
        let left = || since.left_of(timeout);
        let Some(first) = self.place(quantity, timeout)? else { return Ok(None) };
        // A stop or a packet does not matter here: what is sent then asks for both.
        self.clock().sleep(apart.min(left()));
        // A query that is sent has time for its reply.
        let second = self.place(quantity, left().max(QUERY_PERIOD))?;
        Ok(second.filter(|second| first.is_still(second)))
    }

    /// Waits until two answers say that the arm is at rest; false if they do not within `timeout`.
    pub(crate) fn comes_to_rest(&mut self, timeout: Duration) -> Result<bool, Error> {
        let since = self.clock().stopwatch();
        let due = self.link.stops.rest_due();
        loop {
            let (left, asked) = (since.left_of(timeout), self.clock().stopwatch());
            if self.place_at_rest(Quantity::Joints, left.max(QUERY_PERIOD * 2))?.is_some() {
                self.link.stops.rest_seen(due);
                return Ok(true);
            }
            if left.is_zero() {
                return Ok(false);
            }
            // A controller without a position says so at once.
            self.clock().sleep(asked.left_of(QUERY_PERIOD).min(since.left_of(timeout)));
        }
    }

    /// Error of a query that has been outstanding for longer than [`SETTLING`].
    pub(crate) fn unanswered(&self) -> Option<Error> {
        let query = self.query.as_ref()?;
        let after = self.clock().elapsed(query.at);
        (after >= SETTLING).then(|| self.no_position(query.quantity, after))
    }

    fn no_position(&self, quantity: Quantity, after: Duration) -> Error {
        let command = quantity.info().name.to_owned();
        self.link.attach(jaka_sync::ErrorKind::Timeout { command, after }.into())
    }
}

impl Quantity {
    fn info(self) -> &'static CommandInfo {
        match self {
            Self::Joints => GetJointPos::INFO,
            Self::Pose => GetTcpPos::INFO,
        }
    }
}
