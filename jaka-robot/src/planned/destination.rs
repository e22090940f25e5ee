//! Goals of batches, and whether the arm is there.

use jaka_proto::Target;

use crate::place::{Place, Quantity};

/// End of a batch of motions, once it has been accepted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Destination {
    /// Here, or this many millimetres before, if the controller may blend into a motion that follows.
    At(Place, f64),
    Unknown,
}

/// Nearness of the arm's place to the goal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Nearness {
    There,
    /// Within the tolerance of a motion that may blend into the next one.
    Within,
    Elsewhere,
    Unknown,
}

impl Destination {
    /// The goal of a motion to `target` that begins at `start`, if that is known.
    pub(super) fn new(target: Target, tolerance: f64, start: Option<Place>) -> Self {
        Place::of(target, start).map_or(Self::Unknown, |place| Self::At(place, tolerance))
    }

    /// Quantity to ask for, to see whether the arm is there.
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

#[cfg(test)]
mod tests {
    use jaka_proto::messages::types::{JointPosition, Pose};

    use super::*;

    fn pose(x: f64, rz: f64) -> Pose {
        Pose { x, y: 0.0, z: 0.0, rx: 0.0, ry: 0.0, rz }
    }

    #[test]
    fn there_is_a_tenth_of_a_degree_and_half_a_millimetre() {
        let at = |x, rz| Destination::At(Place::Pose(pose(0.0, 180.0)), 3.0).nearness(&Place::Pose(pose(x, rz)));
        assert_eq!(at(0.5, 180.0), Nearness::There);
        // Another notation of the same orientation.
        assert_eq!(at(0.0, -180.0), Nearness::There);
        assert_eq!(at(0.0, 179.95), Nearness::There);
        assert_eq!(at(0.51, 180.0), Nearness::Within);
        assert_eq!(at(3.1, 180.0), Nearness::Elsewhere);
        let joints = |angle| Place::Joints(JointPosition([angle, 0.0, 0.0, 0.0, 0.0, 0.0]));
        let goal = Destination::At(joints(10.0), 0.0);
        assert_eq!(goal.nearness(&joints(10.09)), Nearness::There);
        assert_eq!(goal.nearness(&joints(9.8)), Nearness::Elsewhere);
        assert_eq!(goal.nearness(&joints(f64::NAN)), Nearness::Elsewhere);
        assert_eq!(Destination::Unknown.nearness(&joints(0.0)), Nearness::Unknown);
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
        assert_eq!(
            Destination::new(by, 0.0, Some(joints)),
            Destination::At(Place::Joints(JointPosition([3.0; 6])), 0.0)
        );
        assert_eq!(Destination::new(by, 0.0, None), Destination::Unknown);
        assert_eq!(Destination::new(Target::Offset([1.0, 0.0, 0.0]), 0.0, Some(joints)), Destination::Unknown);
        let along = Destination::new(Target::Offset([1.0, 0.0, 0.0]), 0.0, Some(Place::Pose(pose(1.0, 90.0))));
        assert_eq!(along, Destination::At(Place::Pose(pose(2.0, 90.0)), 0.0));
    }
}
