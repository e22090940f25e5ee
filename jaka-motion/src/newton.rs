//! Refinement of joint positions by Newton steps.

use nalgebra::{Isometry3, Vector3, Vector6};

use crate::damped::Damped;
use crate::links::{Links, jacobian};

/// Weight of one radian relative to one millimetre.
pub(crate) const RADIAN: f64 = 1e3;
/// Greatest error of the flange for a solution, in the unit of [`off`].
pub(crate) const ACCEPTED: f64 = 1e-3;
/// Settings for the refinement of joint positions.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Refinement {
    /// Error below which no further step is taken, in the unit of [`off`].
    pub(crate) exact: f64,
    /// Damping that is added to the squares of the Jacobian's singular values. These are hundreds of mm per radian away
    /// from singularities.
    pub(crate) damping: f64,
}

/// Refinement of joint positions that have only rounding errors.
pub(crate) const USUAL: Refinement = Refinement { exact: 1e-8, damping: 1.0 };
/// Greatest number of steps. Away from singularities each squares the error.
const STEPS: usize = 12;

/// Returns the small translation and rotation from one transform to the other: mm, and radians times [`RADIAN`].
pub(crate) fn off(from: &Isometry3<f64>, to: &Isometry3<f64>) -> Vector6<f64> {
    let moved: Vector3<f64> = to.translation.vector - from.translation.vector;
    let turned = (to.rotation * from.rotation.inverse()).scaled_axis() * RADIAN;
    Vector6::new(moved.x, moved.y, moved.z, turned.x, turned.y, turned.z)
}

impl Links {
    /// Returns the distance of the flange from a target, in the unit of [`off`], for joint positions in degrees.
    pub(crate) fn error(&self, joints: &[f64; 6], target: &Isometry3<f64>) -> f64 {
        off(&self.flange(joints), target).norm()
    }

    /// Returns the joint positions after one damped Newton step. Damping limits a joint that hardly moves the flange.
    pub(crate) fn newton(&self, joints: &[f64; 6], target: &Isometry3<f64>, damping: f64) -> Option<[f64; 6]> {
        let frames = self.frames(joints);
        let mut jacobian = jacobian(&frames, &frames[5].translation.vector);
        jacobian.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        let step = Damped::new(&jacobian, damping)?.turns(&off(&frames[5], target));
        Some(std::array::from_fn(|index| joints[index] + step[index].to_degrees()))
    }

    /// Returns the joint positions after Newton steps for as long as these reduce the error.
    pub(crate) fn refined(&self, joints: [f64; 6], target: &Isometry3<f64>, refinement: Refinement) -> [f64; 6] {
        let Refinement { exact, damping: least } = refinement;
        let (mut best, mut error, mut damping) = (joints, self.error(&joints, target), least);
        for _ in 0..STEPS {
            let Some(next) = (error >= exact).then(|| self.newton(&best, target, damping)).flatten() else { break };
            let next_error = self.error(&next, target);
            if next_error < error {
                (best, error, damping) = (next, next_error, least);
            } else {
                // The step is too long for a linear approximation.
                damping *= 100.0;
            }
        }
        best
    }
}
