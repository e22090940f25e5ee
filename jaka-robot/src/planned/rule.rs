//! Rule for the end of a motion: a state machine over status packets and the controller's own answers.
//!
//! A status packet cannot show its age, so it never ends a motion alone: a stalled link delivers old packets. Packets
//! that speak against a motion count at once (stops, drag mode, errors, a soft limit), or once the next one says the
//! same (an arm without power or not enabled); the arm's state finds them. A packet that shows the arm in position only
//! leads to a query, whose answer is later than the motion's acceptance.
//!
//! One answer at the target, or two that agree near it, are enough for one motion that was seen to leave: the arm is
//! there only at the end. Two, because the observed movement may belong to the previous motion. In all other cases
//! (several motions, a motion without length, an arm at rest elsewhere) the answers must agree for a grace time.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::{Duration, Instant};

use jaka_proto::messages::status::RobotStatus;
use jaka_proto::messages::types::JointPosition;

use super::batch::Batch;
use super::destination::{Destination, Nearness};
use crate::arm::QUERY_PERIOD;
use crate::place::{Place, Quantity};
use crate::{Cause, Error, Occurrence, Rest, Snapshot};

/// Number of packets that are kept to show the cause of an end.
const KEPT: usize = 10;

/// Least time and number of packets for which the arm must be seen at rest, if one answer at its target is not enough.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Grace {
    pub(crate) time: Duration,
    pub(crate) packets: u32,
}

/// The rule by which a batch ends, and its state so far.
#[derive(Debug)]
pub(super) struct EndRule {
    pub(super) batch: Batch,
    /// Number of this program's frame changes by now.
    frame_changes: u64,
    grace: Grace,
    /// Whether the arm is at rest by the newest packet; `None` if it does not say.
    in_position: Option<bool>,
    is_paused: bool,
    /// A code that has come since the acceptance and is in no table: it counts once the arm rests.
    pub(super) unknown_code: Option<Occurrence>,
    /// Time at which the last query was sent.
    asked: Option<Instant>,
    /// Whether packets said by then that the arm had left and was in position again.
    had_ended: bool,
    /// Answers that agree.
    answers: Option<Series<Place>>,
    /// Packets that agree, if there are no answers.
    still: Option<Series<Option<JointPosition>>>,
    /// Reason why the last query brought no position.
    pub(super) failure: Option<Error>,
    pub(super) packets: VecDeque<Arc<Snapshot>>,
}

/// Positions that agree with the first of them.
#[derive(Debug, Clone, Copy)]
struct Series<P> {
    first: P,
    since: Instant,
    count: u32,
    /// Packets in position since the first.
    packets: u32,
}

impl<P> Series<P> {
    fn new(first: P, since: Instant) -> Self {
        Self { first, since, count: 1, packets: 0 }
    }

    /// True if it has lasted for the grace, up to a time at which the last position was known to hold.
    fn lasts(&self, until: Instant, grace: Grace, counts_packets: bool) -> bool {
        let is_long = until.saturating_duration_since(self.since) >= grace.time;
        self.count > 1 && is_long && (!counts_packets || self.packets >= grace.packets)
    }
}

impl EndRule {
    pub(super) fn new(batch: Batch, frame_changes: u64, grace: Grace) -> Self {
        Self {
            batch,
            frame_changes,
            grace,
            in_position: None,
            is_paused: false,
            unknown_code: None,
            asked: None,
            had_ended: false,
            answers: None,
            still: None,
            failure: None,
            packets: VecDeque::with_capacity(KEPT),
        }
    }

    /// Query that is due now, if any.
    pub(super) fn query(&self, now: Instant) -> Option<Quantity> {
        self.query_in(now).is_zero().then(|| self.batch.goal.quantity())
    }

    /// Time until a query is due, if no packet comes before.
    pub(super) fn query_in(&self, now: Instant) -> Duration {
        if self.packets.is_empty() || !self.may_rest() {
            return Duration::MAX;
        }
        let after = |from: Instant, time: Duration| time.saturating_sub(now.saturating_duration_since(from));
        let next = self.asked.map_or(Duration::ZERO, |asked| after(asked, QUERY_PERIOD));
        // At first, packets still say that the arm is in position; a query then would be useless.
        let begun = if self.batch.has_left { Duration::ZERO } else { after(self.batch.accepted, self.grace.time / 2) };
        next.max(begun)
    }

    /// True if queries are sent as soon as they are due.
    fn may_rest(&self) -> bool {
        !self.is_paused && self.in_position != Some(false)
    }

    /// A query goes out.
    pub(super) fn asked(&mut self, at: Instant) {
        self.asked = Some(at);
        self.had_ended = self.has_ended();
    }

    /// Whether packets say that the arm has left and is in position again. They may be of the motion before.
    fn has_ended(&self) -> bool {
        self.batch.has_left && self.in_position == Some(true) && !self.is_paused
    }

    /// Takes a packet: the end and the rest, if it shows one.
    pub(super) fn packet(&mut self, snapshot: &Arc<Snapshot>) -> Option<(Occurrence, Rest)> {
        let is_seen = self.packets.back().is_some_and(|last| last.number >= snapshot.number);
        if is_seen || snapshot.received <= self.batch.accepted {
            return None;
        }
        if self.packets.len() == KEPT {
            self.packets.pop_front();
        }
        self.packets.push_back(Arc::clone(snapshot));
        self.batch.under_way.see(snapshot);
        if let Some(change) = self.batch.frame_change() {
            return Some((Occurrence::frames_changed(change), Rest::NotSeen));
        }
        self.see_rest(&snapshot.status, snapshot.received).map(|occurrence| (occurrence, Rest::Packets))
    }

    fn see_rest(&mut self, status: &RobotStatus, received: Instant) -> Option<Occurrence> {
        self.is_paused = status.paused == Some(true);
        self.in_position = status.in_position;
        if !self.may_rest() {
            self.batch.has_left |= self.in_position == Some(false);
            self.answers = None;
            self.still = None;
            return None;
        }
        let counted = u32::from(self.in_position == Some(true));
        if let Some(answers) = &mut self.answers {
            answers.packets += counted;
        }
        self.see_still(status.joint_actual_position, received, counted)
    }

    /// Rest as packets alone show it, which is never more than rest.
    fn see_still(&mut self, joints: Option<JointPosition>, received: Instant, counted: u32) -> Option<Occurrence> {
        let is_same = |first: Option<JointPosition>| match (first, joints) {
            (Some(first), Some(joints)) => Place::Joints(first).is_still(&Place::Joints(joints)),
            (first, joints) => first.is_none() && joints.is_none(),
        };
        match &mut self.still {
            Some(still) if is_same(still.first) => {
                still.count += 1;
                still.packets += counted;
            }
            _ => self.still = Some(Series::new(joints, received)),
        }
        let lasts = self.still.is_some_and(|still| still.lasts(received, self.grace, true));
        (self.failure.is_some() && self.batch.has_left && lasts).then(|| self.at_rest(Nearness::Unknown))
    }

    /// Takes the answer to a query that was sent at `asked` and came at `received`: the end, if it shows one.
    pub(super) fn answer(&mut self, place: Place, asked: Instant, received: Instant) -> Option<Occurrence> {
        if asked <= self.batch.accepted {
            return None;
        }
        self.failure = None;
        let nearness = self.nearness(&place);
        let has_ended = self.had_ended && self.has_ended() && self.batch.is_simple();
        if has_ended && nearness == Nearness::There && (self.is_exact(&place) || self.agrees(&place, asked)) {
            return Some(Cause::Reached.into());
        }
        if !self.may_rest() {
            return None;
        }
        match &mut self.answers {
            Some(answers) if answers.first.is_still(&place) => answers.count += 1,
            answers => *answers = Some(Series::new(place, received)),
        }
        let counts_packets = self.in_position.is_some();
        let lasts = self.answers.is_some_and(|answers| answers.lasts(asked, self.grace, counts_packets));
        let had_time = asked.saturating_duration_since(self.batch.accepted) >= self.grace.time;
        (lasts && had_time).then(|| self.at_rest(nearness))
    }

    /// True for a place exactly at the goal, at which a motion rests and which it does not pass.
    fn is_exact(&self, place: &Place) -> bool {
        matches!(&self.batch.goal, Destination::At(goal, _) if goal.is_exactly(place))
    }

    /// True if an answer some time before was the same.
    fn agrees(&self, place: &Place, asked: Instant) -> bool {
        let since = |answers: Series<Place>| asked.saturating_duration_since(answers.since);
        self.answers.is_some_and(|answers| answers.first.is_still(place) && since(answers) >= QUERY_PERIOD / 2)
    }

    /// A query brought no position.
    pub(super) fn no_answer(&mut self, failure: Error) {
        self.answers = None;
        self.failure = Some(failure);
    }

    fn at_rest(&mut self, nearness: Nearness) -> Occurrence {
        match (nearness, self.unknown_code.take()) {
            (Nearness::There, _) => Cause::Reached.into(),
            (Nearness::Elsewhere | Nearness::Within | Nearness::Unknown, Some(occurrence)) => occurrence,
            (Nearness::Elsewhere, None) => Cause::Stopped.into(),
            (Nearness::Within | Nearness::Unknown, None) => Cause::AtRest.into(),
        }
    }

    fn nearness(&self, place: &Place) -> Nearness {
        let newest = self.packets.back();
        let goal =
            newest.map_or(Destination::Unknown, |newest| self.batch.goal_now(&newest.status, self.frame_changes));
        goal.nearness(place)
    }
}
