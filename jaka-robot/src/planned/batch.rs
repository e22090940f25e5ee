//! Motions that were accepted and have not been waited for.

use std::time::Instant;

use jaka_proto::messages::status::RobotStatus;

use super::destination::Destination;
use crate::arm::Since;
use crate::place::Place;
use crate::under_way::UnderWay;
use crate::{FrameChange, SelectedFrames, Snapshot};

/// Motions that were accepted and have not been waited for.
#[derive(Debug, Clone)]
pub(super) struct Batch {
    /// Time at which the last one was accepted: packets and answers from before say nothing about it.
    pub(super) accepted: Instant,
    pub(super) goal: Destination,
    /// Packets after which news counts.
    pub(super) since: Since,
    /// True if a packet has said since that the arm is not in position: only after that can one say that the motion has
    /// ended.
    pub(super) has_left: bool,
    count: u32,
    pub(super) begin: Begin,
    frames: GoalFrames,
    pub(super) under_way: UnderWay,
    /// True if one of the motions depends on the selected frames.
    depends_on_frames: bool,
}

/// State of the arm when the first motion was sent, as far as it was known.
#[derive(Debug, Clone, Default)]
pub(super) struct Begin {
    pub(super) at_rest: bool,
    /// By the status, which may be old.
    pub(super) places: [Option<Place>; 2],
    /// By a query.
    pub(super) start: Option<Place>,
    pub(super) frames: GoalFrames,
    pub(super) under_way: UnderWay,
    /// True if the motion depends on the selected frames.
    pub(super) depends_on_frames: bool,
    /// Number of the newest packet.
    pub(super) packet: u64,
    /// The latest stop before: a later one ends the motion.
    pub(super) stops: u64,
}

/// Frames of a goal, by packets, unless these may be older than a change by this program; and the number of changes by
/// it and by the other handles of its connection until then.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct GoalFrames {
    pub(super) shown: SelectedFrames,
    /// Changes of frames on this connection.
    pub(super) changes: u64,
    /// Changes of anything by other handles of it.
    pub(super) by_others: u64,
}

impl Begin {
    /// By the newest packet.
    pub(super) fn new(newest: &Snapshot, frames: GoalFrames, under_way: UnderWay) -> Self {
        let status = &newest.status;
        Self {
            at_rest: status.in_position == Some(true) && status.paused != Some(true),
            places: [status.joint_actual_position.map(Place::Joints), status.actual_position.map(Place::Pose)],
            start: None,
            frames,
            under_way,
            depends_on_frames: false,
            packet: newest.number,
            stops: 0,
        }
    }
}

impl Batch {
    /// A first motion that was accepted, after this packet.
    pub(super) fn new(accepted: Instant, packet: u64, goal: Destination, begin: Begin) -> Self {
        let (frames, under_way, depends_on_frames) = (begin.frames, begin.under_way.clone(), begin.depends_on_frames);
        let since = Since { events: begin.packet, states: packet };
        Self { accepted, goal, since, has_left: false, count: 1, begin, frames, under_way, depends_on_frames }
    }

    /// One more that was accepted after it, and after this packet.
    pub(super) fn then(self, accepted: Instant, packet: u64, goal: Destination, begin: Begin) -> Self {
        let since = Since { states: packet, ..self.since };
        let depends_on_frames = self.depends_on_frames || begin.depends_on_frames;
        let is_same = begin.frames.changes == self.frames.changes;
        let under_way = if is_same { self.under_way } else { begin.under_way };
        let count = self.count.saturating_add(1);
        Self { accepted, goal, since, count, frames: begin.frames, under_way, depends_on_frames, ..self }
    }

    /// Compares no frames any more, if they were changed by the handle that started the motions.
    pub(super) fn wait_after(&mut self, changes: u64, by_others: u64) {
        if changes != self.frames.changes && by_others == self.frames.by_others {
            self.under_way.forget_frames();
        }
    }

    /// Change of the frames since the start, if a motion depends on them.
    pub(super) fn frame_change(&mut self) -> Option<FrameChange> {
        if self.depends_on_frames { self.under_way.change() } else { None }
    }

    /// True for one motion that began at rest away from its goal: it is there only at its end.
    pub(super) fn is_simple(&self) -> bool {
        let Destination::At(goal, _) = self.goal else { return false };
        let mut places = self.begin.places.iter().chain([&self.begin.start]).flatten();
        self.count == 1 && self.begin.at_rest && !places.any(|place| goal.is_at(place))
    }

    /// The goal, unless it is a pose and the frames have changed since it was given.
    pub(super) fn goal_now(&self, newest: &RobotStatus, changes: u64) -> Destination {
        let has_changed = self.frames.changes != changes || self.frames.shown.change_to(newest).is_some();
        match self.goal {
            Destination::At(Place::Pose(_), _) if has_changed => Destination::Unknown,
            goal => goal,
        }
    }
}
