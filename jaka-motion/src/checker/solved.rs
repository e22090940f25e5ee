//! Joint positions, and the motion of the tool with the joints there.

use nalgebra::{Isometry3, Point3, Vector6};

use crate::damped::Damped;
use crate::links::{bend, jacobian};
use crate::model::Point;
use crate::newton::RADIAN;
use crate::piece::Sample;

/// Joint positions that bring the tool to a pose, with intermediate results of the solution.
#[derive(Debug, Clone)]
pub(crate) struct Solved {
    pub(crate) joints: [f64; 6],
    pub(crate) frames: [Isometry3<f64>; 6],
    /// Pose of the tool in the arm's base.
    pub(crate) tool: Isometry3<f64>,
    /// Jacobian of the tool centre point, with turns weighted as in [`off`](crate::newton::off).
    jacobian: Damped,
}

/// Damping that is added to the squares of the Jacobian's singular values. It is small enough that joint rates are
/// exact down to hundredths of a degree from a singularity.
const DAMPING: f64 = 1e-4;
/// Greatest share of a motion of the tool that the joints may fail to make.
const MISSED: f64 = 1e-3;

impl Solved {
    /// Creates a solution from joint positions with their frames and a tool on the flange; `None` if a number is not
    /// finite.
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

    /// Returns the joint positions after one Newton step towards a tool that is `off` by this.
    pub(super) fn closer(&self, off: &Vector6<f64>) -> [f64; 6] {
        let step = self.jacobian.turns(off);
        std::array::from_fn(|index| self.joints[index] + step[index].to_degrees())
    }

    /// Returns the turns of the joints, in degrees, for a motion of the tool, in mm and radians; `None` if the joints
    /// cannot follow it.
    pub(super) fn rates(&self, moved: &Vector6<f64>) -> Option<[f64; 6]> {
        let mut moved = *moved;
        moved.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        let rates = self.jacobian.turns(&moved);
        let missed = (self.jacobian.moved(&rates) - moved).norm();
        (missed <= MISSED * moved.norm()).then(|| std::array::from_fn(|index| rates[index].to_degrees()))
    }

    /// Returns the motion of the joints for a velocity and an acceleration of the tool, in mm and radians a second;
    /// `None` if the joints cannot follow them.
    pub(crate) fn moving(&self, velocity: &Vector6<f64>, acceleration: &Vector6<f64>) -> Option<Sample> {
        let velocity = self.rates(velocity)?;
        let acceleration = self.rates(&(acceleration - self.bend(&velocity.map(f64::to_radians))))?;
        Some(Sample { joints: self.joints.into(), velocity, acceleration })
    }

    /// Returns the joint positions after a small motion of the tool, weighted as in [`off`](crate::newton::off). They
    /// include the curvature of the path, so the error is of the third order in the motion.
    pub(super) fn stepped(&self, off: &Vector6<f64>) -> [f64; 6] {
        let turns = self.jacobian.turns(off);
        let mut bend = self.bend(&turns.into());
        bend.fixed_rows_mut::<3>(3).scale_mut(RADIAN);
        let more = self.jacobian.turns(&bend);
        std::array::from_fn(|index| self.joints[index] + (turns[index] - 0.5 * more[index]).to_degrees())
    }

    /// Returns the change of the tool's velocity while the joints keep these rates.
    fn bend(&self, turns: &[f64; 6]) -> Vector6<f64> {
        bend(&self.frames, &self.tool.translation.vector, turns)
    }
}
