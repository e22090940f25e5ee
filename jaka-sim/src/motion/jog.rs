//! Continuous jogs. Jogs by a distance or to a position are planned motions.

use jaka_motion::{Model, Transform};
use jaka_proto::messages::types::Pose;

use super::path::Joints;
use crate::clock::CYCLE;

/// A jog that goes on until it is stopped, or the arm can go no further.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Jogging {
    /// One joint, by index, at a velocity in deg/s.
    Joint { index: usize, velocity: f64 },
    /// The tool centre point along or about one axis of a frame, at a velocity in mm/s or deg/s.
    Axis { index: usize, velocity: f64, reference: Reference },
}

/// The frame whose axes a jog follows.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Reference {
    /// A fixed frame, and the tool on the flange.
    Fixed { base: Transform, tool: Transform },
    /// The tool's own.
    Tool { tool: Transform },
}

impl Jogging {
    /// The axis that is jogged, from 0 to 5.
    pub(crate) fn index(&self) -> usize {
        match self {
            Self::Joint { index, .. } | Self::Axis { index, .. } => *index,
        }
    }

    /// One cycle: where the arm is, and whether the jog goes on.
    pub(super) fn cycle(&self, joints: Joints, rate: f64, model: &Model) -> (Joints, bool) {
        let step = CYCLE.as_secs_f64() * rate;
        let next = match *self {
            Self::Joint { index, velocity } => {
                let mut next = joints;
                next[index] += velocity * step;
                Some(next)
            }
            Self::Axis { index, velocity, reference } => {
                let flange = reference.moved(model.forward(joints), small(index, velocity * step));
                model.inverse(flange, joints).ok().map(Into::into)
            }
        };
        match next.filter(|next| model.is_within_range(*next)) {
            Some(next) => (next, true),
            None => (joints, false),
        }
    }
}

impl Reference {
    /// The flange after a displacement along this frame's axes.
    pub(crate) fn moved(self, flange: Transform, by: Transform) -> Transform {
        match self {
            Self::Tool { tool } => flange * tool * by * tool.inverse(),
            Self::Fixed { base, tool } => base * (base.inverse() * flange * tool).displaced(&by) * tool.inverse(),
        }
    }
}

/// A displacement along, or a turn about, one of the axes x, y, z, rx, ry, rz.
pub(crate) fn small(index: usize, amount: f64) -> Transform {
    let mut pose = [0.0; 6];
    pose[index] = amount;
    Pose::from(pose).into()
}
