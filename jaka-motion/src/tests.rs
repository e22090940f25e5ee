//! Shared helpers of the tests: a deterministic random generator, and differences between transforms.

#[cfg(feature = "generator")]
mod braking;
mod calibrated;
mod checker;
mod conventions;
mod differences;
mod fit;
mod follower;
#[cfg(feature = "generator")]
mod generator;
mod hostile;
mod limits;
mod offset_wrist;
mod options;
mod overtravel;
mod round_trip;
mod trajectory;

use jaka_proto::messages::types::Pose;

use crate::{Model, Transform};

/// Marsaglia's xorshift, 64 bits.
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        Self(seed | 1)
    }

    fn between(&mut self, min: f64, max: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        let unit = f64::from(u32::try_from(self.0 >> 32).expect("32 bits are left")) / f64::from(u32::MAX);
        min + unit * (max - min)
    }

    fn below(&mut self, count: u8) -> usize {
        let at = self.between(0.0, f64::from(count));
        (0..count).rev().find(|number| f64::from(*number) <= at).unwrap_or(0).into()
    }

    fn joints(&mut self, model: &Model) -> [f64; 6] {
        std::array::from_fn(|index| self.between(model.joint_min()[index], model.joint_max()[index]))
    }
}

/// Returns the transform of a pose in mm and degrees.
fn from_pose(pose: [f64; 6]) -> Transform {
    Pose::from(pose).into()
}

/// Returns the pose in mm and degrees of a transform.
fn to_pose(transform: Transform) -> [f64; 6] {
    Pose::from(transform).into()
}

/// Returns the distance between two transforms, in mm and degrees.
fn apart(one: &Transform, other: &Transform) -> (f64, f64) {
    (one.distance_mm(other), one.angle_deg(other))
}

#[track_caller]
fn assert_close(one: &Transform, other: &Transform, within: (f64, f64), what: &str) {
    let (moved, turned) = apart(one, other);
    assert!(moved <= within.0 && turned <= within.1, "{what}: {moved} mm, {turned} degrees apart");
}
