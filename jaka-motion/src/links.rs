//! Chain of links, and the frames of the joints.

use std::f64::consts::FRAC_1_SQRT_2;
use std::ops::Range;

use nalgebra::{Isometry3, Matrix6, Quaternion, Translation3, UnitQuaternion, Vector3, Vector6};

/// Denavit-Hartenberg parameters in mm and degrees, in Craig's convention.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Links {
    pub(crate) alpha: [f64; 6],
    pub(crate) a: [f64; 6],
    pub(crate) d: [f64; 6],
    pub(crate) joint_home_offset: [f64; 6],
}

impl Links {
    /// Returns the angles of the links in radians for joint positions in degrees.
    pub(crate) fn angles(&self, joints: &[f64; 6]) -> [f64; 6] {
        std::array::from_fn(|index| (joints[index] + self.joint_home_offset[index]).to_radians())
    }

    /// Returns the joint positions in degrees for angles of the links in radians.
    pub(crate) fn positions(&self, angles: &[f64; 6]) -> [f64; 6] {
        std::array::from_fn(|index| angles[index].to_degrees() - self.joint_home_offset[index])
    }

    /// Returns the transform across consecutive links, counted from 0, at angles in radians.
    pub(crate) fn product(&self, links: Range<usize>, angles: &[f64; 6]) -> Isometry3<f64> {
        links.fold(Isometry3::identity(), |before, index| before * self.link(index, angles[index]))
    }

    /// Returns the flange in the base frame for joint positions in degrees.
    pub(crate) fn flange(&self, joints: &[f64; 6]) -> Isometry3<f64> {
        self.product(0..6, &self.angles(joints))
    }

    /// Returns the frames of all joints in the base frame for joint positions in degrees; the last one is the flange.
    pub(crate) fn frames(&self, joints: &[f64; 6]) -> [Isometry3<f64>; 6] {
        let angles = self.angles(joints);
        let mut frame = Isometry3::identity();
        std::array::from_fn(|index| {
            frame *= self.link(index, angles[index]);
            frame
        })
    }

    /// Returns the greatest possible distance of a point of the flange from the base, in mm.
    pub(crate) fn length(&self) -> f64 {
        self.a.iter().chain(&self.d).map(|length| length.abs()).sum()
    }

    /// Returns a bound of the Jacobian's determinant, in mm³, on an arm with an offset wrist: upper arm times forearm
    /// times their sum.
    pub(crate) fn largest_determinant(&self) -> f64 {
        let (upper_arm, forearm) = (self.a[2].abs(), self.d[3].abs());
        upper_arm * forearm * (upper_arm + forearm)
    }

    /// Returns the transform across one link: `Rx(alpha) Tx(a) Rz(angle) Tz(d)`, multiplied out.
    fn link(&self, index: usize, angle: f64) -> Isometry3<f64> {
        let (half_sin, half_cos) = half_turn(self.alpha[index]);
        let (twist_sin, twist_cos) = (2.0 * half_sin * half_cos, half_cos * half_cos - half_sin * half_sin);
        let along = Translation3::new(self.a[index], -twist_sin * self.d[index], twist_cos * self.d[index]);
        let (sin, cos) = (0.5 * angle).sin_cos();
        let turn = Quaternion::new(half_cos * cos, half_sin * cos, -half_sin * sin, half_cos * sin);
        Isometry3::from_parts(along, UnitQuaternion::new_unchecked(turn))
    }
}

/// Returns sine and cosine of half an angle in degrees; exact for the angles of most links.
fn half_turn(degrees: f64) -> (f64, f64) {
    match degrees {
        0.0 => (0.0, 1.0),
        90.0 => (FRAC_1_SQRT_2, FRAC_1_SQRT_2),
        -90.0 => (-FRAC_1_SQRT_2, FRAC_1_SQRT_2),
        degrees => (0.5 * degrees.to_radians()).sin_cos(),
    }
}

/// Returns the motion of a point on the last link with each joint: mm per radian, and in the rows below radians per
/// radian.
pub(crate) fn jacobian(frames: &[Isometry3<f64>; 6], point: &Vector3<f64>) -> Matrix6<f64> {
    Matrix6::from_columns(&frames.map(|frame| {
        let axis = frame.rotation * Vector3::z();
        let moved = axis.cross(&(point - frame.translation.vector));
        [moved.x, moved.y, moved.z, axis.x, axis.y, axis.z].into()
    }))
}

/// Returns the change of the velocity of a point on the last link while the joints keep these rates, in radians a
/// second: mm/s², and in the rows below rad/s².
pub(crate) fn bend(frames: &[Isometry3<f64>; 6], point: &Vector3<f64>, rates: &[f64; 6]) -> Vector6<f64> {
    let axes = frames.map(|frame| frame.rotation * Vector3::z());
    let origins = frames.map(|frame| frame.translation.vector);
    let whole: Vector3<f64> = (0..6).map(|joint| axes[joint].cross(&(point - origins[joint])) * rates[joint]).sum();
    let (mut moved, mut turned, mut turning) = (Vector3::zeros(), Vector3::zeros(), Vector3::zeros());
    // Motion of the origin of each joint with the joints before it.
    let (mut before, mut carried) = (origins[0], Vector3::zeros());
    for joint in 0..6 {
        carried += turning.cross(&(origins[joint] - before));
        before = origins[joint];
        // The axis of a joint turns with the joints before it.
        let swing = turning.cross(&axes[joint]);
        let lever = point - origins[joint];
        moved += (swing.cross(&lever) + axes[joint].cross(&(whole - carried))) * rates[joint];
        turned += swing * rates[joint];
        turning += axes[joint] * rates[joint];
    }
    Vector6::new(moved.x, moved.y, moved.z, turned.x, turned.y, turned.z)
}
