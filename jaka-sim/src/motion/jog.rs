//! Continuous jogs. Jogs by a distance or to a position are planned motions.

use jaka_motion::{Model, Transform};
use jaka_proto::messages::motion::JogFrame;
use jaka_proto::messages::types::Pose;

use super::path::Joints;
use crate::clock::CYCLE;

/// Jog that continues until a stop or the end of the arm's range.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Jogging {
    /// Frame of the axes along or about which the tool centre point moves, or the joints.
    pub(crate) frame: JogFrame,
    /// Index of the axis or joint, from 0 to 5.
    pub(crate) index: usize,
    /// Velocity, in mm/s or deg/s.
    pub(crate) velocity: f64,
    /// Tool frame relative to the flange.
    pub(crate) tool: Transform,
}

impl Jogging {
    /// Computes one cycle; returns the joint position and whether the jog continues.
    pub(super) fn cycle(&self, joints: Joints, rate: f64, model: &Model) -> (Joints, bool) {
        let way = self.velocity * CYCLE.as_secs_f64() * rate;
        let next = if self.frame == JogFrame::Joint {
            let mut next = joints;
            next[self.index] += way;
            Some(next)
        } else {
            let flange = moved(self.frame, model.forward(joints), self.tool, small(self.index, way));
            model.inverse(flange, joints).ok().map(Into::into)
        };
        match next.filter(|next| model.is_within_range(*next)) {
            Some(next) => (next, true),
            None => (joints, false),
        }
    }
}

/// Returns the flange after a displacement of the tool along its own axes, or along those of the arm's base.
pub(crate) fn moved(frame: JogFrame, flange: Transform, tool: Transform, by: Transform) -> Transform {
    let moved = if frame == JogFrame::Tool { flange * tool * by } else { (flange * tool).displaced(&by) };
    moved * tool.inverse()
}

/// Returns a displacement along, or a rotation about, one of the axes x, y, z, rx, ry, rz.
pub(crate) fn small(index: usize, amount: f64) -> Transform {
    let mut pose = [0.0; 6];
    pose[index] = amount;
    Pose::from(pose).into()
}
