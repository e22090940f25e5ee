//! Results of the inverse kinematics.

use std::fmt;
use std::ops::Deref;

use arrayvec::ArrayVec;
use jaka_proto::messages::types::JointPosition;

/// Joint positions that bring the flange to a pose, one for each branch, as a slice with the nearest first: at most
/// eight, and sixteen for the A12.
#[derive(Clone, Default)]
pub struct Branches(ArrayVec<JointPosition, 16>);

jaka_proto::worded! {
    /// Error for a pose to which the arm cannot bring its flange.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum NoSolution {
        /// The pose or the reference has a number that is not finite.
        NotFinite => "a number of the pose or of the reference is not finite",
        /// The pose is too far away, or too near to the axis of joint 1.
        OutOfReach {
            /// Least change of the distance between shoulder and wrist that would bring the pose within reach, in mm.
            by_mm: f64,
        } => "out of reach by {by_mm:.1} mm",
        /// The position is within reach, but not with this orientation.
        Orientation => "the orientation is out of reach",
        /// The pose is within reach, but each branch turns a joint beyond its range. The fields are those of the least
        /// excess.
        BeyondRange {
            /// Number of the joint, 1 to 6.
            joint: usize,
            /// Position that the joint would have, in degrees.
            position_deg: f64,
            /// End of the joint's range, in degrees.
            limit_deg: f64,
        } => "joint {joint} would be at {position_deg:.1} deg; limit {limit_deg}",
        /// The joint positions from the solver do not bring the flange close enough to the pose. This happens at the
        /// edge of reach.
        NotConfirmed => "at the edge of reach: no joint position was confirmed",
    }
}

/// Distance, in degrees, below which two branches are one.
const SAME: f64 = 1e-6;

impl Branches {
    /// Adds a branch unless it is there already.
    pub(crate) fn add(&mut self, joints: JointPosition) {
        if !self.iter().any(|other| other.max_distance(&joints) < SAME) {
            // A seventeenth is dropped: the supported arms have no more than sixteen.
            let _ = self.0.try_push(joints);
        }
    }
}

impl Deref for Branches {
    type Target = [JointPosition];

    fn deref(&self) -> &[JointPosition] {
        &self.0
    }
}

impl fmt::Debug for Branches {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl std::error::Error for NoSolution {}
