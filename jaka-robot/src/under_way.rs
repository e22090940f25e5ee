//! Changes that packets show while the arm moves, and that are not its motion: the selected frames and the rapid rate.

use std::fmt;
use std::time::Instant;

use jaka_proto::messages::status::RobotStatus;

use crate::Snapshot;

/// Ids of the selected tool frame and user frame, as status packets show them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct SelectedFrames {
    /// Id of the tool frame; `None` if packets do not show it.
    pub tool: Option<i64>,
    /// Id of the user frame; `None` if packets do not show it.
    pub user: Option<i64>,
}

/// Change of the selected frames since the start of a motion, as a status packet shows it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct FrameChange {
    /// Frames at the start.
    pub before: SelectedFrames,
    /// Frames in the packet.
    pub after: SelectedFrames,
}

impl SelectedFrames {
    pub(crate) fn of(status: &RobotStatus) -> Self {
        Self { tool: status.current_tool_id, user: status.current_user_frame_id }
    }

    /// Change from these frames to a packet's: of an id that one of both does not have, no change is known.
    pub(crate) fn change_to(self, status: &RobotStatus) -> Option<FrameChange> {
        let change = FrameChange { before: self, after: Self::of(status) };
        change.ids().next().is_some().then_some(change)
    }
}

impl FrameChange {
    /// Kind, id before and id after of each frame that is another one.
    fn ids(&self) -> impl Iterator<Item = (&'static str, i64, i64)> {
        let Self { before, after } = *self;
        let pairs = [("tool", before.tool, after.tool), ("user", before.user, after.user)];
        let known = pairs.into_iter().filter_map(|(kind, before, after)| Some((kind, before?, after?)));
        known.filter(|(_, before, after)| before != after)
    }
}

impl fmt::Display for FrameChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (kind, before, after)) in self.ids().enumerate() {
            let joint = if index == 0 { "" } else { ", " };
            write!(f, "{joint}{kind} frame {after}, {before} before")?;
        }
        Ok(())
    }
}

/// Selected frames and rapid rate, from the start of a motion on.
#[derive(Debug, Clone, Default)]
pub(crate) struct UnderWay {
    start: Start,
    /// Change that the newest packet shows.
    change: Option<FrameChange>,
    /// The rate of all packets that is the furthest from 1; `None` if they show none.
    rapid_rate: Option<f64>,
    /// Number of the newest packet.
    packet: u64,
    was_told_unknown: bool,
}

/// Frames at the start.
#[derive(Debug, Clone, Copy, Default)]
enum Start {
    /// None is compared.
    #[default]
    Unknown,
    /// Frames of the first packet that comes after this time: this program has changed frames shortly before.
    After(Instant),
    Shown(SelectedFrames),
}

impl UnderWay {
    /// From a packet on that shows the frames of the start.
    pub(crate) fn from(newest: &Snapshot) -> Self {
        let mut begun = Self { start: Start::Shown(SelectedFrames::of(&newest.status)), ..Self::default() };
        begun.see(newest);
        begun
    }

    /// From the first packet on that comes after this.
    pub(crate) fn after(now: Instant) -> Self {
        Self { start: Start::After(now), ..Self::default() }
    }

    /// Compares no frames any more: this program itself has changed them.
    pub(crate) fn forget_frames(&mut self) {
        (self.start, self.change) = (Start::Unknown, None);
    }

    /// Takes the newest packet. A rate other than 1 is logged once.
    pub(crate) fn see(&mut self, newest: &Snapshot) {
        if newest.number <= self.packet {
            return;
        }
        self.packet = newest.number;
        match self.start {
            Start::After(since) if newest.received > since => {
                self.start = Start::Shown(SelectedFrames::of(&newest.status));
            }
            Start::Unknown | Start::After(_) | Start::Shown(_) => {}
        }
        self.change = self.frames().change_to(&newest.status);
        self.rapid_rate = newest.status.rapid_rate.map(|rate| self.furthest(rate)).or(self.rapid_rate);
    }

    /// Change of the frames, for a motion that depends on them. Where packets do not show them, that is logged once.
    pub(crate) fn change(&mut self) -> Option<FrameChange> {
        let is_unknown = matches!(self.start, Start::Shown(SelectedFrames { tool, user }) if tool.and(user).is_none());
        if is_unknown && !self.was_told_unknown {
            self.was_told_unknown = true;
            log::warn!(target: "jaka_robot", "status packets do not show the selected frames: a change of them is not noticed");
        }
        self.change
    }

    /// Frames at the start, where packets have shown them.
    pub(crate) fn frames(&self) -> SelectedFrames {
        match self.start {
            Start::Shown(frames) => frames,
            Start::Unknown | Start::After(_) => SelectedFrames::default(),
        }
    }

    /// The rate of all packets that is the furthest from 1; `None` if they show none.
    pub(crate) fn rapid_rate(&self) -> Option<f64> {
        self.rapid_rate
    }

    fn furthest(&self, rate: f64) -> f64 {
        let off = |rate: f64| (rate - 1.0).abs();
        let before = self.rapid_rate.unwrap_or(1.0);
        if off(rate) <= off(before) {
            return before;
        }
        if off(before) < f64::EPSILON {
            log::warn!(target: "jaka_robot", "the rapid rate is {rate} of 1: motions run at another speed than requested");
        }
        rate
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frames(tool: Option<i64>, user: Option<i64>) -> RobotStatus {
        let mut status = RobotStatus::default();
        (status.current_tool_id, status.current_user_frame_id) = (tool, user);
        status
    }

    #[test]
    fn an_id_that_one_packet_does_not_show_is_no_change() {
        let start = SelectedFrames::of(&frames(Some(0), None));
        for same in [frames(Some(0), None), frames(Some(0), Some(3)), frames(None, None)] {
            assert_eq!(start.change_to(&same), None);
        }
        let change = start.change_to(&frames(Some(2), Some(3))).expect("another tool");
        assert_eq!(change.to_string(), "tool frame 2, 0 before");
        let both = SelectedFrames::of(&frames(Some(0), Some(1))).change_to(&frames(Some(2), Some(3)));
        assert_eq!(both.expect("both").to_string(), "tool frame 2, 0 before, user frame 3, 1 before");
    }
}
