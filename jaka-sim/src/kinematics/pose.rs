//! Poses as the wire has them.

use jaka_proto::messages::types::{JointPosition, Pose};
use nalgebra::{Isometry3, Translation3, UnitQuaternion};

use super::Model;

/// How close to gimbal lock, as the cosine of `ry`, rz is set to zero.
const LOCKED: f64 = 1e-10;

/// The transform of a pose `[x, y, z, rx, ry, rz]` in mm and degrees.
///
/// A pose with a number that is not finite gives a transform that
/// [`Model::inverse`](super::Model::inverse) refuses.
pub(crate) fn from_pose(pose: [f64; 6]) -> Isometry3<f64> {
    let [x, y, z, rx, ry, rz] = pose;
    let turn = UnitQuaternion::from_euler_angles(rx.to_radians(), ry.to_radians(), rz.to_radians());
    Isometry3::from_parts(Translation3::new(x, y, z), turn)
}

/// The pose `[x, y, z, rx, ry, rz]` in mm and degrees of a transform; `ry` is within 90 degrees of zero.
///
/// At gimbal lock, where `ry` is 90 or -90, only the sum or difference of `rx` and `rz` is given: `rz` is zero there.
/// A rotation converted to a pose and back is the same everywhere, since `rx` and `ry` are computed after `rz` has been
/// taken out.
pub(crate) fn to_pose(transform: &Isometry3<f64>) -> [f64; 6] {
    let turn = transform.rotation.to_rotation_matrix();
    let (x_x, x_y) = (turn[(0, 0)], turn[(1, 0)]);
    let rz = if x_x.hypot(x_y) < LOCKED { 0.0 } else { x_y.atan2(x_x) };
    let (sin, cos) = rz.sin_cos();
    let ry = (-turn[(2, 0)]).atan2(x_x.hypot(x_y));
    let rx = (sin * turn[(0, 2)] - cos * turn[(1, 2)]).atan2(cos * turn[(1, 1)] - sin * turn[(0, 1)]);
    let at = transform.translation.vector;
    // Adding zero turns -0 into 0, which is what a reader of the wire expects.
    [at.x, at.y, at.z, rx.to_degrees(), ry.to_degrees(), rz.to_degrees()].map(|number| number + 0.0)
}

impl Model {
    /// The pose of the flange in the base frame for these joints; soft limits are not checked.
    pub fn flange(&self, joints: JointPosition) -> Pose {
        to_pose(&self.forward(joints.0)).into()
    }

    /// The joints within the soft limits that bring the flange to a pose, those nearest to `reference`; `None` if the arm cannot
    /// reach it.
    pub fn joints(&self, flange: Pose, reference: JointPosition) -> Option<JointPosition> {
        self.inverse(&from_pose(flange.into()), reference.0).map(Into::into)
    }
}
