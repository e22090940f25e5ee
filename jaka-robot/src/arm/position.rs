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
use jaka_proto::messages::types::{JointPosition, Pose};
use jaka_proto::wire::Fields;
use jaka_proto::{Command, CommandInfo};
use jaka_sync::layer::{ClientParts as _, Handle, Link, Sent, unexpected};

use super::rest::{APART, REST_SPEED, RestWindow, Seen, TimedJoints, Turn};
use crate::error::Attach as _;
use crate::place::{Place, Quantity};
use crate::{Client, Error, ErrorKind};

/// Timeout for the news that settles the cause of an end: the next packet, or the end of the other connection.
pub(crate) const SETTLING: Duration = Duration::from_millis(250);

/// The shortest time between two queries.
pub(crate) const QUERY_PERIOD: Duration = APART;

/// Queries of the position of the arm on one connection.
#[derive(Debug)]
pub(crate) struct Position {
    link: Arc<Link>,
    handle: Handle,
    /// Longest wait for an answer.
    reply_timeout: Duration,
    /// The query that has not been answered.
    query: Option<Query>,
    /// Greatest speed of a joint of an arm at rest, in deg/s.
    rest_speed: f64,
    /// Number of the changes by other handles when the arm was seen at rest by the controller's answers, if nothing was
    /// sent since by this one.
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
    /// Time at which the answer was there.
    pub(crate) answered: Instant,
}

/// Waits until an arm is at rest, by the controller's answers, for a program that has only a client: see
/// [`Robot::wait_for_rest`](crate::Robot::wait_for_rest). No joint may turn faster than 0.5 deg/s.
///
/// ```no_run
/// use std::time::Duration;
/// use jaka_robot::{Client, wait_for_rest};
///
/// let mut client = Client::connect("10.5.5.100")?;
/// client.stop_handle().stop()?;
/// wait_for_rest(&mut client, Duration::from_secs(2))?;
/// # Ok::<(), jaka_robot::Error>(())
/// ```
///
/// # Errors
/// As [`Robot::wait_for_rest`](crate::Robot::wait_for_rest).
pub fn wait_for_rest(client: &mut Client, timeout: Duration) -> Result<(), Error> {
    let mut position = Position::new(client);
    let rest = position.wait_for_rest(timeout).map(drop);
    position.forget();
    rest
}

impl Position {
    pub(super) fn new(client: &Client) -> Self {
        let (link, handle) = (Arc::clone(client.link()), client.handle());
        Self { link, handle, reply_timeout: client.reply_timeout(), query: None, rest_speed: REST_SPEED, rests: None }
    }

    /// Sets the greatest speed of a joint of an arm at rest, in deg/s.
    pub(crate) fn set_rest_speed(&mut self, rest_speed: f64) {
        self.rest_speed = rest_speed;
    }

    /// Hands the queries over to another thread, which ends before this object is dropped. The outstanding query and
    /// the rest that was noted go with them.
    pub(super) fn lent(&mut self) -> Self {
        let link = Arc::clone(&self.link);
        Self { link, query: self.query.take(), rests: mem::take(&mut self.rests), ..*self }
    }

    /// Notes whether the arm was seen at rest by answers, however it was. A command that is sent ends that.
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
        Some(Answer { place, asked: query.at, answered: self.clock().now() })
    }

    fn poll<R: Fields>(
        &self,
        question: &Sent<'_>,
        info: &'static CommandInfo,
        time: Duration,
        place: impl Fn(R) -> Place,
    ) -> Result<Option<Place>, Error> {
        let link = &self.link;
        let (mut text, mut reader) = (String::new(), TypedReply::new(info));
        if !link.poll(question, time, &mut text, &mut reader)? {
            return Ok(None);
        }
        let reply = reader.take(&text).map_err(|source| link.attach(unexpected(info.name, source).into()))?;
        Ok(Some(place(reply)))
    }

    /// Answer to a query that is sent now. Waits no longer than for any reply.
    fn answer_now(&mut self, quantity: Quantity, timeout: Duration) -> Result<Answer, Error> {
        let (since, timeout) = (self.clock().stopwatch(), timeout.min(self.reply_timeout));
        loop {
            self.ask(quantity)?;
            let left = since.left_of(timeout);
            match self.answer(left) {
                None if left.is_zero() => return Err(self.no_position(quantity, timeout)),
                Some(Answer { place: Ok(place), .. }) if place.quantity() != quantity => {}
                Some(answer) if answer.asked >= since.began => return Ok(answer),
                _ => {}
            }
        }
    }

    /// The arm's position now; `None` if the controller does not report it.
    pub(crate) fn place(&mut self, quantity: Quantity, timeout: Duration) -> Result<Option<Place>, Error> {
        match self.answer_now(quantity, timeout)?.place {
            Ok(place) => Ok(Some(place)),
            Err(error) if error.is_disconnected() => Err(error),
            Err(_) => Ok(None),
        }
    }

    /// The pose of the tool centre point now; `None` if the controller does not report it.
    pub(crate) fn tcp_pose(&mut self, timeout: Duration) -> Result<Option<Pose>, Error> {
        let place = self.place(Quantity::Pose, timeout)?;
        Ok(place.and_then(|place| if let Place::Pose(pose) = place { Some(pose) } else { None }))
    }

    /// Place of the arm at rest, by three answers that show rest, or by one if the arm was seen at rest and nothing was
    /// sent since; `None` if the controller does not report it, or the arm moves.
    pub(crate) fn place_at_rest(&mut self, quantity: Quantity, timeout: Duration) -> Result<Option<Place>, Error> {
        if self.rests == Some(self.link.changes_but_of(self.handle)) {
            self.place(quantity, timeout)
        } else {
            self.place_settled(quantity, APART * 2, timeout)
        }
    }

    /// Place of the arm after three answers that show rest over at least this time; `None` if the controller does not
    /// report it, or the arm moves.
    pub(crate) fn place_settled(
        &mut self,
        quantity: Quantity,
        time: Duration,
        timeout: Duration,
    ) -> Result<Option<Place>, Error> {
        let since = self.clock().stopwatch();
        match (self.place_still_for(time, timeout)?, quantity) {
            (None, _) => Ok(None),
            (Some(joints), Quantity::Joints) => Ok(Some(Place::Joints(joints))),
            (Some(_), Quantity::Pose) => self.place(quantity, since.left_of(timeout)),
        }
    }

    /// Place of the arm, by three answers that show rest over at least this time; `None` if the controller does not
    /// report it, or the arm moves.
    pub(crate) fn place_still_for(
        &mut self,
        time: Duration,
        timeout: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        match self.rest_within(Duration::ZERO, (time / 2).max(APART), timeout) {
            Ok(joints) => Ok(Some(joints)),
            Err(error) if error.is_disconnected() || error.is_timeout() => Err(error),
            Err(_) => Ok(None),
        }
    }

    /// Waits until three answers say that the arm is at rest, and returns the last one.
    pub(crate) fn wait_for_rest(&mut self, timeout: Duration) -> Result<JointPosition, Error> {
        self.rest_within(timeout, APART, timeout)
    }

    /// Waits until three answers, each this time after the one before, say that the arm is at rest: for at most `time`,
    /// but always for the first three. Returns the last one.
    fn rest_within(&mut self, time: Duration, apart: Duration, timeout: Duration) -> Result<JointPosition, Error> {
        self.note_rest(false);
        let due = self.link.stops.rest_due();
        let (since, mut window) = (self.clock().stopwatch(), RestWindow::new(self.rest_speed));
        loop {
            // A query that is sent has time for its reply.
            let Answer { place, asked, answered } =
                self.answer_now(Quantity::Joints, since.left_of(timeout).max(APART * 2))?;
            let is_over = since.left_of(time) < apart;
            match place {
                Ok(Place::Joints(joints)) => match window.take(TimedJoints { joints, asked, answered }) {
                    Seen::AtRest => {
                        self.note_rest(true);
                        self.link.stops.rest_seen(due);
                        return Ok(joints);
                    }
                    Seen::Turns(turn) if is_over => return Err(self.not_at_rest(turn)),
                    Seen::Turns(_) | Seen::TooFew => {}
                },
                Err(error) if is_over || error.is_disconnected() => return Err(error),
                // It may report them later.
                Ok(Place::Pose(_)) | Err(_) => window.clear(),
            }
            self.clock().sleep(apart);
        }
    }

    fn not_at_rest(&self, turn: Turn) -> Error {
        let Turn { joint, by_deg, within } = turn;
        let (speed, rest_speed) = (turn.speed(), self.rest_speed);
        self.link.attach(ErrorKind::NotAtRest { joint, by_deg, within, speed, rest_speed }.into())
    }

    /// Gives up the query that has not been answered.
    fn forget(&mut self) {
        if let Some(query) = self.query.take() {
            self.link.forget(&query.question);
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
