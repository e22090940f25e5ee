//! Where the flange is for given joints, and which joints put it there.
//!
//! Lengths are millimetres and angles degrees, as on the wire. A [`Model`] carries the Denavit-Hartenberg parameters
//! of one arm as `get_dh_param` (document 2.0.4, section 4.82) answers them; [`Model::forward`] and
//! [`Model::inverse`] work from nothing else, so that `kine_forward`, `kine_inverse`, `get_tcp_pos` and
//! `get_dh_param` cannot disagree.
//!
//! # Conventions
//! **Links** follow Craig's modified parameters: from frame i-1 to frame i the transform is
//! `Rx(alpha[i]) Tx(a[i]) Rz(q[i] + joint_home_offset[i]) Tz(d[i])`. Evidence: a client's solver for the JAKA Lumi lists,
//! as "obtained from the robot", alpha 0, 90, 0, 0, 90, -90, a 0, 0, 897, 744.5, 0, 0, d 196.5, 0, 0,
//! -188.35000610351562, 138.5, 120.5 and `joint_home_offset` 0 (the float noise is a controller's); read this way they
//! are the chain of the vendor's `jaka_zu20.urdf`, read as standard parameters joints 1 and 2 would be parallel.
//!
//! **Orientation** `rx, ry, rz` is roll, pitch, yaw: `R = Rz(rz) Ry(ry) Rx(rx)`, turns about the fixed axes X, then
//! Y, then Z, which is what the document's "Euler angles, order XYZ" (section 4.16) means. Evidence: the vendor's SDK
//! names the type `Rpy` (`jktypes.h`) and its C and C++ examples pair rpy -1.81826, -0.834253, -2.30243 rad with
//! joints 0.558, 0.872, 0.872, 0.349, 0.191, 0.191 rad and the quaternion 0.0629, 0.522886, -0.5592, 0.6453; both fit
//! this order alone. `tests::conventions` has both.
//!
//! # Invariant
//! No input makes a function here panic, and [`Model::inverse`] returns nothing that [`Model::forward`] does not
//! confirm.

mod closed_form;
mod inverse;
mod link;
mod model;
mod pose;
mod published;
mod wrist;

#[cfg(test)]
mod tests;

pub use model::Model;
pub(crate) use pose::{from_pose, to_pose};
