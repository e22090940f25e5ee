//! All joint positions that reach a pose.

use std::fmt;
use std::ops::Deref;

use arrayvec::ArrayVec;
use jaka_proto::messages::types::JointPosition;

/// The joint positions that bring the flange to a pose, one for each branch: a slice, at most eight, nearest first.
#[derive(Clone, Default)]
pub struct Branches(ArrayVec<JointPosition, 8>);

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
