//! Poses to which the controller finds the way in joint space.

use jaka_proto::messages::types::Pose;

use super::Checker;
use super::pace::JointPace;
use crate::beyond::Found;
use crate::transform::Transform;

impl Checker {
    pub(super) fn end_move(&self, from: &[f64; 6], to: Pose, pace: JointPace) -> Result<(), Found> {
        let flange = Transform(self.in_base(to) * self.tool.inverse());
        let branches = self.limits.model().inverse_all(flange, *from).map_err(|reason| (reason.into(), 1.0))?;
        branches.iter().try_for_each(|joints| self.joint_way(from, &joints.0, pace))
    }
}
