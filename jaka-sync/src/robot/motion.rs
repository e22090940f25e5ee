//! Motions that can be waited for.

use jaka_proto::Command;
use jaka_proto::messages::force::StartTorqSensorPayloadIdentify;
use jaka_proto::messages::motion::{EndMove, JointMove, LineMode, MoveC, MoveL};
use jaka_proto::messages::types::MoveMode;

use super::Target;

/// A planned motion: one whose reply says that it was accepted, and whose end is waited for.
pub trait Motion: Command<Reply = ()> {
    /// Where it ends, as far as the request determines it. The controller's own answer says whether the arm is there.
    fn target(&self) -> Target;

    /// How far from its target it may end, in mm, since the controller may blend it into the next motion. 0 for none.
    fn tolerance(&self) -> f64 {
        0.0
    }
}

impl Motion for JointMove {
    fn target(&self) -> Target {
        match self.mode {
            MoveMode::Absolute => Target::Joints(self.joint_position),
            MoveMode::Relative => Target::JointOffset(self.joint_position),
            _ => Target::Unknown,
        }
    }
}

impl Motion for StartTorqSensorPayloadIdentify {
    fn target(&self) -> Target {
        Target::Joints(self.joint_position)
    }
}

impl Motion for EndMove {
    fn target(&self) -> Target {
        Target::Pose(self.pose)
    }
}

impl Motion for MoveL {
    /// An offset is one along the axes of the selected user frame; the document does not say how an offset of the orientation counts.
    fn target(&self) -> Target {
        let pose = self.pose;
        let turns = [pose.rx, pose.ry, pose.rz].iter().any(|angle| *angle != 0.0);
        match self.mode {
            LineMode::Absolute => Target::Pose(pose),
            LineMode::Relative if !turns => Target::Offset([pose.x, pose.y, pose.z]),
            _ => Target::Unknown,
        }
    }

    fn tolerance(&self) -> f64 {
        self.tolerance.unwrap_or(0.0)
    }
}

impl Motion for MoveC {
    /// The document does not say from where the offsets of an arc count.
    fn target(&self) -> Target {
        match self.mode {
            MoveMode::Absolute => Target::Pose(self.end_pose),
            _ => Target::Unknown,
        }
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }
}
