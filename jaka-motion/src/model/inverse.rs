//! Results of the inverse kinematics.

use std::fmt;
use std::ops::Deref;

use arrayvec::ArrayVec;
use jaka_proto::messages::types::JointPosition;

/// The joint positions that bring the flange to a pose, one for each branch: a slice, nearest first: at
/// most eight, and sixteen for the A12.
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
            /// Least change of the arm's length between shoulder and wrist with which it would reach, in mm.
            by_mm: f64,
        } => "out of reach by {by_mm:.1} mm",
        /// The position is within reach, but not with this orientation.
        Orientation => "the orientation is out of reach",
        /// The pose is within reach, but each way to it turns a joint beyond its range. This is the least of it.
        BeyondRange {
            /// The joint, 1 to 6.
            joint: usize,
            /// Position that the joint would have, in degrees.
            position_deg: f64,
            /// The end of its range, in degrees.
            limit_deg: f64,
        } => "joint {joint} would be at {position_deg:.1} deg; limit {limit_deg}",
        /// The joint positions that were found do not bring the flange there well enough, which is so at the edge of
        /// reach.
        NotConfirmed => "at the edge of reach: no joint position was confirmed",
    }
}

/// Two branches nearer to each other than this, in degrees, are one.
const SAME: f64 = 1e-6;

impl Branches {
    /// Adds a branch that is not there yet.
    pub(crate) fn add(&mut self, joints: JointPosition) {
        if !self.iter().any(|other| other.max_distance(&joints) < SAME) {
            // A seventeenth is dropped: the arms here have no more than sixteen.
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
