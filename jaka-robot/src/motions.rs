//! Motions that can be waited for.

mod target;

use jaka_proto::Command;
use jaka_proto::messages::force::StartTorqSensorPayloadIdentify;
use jaka_proto::messages::motion::{EndMove, JointMove, LineMode, MoveC, MoveL};
use jaka_proto::messages::types::{MoveMode, Pose};

pub use self::target::Target;

/// A planned motion: one whose reply says that it was accepted, and whose end is waited for.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a motion whose end a robot waits for",
    note = "any other command goes out by `Robot::client`: `robot.client().call(&request)`",
    note = "a motion of a pack implements `Motion`, which says where it ends"
)]
pub trait Motion: Command<Reply = ()> {
    /// Where it ends, as far as the request determines it. The controller's own answer says whether the arm is there.
    fn target(&self) -> Target;

    /// The way on which it goes there. A robot with limits refuses a motion whose way is not known, as it is by default.
    fn path(&self) -> Path {
        Path::Unknown
    }

    /// How far from its target it may end, in mm, since the controller may blend it into the next motion. 0 for none.
    fn tolerance(&self) -> f64 {
        0.0
    }
}

/// The way of a [`Motion`] to its target, and how fast it goes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Path {
    /// All joints at once, from beginning to end together.
    Joints {
        /// The speed of the joint with the longest way, in deg/s.
        speed: f64,
        /// Its acceleration in deg/s²; none where the controller chooses it.
        acceleration: Option<f64>,
    },
    /// The tool centre point on a straight line.
    Line {
        /// Its speed in mm/s.
        speed: f64,
        /// Its acceleration in mm/s²; none where the controller chooses it.
        acceleration: Option<f64>,
    },
    /// The tool centre point on an arc.
    Arc {
        /// The pose between its ends, in the frames that are selected when it is sent; mm and degrees.
        through: Pose,
        /// The speed of the tool centre point in mm/s.
        speed: f64,
        /// Its acceleration in mm/s²; none where the controller chooses it.
        acceleration: Option<f64>,
    },
    /// The request does not determine it.
    Unknown,
}

impl Motion for JointMove {
    fn target(&self) -> Target {
        match self.mode {
            MoveMode::Absolute => Target::Joints(self.joint_position),
            MoveMode::Relative => Target::JointOffset(self.joint_position),
            _ => Target::Unknown,
        }
    }

    /// No source says which joint has the speed that is given; taken is the one with the longest way, as controllers of such arms do.
    fn path(&self) -> Path {
        Path::Joints { speed: self.speed, acceleration: self.acceleration }
    }
}

/// Its way to the position is the controller's choice.
impl Motion for StartTorqSensorPayloadIdentify {
    fn target(&self) -> Target {
        Target::Joints(self.joint_position)
    }
}

impl Motion for EndMove {
    fn target(&self) -> Target {
        Target::Pose(self.pose)
    }

    fn path(&self) -> Path {
        Path::Joints { speed: self.speed, acceleration: self.acceleration }
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

    fn path(&self) -> Path {
        Path::Line { speed: self.speed, acceleration: self.acceleration }
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

    fn path(&self) -> Path {
        Path::Arc { through: self.mid_pose, speed: self.speed, acceleration: Some(self.acceleration) }
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }
}
