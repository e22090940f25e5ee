//! Motions with an end that can be awaited.

use crate::command::Command;
use crate::messages::types::{JointPosition, Pose};

/// Planned motion: the reply says that it was accepted, and its end is waited for.
///
/// Implemented by the generated requests of commands with a `[command.motion]` in their TOML, of packs too. Implement
/// it for another request of a pack where its target cannot be told by the names of its fields.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a motion whose end a robot waits for",
    note = "any other command goes out by `Robot::client`: `robot.client().call(&request)`",
    note = "a command of a pack is a motion by a table `[command.motion]` in the pack"
)]
pub trait Motion: Command {
    /// Target of the motion, as far as the request determines it.
    fn target(&self) -> Target;

    /// Path to the target. A robot with limits refuses a motion whose path is unknown, which is the default.
    fn path(&self) -> Path {
        Path::Unknown
    }

    /// Distance from the target at which the controller may blend into the next motion, in mm; 0 for none.
    fn tolerance(&self) -> f64 {
        0.0
    }
}

/// Target of a [`Motion`], as far as its request determines it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Target {
    /// At these joint positions, in degrees.
    Joints(JointPosition),
    /// By this offset of the joints from their start, in degrees.
    JointOffset(JointPosition),
    /// At this pose of the tool centre point, in the frames that are selected when it is sent; mm and degrees.
    Pose(Pose),
    /// By this offset from the start along x, y and z of the selected user frame, in mm, without a rotation.
    Offset([f64; 3]),
    /// The request does not determine it.
    Unknown,
}

impl Target {
    /// Target by an offset of the pose: unknown if it has a rotation, since no source says how that counts.
    pub fn pose_offset(by: Pose) -> Self {
        let has_rotation = [by.rx, by.ry, by.rz].iter().any(|angle| *angle != 0.0);
        if has_rotation { Self::Unknown } else { Self::Offset([by.x, by.y, by.z]) }
    }
}

/// Path of a [`Motion`] to its target, and its speed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Path {
    /// All joints at once, from beginning to end together.
    ///
    /// No source states the joint of the given speed; the check assumes the joint with the longest path, as controllers
    /// of such arms do.
    Joints {
        /// The speed of the joint with the longest path, in deg/s.
        speed: f64,
        /// Its acceleration in deg/s²; `None` if the controller chooses it.
        acceleration: Option<f64>,
    },
    /// The tool centre point on a straight line.
    Line {
        /// Its speed in mm/s.
        speed: f64,
        /// Its acceleration in mm/s²; `None` if the controller chooses it.
        acceleration: Option<f64>,
    },
    /// The tool centre point on an arc.
    Arc {
        /// The pose between its ends, in the frames that are selected when it is sent; mm and degrees.
        through: Pose,
        /// The speed of the tool centre point in mm/s.
        speed: f64,
        /// Its acceleration in mm/s²; `None` if the controller chooses it.
        acceleration: Option<f64>,
    },
    /// The request does not determine it.
    Unknown,
}
