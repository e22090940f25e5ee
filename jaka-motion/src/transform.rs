//! Position and orientation of a frame, seen from another.

use std::ops::Mul;

use jaka_proto::messages::types::Pose;
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};

/// Position, in mm, and orientation of a frame, seen from another.
///
/// It is a [`Pose`] in a form for computation: `a * b` is frame `b`, given in frame `a`, seen from the frame in which
/// `a` is given. `from` and `into` convert between poses and transforms; see [`jaka_proto::geometry`] for the angles.
///
/// ```
/// use jaka_motion::Transform;
/// use jaka_proto::messages::types::Pose;
///
/// let flange = Transform::from(Pose::from_millimetres_degrees([400.0, 0.0, 300.0], [180.0, 0.0, 0.0]));
/// let gripper = Transform::from(Pose::from_millimetres_degrees([0.0, 0.0, 120.0], [0.0; 3]));
/// let tip = flange * gripper;
/// assert_eq!(tip.position_mm().map(f64::round), [400.0, 0.0, 180.0]);
/// assert!((tip * gripper.inverse()).distance_mm(&flange) < 1e-9);
/// ```
///
/// A pose with numbers that are not finite gives a transform without finite numbers, which
/// [`Model::inverse`](crate::Model::inverse) refuses; such a transform gives a pose without finite numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transform(pub(crate) Isometry3<f64>);

/// Greatest distance from half a turn, in degrees, at which the sign is positive. Half a turn has two signs, and
/// rounding must not choose one.
const ROUNDING: f64 = 1e-9;

impl Transform {
    /// Returns the frame from which it is seen.
    pub fn identity() -> Self {
        Self(Isometry3::identity())
    }

    /// Returns the other frame, seen from this one.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self(self.0.inverse())
    }

    /// Returns the position x, y, z in mm.
    pub fn position_mm(&self) -> [f64; 3] {
        self.0.translation.vector.into()
    }

    /// Returns the distance between the positions of two frames, in mm.
    pub fn distance_mm(&self, other: &Self) -> f64 {
        (self.0.translation.vector - other.0.translation.vector).norm()
    }

    /// Returns the angle of the single turn from one orientation to the other, 0 to 180 degrees.
    pub fn angle_deg(&self, other: &Self) -> f64 {
        self.0.rotation.angle_to(&other.0.rotation).to_degrees()
    }

    /// Returns the frame moved by an offset along the axes of the frame from which it is seen, and turned about these
    /// directions at its place.
    ///
    /// A relative `moveL` (section 4.9) applies its offset in this way.
    #[must_use]
    pub fn displaced(&self, offset: &Self) -> Self {
        let place = self.0.translation.vector + offset.0.translation.vector;
        Self(Isometry3::from_parts(Translation3::from(place), offset.0.rotation * self.0.rotation))
    }

    /// Returns the frame at a share, from 0 to 1, of the straight path to another, turned evenly about one axis.
    #[must_use]
    pub fn between(&self, to: &Self, share: f64) -> Self {
        let (from, to) = (&self.0, &to.0);
        let place = from.translation.vector.lerp(&to.translation.vector, share);
        // Axis and angle, unlike slerp, define a path also for half a turn.
        let turn = (from.rotation.inverse() * to.rotation).scaled_axis() * share;
        Self(Isometry3::from_parts(Translation3::from(place), from.rotation * UnitQuaternion::from_scaled_axis(turn)))
    }
}

impl Mul for Transform {
    type Output = Self;

    fn mul(self, seen_from_it: Self) -> Self {
        Self(self.0 * seen_from_it.0)
    }
}

impl From<Pose> for Transform {
    fn from(pose: Pose) -> Self {
        let turn = pose.quaternion();
        let turn = UnitQuaternion::new_unchecked(Quaternion::new(turn.w, turn.x, turn.y, turn.z));
        Self(Isometry3::from_parts(Translation3::from(pose.position_mm()), turn))
    }
}

impl From<Transform> for Pose {
    fn from(Transform(frame): Transform) -> Self {
        let turn = frame.rotation.to_rotation_matrix();
        let rows = [0, 1, 2].map(|row| [0, 1, 2].map(|column| turn[(row, column)]));
        let unturned = Self::from_millimetres_degrees(frame.translation.vector.into(), [f64::NAN; 3]);
        // The matrix is a rotation unless its numbers are not finite.
        let pose = unturned.with_rotation_matrix(rows).unwrap_or(unturned);
        let half_turn = |angle: f64| if angle < ROUNDING - 180.0 { 180.0 } else { angle };
        // Adding zero turns -0 into 0.
        let [x, y, z] = pose.position_mm().map(|length| length + 0.0);
        Self { x, y, z, rx: half_turn(pose.rx), rz: half_turn(pose.rz), ..pose }
    }
}
