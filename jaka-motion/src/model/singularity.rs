//! How far joint positions are from those at which the arm loses a direction.

use jaka_proto::messages::types::JointPosition;
use nalgebra::{Isometry3, Matrix6, Vector3};

use super::Model;
use crate::links::jacobian;

/// How far joint positions are from a singularity, where the tool cannot be moved or turned in some direction, and near
/// which a slow motion of the tool takes a fast one of the joints.
///
/// Each number is zero at a singularity and has no unit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SingularityDistance {
    /// How far the wrist, where the axes of joints 5 and 6 meet, is from the plane through the axis of joint 1 that is
    /// parallel to the axis of joint 2, divided by [`Model::reach_mm`]. It is zero where the wrist is above the
    /// shoulder.
    pub shoulder: f64,
    /// The sine of the angle between upper arm and forearm, zero where the arm is stretched.
    pub elbow: f64,
    /// The sine of the angle between the axes of joints 4 and 6, zero where joint 5 puts them in line.
    pub wrist: f64,
    /// The smallest singular value of the Jacobian at the flange, for radians of the joints, with lengths divided by
    /// [`Model::reach_mm`].
    pub smallest_singular_value: f64,
}

jaka_proto::worded! {
    /// Where the arm loses a direction.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    pub enum Singularity {
        /// The wrist is above the shoulder.
        Shoulder => "shoulder",
        /// The arm is stretched.
        Elbow => "elbow",
        /// Joint 5 puts the axes of joints 4 and 6 in line.
        Wrist => "wrist",
    }
}

impl Singularity {
    /// All three, in the order of the joints.
    pub(crate) const ALL: [Self; 3] = [Self::Shoulder, Self::Elbow, Self::Wrist];

    /// The nearest one of these distances, and its distance.
    pub(crate) fn nearest(distances: &[f64; 3]) -> (Self, f64) {
        let distances = Self::ALL.into_iter().zip(*distances);
        distances.min_by(|one, other| one.1.total_cmp(&other.1)).unwrap_or((Self::Wrist, f64::NAN))
    }
}

/// The most rounds of the search for singular values. It takes about ten.
const ROUNDS: usize = 200;

impl Model {
    /// How far these joint positions are from the singularities of shoulder, elbow and wrist; NaN for joint positions
    /// that are not finite.
    ///
    /// ```
    /// use jaka_motion::Model;
    ///
    /// let arm = Model::named("Zu 5").expect("a published arm");
    /// let stretched = arm.singularity_distance([0.0, 60.0, 0.0, 30.0, -90.0, 0.0]);
    /// assert!(stretched.elbow < 1e-9 && stretched.wrist > 0.9 && stretched.smallest_singular_value < 1e-9);
    /// ```
    pub fn singularity_distance(&self, joints: impl Into<JointPosition>) -> SingularityDistance {
        let frames = self.links.frames(&joints.into().0);
        let [shoulder, elbow, wrist] = self.distances(&frames);
        let mut unitless = jacobian(&frames, &frames[5].translation.vector);
        unitless.fixed_rows_mut::<3>(0).unscale_mut(self.reach_mm());
        SingularityDistance { shoulder, elbow, wrist, smallest_singular_value: smallest_singular_value(&unitless) }
    }

    /// How far shoulder, elbow and wrist are from their singularities, for the frames of the joints.
    pub(crate) fn distances(&self, frames: &[Isometry3<f64>; 6]) -> [f64; 3] {
        self.signed_distances(frames).map(f64::abs)
    }

    /// The distances, with another sign on each side of a singularity.
    pub(crate) fn signed_distances(&self, frames: &[Isometry3<f64>; 6]) -> [f64; 3] {
        let at = |index: usize| frames[index].translation.vector;
        let axis = |index: usize| frames[index].rotation * Vector3::z();
        // Joint 2 turns both in one plane, to which lengths along its axis do not count.
        let in_plane = |bar: Vector3<f64>| bar - axis(1) * axis(1).dot(&bar);
        let (upper_arm, forearm) = (in_plane(at(2) - at(1)), in_plane(at(3) - at(2)));
        let (bend, turn) = (upper_arm.cross(&forearm), axis(3).cross(&axis(5)));
        [
            axis(0).cross(&axis(1)).dot(&(at(4) - at(0))) / self.reach_mm(),
            bend.norm().copysign(bend.dot(&axis(1))) / (upper_arm.norm() * forearm.norm()),
            turn.norm().copysign(turn.dot(&axis(4))),
        ]
    }
}

/// NaN for a matrix that is not finite, on which the search would not end; zero, as at a singularity, where it does
/// not.
fn smallest_singular_value(matrix: &Matrix6<f64>) -> f64 {
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return f64::NAN;
    }
    matrix.try_svd_unordered(false, false, f64::EPSILON, ROUNDS).map_or(0.0, |parts| parts.singular_values.min())
}
