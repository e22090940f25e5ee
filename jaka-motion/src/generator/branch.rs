//! Joint positions for a pose.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::Generator;
use crate::beyond::Beyond;

impl Generator {
    /// The joint positions that bring the tool to a pose, nearest to the last set-point, and on the same side of each singularity.
    ///
    /// # Errors
    /// The pose is out of reach, no joint positions on this branch reach it, or those that do are beyond a joint's range or a region.
    pub fn joints_for(&self, pose: Pose) -> Result<JointPosition, Beyond> {
        self.checker.joints_on_branch(self.joints(), pose)
    }
}
