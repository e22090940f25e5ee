//! From joint positions to the flange.

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};

use super::model::Model;

impl Model {
    /// The flange in the base frame, in mm, for joint positions in degrees; soft limits are not checked.
    ///
    /// Joint positions that are not finite give a transform that is not finite either.
    pub(crate) fn forward(&self, joints: [f64; 6]) -> Isometry3<f64> {
        self.product(0..6, &self.angles(&joints))
    }

    /// The angles of the links in radians for joint positions in degrees.
    pub(super) fn angles(&self, joints: &[f64; 6]) -> [f64; 6] {
        std::array::from_fn(|index| (joints[index] + self.joint_home_offset[index]).to_radians())
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

    /// The transform across one link: `Rx(alpha) Tx(a) Rz(angle) Tz(d)`, multiplied out.
    fn link(&self, index: usize, angle: f64) -> Isometry3<f64> {
        let (twist_sin, twist_cos) = self.alpha[index].to_radians().sin_cos();
        let along = Translation3::new(self.a[index], -twist_sin * self.d[index], twist_cos * self.d[index]);
        let (half_sin, half_cos) = (0.5 * self.alpha[index].to_radians()).sin_cos();
        let (sin, cos) = (0.5 * angle).sin_cos();
        let turn = Quaternion::new(half_cos * cos, half_sin * cos, -half_sin * sin, half_cos * sin);
        Isometry3::from_parts(along, UnitQuaternion::new_unchecked(turn))
    }
}
