//! One condition of a guard, and its judgement of packets.

use std::fmt;
use std::sync::Arc;

use super::force::{ForceLimit, contact_force};
use super::{Guard, Question};
use crate::cause::Field;
use crate::error::OptionName;
use crate::inputs::{InputTest, When};
use crate::{Error, GuardTrip, NotShown, Snapshot, TripReason};

jaka_proto::worded! {
    /// One condition of a guard.
    #[derive(Debug, Clone)]
    pub(crate) enum Condition {
        Input(input: InputTest) => "{input}",
        Inside(tcp_box: TcpBox) => "the tool centre point is in {tcp_box}",
        Outside(tcp_box: TcpBox) => "the tool centre point is outside {tcp_box}",
        Force(limit: ForceLimit) => "{limit}",
        Question(question: Question) => (&*question.text),
    }
}

/// Condition, and its memory of earlier packets.
#[derive(Debug)]
pub(super) struct Judge {
    pub(super) condition: Condition,
    /// Whether the level of an edge was there in the packet before.
    held: Option<bool>,
    /// Values of the sensor in the first packet.
    start: Option<[f64; 6]>,
}

impl Judge {
    pub(super) fn new(condition: Condition) -> Self {
        Self { condition, held: None, start: None }
    }

    /// Judges the next packet, and returns the reason for a trip, if it trips.
    pub(super) fn judge(&mut self, packet: &Snapshot) -> Option<TripReason> {
        match self.holds(packet) {
            Ok(holds) => {
                let held = self.held.replace(holds);
                let is_edge = matches!(&self.condition, Condition::Input(input) if input.when == When::Edge);
                let trips = holds && (!is_edge || held == Some(false));
                trips.then_some(TripReason::Holds)
            }
            Err(reason) => Some(reason),
        }
    }

    fn holds(&mut self, packet: &Snapshot) -> Result<bool, TripReason> {
        let holds = match &self.condition {
            Condition::Input(input) => input.holds(packet),
            Condition::Inside(tcp_box) => tcp_box.contains(packet),
            Condition::Outside(tcp_box) => tcp_box.contains(packet).map(|contains| !contains),
            Condition::Force(limit) => {
                contact_force(packet).map(|now| limit.holds(self.start.get_or_insert(now), &now))
            }
            Condition::Question(question) => return question.holds(&packet.status).ok_or(TripReason::Panicked),
        };
        holds.map_err(TripReason::NotShown)
    }
}

impl Condition {
    pub(super) fn check(&self) -> Result<(), Error> {
        match self {
            Self::Input(input) => input.check(),
            Self::Inside(tcp_box) | Self::Outside(tcp_box) => tcp_box.check(),
            Self::Force(limit) => limit.check(),
            Self::Question(_) => Ok(()),
        }
    }

    /// Text for the input in a packet, if the condition is about an input.
    pub(crate) fn says(&self, packet: &Snapshot) -> Option<String> {
        if let Self::Input(input) = self { input.says(packet) } else { None }
    }
}

/// Conditions of a guard, and the last packet that they have judged.
#[derive(Debug)]
pub(super) struct Judging {
    judges: Vec<Judge>,
    /// Number of the last packet that was judged.
    last: u64,
}

impl Judging {
    /// By these conditions, before any packet.
    pub(super) fn of(conditions: &[Condition]) -> Self {
        Self { judges: conditions.iter().cloned().map(Judge::new).collect(), last: 0 }
    }

    /// Judges a packet: the first condition that trips, if one does.
    pub(super) fn judge(&mut self, packet: &Arc<Snapshot>) -> Option<GuardTrip> {
        if packet.number <= self.last {
            return None;
        }
        self.last = packet.number;
        let (condition, reason, text) = self.judges.iter_mut().enumerate().find_map(|(condition, judge)| {
            let reason = judge.judge(packet)?;
            Some((condition, reason, judge.condition.to_string()))
        })?;
        let packet = Arc::clone(packet);
        Some(GuardTrip {
            condition,
            text,
            reason,
            packet,
            reaction: None,
            is_before_start: false,
            is_at_rest: false,
            lag: None,
        })
    }
}

/// A box along the axes of the selected user frame, for the tool centre point: mm.
///
/// It is compared with [`RobotStatus::actual_position`](crate::status::RobotStatus::actual_position), in the frames
/// that are selected when a packet is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TcpBox {
    least: [f64; 3],
    most: [f64; 3],
}

impl TcpBox {
    /// A box of any two opposite corners. A box with a number that is not finite is an
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption) at its use.
    pub fn from_corners(one: [f64; 3], other: [f64; 3]) -> Self {
        // A corner that is not a number stays one, and is refused.
        let pick = |choose: fn(f64, f64) -> bool| {
            std::array::from_fn(|i| if one[i].is_nan() || choose(one[i], other[i]) { one[i] } else { other[i] })
        };
        Self { least: pick(|one, other| one < other), most: pick(|one, other| one > other) }
    }

    /// Guard that trips while the tool centre point is outside.
    pub fn is_left(self) -> Guard {
        Guard::of(Condition::Outside(self))
    }

    /// Guard that trips while the tool centre point is inside.
    pub fn is_entered(self) -> Guard {
        Guard::of(Condition::Inside(self))
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        let Some(odd) = self.least.iter().chain(&self.most).find(|value| !value.is_finite()) else {
            return Ok(());
        };
        Err(OptionName::new("TcpBox", "corner").refuse(odd, "a finite number of mm"))
    }

    pub(super) fn contains(&self, packet: &Snapshot) -> Result<bool, NotShown> {
        let pose = Field { packet, name: "actual_position" }.shown(packet.status.actual_position)?;
        let at = [pose.x, pose.y, pose.z];
        Ok((0..3).all(|i| (self.least[i]..=self.most[i]).contains(&at[i])))
    }
}

impl fmt::Display for TcpBox {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { least: [x0, y0, z0], most: [x1, y1, z1] } = self;
        write!(f, "the box x {x0} to {x1}, y {y0} to {y1}, z {z0} to {z1} mm")
    }
}
