//! From joint positions to the flange.

use jaka_proto::messages::types::JointPosition;
use nalgebra::Isometry3;

use super::Model;
use crate::links;
use crate::transform::Transform;

impl Model {
    /// The flange in the arm's base for these joint positions; the joints' ranges are not checked.
    ///
    /// Joint positions that are not finite give a transform that is not finite either. For the pose of a tool in a user frame
    /// see [`Frames::pose`](crate::Frames::pose).
    pub fn forward(&self, joints: impl Into<JointPosition>) -> Transform {
        Transform(self.links.flange(&joints.into().0))
    }

    /// The frames of the six joints in the arm's base; the last one is the flange.
    ///
    /// The axis of each joint is the z axis of its frame. The third lies at the elbow, the fifth at the wrist, where the axes
    /// of joints 5 and 6 meet.
    pub fn joint_frames(&self, joints: impl Into<JointPosition>) -> [Transform; 6] {
        self.links.frames(&joints.into().0).map(Transform)
    }

    /// How the tool moves with each joint: the rows are its velocity along x, y, z of the arm's base in mm/s and its turning
    /// about these directions in deg/s, the columns the joints, each for 1 deg/s.
    ///
    /// `tool` is seen from the flange; only its position counts.
    pub fn jacobian(&self, joints: impl Into<JointPosition>, tool: &Transform) -> [[f64; 6]; 6] {
        let frames = self.links.frames(&joints.into().0);
        let tool: Isometry3<f64> = frames[5] * tool.0;
        let jacobian = links::jacobian(&frames, &tool.translation.vector);
        std::array::from_fn(|row| {
            std::array::from_fn(|joint| {
                let entry = jacobian[(row, joint)];
                // mm for a radian are more than mm for a degree; a turn has the same unit above and below.
                if row < 3 { entry.to_radians() } else { entry }
            })
        })
    }
}
