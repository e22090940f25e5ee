//! Set-points, and those by which the arm is braked.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::turn;

/// A set-point of one of the four kinds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SetPoint {
    Joints(JointPosition),
    JointOffset(JointPosition),
    Pose(Pose),
    PoseOffset(Pose),
}

/// How far a set-point is from the one before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Step {
    /// Of the joints, in degrees.
    Joints([f64; 6]),
    /// Of the tool centre point: a position in millimetres, and a [turn](super::turn) in degrees.
    Pose([f64; 6]),
}

impl SetPoint {
    pub(super) fn is_pose(&self) -> bool {
        matches!(self, Self::Pose(_) | Self::PoseOffset(_))
    }
}

impl Step {
    pub(super) fn between_joints(from: JointPosition, to: JointPosition) -> Self {
        Self::Joints(difference(&to.0, &from.0))
    }

    pub(super) fn between_poses(from: Pose, to: Pose) -> Self {
        let [x, y, z, ..] = difference(&to.into(), &from.into());
        let [rx, ry, rz] = turn::between(from, to);
        Self::Pose([x, y, z, rx, ry, rz])
    }

    pub(super) fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Joints(parts) => Self::Joints(parts.map(|part| part * factor)),
            Self::Pose(parts) => Self::Pose(parts.map(|part| part * factor)),
        }
    }

    pub(super) fn is_none(&self) -> bool {
        let (Self::Joints(parts) | Self::Pose(parts)) = self;
        parts.iter().all(|part| *part == 0.0)
    }

    /// How far this is from another one of the same kind; none for another kind.
    pub(super) fn change_from(&self, before: &Self) -> Option<Self> {
        match (self, before) {
            (Self::Joints(now), Self::Joints(before)) => Some(Self::Joints(difference(now, before))),
            (Self::Pose(now), Self::Pose(before)) => Some(Self::Pose(difference(now, before))),
            _ => None,
        }
    }
}

fn difference(one: &[f64; 6], other: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|part| one[part] - other[part])
}
