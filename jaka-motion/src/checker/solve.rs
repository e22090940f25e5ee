//! Joint positions that are near to others and bring the tool to a pose.

use nalgebra::{Isometry3, Vector6};

use super::Checker;
use crate::beyond::Exceeded;
use crate::damped::Damped;
use crate::links::{bend, jacobian};
use crate::model::Model;
use crate::model::inverse::{RADIAN, off};
use crate::piece::Sample;
use crate::transform::Transform;

/// Joint positions that bring the tool to a pose, and what was computed on the way.
#[derive(Debug, Clone)]
pub(crate) struct Solved {
    pub(crate) joints: [f64; 6],
    pub(crate) frames: [Isometry3<f64>; 6],
    /// In the arm's base.
    pub(crate) tool: Isometry3<f64>,
    /// Of the tool centre point, with turns weighted as in [`off`].
    jacobian: Damped,
}

/// An error not worth a step, in mm, and in radians times [`RADIAN`]: where a motion starts beyond a limit, the end of the one before is compared
/// with its own.
const EXACT: f64 = 1e-10;
/// How far off the tool may be where no step makes the error smaller, in the same unit.
const ACCEPTED: f64 = 1e-6;
/// How far off the tool may be on the way of a trajectory, in the same unit: a thousandth of what its pieces may be off.
const NEAR_ENOUGH: f64 = 1e-6;
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
            let here = self.at_joints(&joints)?;
            let off = off(&here.tool, tool);
            let error = off.norm();
            if error < EXACT || (error < ACCEPTED && (error >= before || round == STEPS)) {
                return Some(here);
            }
            if error.is_nan() || error >= before {
                return None;
            }
            before = error;
            let step = here.jacobian.turns(&off);
            joints = std::array::from_fn(|index| joints[index] + step[index].to_degrees());
        }
        None
    }

    /// The joint positions to which others go on where the tool is led evenly to a place.
    pub(crate) fn led_on(&self, from: &Solved, tool: &Isometry3<f64>) -> Option<Solved> {
        let mut before = off(&from.tool, tool);
        let mut here = self.at_joints(&from.stepped(&before))?;
        for _ in 0..STEPS {
            let off = off(&here.tool, tool);
            if off.norm() < NEAR_ENOUGH {
                return Some(here);
            }
            if off.norm().is_nan() || off.norm() >= before.norm() {
                return None;
            }
            here = self.at_joints(&here.stepped(&off))?;
            before = off;
        }
        None
    }

    /// Joint positions as they are; none where a number is not finite.
    pub(crate) fn at_joints(&self, joints: &[f64; 6]) -> Option<Solved> {
        self.solved_at(joints, &self.limits.model().links.frames(joints))
    }

    /// Joint positions as they are, with their frames; none where a number is not finite.
    pub(super) fn solved_at(&self, joints: &[f64; 6], frames: &[Isometry3<f64>; 6]) -> Option<Solved> {
        let tool = frames[5] * self.tool;
        let mut jacobian = jacobian(frames, &tool.translation.vector);
        jacobian.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        Some(Solved { joints: *joints, frames: *frames, tool, jacobian: Damped::new(&jacobian, DAMPING)? })
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
        let rates = self.jacobian.turns(&moved);
        let missed = (self.jacobian.moved(&rates) - moved).norm();
        (missed <= MISSED * moved.norm()).then(|| std::array::from_fn(|index| rates[index].to_degrees()))
    }

    /// How the joints move where the tool has this velocity and acceleration, in mm and radians a second; none if they cannot.
    pub(crate) fn moving(&self, velocity: &Vector6<f64>, acceleration: &Vector6<f64>) -> Option<Sample> {
        let velocity = self.rates(velocity)?;
        let acceleration = self.rates(&(acceleration - self.bend(&velocity.map(f64::to_radians))))?;
        Some(Sample { joints: self.joints.into(), velocity, acceleration })
    }

    /// The joint positions after a small motion of the tool, weighted as in [`off`]: with the bend of the way, so that what is missing goes with the third
    /// power of the motion.
    fn stepped(&self, off: &Vector6<f64>) -> [f64; 6] {
        let turns = self.jacobian.turns(off);
        let mut bend = self.bend(&turns.into());
        bend.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        let more = self.jacobian.turns(&bend);
        std::array::from_fn(|index| self.joints[index] + (turns[index] - 0.5 * more[index]).to_degrees())
    }

    /// How the tool's velocity changes where the joints turn on so.
    fn bend(&self, turns: &[f64; 6]) -> Vector6<f64> {
        bend(&self.frames, &self.tool.translation.vector, turns)
    }
}
