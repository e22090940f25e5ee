//! One condition of a guard, and its judgement of packets.

use std::sync::Arc;

use super::Question;
use super::force::{ForceLimit, contact_force};
use super::tcp_box::TcpBox;
use crate::inputs::{InputTest, When};
use crate::{Error, GuardTrip, Snapshot, TripReason};

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

/// A condition, and what it must know of packets before.
#[derive(Debug)]
pub(super) struct Judge {
    pub(super) condition: Condition,
    /// Whether the level of an edge was there in the packet before.
    held: Option<bool>,
    /// What the sensor read in the first packet.
    start: Option<[f64; 6]>,
}

impl Judge {
    pub(super) fn new(condition: Condition) -> Self {
        Self { condition, held: None, start: None }
    }

    /// Judges the next packet: why it trips, if it does.
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

    /// What a packet says of the input that the condition is about, if it is about one.
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
