//! The arm with its tool: tool poses for joint positions, and joint positions for tool poses.

#[cfg(feature = "generator")]
use nalgebra::Vector6;
use nalgebra::{Isometry3, Point3, Vector3};

use super::radii::PieceEnd;
use super::radii::Radii;
use super::solved::Solved;
use crate::beyond::Exceeded;
use crate::model::{Model, Point};
use crate::newton::off;
use crate::transform::Transform;

/// Arm with its tool. All places are in the arm's base.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Arm {
    /// Model with unlimited joints: the limits have the joint ranges.
    model: Model,
    /// Tool, seen from the flange.
    tool: Isometry3<f64>,
    radii: Radii,
}

/// Error, as [`off`] counts it, below which the solver takes no further step. It is this small because a motion that
/// starts beyond a limit compares the end of the motion before with its own start.
const EXACT: f64 = 1e-10;
/// Greatest accepted error of the tool if no step reduces it, in the unit of [`off`].
const ACCEPTED: f64 = 1e-6;
/// Greatest error of the tool on the path of a trajectory, in the unit of [`off`]: a thousandth of the error that its
/// pieces may have.
const NEAR_ENOUGH: f64 = 1e-6;
/// Greatest number of steps. Each squares the error.
const STEPS: usize = 8;
/// Greatest change of a joint from its position before, in degrees. Beyond it the positions may be of another branch.
const NEAR_DEG: f64 = 20.0;
/// Angle beyond the range of any joint, in degrees.
const ANY_TURN: f64 = 720.0;

impl Arm {
    /// Creates an arm of a model and a tool, seen from its flange.
    pub(super) fn new(model: &Model, tool: Isometry3<f64>) -> Self {
        let radii = Radii::new(model, &tool.translation.vector);
        let model = Model { joint_min: [-ANY_TURN; 6], joint_max: [ANY_TURN; 6], ..model.clone() };
        Self { model, tool, radii }
    }

    /// Returns the bounds of the motion of its points.
    pub(crate) fn radii(&self) -> &Radii {
        &self.radii
    }

    /// Returns the length of the arm with its tool, in mm.
    pub(super) fn reach_mm(&self) -> f64 {
        self.model.reach_mm() + self.tool.translation.vector.norm()
    }

    /// Returns the tool's pose for joint positions.
    pub(crate) fn tcp(&self, joints: &[f64; 6]) -> Isometry3<f64> {
        self.model.links.flange(joints) * self.tool
    }

    /// Returns the flange for a pose of the tool.
    pub(super) fn flange(&self, tool: &Isometry3<f64>) -> Transform {
        Transform(tool * self.tool.inverse())
    }

    /// Returns the frames of the joints.
    pub(super) fn frames(&self, joints: &[f64; 6]) -> [Isometry3<f64>; 6] {
        self.model.links.frames(joints)
    }

    /// Returns the position of a point of the arm for joint positions.
    pub(super) fn point(&self, point: Point, joints: &[f64; 6]) -> Point3<f64> {
        let links = &self.model.links;
        let frame = links.product(0..point.frame() + 1, &links.angles(joints));
        let place = if point == Point::Tcp { frame * self.tool } else { frame };
        place.translation.vector.into()
    }

    /// Returns the points and levers of the arm between two pieces.
    pub(super) fn piece_end(&self, joints: &[f64; 6]) -> PieceEnd {
        PieceEnd::new(&self.frames(joints), &self.tool)
    }

    /// Returns the distances from the singularities, for the frames of the joints.
    pub(crate) fn distances(&self, frames: &[Isometry3<f64>; 6]) -> [f64; 3] {
        self.model.distances(frames)
    }

    /// Returns the distances from the singularities, with opposite signs on the two sides of one.
    pub(super) fn signed_distances(&self, joints: &[f64; 6]) -> [f64; 3] {
        self.model.signed_distances(&self.frames(joints))
    }

    /// Returns the distance that the tool centre point would travel, in mm, if it kept its velocity while the joints
    /// turn by `moved` degrees.
    pub(crate) fn tcp_rate(&self, joints: &[f64; 6], moved: &[f64; 6]) -> f64 {
        self.tool_moves(joints, moved)[0].norm()
    }

    /// Returns the motion of the tool centre point, in mm, and the turn of the tool, in radians, for its velocity at
    /// these joint positions while the joints turn by `moved` degrees.
    pub(crate) fn tool_moves(&self, joints: &[f64; 6], moved: &[f64; 6]) -> [Vector3<f64>; 2] {
        let frames = self.frames(joints);
        let tcp = (frames[5] * self.tool).translation.vector;
        let mut total = [Vector3::zeros(); 2];
        for (frame, moved) in frames.iter().zip(moved) {
            let turn = frame.rotation * Vector3::z() * moved.to_radians();
            total[0] += turn.cross(&(tcp - frame.translation.vector));
            total[1] += turn;
        }
        total
    }

    /// Returns the distance between the tool centre points at two joint positions, in mm.
    pub(crate) fn tcp_distance(&self, one: &[f64; 6], other: &[f64; 6]) -> f64 {
        (self.point(Point::Tcp, one) - self.point(Point::Tcp, other)).norm()
    }

    /// Returns the joint speeds for a velocity of the tool, in deg/s, and the distances from singularities. The speeds
    /// are `None` if the joints cannot follow the tool.
    #[cfg(feature = "generator")]
    pub(crate) fn rates(&self, joints: &[f64; 6], twist: &Vector6<f64>) -> (Option<[f64; 6]>, [f64; 3]) {
        let frames = self.frames(joints);
        let here = Solved::new(joints, &frames, &self.tool);
        (here.and_then(|here| here.rates(twist)), self.distances(&frames))
    }

    /// Returns the solution for these joint positions; `None` if a number is not finite.
    pub(crate) fn at_joints(&self, joints: &[f64; 6]) -> Option<Solved> {
        Solved::new(joints, &self.frames(joints), &self.tool)
    }

    /// Returns the joint positions that Newton's method finds from a guess.
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
            joints = here.closer(&off);
        }
        None
    }

    /// Returns the joint positions that continue from others while the tool moves evenly to a place.
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

    /// Returns the joint positions nearest to others, within their ranges or not.
    pub(super) fn nearest(&self, tool: &Isometry3<f64>, reference: &[f64; 6]) -> Result<[f64; 6], Exceeded> {
        let near = |joints: &[f64; 6]| joints.iter().zip(reference).all(|(one, other)| (one - other).abs() < NEAR_DEG);
        match self.solved(tool, reference) {
            Some(Solved { joints, .. }) if near(&joints) => Ok(joints),
            _ => self.any_branch(tool, reference),
        }
    }

    /// Returns the nearest joint positions of all branches, within their ranges or not.
    pub(super) fn any_branch(&self, tool: &Isometry3<f64>, reference: &[f64; 6]) -> Result<[f64; 6], Exceeded> {
        Ok(self.model.inverse(self.flange(tool), *reference)?.0)
    }
}
