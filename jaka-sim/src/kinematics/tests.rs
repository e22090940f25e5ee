//! What the tests share: a deterministic source of numbers, and differences between transforms.

mod conventions;
mod hostile;
mod polish;
mod round_trip;
mod urdf;

use nalgebra::Isometry3;

use super::Model;

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

    fn joints(&mut self, model: &Model) -> [f64; 6] {
        std::array::from_fn(|index| self.between(model.joint_min()[index], model.joint_max()[index]))
    }
}

/// How far apart two transforms are in mm and degrees.
fn apart(one: &Isometry3<f64>, other: &Isometry3<f64>) -> (f64, f64) {
    let moved = (one.translation.vector - other.translation.vector).norm();
    (moved, one.rotation.angle_to(&other.rotation).to_degrees())
}

#[track_caller]
fn assert_close(one: &Isometry3<f64>, other: &Isometry3<f64>, within: (f64, f64), what: &str) {
    let (moved, turned) = apart(one, other);
    assert!(moved <= within.0 && turned <= within.1, "{what}: {moved} mm, {turned} degrees apart");
}
