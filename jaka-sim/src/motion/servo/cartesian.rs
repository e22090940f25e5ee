//! Limits of the tool centre point's motion: filter 4 of 4.60.

use jaka_motion::{Model, Transform};
use jaka_proto::messages::types::Pose;

use super::tracker::Tracker;
use crate::motion::Joints;
use crate::motion::vector::{minus, plus};

/// Filter that follows poses within limits of translation and rotation.
#[derive(Debug, Clone)]
pub(crate) struct Cartesian {
    translation: Tracker<3>,
    rotation: Tracker<3>,
    /// Pose of the tool.
    at: Transform,
    /// Target pose of the tool in the last cycle.
    before: Transform,
    /// Tool frame relative to the flange.
    tool: Transform,
}

impl Cartesian {
    pub(super) fn new(translation: Tracker<3>, rotation: Tracker<3>, at: Transform, tool: Transform) -> Self {
        Self { translation, rotation, at, before: at, tool }
    }

    /// Accepts joints without limits.
    pub(super) fn pass(&mut self, joints: Joints, model: &Model) -> Joints {
        let at = model.forward(joints) * self.tool;
        (self.at, self.before) = (at, at);
        self.translation.halt();
        self.rotation.halt();
        joints
    }

    /// Computes one cycle; returns `None` if no joints near to these reach the pose.
    pub(super) fn next(&mut self, joints: Joints, to: Joints, model: &Model) -> Option<Joints> {
        let target = model.forward(to) * self.tool;
        let way = minus(target.position_mm(), self.before.position_mm());
        let translation = self.translation.next(minus(self.at.position_mm(), self.before.position_mm()), way);
        // Small rotations are vectors. For large ones, this affects only the direction in which the tool turns back.
        let rotation = self.rotation.next(turn(self.before, self.at), turn(self.before, target));
        self.before = target;
        if translation.arrives && rotation.arrives {
            self.at = target;
            return Some(to);
        }
        let [rx, ry, rz] = rotation.by;
        let by = Transform::from(Pose::from([0.0, 0.0, 0.0, rx, ry, rz]));
        let turned = Pose::from(if rotation.arrives { target } else { self.at * by });
        let moved = plus(self.at.position_mm(), translation.by);
        let [x, y, z] = if translation.arrives { target.position_mm() } else { moved };
        self.at = Pose { x, y, z, ..turned }.into();
        model.inverse(self.at * self.tool.inverse(), joints).ok().map(Into::into)
    }

    pub(super) fn is_at_rest(&self) -> bool {
        self.translation.is_at_rest() && self.rotation.is_at_rest()
    }
}

/// Returns the rotation from one orientation to another, about the axes of the first, in degrees.
fn turn(from: Transform, to: Transform) -> [f64; 3] {
    let [_, _, _, rx, ry, rz] = <[f64; 6]>::from(Pose::from(from.inverse() * to));
    [rx, ry, rz]
}
