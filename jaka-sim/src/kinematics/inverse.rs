//! From a pose to the joint positions nearest to a reference.

use nalgebra::{Isometry3, Matrix6, Vector3, Vector6};

use super::model::Model;

/// How far a solution's flange may be off: mm, and radians times this many mm.
const ACCEPTED: f64 = 1e-3;
/// An error not worth a Newton step, in the same unit.
const EXACT: f64 = 1e-8;
/// The weight of one radian relative to one millimetre.
const RADIAN: f64 = 1e3;
/// Added to the squares of the Jacobian's singular values, which are hundreds of mm per radian away from
/// singularities.
const DAMPING: f64 = 1.0;
/// A joint that is beyond its limit by this many degrees or less, which is rounding, is set to the limit.
const ON_LIMIT: f64 = 1e-6;

impl Model {
    /// The joint positions in degrees, within the soft limits, that bring the flange to `target` and are nearest to
    /// `reference`; none if the arm cannot reach `target` or an input is not finite.
    ///
    /// Nearest is the least sum of squares over the six joints. A joint that may turn more than once takes the turn
    /// nearest to the reference. Where the wrist is singular, joint 6 (joint 4 on a spherical wrist) keeps the
    /// reference's position.
    pub(crate) fn inverse(&self, target: &Isometry3<f64>, reference: [f64; 6]) -> Option<[f64; 6]> {
        let finite = target.rotation.coords.iter().chain(&reference).all(|number| number.is_finite());
        // A target that is not finite, or too large to square, fails this comparison too.
        let near_enough = target.translation.vector.norm() <= self.reach();
        if !finite || !near_enough {
            return None;
        }
        let solutions = self.closed_form(target, &self.angles(&reference));
        let mut choices: Vec<_> =
            solutions.into_iter().filter_map(|angles| self.nearest_turns(angles, &reference)).collect();
        choices.sort_by(|one, other| distance(one, &reference).total_cmp(&distance(other, &reference)));
        choices.into_iter().find_map(|joints| self.confirmed(joints, target))
    }

    /// Joint positions in degrees for angles in radians, each by as many full turns as bring it nearest to the
    /// reference.
    fn nearest_turns(&self, angles: [f64; 6], reference: &[f64; 6]) -> Option<[f64; 6]> {
        let mut joints = [0.0; 6];
        for (index, joint) in joints.iter_mut().enumerate() {
            let (min, max) = (self.joint_min[index], self.joint_max[index]);
            let position = angles[index].to_degrees() - self.joint_home_offset[index];
            let lowest = min - ON_LIMIT + (position - min + ON_LIMIT).rem_euclid(360.0);
            let from_reference = |position: &f64| (position - reference[index]).abs();
            *joint = std::iter::successors(Some(lowest), |position| Some(position + 360.0))
                .take_while(|position| *position <= max + ON_LIMIT)
                .min_by(|one, other| from_reference(one).total_cmp(&from_reference(other)))?
                .clamp(min, max);
        }
        Some(joints)
    }

    /// The joint positions, after a Newton step if rounding has left an error; none if they do not bring the flange to the
    /// target.
    fn confirmed(&self, joints: [f64; 6], target: &Isometry3<f64>) -> Option<[f64; 6]> {
        let error = |joints: &[f64; 6]| off(&self.forward(*joints), target).norm();
        let rough = error(&joints);
        if rough < EXACT {
            return Some(joints);
        }
        let polished = self.newton(&joints, target).filter(|polished| self.within_limits(polished));
        let better = polished.filter(|polished| error(polished) < rough).unwrap_or(joints);
        (error(&better) < ACCEPTED).then_some(better)
    }

    /// One damped Newton step: damping limits a joint that hardly moves the flange.
    pub(super) fn newton(&self, joints: &[f64; 6], target: &Isometry3<f64>) -> Option<[f64; 6]> {
        let frames = self.frames(&self.angles(joints));
        let flange = frames[5];
        let jacobian = Matrix6::from_columns(&frames.map(|frame| {
            let axis = frame.rotation * Vector3::z();
            let lever = flange.translation.vector - frame.translation.vector;
            stack(&axis.cross(&lever), &axis)
        }));
        let damped = jacobian * jacobian.transpose() + Matrix6::identity() * DAMPING;
        let step = jacobian.transpose() * damped.cholesky()?.solve(&off(&flange, target));
        Some(std::array::from_fn(|index| joints[index] + step[index].to_degrees()))
    }
}

/// The small translation and rotation that take one transform to the other.
fn off(from: &Isometry3<f64>, to: &Isometry3<f64>) -> Vector6<f64> {
    let turn = (to.rotation * from.rotation.inverse()).scaled_axis();
    stack(&(to.translation.vector - from.translation.vector), &turn)
}

fn stack(moved: &Vector3<f64>, turned: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(moved.x, moved.y, moved.z, RADIAN * turned.x, RADIAN * turned.y, RADIAN * turned.z)
}

fn distance(one: &[f64; 6], other: &[f64; 6]) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other) * (one - other)).sum()
}
