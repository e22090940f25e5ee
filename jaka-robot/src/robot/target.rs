//! Where a motion ends, and whether the arm is there.

use jaka_proto::messages::types::{JointPosition, Pose};

/// How close a joint is to its target when it is there, in degrees.
const CLOSE_DEG: f64 = 0.1;

/// How close the tool centre point is to its target when it is there, in millimetres.
const CLOSE_MM: f64 = 0.5;

/// How little may change between two replies of an arm at rest: noise of the encoders, as far as it is known.
const STILL_DEG: f64 = 0.002;
const STILL_MM: f64 = 0.02;

/// What rounding may add to a position: replies have six decimals.
const ROUNDING_DEG: f64 = 1e-5;
const ROUNDING_MM: f64 = 2e-6;

/// Where a [`Motion`](super::Motion) ends, as far as its request determines it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Target {
    /// At these joint positions, in degrees.
    Joints(JointPosition),
    /// By this offset of the joints from where it begins, in degrees.
    JointOffset(JointPosition),
    /// At this pose of the tool centre point, in the frames that are selected when it is sent; mm and degrees.
    Pose(Pose),
    /// By this offset from where it begins along x, y and z of the selected user frame, in mm, without a rotation.
    Offset([f64; 3]),
    /// The request does not determine it.
    Unknown,
}

/// A position of the arm, as one of the two queries gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Place {
    Joints(JointPosition),
    Pose(Pose),
}

/// Which query gives a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Quantity {
    Joints,
    Pose,
}

impl Place {
    /// True if the arm is here when it is at `other`.
    pub(super) fn is_at(&self, other: &Self) -> bool {
        self.is_within(other, CLOSE_DEG, CLOSE_MM)
    }

    /// True if both are the same except for noise. An arm that moves by less during the grace time cannot be distinguished from one at
    /// rest.
    pub(super) fn is_still(&self, other: &Self) -> bool {
        self.is_within(other, STILL_DEG, STILL_MM)
    }

    /// True if both are the same. An arm that brakes is elsewhere until it rests, if only by micrometres.
    pub(super) fn is_exactly(&self, other: &Self) -> bool {
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

/// Where a batch of motions ends, once it has been accepted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Goal {
    /// Here, or this many millimetres before, where the controller may blend into a motion that follows.
    At(Place, f64),
    Unknown,
}

/// How near the arm's place is to the goal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Nearness {
    There,
    /// Within the tolerance of a motion that may blend into the next one.
    Within,
    Elsewhere,
    Unknown,
}

impl Goal {
    /// The goal of a motion to `target` that begins at `start`, if that is known.
    pub(super) fn new(target: Target, tolerance: f64, start: Option<Place>) -> Self {
        target.from(start).map_or(Self::Unknown, |place| Self::At(place, tolerance))
    }

    /// What to ask for, to see whether the arm is there.
    pub(super) fn quantity(&self) -> Quantity {
        match self {
            Self::At(Place::Pose(_), _) => Quantity::Pose,
            _ => Quantity::Joints,
        }
    }

    pub(super) fn nearness(&self, place: &Place) -> Nearness {
        match self {
            Self::Unknown => Nearness::Unknown,
            Self::At(goal, _) if goal.is_at(place) => Nearness::There,
            Self::At(Place::Pose(goal), tolerance) => match place {
                Place::Pose(pose) if goal.distance_mm(pose) <= *tolerance => Nearness::Within,
                _ => Nearness::Elsewhere,
            },
            Self::At(..) => Nearness::Elsewhere,
        }
    }
}

impl Target {
    /// Where it is for a motion that begins at `start`, if that determines it.
    pub(super) fn from(self, start: Option<Place>) -> Option<Place> {
        match (self, start) {
            (Self::Joints(joints), _) => Some(Place::Joints(joints)),
            (Self::Pose(pose), _) => Some(Place::Pose(pose)),
            (Self::JointOffset(by), Some(Place::Joints(from))) => {
                Some(Place::Joints(JointPosition(std::array::from_fn(|i| from.0[i] + by.0[i]))))
            }
            (Self::Offset([x, y, z]), Some(Place::Pose(from))) => {
                Some(Place::Pose(Pose { x: from.x + x, y: from.y + y, z: from.z + z, ..from }))
            }
            _ => None,
        }
    }

    /// What must be known of the beginning, if the end follows from it.
    pub(super) fn start_quantity(&self) -> Option<Quantity> {
        match self {
            Self::JointOffset(_) => Some(Quantity::Joints),
            Self::Offset(_) => Some(Quantity::Pose),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pose(x: f64, rz: f64) -> Pose {
        Pose { x, y: 0.0, z: 0.0, rx: 0.0, ry: 0.0, rz }
    }

    #[test]
    fn there_is_a_tenth_of_a_degree_and_half_a_millimetre() {
        let at = |x, rz| Goal::At(Place::Pose(pose(0.0, 180.0)), 3.0).nearness(&Place::Pose(pose(x, rz)));
        assert_eq!(at(0.5, 180.0), Nearness::There);
        // The same orientation, written otherwise.
        assert_eq!(at(0.0, -180.0), Nearness::There);
        assert_eq!(at(0.0, 179.95), Nearness::There);
        assert_eq!(at(0.51, 180.0), Nearness::Within);
        assert_eq!(at(3.1, 180.0), Nearness::Elsewhere);
        let joints = |angle| Place::Joints(JointPosition([angle, 0.0, 0.0, 0.0, 0.0, 0.0]));
        let goal = Goal::At(joints(10.0), 0.0);
        assert_eq!(goal.nearness(&joints(10.09)), Nearness::There);
        assert_eq!(goal.nearness(&joints(9.8)), Nearness::Elsewhere);
        assert_eq!(goal.nearness(&joints(f64::NAN)), Nearness::Elsewhere);
        assert_eq!(Goal::Unknown.nearness(&joints(0.0)), Nearness::Unknown);
    }

    #[test]
    fn an_arm_that_brakes_is_not_exactly_at_its_goal() {
        let goal = Place::Pose(pose(0.0, 180.0));
        assert!(goal.is_exactly(&Place::Pose(pose(0.000_000_5, 180.0))));
        assert!(!goal.is_exactly(&Place::Pose(pose(0.01, 180.0))) && goal.is_still(&Place::Pose(pose(0.01, 180.0))));
    }

    #[test]
    fn a_goal_follows_from_a_start_of_its_own_kind_alone() {
        let joints = Place::Joints(JointPosition([1.0; 6]));
        let by = Target::JointOffset(JointPosition([2.0; 6]));
        assert_eq!(Goal::new(by, 0.0, Some(joints)), Goal::At(Place::Joints(JointPosition([3.0; 6])), 0.0));
        assert_eq!(Goal::new(by, 0.0, None), Goal::Unknown);
        assert_eq!(Goal::new(Target::Offset([1.0, 0.0, 0.0]), 0.0, Some(joints)), Goal::Unknown);
        let along = Goal::new(Target::Offset([1.0, 0.0, 0.0]), 0.0, Some(Place::Pose(pose(1.0, 90.0))));
        assert_eq!(along, Goal::At(Place::Pose(pose(2.0, 90.0)), 0.0));
    }
}
