//! The ways from one point of a trajectory to the next.

use super::line::Line;

/// A way straight in joint space, or on a straight line of the tool.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Leg {
    /// The number of the way-point at its start, from 1.
    pub(super) after: usize,
    /// In degrees, of all joints together; or in mm, with [`TURN_MM`] for each radian.
    pub(super) length: f64,
    /// The joints at its start.
    pub(super) start: [f64; 6],
    pub(super) path: LegPath,
}

/// Path of a leg, for each unit of its length.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum LegPath {
    Joints([f64; 6]),
    Tool(Line),
}

/// What a trajectory is planned with.
#[derive(Debug, Clone, Copy)]
pub(super) struct Budget {
    /// In deg/s, deg/s² and deg/s³.
    pub(super) speeds: [f64; 6],
    pub(super) accelerations: [f64; 6],
    pub(super) jerks: [f64; 6],
    /// In mm/s.
    pub(super) tcp_speed: f64,
    /// Share of the accelerations for curves at a constant speed.
    pub(super) curving: f64,
}

/// How far a corner may be rounded: in mm, in degrees of the tool's turn, in degrees of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tolerances {
    pub(super) mm: f64,
    pub(super) turn_deg: f64,
    pub(super) joint_deg: f64,
}

impl Leg {
    pub(super) fn joints(after: usize, from: [f64; 6], to: [f64; 6]) -> Self {
        let moved: [f64; 6] = std::array::from_fn(|joint| to[joint] - from[joint]);
        let length = moved.iter().map(|moved| moved * moved).sum::<f64>().sqrt();
        Self { after, length, start: from, path: LegPath::Joints(moved.map(|moved| moved / length)) }
    }

    /// Where the joints are after a way on a leg in joint space.
    pub(super) fn joints_at(&self, direction: &[f64; 6], way: f64) -> [f64; 6] {
        std::array::from_fn(|joint| self.start[joint] + way * direction[joint])
    }
}
