//! Joint positions and poses in other units, and orientations as matrices and quaternions.
//!
//! On the wire, and so in the fields of [`JointPosition`](crate::messages::types::JointPosition) and
//! [`Pose`](crate::messages::types::Pose), angles are degrees and lengths millimetres. The conversions are methods of
//! the two types, and each name states its unit.
//!
//! ```
//! use jaka_proto::geometry::Quaternion;
//! use jaka_proto::messages::types::{JointPosition, Pose};
//!
//! let joints = JointPosition::from_radians([0.0, std::f64::consts::FRAC_PI_2, 0.0, 0.0, 0.0, 0.0]);
//! assert_eq!(joints.degrees(), [0.0, 90.0, 0.0, 0.0, 0.0, 0.0]);
//!
//! // The tool points down, half a metre before the base.
//! let down = Quaternion { w: 0.0, x: 1.0, y: 0.0, z: 0.0 };
//! let pose = Pose::from_metres_radians([0.5, 0.0, 0.3], [0.0; 3]).with_quaternion(down)?;
//! assert_eq!(pose.position_mm(), [500.0, 0.0, 300.0]);
//! assert_eq!(pose.rotation_deg(), [180.0, 0.0, 0.0]);
//! # Ok::<(), jaka_proto::geometry::NotARotation>(())
//! ```
//!
//! # Orientation
//! `rx`, `ry`, `rz` are roll, pitch and yaw: turns about the **fixed** axes x, then y, then z, so that
//!
//! ```text
//! R = Rz(rz) · Ry(ry) · Rx(rx)
//! ```
//!
//! takes coordinates in the posed frame to those in the reference frame; the columns of `R` are the axes of the posed
//! frame. The same is called extrinsic XYZ, or intrinsic ZYX: turns about the moving axes z, then y, then x. It is
//! *not* intrinsic XYZ.
//!
//! The document says "Euler angles" in the order x, y, z (section 4.16) and leaves open which axes these are. The
//! vendor's SDK decides it: it calls the type `Rpy`, and its examples pair the angles -1.81826, -0.834253, -2.30243 rad
//! with the quaternion 0.0629, 0.522886, -0.5592, 0.6453 (w first), which fits this order alone.
//!
//! # From an orientation to angles
//! `ry` is within 90 degrees of zero, `rx` and `rz` above -180 and up to 180. At gimbal lock, with `ry` at 90 or -90,
//! only the difference or sum of `rx` and `rz` is determined: `rz` is zero there. The angles may differ from those of
//! the original quaternion or matrix, the orientation does not.
//!
//! # nalgebra, glam and others
//! They exchange values with each other through the `mint` crate, and with us under the feature `mint`:
//!
//! ```
//! # #[cfg(feature = "mint")] {
//! use jaka_proto::messages::types::Pose;
//!
//! let pose = Pose::from_millimetres_degrees([300.0, 0.0, 200.0], [180.0, 0.0, 45.0]);
//! let position = mint::Point3::from(pose); // mm; or a `mint::Vector3`
//! let orientation = mint::Quaternion::from(pose);
//! let back = Pose::try_from((position, orientation))?;
//! assert!(back.distance_mm(&pose) == 0.0 && back.angle_deg(&pose) < 1e-9);
//! # }
//! # Ok::<(), jaka_proto::geometry::NotARotation>(())
//! ```
//!
//! # Numbers that are not finite
//! Nothing here panics. NaN and infinity in a position or pose give NaN or infinity, and such a pose is refused before
//! it is sent; in a quaternion or matrix they are [`NotARotation`].

mod joint_position;
#[cfg(feature = "mint")]
mod mint_conversions;
mod pose;
mod rotation;

#[cfg(test)]
mod tests;

pub use rotation::{NotARotation, Quaternion};
