//! Joint positions that are near to others and bring the tool to a pose.

use nalgebra::{Isometry3, Matrix6, Vector6};

use super::Checker;
use crate::beyond::Exceeded;
use crate::links::jacobian;
use crate::model::Model;
use crate::model::inverse::{RADIAN, off};
use crate::transform::Transform;

/// Joint positions that bring the tool to a pose, and what was computed on the way.
#[derive(Debug, Clone)]
pub(super) struct Solved {
    pub(super) joints: [f64; 6],
    pub(super) frames: [Isometry3<f64>; 6],
    /// Of the tool centre point, with turns weighted as in [`off`].
    jacobian: Matrix6<f64>,
}

/// An error not worth a step, in mm, and in radians times [`RADIAN`]: where a motion starts beyond a limit, the end of the one before is compared
/// with its own.
const EXACT: f64 = 1e-10;
/// How far off the tool may be where no step makes the error smaller, in the same unit.
const ACCEPTED: f64 = 1e-6;
/// The most steps. Each squares the error.
const STEPS: usize = 8;
/// Added to the squares of the Jacobian's singular values: little enough that the rates of joints are exact down to hundredths of a
/// degree from a singularity.
const DAMPING: f64 = 1e-4;
/// The share of a motion of the tool that joints may fail to make.
const MISSED: f64 = 1e-3;
/// Joint positions that are further than this from those before, in degrees, may be of another branch.
const NEAR_DEG: f64 = 20.0;
/// Further than any joint turns, in degrees.
const ANY_TURN: f64 = 720.0;

impl Checker {
    /// The joint positions that Newton's method finds from a guess.
    pub(super) fn solved(&self, tool: &Isometry3<f64>, guess: &[f64; 6]) -> Option<Solved> {
        let (mut joints, mut before) = (*guess, f64::INFINITY);
        for round in 1..=STEPS {
            let here = self.solved_at(&joints, &self.limits.model().links.frames(&joints));
            let off = off(&(here.frames[5] * self.tool), tool);
            let error = off.norm();
            if error < EXACT || (error < ACCEPTED && (error >= before || round == STEPS)) {
                return Some(here);
            }
            if error.is_nan() || error >= before {
                return None;
            }
            before = error;
            let step = damped(&here.jacobian, &off)?;
            joints = std::array::from_fn(|index| joints[index] + step[index].to_degrees());
        }
        None
    }

    /// Joint positions as they are, with their frames.
    pub(super) fn solved_at(&self, joints: &[f64; 6], frames: &[Isometry3<f64>; 6]) -> Solved {
        let mut jacobian = jacobian(frames, &(frames[5] * self.tool).translation.vector);
        jacobian.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        Solved { joints: *joints, frames: *frames, jacobian }
    }

    /// The joint positions nearest to others, within their ranges or not.
    pub(super) fn nearest(&self, tool: &Isometry3<f64>, reference: &[f64; 6]) -> Result<[f64; 6], Exceeded> {
        let near = |joints: &[f64; 6]| joints.iter().zip(reference).all(|(one, other)| (one - other).abs() < NEAR_DEG);
        match self.solved(tool, reference) {
            Some(Solved { joints, .. }) if near(&joints) => Ok(joints),
            _ => self.any_branch(tool, reference),
        }
    }

    /// The nearest joint positions of all branches, within their ranges or not.
    pub(super) fn any_branch(&self, tool: &Isometry3<f64>, reference: &[f64; 6]) -> Result<[f64; 6], Exceeded> {
        let unlimited = Model { joint_min: [-ANY_TURN; 6], joint_max: [ANY_TURN; 6], ..self.limits.model().clone() };
        let flange = Transform(tool * self.tool.inverse());
        Ok(unlimited.inverse(flange, *reference)?.0)
    }
}

impl Solved {
    /// How the joints turn, in degrees, where the tool moves so, in mm and radians; none if they cannot.
    pub(super) fn rates(&self, moved: &Vector6<f64>) -> Option<[f64; 6]> {
        let mut moved = *moved;
        moved.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        let rates = damped(&self.jacobian, &moved)?;
        let missed = (self.jacobian * rates - moved).norm();
        (missed <= MISSED * moved.norm()).then(|| std::array::from_fn(|index| rates[index].to_degrees()))
    }
}

/// The turns of joints, in radians, that move the tool so, or nearly so at a singularity.
fn damped(jacobian: &Matrix6<f64>, moved: &Vector6<f64>) -> Option<Vector6<f64>> {
    let squares = jacobian * jacobian.transpose() + Matrix6::identity() * DAMPING;
    Some(jacobian.transpose() * squares.cholesky()?.solve(moved))
}
