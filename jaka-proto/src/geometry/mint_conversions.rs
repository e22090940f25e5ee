//! Conversions to and from `mint`, through which nalgebra, glam and others exchange values.
//!
//! Positions are millimetres. A pose gives its parts; it is made of a position and an orientation.

use super::{NotARotation, Quaternion};
use crate::messages::types::Pose;

impl From<Quaternion> for mint::Quaternion<f64> {
    fn from(Quaternion { w, x, y, z }: Quaternion) -> Self {
        Self { s: w, v: [x, y, z].into() }
    }
}

impl From<mint::Quaternion<f64>> for Quaternion {
    fn from(mint::Quaternion { s, v }: mint::Quaternion<f64>) -> Self {
        Self { w: s, x: v.x, y: v.y, z: v.z }
    }
}

/// The position in millimetres.
impl From<Pose> for mint::Point3<f64> {
    fn from(pose: Pose) -> Self {
        pose.position_mm().into()
    }
}

/// The position in millimetres.
impl From<Pose> for mint::Vector3<f64> {
    fn from(pose: Pose) -> Self {
        pose.position_mm().into()
    }
}

/// The orientation as a unit quaternion.
impl From<Pose> for mint::Quaternion<f64> {
    fn from(pose: Pose) -> Self {
        pose.quaternion().into()
    }
}

/// A position in millimetres and an orientation; an error as from [`Pose::with_quaternion`].
impl TryFrom<(mint::Point3<f64>, mint::Quaternion<f64>)> for Pose {
    type Error = NotARotation;

    fn try_from((position, orientation): (mint::Point3<f64>, mint::Quaternion<f64>)) -> Result<Self, NotARotation> {
        Self::from_millimetres_quaternion(position.into(), orientation)
    }
}
