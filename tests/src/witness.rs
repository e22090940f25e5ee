//! Where an arm is, computed a second time: from the vendor's URDF files, by plain matrices, without jaka-motion.

mod urdf;

use std::f64::consts::FRAC_PI_2;

use self::urdf::{Joint, URDF};

/// Below this a length in metres is noise of the drawing.
const NOISE: f64 = 0.000_4;

/// A rotation and a position in mm: the first three rows of a homogeneous matrix.
pub type Frame = [[f64; 4]; 3];

/// An arm as its URDF describes it.
#[derive(Debug, Clone)]
pub struct Witness {
    joints: [Joint; 6],
    flange: Frame,
}

impl Witness {
    /// The names of all arms.
    pub fn names() -> impl Iterator<Item = &'static str> {
        URDF.iter().map(|(name, _)| *name)
    }

    /// The arm as it is drawn, with up to 0.39 mm of noise a joint. The base mesh may lie aside of the axis of joint 1; only
    /// the height over the base counts.
    ///
    /// # Panics
    /// There is no such arm.
    pub fn drawn(name: &str) -> Self {
        let (_, mut joints) = *URDF.iter().find(|(arm, _)| *arm == name).expect("the vendor draws the arm");
        (joints[0][0], joints[0][1]) = (0.0, 0.0);
        // The mesh of the S7's last link is turned half way against those of its sisters; a flange is not.
        let half_turn = if name == "S7" { -1.0 } else { 1.0 };
        let flange = [[half_turn, 0.0, 0.0, 0.0], [0.0, half_turn, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
        Self { joints, flange }
    }

    /// The arm without that noise: lengths in hundredths of a millimetre, and quarter turns.
    ///
    /// # Panics
    /// There is no such arm.
    pub fn published(name: &str) -> Self {
        let mut arm = Self::drawn(name);
        for joint in &mut arm.joints {
            let (place, turn) = joint.split_at_mut(3);
            for length in place.iter_mut() {
                *length = if length.abs() < NOISE { 0.0 } else { (*length * 1e5).round() / 1e5 };
            }
            for angle in &mut turn[..3] {
                *angle = (*angle / FRAC_PI_2).round() * FRAC_PI_2;
            }
        }
        // The other drawings of this forearm have 303.5 mm, and so do two programs.
        if name == "Zu 7" {
            arm.joints[3][0] = 0.3035;
        }
        arm
    }

    /// The flange in the arm's base for joint positions in degrees.
    pub fn flange(&self, joints: [f64; 6]) -> Frame {
        let mut frame = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
        for ([x, y, z, roll, pitch, yaw, axis], position) in self.joints.into_iter().zip(joints) {
            frame = product(frame, pose([x * 1e3, y * 1e3, z * 1e3], [roll, pitch, yaw]));
            frame = product(frame, pose([0.0; 3], [0.0, 0.0, axis * position.to_radians()]));
        }
        product(frame, self.flange)
    }
}

/// How far two frames are apart, in mm and degrees.
pub fn apart(one: Frame, other: Frame) -> (f64, f64) {
    let (mut moved, mut turned) = (0.0, 0.0);
    for (one, other) in one.iter().zip(other) {
        moved += (one[3] - other[3]).powi(2);
        turned += (0..3).map(|column| (one[column] - other[column]).powi(2)).sum::<f64>();
    }
    // The distance of two rotation matrices is the sine of half the angle, times the root of eight.
    (moved.sqrt(), 2.0 * (turned / 8.0).sqrt().min(1.0).asin().to_degrees())
}

/// The frame at a position in mm, turned about the fixed axes x, then y, then z, by angles in radians.
pub fn pose(place: [f64; 3], [roll, pitch, yaw]: [f64; 3]) -> Frame {
    let about = |axis: usize, angle: f64| {
        let (next, last, (sin, cos)) = ((axis + 1) % 3, (axis + 2) % 3, angle.sin_cos());
        let mut frame = [[0.0; 4]; 3];
        frame[axis][axis] = 1.0;
        (frame[next][next], frame[next][last]) = (cos, -sin);
        (frame[last][next], frame[last][last]) = (sin, cos);
        frame
    };
    let mut frame = product(about(2, yaw), product(about(1, pitch), about(0, roll)));
    for (row, length) in frame.iter_mut().zip(place) {
        row[3] = length;
    }
    frame
}

/// One frame, seen from the other.
pub fn product(one: Frame, other: Frame) -> Frame {
    one.map(|row| {
        let mut sums = [0.0; 4];
        for (column, sum) in sums.iter_mut().enumerate() {
            *sum = (0..3).map(|inner| row[inner] * other[inner][column]).sum();
        }
        sums[3] += row[3];
        sums
    })
}
