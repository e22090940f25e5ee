//! The arm with its tool: where it is for joint positions, and which joint positions bring it to a place.

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

/// An arm with its tool. All places are in the arm's base.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Arm {
    /// With joints that turn any way: their ranges are limits.
    model: Model,
    /// The tool, seen from the flange.
    tool: Isometry3<f64>,
    radii: Radii,
}

/// An error not worth a step, as [`off`] counts it: where a motion starts beyond a limit, the end of the one before is
/// compared with its own.
const EXACT: f64 = 1e-10;
/// Greatest accepted error of the tool where no step makes it smaller, in the unit of [`off`].
const ACCEPTED: f64 = 1e-6;
/// Greatest error of the tool on the path of a trajectory, in the unit of [`off`]: a thousandth of the error that its
/// pieces may have.
const NEAR_ENOUGH: f64 = 1e-6;
/// The most steps. Each squares the error.
const STEPS: usize = 8;
/// Joint positions that are further than this from those before, in degrees, may be of another branch.
const NEAR_DEG: f64 = 20.0;
/// Further than any joint turns, in degrees.
const ANY_TURN: f64 = 720.0;

impl Arm {
    /// A model with a tool, seen from its flange.
    pub(super) fn new(model: &Model, tool: Isometry3<f64>) -> Self {
        let radii = Radii::new(model, &tool.translation.vector);
        let model = Model { joint_min: [-ANY_TURN; 6], joint_max: [ANY_TURN; 6], ..model.clone() };
        Self { model, tool, radii }
    }

    /// Bounds of how its points move.
    pub(crate) fn radii(&self) -> &Radii {
        &self.radii
    }

    /// Length of the arm with its tool, in mm.
    pub(super) fn reach_mm(&self) -> f64 {
        self.model.reach_mm() + self.tool.translation.vector.norm()
    }

    /// The tool for joint positions.
    pub(crate) fn tcp(&self, joints: &[f64; 6]) -> Isometry3<f64> {
        self.model.links.flange(joints) * self.tool
    }

    /// The flange for a tool.
    pub(super) fn flange(&self, tool: &Isometry3<f64>) -> Transform {
        Transform(tool * self.tool.inverse())
    }

    /// The frames of the joints.
    pub(super) fn frames(&self, joints: &[f64; 6]) -> [Isometry3<f64>; 6] {
        self.model.links.frames(joints)
    }

    /// A point of the arm for joint positions.
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

    /// Distances from the singularities, for the frames of the joints.
    pub(crate) fn distances(&self, frames: &[Isometry3<f64>; 6]) -> [f64; 3] {
        self.model.distances(frames)
    }

    /// Distances from the singularities, with another sign on each side of one.
    pub(super) fn signed_distances(&self, joints: &[f64; 6]) -> [f64; 3] {
        self.model.signed_distances(&self.frames(joints))
    }

    /// Returns the distance that the tool centre point would move if the joints went on so, in mm.
    pub(crate) fn tcp_rate(&self, joints: &[f64; 6], moved: &[f64; 6]) -> f64 {
        self.tool_moves(joints, moved)[0].norm()
    }

    /// Motion of the tool centre point, in mm, and turn of the tool, in radians, if the joints went on so.
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

    /// Returns the joint speeds for a velocity of the tool, in deg/s, or none if the joints cannot follow it; and the
    /// distances from singularities.
    #[cfg(feature = "generator")]
    pub(crate) fn rates(&self, joints: &[f64; 6], twist: &Vector6<f64>) -> (Option<[f64; 6]>, [f64; 3]) {
        let frames = self.frames(joints);
        let here = Solved::new(joints, &frames, &self.tool);
        (here.and_then(|here| here.rates(twist)), self.distances(&frames))
    }

    /// Joint positions as they are; none where a number is not finite.
    pub(crate) fn at_joints(&self, joints: &[f64; 6]) -> Option<Solved> {
        Solved::new(joints, &self.frames(joints), &self.tool)
    }

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
            joints = here.closer(&off);
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
        Ok(self.model.inverse(self.flange(tool), *reference)?.0)
    }
}
