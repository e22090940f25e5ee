//! Set-points, and those by which the arm is braked.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::turn::Turn;

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
    /// In degrees.
    Joints([f64; 6]),
    /// In millimetres, and a turn.
    Pose([f64; 3], Turn),
}

impl SetPoint {
    pub(super) fn is_pose(&self) -> bool {
        matches!(self, Self::Pose(_) | Self::PoseOffset(_))
    }
}

impl Step {
    pub(super) fn between_joints(from: JointPosition, to: JointPosition) -> Self {
        Self::Joints(std::array::from_fn(|joint| to.0[joint] - from.0[joint]))
    }

    pub(super) fn between_poses(from: Pose, to: Pose) -> Self {
        let (before, after) = (from.position_mm(), to.position_mm());
        Self::Pose(std::array::from_fn(|axis| after[axis] - before[axis]), Turn::between(from, to))
    }

    /// Of an offset of the pose: its angles are taken as a turn, which they are where they are small.
    pub(super) fn of_offset(offset: Pose) -> Self {
        Self::Pose(offset.position_mm(), Turn::of(offset.rotation_deg()))
    }

    pub(super) fn scaled(&self, factor: f64) -> Self {
        match *self {
            Self::Joints(step) => Self::Joints(step.map(|joint| joint * factor)),
            Self::Pose(mm, turn) => Self::Pose(mm.map(|axis| axis * factor), turn.scaled(factor)),
        }
    }

    pub(super) fn is_none(&self) -> bool {
        match self {
            Self::Joints(step) => step.iter().all(|joint| *joint == 0.0),
            Self::Pose(mm, turn) => mm.iter().all(|axis| *axis == 0.0) && turn.angle_deg() == 0.0,
        }
    }

    /// How far this is from another one of the same kind; none for another kind.
    pub(super) fn change_from(&self, before: &Self) -> Option<Self> {
        let minus = |one: f64, other: f64| one - other;
        match (self, before) {
            (Self::Joints(now), Self::Joints(before)) => {
                Some(Self::Joints(std::array::from_fn(|joint| minus(now[joint], before[joint]))))
            }
            (Self::Pose(now, turn), Self::Pose(before, turn_before)) => Some(Self::Pose(
                std::array::from_fn(|axis| minus(now[axis], before[axis])),
                turn.change_from(turn_before),
            )),
            _ => None,
        }
    }
}
