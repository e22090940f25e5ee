//! Motions that were accepted and have not been waited for.

use std::time::Instant;

use jaka_proto::messages::status::RobotStatus;

use super::destination::Destination;
use crate::arm;
use crate::place::Place;

/// Motions that were accepted and have not been waited for.
#[derive(Debug, Clone)]
pub(super) struct Batch {
    /// When the last one was accepted: packets and answers from before say nothing about it.
    pub(super) accepted: Instant,
    pub(super) goal: Destination,
    /// The event that the status showed before; only another one counts.
    pub(super) code_before: Option<String>,
    /// Whether a packet has said since that the arm is not in position: only after that can one say that the motion has
    /// ended.
    pub(super) has_left: bool,
    count: u32,
    begin: Begin,
    frames: SelectedFrames,
}

/// What was known of the arm when the first motion was sent.
#[derive(Debug, Clone, Default)]
pub(super) struct Begin {
    pub(super) at_rest: bool,
    /// By the status, which may be old.
    pub(super) places: [Option<Place>; 2],
    /// By a query.
    pub(super) start: Option<Place>,
    pub(super) frames: SelectedFrames,
    pub(super) code: Option<String>,
}

/// The ids of the selected frames, as the status shows them, and how often this program has changed any.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct SelectedFrames {
    tool: Option<i64>,
    user: Option<i64>,
    pub(super) changes: u64,
}

impl SelectedFrames {
    /// As the status shows them; not those of a status that may be older than a change of this program.
    pub(super) fn new(status: &RobotStatus, changes: u64, before: u64) -> Self {
        let shown = |id: Option<i64>| id.filter(|_| changes == before);
        Self { tool: shown(status.current_tool_id), user: shown(status.current_user_frame_id), changes }
    }

    fn differ_from(&self, status: &RobotStatus) -> bool {
        let differ = |one: Option<i64>, other| one.zip(other).is_some_and(|(one, other)| one != other);
        differ(self.tool, status.current_tool_id) || differ(self.user, status.current_user_frame_id)
    }
}

impl Begin {
    /// By the newest packet.
    pub(super) fn new(status: &RobotStatus, frames: SelectedFrames) -> Self {
        Self {
            at_rest: status.in_position == Some(true) && status.paused != Some(true),
            places: [status.joint_actual_position.map(Place::Joints), status.actual_position.map(Place::Pose)],
            start: None,
            frames,
            code: arm::code(status).map(str::to_owned),
        }
    }
}

impl Batch {
    /// A first motion that was accepted.
    pub(super) fn new(accepted: Instant, goal: Destination, begin: Begin) -> Self {
        Self { accepted, goal, code_before: begin.code.clone(), has_left: false, count: 1, frames: begin.frames, begin }
    }

    /// One more that was accepted after it.
    pub(super) fn then(self, accepted: Instant, goal: Destination, frames: SelectedFrames) -> Self {
        Self { accepted, goal, count: self.count.saturating_add(1), frames, ..self }
    }

    /// True for one motion that began at rest away from its goal: it is there only at its end.
    pub(super) fn is_simple(&self) -> bool {
        let Destination::At(goal, _) = self.goal else { return false };
        let mut places = self.begin.places.iter().chain([&self.begin.start]).flatten();
        self.count == 1 && self.begin.at_rest && !places.any(|place| goal.is_at(place))
    }

    /// The goal, unless it is a pose and the frames have changed since it was given.
    pub(super) fn goal_now(&self, newest: &RobotStatus, changes: u64) -> Destination {
        let has_changed = self.frames.changes != changes || self.frames.differ_from(newest);
        match self.goal {
            Destination::At(Place::Pose(_), _) if has_changed => Destination::Unknown,
            goal => goal,
        }
    }
}
