//! All joint angles that reach a pose, in closed form.
//!
//! Joints 2 and 3 are parallel on every arm here, so the wrist stays at a fixed distance from the vertical plane
//! through the base axis that joint 1 turns: that gives two solutions for joint 1. The wrist gives two for each, and the
//! triangle of upper arm and forearm two more: eight in all.

use std::f64::consts::PI;

use nalgebra::{Isometry3, Point3};

use super::model::{Model, Wrist};

/// How far beyond its range a sine or cosine may be by rounding; `inverse` verifies the solutions that this admits.
const ROUNDING: f64 = 1e-6;

impl Model {
    /// The angles in radians, at most eight sets, that bring the flange to `target`; where the wrist is singular, the
    /// joint that is free keeps its angle from `reference`.
    pub(super) fn closed_form(&self, target: &Isometry3<f64>, reference: &[f64; 6]) -> Vec<[f64; 6]> {
        let solve = match self.wrist {
            Wrist::Parallel => Self::parallel_wrist,
            Wrist::Spherical => Self::spherical_wrist,
        };
        self.base_angles(target).into_iter().flatten().flat_map(|first| solve(self, target, first, reference)).collect()
    }

    /// Joint 1: the wrist's offset from the plane of the arm is `x sin - y cos`.
    fn base_angles(&self, target: &Isometry3<f64>) -> [Option<f64>; 2] {
        let wrist = target * Point3::new(0.0, 0.0, -self.d[5]);
        let offset = match self.wrist {
            Wrist::Parallel => self.d[1] + self.d[2] + self.d[3],
            Wrist::Spherical => self.d[1] + self.d[2],
        };
        let Some(aside) = unit(offset / wrist.x.hypot(wrist.y)).map(f64::asin) else {
            return [None, None];
        };
        let direction = wrist.y.atan2(wrist.x);
        [Some(direction + aside), Some(direction + PI - aside)]
    }
}

/// Two bars in a plane, joined end to end: the angles at the first joint and between the bars that bring the end to
/// `x, y`.
pub(super) fn two_bars(first: f64, second: f64, x: f64, y: f64) -> [Option<(f64, f64)>; 2] {
    let cos = (x * x + y * y - first * first - second * second) / (2.0 * first * second);
    let Some(bend) = unit(cos).map(f64::acos) else {
        return [None, None];
    };
    [bend, -bend].map(|bend| Some((y.atan2(x) - (second * bend.sin()).atan2(first + second * bend.cos()), bend)))
}

/// A sine or cosine, clamped to its range if only rounding took it out.
fn unit(value: f64) -> Option<f64> {
    (value.abs() <= 1.0 + ROUNDING).then(|| value.clamp(-1.0, 1.0))
}
