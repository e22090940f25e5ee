//! Poses on one side of each singularity.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::Checker;
use super::amounts::ROUNDING;
use crate::beyond::{Beyond, Exceeded, Way};
use crate::model::Singularity;
use crate::transform::Transform;

impl Checker {
    /// The joint positions that bring the tool to a pose, nearest to others and on the same sides of the singularities as these.
    ///
    /// # Errors
    /// The pose is out of reach, no joint positions on this branch reach it, or those that do are beyond a joint's range or a region.
    pub fn joints_on_branch(&self, near: JointPosition, pose: Pose) -> Result<JointPosition, Beyond> {
        self.checked(Way::Place, &[near], &[pose], || {
            let joints = self.on_branch(&near.0, pose);
            let free = joints.and_then(|joints| self.place(&joints).map(|()| JointPosition(joints)));
            free.map_err(|exceeded| (exceeded, 1.0))
        })
    }

    fn on_branch(&self, near: &[f64; 6], pose: Pose) -> Result<[f64; 6], Exceeded> {
        let model = self.limits.model();
        let sides = |joints: &[f64; 6]| model.signed_distances(&model.links.frames(joints));
        let here = sides(near);
        let passed =
            |there: &[f64; 3]| (0..3).find(|index| here[*index].abs() > ROUNDING && here[*index] * there[*index] < 0.0);
        let flange = Transform(self.in_base(pose) * self.tool.inverse());
        let branches = model.inverse_all(flange, *near)?;
        if let Some(joints) = branches.iter().find(|joints| passed(&sides(&joints.0)).is_none()) {
            return Ok(joints.0);
        }
        let which = branches.first().and_then(|joints| passed(&sides(&joints.0)));
        let least = self.limits.singularity_distance();
        Err(which.map_or(Exceeded::NotConfirmed, |index| Exceeded::Singularity {
            which: Singularity::ALL[index],
            distance: 0.0,
            least,
        }))
    }
}
