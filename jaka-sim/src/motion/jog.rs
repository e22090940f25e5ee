//! Continuous jogs. Jogs by a distance or to a position are planned motions.

use jaka_motion::{Model, Transform};
use jaka_proto::messages::types::Pose;

use super::path::Joints;
use crate::clock::CYCLE;

/// Jog that continues until a stop or the end of the arm's range.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Jogging {
    /// One joint, by index, at a velocity in deg/s.
    Joint { index: usize, velocity: f64 },
    /// Tool centre point along or about one axis of a frame, at a velocity in mm/s or deg/s.
    Axis { index: usize, velocity: f64, reference: Reference },
}

/// Frame for the axes of a jog.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Reference {
    /// Fixed frame, and the tool frame relative to the flange.
    Fixed { base: Transform, tool: Transform },
    /// Tool frame.
    Tool { tool: Transform },
}

impl Jogging {
    /// Returns the index of the jogged axis, from 0 to 5.
    pub(crate) fn index(&self) -> usize {
        match self {
            Self::Joint { index, .. } | Self::Axis { index, .. } => *index,
        }
    }

    /// Computes one cycle; returns the joint position and whether the jog continues.
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
    /// Returns the flange after a displacement along this frame's axes.
    pub(crate) fn moved(self, flange: Transform, by: Transform) -> Transform {
        match self {
            Self::Tool { tool } => flange * tool * by * tool.inverse(),
            Self::Fixed { base, tool } => base * (base.inverse() * flange * tool).displaced(&by) * tool.inverse(),
        }
    }
}

/// Returns a displacement along, or a rotation about, one of the axes x, y, z, rx, ry, rz.
pub(crate) fn small(index: usize, amount: f64) -> Transform {
    let mut pose = [0.0; 6];
    pose[index] = amount;
    Pose::from(pose).into()
}
