//! Places of an arm, and the distance between two of them.

use jaka_proto::Target;
use jaka_proto::messages::types::{JointPosition, Pose};

/// Tolerance of a joint that is at its target, in degrees.
const CLOSE_DEG: f64 = 0.1;

/// Tolerance of the tool centre point that is at its target, in millimetres.
const CLOSE_MM: f64 = 0.5;

/// Greatest change between two replies of an arm at rest: noise of the encoders, as far as it is known.
const STILL_DEG: f64 = 0.002;
const STILL_MM: f64 = 0.02;

/// Rounding error of a position: replies have six decimals.
const ROUNDING_DEG: f64 = 1e-5;
const ROUNDING_MM: f64 = 2e-6;

/// A position of the arm, as one of the two queries gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Place {
    Joints(JointPosition),
    Pose(Pose),
}

/// Quantity of a place: each has a query of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantity {
    Joints,
    Pose,
}

impl Quantity {
    /// Quantity that must be known of the beginning of a motion to `target`, if its end follows from it.
    pub(crate) fn of_start(target: Target) -> Option<Self> {
        match target {
            Target::JointOffset(_) => Some(Self::Joints),
            Target::Offset(_) => Some(Self::Pose),
            _ => None,
        }
    }
}

impl Place {
    /// True if the arm is here when it is at `other`.
    pub(crate) fn is_at(&self, other: &Self) -> bool {
        self.is_within(other, CLOSE_DEG, CLOSE_MM)
    }

    /// True if both are the same except for noise. An arm that moves by less during the grace time cannot be
    /// distinguished from one at rest.
    pub(crate) fn is_still(&self, other: &Self) -> bool {
        self.is_within(other, STILL_DEG, STILL_MM)
    }

    /// True if both are the same. An arm that brakes is elsewhere until it rests, if only by micrometres.
    pub(crate) fn is_exactly(&self, other: &Self) -> bool {
        self.is_within(other, ROUNDING_DEG, ROUNDING_MM)
    }

    fn is_within(&self, other: &Self, degrees: f64, millimetres: f64) -> bool {
        match (self, other) {
            (Self::Joints(one), Self::Joints(other)) => one.max_distance(other) <= degrees,
            (Self::Pose(one), Self::Pose(other)) => {
                one.distance_mm(other) <= millimetres && one.angle_deg(other) <= degrees
            }
            _ => false,
        }
    }
}

impl Place {
    /// Place at which a motion to `target` ends that begins at `start`, if that determines it.
    pub(crate) fn of(target: Target, start: Option<Self>) -> Option<Self> {
        match (target, start) {
            (Target::Joints(joints), _) => Some(Self::Joints(joints)),
            (Target::Pose(pose), _) => Some(Self::Pose(pose)),
            (Target::JointOffset(by), Some(Self::Joints(from))) => {
                Some(Self::Joints(JointPosition(std::array::from_fn(|i| from.0[i] + by.0[i]))))
            }
            (Target::Offset([x, y, z]), Some(Self::Pose(from))) => {
                Some(Self::Pose(Pose { x: from.x + x, y: from.y + y, z: from.z + z, ..from }))
            }
            _ => None,
        }
    }

    /// Query that gives such a place.
    pub(crate) fn quantity(&self) -> Quantity {
        match self {
            Self::Joints(_) => Quantity::Joints,
            Self::Pose(_) => Quantity::Pose,
        }
    }
}
