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

/// The orientation as a rotation matrix.
impl From<Pose> for mint::ColumnMatrix3<f64> {
    fn from(pose: Pose) -> Self {
        mint::RowMatrix3::from(pose.rotation_matrix()).into()
    }
}

/// The rotation in radians: `rz`, `ry`, `rx` about the moving axes z, y, x.
impl From<Pose> for mint::EulerAngles<f64, mint::IntraZYX> {
    fn from(pose: Pose) -> Self {
        let [rx, ry, rz] = pose.rotation_rad();
        [rz, ry, rx].into()
    }
}

/// A position in millimetres and an orientation; an error as from [`Pose::with_quaternion`].
impl TryFrom<(mint::Point3<f64>, mint::Quaternion<f64>)> for Pose {
    type Error = NotARotation;

    fn try_from((position, orientation): (mint::Point3<f64>, mint::Quaternion<f64>)) -> Result<Self, NotARotation> {
        Self::from_millimetres_quaternion(position.into(), orientation)
    }
}

/// A position in millimetres and a rotation matrix; an error as from [`Pose::with_rotation_matrix`].
impl TryFrom<(mint::Point3<f64>, mint::ColumnMatrix3<f64>)> for Pose {
    type Error = NotARotation;

    fn try_from((position, matrix): (mint::Point3<f64>, mint::ColumnMatrix3<f64>)) -> Result<Self, NotARotation> {
        let rows = mint::RowMatrix3::from(matrix).into();
        Self::from_millimetres_degrees(position.into(), [0.0; 3]).with_rotation_matrix(rows)
    }
}

/// A position in millimetres, and a rotation in radians with unchanged angles.
impl From<(mint::Point3<f64>, mint::EulerAngles<f64, mint::IntraZYX>)> for Pose {
    fn from((position, angles): (mint::Point3<f64>, mint::EulerAngles<f64, mint::IntraZYX>)) -> Self {
        let rotation = [angles.c, angles.b, angles.a].map(f64::to_degrees);
        Self::from_millimetres_degrees(position.into(), rotation)
    }
}
