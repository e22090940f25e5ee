//! Joint positions, and how the tool moves with the joints there.

use nalgebra::{Isometry3, Point3, Vector6};

use crate::damped::Damped;
use crate::links::{bend, jacobian};
use crate::model::Point;
use crate::newton::RADIAN;
use crate::piece::Sample;

/// Joint positions that bring the tool to a pose, and what was computed on the way.
#[derive(Debug, Clone)]
pub(crate) struct Solved {
    pub(crate) joints: [f64; 6],
    pub(crate) frames: [Isometry3<f64>; 6],
    /// In the arm's base.
    pub(crate) tool: Isometry3<f64>,
    /// Of the tool centre point, with turns weighted as in [`off`](crate::newton::off).
    jacobian: Damped,
}

/// Added to the squares of the Jacobian's singular values: little enough that the rates of joints are exact down to
/// hundredths of a degree from a singularity.
const DAMPING: f64 = 1e-4;
/// The share of a motion of the tool that joints may fail to make.
const MISSED: f64 = 1e-3;

impl Solved {
    /// Joint positions with their frames, and a tool on the flange; none where a number is not finite.
    pub(super) fn new(joints: &[f64; 6], frames: &[Isometry3<f64>; 6], tool: &Isometry3<f64>) -> Option<Self> {
        let tool = frames[5] * tool;
        let mut jacobian = jacobian(frames, &tool.translation.vector);
        jacobian.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        Some(Self { joints: *joints, frames: *frames, tool, jacobian: Damped::new(&jacobian, DAMPING)? })
    }

    /// Returns the position of a point of the arm, in mm in the arm's base.
    pub(super) fn point(&self, point: Point) -> Point3<f64> {
        let frame = if point == Point::Tcp { &self.tool } else { &self.frames[point.frame()] };
        frame.translation.vector.into()
    }

    /// The joint positions after one Newton step towards a tool that is off by this.
    pub(super) fn closer(&self, off: &Vector6<f64>) -> [f64; 6] {
        let step = self.jacobian.turns(off);
        std::array::from_fn(|index| self.joints[index] + step[index].to_degrees())
    }

    /// Returns the turns of the joints, in degrees, for a motion of the tool, in mm and radians; none if the joints
    /// cannot follow it.
    pub(super) fn rates(&self, moved: &Vector6<f64>) -> Option<[f64; 6]> {
        let mut moved = *moved;
        moved.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        let rates = self.jacobian.turns(&moved);
        let missed = (self.jacobian.moved(&rates) - moved).norm();
        (missed <= MISSED * moved.norm()).then(|| std::array::from_fn(|index| rates[index].to_degrees()))
    }

    /// Returns the motion of the joints for a velocity and an acceleration of the tool, in mm and radians a second;
    /// none if the joints cannot follow them.
    pub(crate) fn moving(&self, velocity: &Vector6<f64>, acceleration: &Vector6<f64>) -> Option<Sample> {
        let velocity = self.rates(velocity)?;
        let acceleration = self.rates(&(acceleration - self.bend(&velocity.map(f64::to_radians))))?;
        Some(Sample { joints: self.joints.into(), velocity, acceleration })
    }

    /// The joint positions after a small motion of the tool, weighted as in [`off`](crate::newton::off): with
    /// the bend of the way, so that what is missing goes with the third power of the motion.
    pub(super) fn stepped(&self, off: &Vector6<f64>) -> [f64; 6] {
        let turns = self.jacobian.turns(off);
        let mut bend = self.bend(&turns.into());
        bend.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        let more = self.jacobian.turns(&bend);
        std::array::from_fn(|index| self.joints[index] + (turns[index] - 0.5 * more[index]).to_degrees())
    }

    /// Returns the change of the tool's velocity where the joints go on at these rates.
    fn bend(&self, turns: &[f64; 6]) -> Vector6<f64> {
        bend(&self.frames, &self.tool.translation.vector, turns)
    }
}
