//! Paths of the arm.

use jaka_motion::{Arc, Model, Transform};

/// Joint positions, in degrees.
pub(crate) type Joints = [f64; 6];

/// Path from one position to another, by the distance from its start.
#[derive(Debug, Clone)]
pub(crate) enum ArmPath {
    /// All joints at once, each at an equal share of its distance.
    Joints { from: Joints, to: Joints },
    /// Straight line of the tool centre point.
    Line { from: Transform, to: Transform, tool: Transform },
    /// Arc of the tool centre point.
    Arc { arc: Box<Arc>, tool: Transform },
}

impl ArmPath {
    /// Returns the arc of the tool centre point through three poses; `None` if they are on a line.
    pub(crate) fn arc(from: Transform, middle: Transform, to: Transform, tool: Transform) -> Option<Self> {
        Arc::through(from, middle, to).map(|arc| Self::Arc { arc: Box::new(arc), tool })
    }

    /// Returns the length of the path: in degrees of the joint that turns furthest, or in millimetres of the tool
    /// centre point.
    ///
    /// If the tool turns further in degrees than it moves in millimetres, the turn is the length, so that a turn
    /// without translation takes time.
    pub(crate) fn length(&self) -> f64 {
        match self {
            Self::Joints { from, to } => from.iter().zip(to).map(|(from, to)| (to - from).abs()).fold(0.0, f64::max),
            Self::Line { from, to, .. } => from.distance_mm(to).max(from.angle_deg(to)),
            Self::Arc { arc, .. } => arc.length_mm().max(arc.turn_deg()),
        }
    }

    /// Returns the joints at a share of the path from 0 to 1; `None` if the arm cannot reach the point.
    pub(crate) fn at(&self, share: f64, model: &Model, reference: Joints) -> Option<Joints> {
        let flange = match self {
            Self::Joints { from, to } => return Some(std::array::from_fn(|i| from[i] + (to[i] - from[i]) * share)),
            Self::Line { from, to, tool } => from.between(to, share) * tool.inverse(),
            Self::Arc { arc, tool } => arc.at(share) * tool.inverse(),
        };
        model.inverse(flange, reference).ok().map(Into::into)
    }

    /// Returns the joints at the end, if the arm can follow the path: checked at some points on it.
    pub(crate) fn end(&self, model: &Model, start: Joints) -> Option<Joints> {
        const PLACES: u32 = 32;
        let places = (1..=PLACES).map(|place| f64::from(place) / f64::from(PLACES));
        let end = places.into_iter().try_fold(start, |reference, share| self.at(share, model, reference))?;
        model.is_within_range(end).then_some(end)
    }
}
