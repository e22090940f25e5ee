//! Path of the tool centre point.

use nalgebra::{Isometry3, Vector3};

use super::radii::PointMotion;
use crate::arc::Arc;
use crate::transform::Transform;

/// Path of the tool in the arm's base.
#[derive(Debug)]
pub(super) enum ToolPath {
    Line { from: Transform, to: Transform },
    Arc(Arc),
}

/// Part of a path on which the tool turns evenly.
#[derive(Debug, Clone, Copy)]
pub(super) struct EvenTurn {
    /// End of the part, as a share of the path.
    pub(super) end: f64,
    /// Turn of the tool, in radians for the length of the whole path.
    pub(super) turn: Vector3<f64>,
}

/// Least angle, in degrees, of a turn whose direction is undetermined.
const HALF_TURN: f64 = 179.99;

impl ToolPath {
    pub(super) fn at(&self, share: f64) -> Isometry3<f64> {
        match self {
            // Exact at both ends.
            Self::Line { to, .. } if share >= 1.0 => to.0,
            Self::Line { from, to } => from.between(to, share).0,
            Self::Arc(arc) => arc.at(share).0,
        }
    }

    /// Returns the velocity of the tool centre point, in mm for the length of the whole path.
    pub(super) fn velocity(&self, share: f64) -> Vector3<f64> {
        match self {
            Self::Line { from, to } => to.0.translation.vector - from.0.translation.vector,
            Self::Arc(arc) => arc.velocity(share),
        }
    }

    pub(super) fn length_mm(&self) -> f64 {
        match self {
            Self::Line { from, to } => from.distance_mm(to),
            Self::Arc(arc) => arc.length_mm(),
        }
    }

    /// Returns the bounds of the tool centre point's motion. On a circle the change of its velocity is the angle times
    /// the speed.
    pub(super) fn motion(&self) -> PointMotion {
        let rate_mm = self.length_mm();
        let bend_mm = match self {
            Self::Line { .. } => 0.0,
            Self::Arc(arc) => rate_mm * arc.angle(),
        };
        PointMotion { rate_mm, bend_mm }
    }

    /// Returns the parts on which the tool turns evenly; `None` if it makes half a turn on one.
    pub(super) fn even_turns(&self) -> Option<[EvenTurn; 2]> {
        let piece = |from: Transform, to: Transform, start: f64, end: f64| {
            let turn = from.0.rotation * (from.0.rotation.inverse() * to.0.rotation).scaled_axis() / (end - start);
            (from.angle_deg(&to) < HALF_TURN).then_some(EvenTurn { end, turn })
        };
        Some(match self {
            Self::Line { from, to } => {
                let whole = piece(*from, *to, 0.0, 1.0)?;
                [whole, whole]
            }
            Self::Arc(arc) => {
                let ([from, middle, to], share) = (arc.poses(), arc.middle_share());
                [piece(from, middle, 0.0, share)?, piece(middle, to, share, 1.0)?]
            }
        })
    }
}
