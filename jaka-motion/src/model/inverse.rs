//! Results of the inverse kinematics.

use std::fmt;
use std::ops::Deref;

use arrayvec::ArrayVec;
use jaka_proto::messages::types::JointPosition;
use nalgebra::{Isometry3, Vector3, Vector6};

/// The joint positions that bring the flange to a pose, one for each branch: a slice, at most eight, nearest first.
#[derive(Clone, Default)]
pub struct Branches(ArrayVec<JointPosition, 8>);

jaka_proto::worded! {
    /// Why the arm cannot bring its flange to a pose.
    #[derive(Debug, Clone, Copy, PartialEq)]
    #[non_exhaustive]
    pub enum NoSolution {
        /// The pose or the reference has a number that is not finite.
        NotFinite => "a number of the pose or of the reference is not finite",
        /// The pose is too far away, or too near to the axis of joint 1.
        OutOfReach {
            /// How much longer or shorter the arm would have to be between shoulder and wrist, at least, in mm.
            by_mm: f64,
        } => "out of reach by {by_mm:.1} mm",
        /// The pose is within reach, but each way to it turns a joint beyond its range. This is the least of it.
        BeyondRange {
            /// The joint, 1 to 6.
            joint: usize,
            /// Where it would be, in degrees.
            position_deg: f64,
            /// The end of its range, in degrees.
            limit_deg: f64,
        } => "joint {joint} would be at {position_deg:.1} deg; limit {limit_deg}",
        /// The joint positions that were found do not bring the flange there well enough, which is so at the edge of
        /// reach.
        NotConfirmed => "at the edge of reach: no joint position was confirmed",
    }
}

/// The weight of one radian relative to one millimetre.
pub(crate) const RADIAN: f64 = 1e3;
/// Two branches nearer to each other than this, in degrees, are one.
const SAME: f64 = 1e-6;

impl Branches {
    /// Adds a branch that is not there yet.
    pub(crate) fn add(&mut self, joints: JointPosition) {
        if !self.iter().any(|other| other.max_distance(&joints) < SAME) {
            // A ninth is dropped: the arms here have no more than eight.
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

/// The small translation and rotation that take one transform to the other.
pub(crate) fn off(from: &Isometry3<f64>, to: &Isometry3<f64>) -> Vector6<f64> {
    let moved: Vector3<f64> = to.translation.vector - from.translation.vector;
    let turned = (to.rotation * from.rotation.inverse()).scaled_axis() * RADIAN;
    Vector6::new(moved.x, moved.y, moved.z, turned.x, turned.y, turned.z)
}
