//! From joint positions to the flange.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};

use super::model::Model;

impl Model {
    /// The flange in the base frame, in mm, for joint positions in degrees; soft limits are not looked at.
    ///
    /// Joint positions that are not finite give a transform that is not finite either.
    pub fn forward(&self, joints: [f64; 6]) -> Isometry3<f64> {
        self.product(0..6, &self.angles(&joints))
    }

    /// The angles of the links in radians for joint positions in degrees.
    pub(super) fn angles(&self, joints: &[f64; 6]) -> [f64; 6] {
        std::array::from_fn(|index| (joints[index] + self.joint_homeoff[index]).to_radians())
    }

    /// The transform across consecutive links, counted from 0, at angles in radians.
    pub(super) fn product(&self, links: std::ops::Range<usize>, angles: &[f64; 6]) -> Isometry3<f64> {
        links.fold(Isometry3::identity(), |before, index| before * self.link(index, angles[index]))
    }

    /// The frame of every joint in the base frame at angles in radians; the last one is the flange.
    pub(super) fn frames(&self, angles: &[f64; 6]) -> [Isometry3<f64>; 6] {
        let mut frame = Isometry3::identity();
        std::array::from_fn(|index| {
            frame *= self.link(index, angles[index]);
            frame
        })
    }

    /// No point of the flange is further than this from the base, in mm.
    pub(super) fn reach(&self) -> f64 {
        self.a.iter().chain(&self.d).map(|length| length.abs()).sum()
    }

    fn link(&self, index: usize, angle: f64) -> Isometry3<f64> {
        let twist = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), self.alpha[index].to_radians());
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle);
        let along = Vector3::x() * self.a[index] + twist * Vector3::z() * self.d[index];
        Isometry3::from_parts(Translation3::from(along), twist * turn)
    }
}
