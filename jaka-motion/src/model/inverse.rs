//! From a pose to joint positions.

use jaka_proto::messages::types::JointPosition;
use nalgebra::{Isometry3, Vector3, Vector6};

use super::Model;
use crate::branches::Branches;
use crate::closed_form::UpToEight;
use crate::damped::Damped;
use crate::links::jacobian;
use crate::no_solution::NoSolution;
use crate::transform::Transform;

/// How far a solution's flange may be off: mm, and radians times [`RADIAN`].
const ACCEPTED: f64 = 1e-3;
/// An error not worth a Newton step, in the same unit.
const EXACT: f64 = 1e-8;
/// The weight of one radian relative to one millimetre.
pub(crate) const RADIAN: f64 = 1e3;
/// Added to the squares of the Jacobian's singular values, which are hundreds of mm per radian away from
/// singularities.
pub(crate) const DAMPING: f64 = 1.0;
/// The most Newton steps. Away from singularities each squares the error.
const STEPS: usize = 12;
/// Further away than this, in mm, the closed form's numbers could overflow.
const FAR: f64 = 1e9;
/// A joint that is beyond its limit by this many degrees or less, which is rounding, is set to the limit.
const ON_LIMIT: f64 = 1e-6;

impl Model {
    /// The joint positions that bring the flange to a pose in the arm's base, on the branch nearest to `reference`.
    ///
    /// Nearest is the least sum of squares over the six joints. A joint that may turn more than once takes the turn
    /// nearest to the reference. Where the wrist is singular, joint 6 (joint 4 on a spherical wrist) keeps the
    /// reference's position. The flange is within 0.001 mm and 0.0001 degrees of the pose. For a pose of the tool in a user
    /// frame see [`Frames::flange`](crate::Frames::flange).
    pub fn inverse(
        &self,
        flange: impl Into<Transform>,
        reference: impl Into<JointPosition>,
    ) -> Result<JointPosition, NoSolution> {
        let target = flange.into().0;
        let candidates = self.candidates(&target, &reference.into().0)?;
        let mut confirmed = candidates.iter().filter_map(|joints| self.confirmed(joints, &target));
        confirmed.next().ok_or(NoSolution::NotConfirmed)
    }

    /// The joint positions of every branch that bring the flange to a pose in the arm's base, as [`inverse`](Self::inverse)
    /// finds them, the nearest to `reference` first.
    ///
    /// Where the wrist is singular any position of one joint would do, and there is a branch for the reference's alone.
    pub fn inverse_all(
        &self,
        flange: impl Into<Transform>,
        reference: impl Into<JointPosition>,
    ) -> Result<Branches, NoSolution> {
        let target = flange.into().0;
        let candidates = self.candidates(&target, &reference.into().0)?;
        let mut branches = Branches::default();
        let confirmed = candidates.iter().filter_map(|joints| self.confirmed(joints, &target));
        confirmed.for_each(|joints| branches.add(joints));
        if branches.is_empty() { Err(NoSolution::NotConfirmed) } else { Ok(branches) }
    }

    /// What the closed form says, in degrees and within the joints' ranges, nearest to the reference first.
    fn candidates(&self, target: &Isometry3<f64>, reference: &[f64; 6]) -> Result<UpToEight, NoSolution> {
        if !target.to_homogeneous().iter().chain(reference).all(|number| number.is_finite()) {
            return Err(NoSolution::NotFinite);
        }
        let distance = target.translation.vector.norm();
        if distance > FAR {
            return Err(NoSolution::OutOfReach { by_mm: distance });
        }
        let form = &self.closed_form;
        let found = form.solve(target, &form.links.angles(reference));
        let (mut candidates, mut beyond) = (UpToEight::new(), None::<(f64, NoSolution)>);
        for angles in &found.angles {
            let joints = form.links.positions(angles);
            let joints = if self.is_calibrated() { self.refined(joints, target) } else { joints };
            match self.nearest_turns(&joints, reference) {
                Ok(joints) => candidates.push(joints),
                Err(other) => beyond = Some(beyond.filter(|least| least.0 <= other.0).unwrap_or(other)),
            }
        }
        if candidates.is_empty() {
            let out_of_reach = NoSolution::OutOfReach { by_mm: found.short_mm };
            return Err(beyond.map_or(out_of_reach, |(_, reason)| reason));
        }
        let distance = |joints: &[f64; 6]| -> f64 {
            joints.iter().zip(reference).map(|(joint, reference)| (joint - reference).powi(2)).sum()
        };
        candidates.sort_unstable_by(|one, other| distance(one).total_cmp(&distance(other)));
        Ok(candidates)
    }

    /// Each joint by as many full turns as bring it nearest to the reference, or by how much the joint that is furthest beyond its range is
    /// beyond it, in degrees.
    fn nearest_turns(&self, joints: &[f64; 6], reference: &[f64; 6]) -> Result<[f64; 6], (f64, NoSolution)> {
        let (mut turned, mut furthest) = ([0.0; 6], None::<(f64, NoSolution)>);
        for index in 0..6 {
            match self.nearest_turn(index, joints[index], reference[index]) {
                Ok(position) => turned[index] = position,
                Err(other) => furthest = Some(furthest.filter(|beyond| beyond.0 >= other.0).unwrap_or(other)),
            }
        }
        furthest.map_or(Ok(turned), Err)
    }

    fn nearest_turn(&self, index: usize, position: f64, reference: f64) -> Result<f64, (f64, NoSolution)> {
        let (min, max) = (self.joint_min[index], self.joint_max[index]);
        let lowest = min - ON_LIMIT + (position - min + ON_LIMIT).rem_euclid(360.0);
        let from_reference = |position: &f64| (position - reference).abs();
        std::iter::successors(Some(lowest), |position| Some(position + 360.0))
            .take_while(|position| *position <= max + ON_LIMIT)
            .min_by(|one, other| from_reference(one).total_cmp(&from_reference(other)))
            .map(|position| position.clamp(min, max))
            .ok_or_else(|| {
                let beyond = |position_deg: f64, limit_deg: f64| {
                    let reason = NoSolution::BeyondRange { joint: index + 1, position_deg, limit_deg };
                    ((position_deg - limit_deg).abs(), reason)
                };
                let (above, below) = (beyond(lowest, max), beyond(lowest - 360.0, min));
                if above.0 <= below.0 { above } else { below }
            })
    }

    /// The joint positions, after Newton steps if rounding has left an error; none if they do not
    /// bring the flange to the target.
    fn confirmed(&self, joints: &[f64; 6], target: &Isometry3<f64>) -> Option<JointPosition> {
        let refined = self.refined(*joints, target);
        let joints = if self.is_within_range(refined) { refined } else { *joints };
        (self.error(&joints, target) < ACCEPTED).then_some(JointPosition(joints))
    }

    /// The joint positions after as many Newton steps as make the error smaller.
    fn refined(&self, joints: [f64; 6], target: &Isometry3<f64>) -> [f64; 6] {
        let (mut best, mut error, mut damping) = (joints, self.error(&joints, target), DAMPING);
        for _ in 0..STEPS {
            let Some(next) = (error >= EXACT).then(|| self.newton(&best, target, damping)).flatten() else { break };
            let next_error = self.error(&next, target);
            if next_error < error {
                (best, error, damping) = (next, next_error, DAMPING);
            } else {
                // Too far for a straight step.
                damping *= 100.0;
            }
        }
        best
    }

    /// One damped Newton step: damping limits a joint that hardly moves the flange.
    pub(crate) fn newton(&self, joints: &[f64; 6], target: &Isometry3<f64>, damping: f64) -> Option<[f64; 6]> {
        let frames = self.links.frames(joints);
        let mut jacobian = jacobian(&frames, &frames[5].translation.vector);
        jacobian.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        let step = Damped::new(&jacobian, damping)?.turns(&off(&frames[5], target));
        Some(std::array::from_fn(|index| joints[index] + step[index].to_degrees()))
    }

    /// How far the flange is off.
    fn error(&self, joints: &[f64; 6], target: &Isometry3<f64>) -> f64 {
        off(&self.links.flange(joints), target).norm()
    }
}

/// The small translation and rotation that take one transform to the other.
pub(crate) fn off(from: &Isometry3<f64>, to: &Isometry3<f64>) -> Vector6<f64> {
    let moved: Vector3<f64> = to.translation.vector - from.translation.vector;
    let turned = (to.rotation * from.rotation.inverse()).scaled_axis() * RADIAN;
    Vector6::new(moved.x, moved.y, moved.z, turned.x, turned.y, turned.z)
}
