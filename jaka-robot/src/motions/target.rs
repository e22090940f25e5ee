//! Where a motion ends.

use jaka_proto::messages::types::{JointPosition, Pose};

use crate::place::{Place, Quantity};

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

impl Target {
    /// Where it is for a motion that begins at `start`, if that determines it.
    pub(crate) fn from(self, start: Option<Place>) -> Option<Place> {
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
    pub(crate) fn start_quantity(&self) -> Option<Quantity> {
        match self {
            Self::JointOffset(_) => Some(Quantity::Joints),
            Self::Offset(_) => Some(Quantity::Pose),
            _ => None,
        }
    }
}
