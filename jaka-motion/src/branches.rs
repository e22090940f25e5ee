//! All joint positions that reach a pose.

use std::fmt;
use std::ops::Deref;

use jaka_proto::messages::types::JointPosition;

/// The joint positions that bring the flange to a pose, one for each branch: a slice, at most eight, nearest first.
#[derive(Clone, Copy)]
pub struct Branches {
    joints: [JointPosition; 8],
    count: usize,
}

/// Two branches nearer to each other than this, in degrees, are one.
const SAME: f64 = 1e-6;

impl Branches {
    pub(crate) fn new() -> Self {
        Self { joints: [JointPosition([0.0; 6]); 8], count: 0 }
    }

    /// Adds a branch that is not there yet.
    pub(crate) fn add(&mut self, joints: JointPosition) {
        if self.iter().any(|other| other.max_distance(&joints) < SAME) {
            return;
        }
        if let Some(place) = self.joints.get_mut(self.count) {
            *place = joints;
            self.count += 1;
        }
    }
}

impl Deref for Branches {
    type Target = [JointPosition];

    fn deref(&self) -> &[JointPosition] {
        &self.joints[..self.count]
    }
}

impl fmt::Debug for Branches {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}
