//! Distances of joint positions from singularities.

use nalgebra::Matrix6;

/// Distance of joint positions from the singularities. At a singularity the tool cannot move or turn in some direction;
/// near one, a slow motion of the tool requires a fast motion of the joints.
///
/// Each number is zero at a singularity and has no unit.
///
/// The A12, whose wrist has an offset, has no singularities of a single joint: its forearm may be stretched, and its
/// joint 5 at any position, without the loss of a direction. For this arm `wrist` is the distance of the whole arm, and
/// `shoulder` and `elbow` are 1. It is a product, and so mostly smaller than the distances of other arms: half of all
/// joint positions are below 0.11, and one in nine below 0.01.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SingularityDistance {
    /// Distance of the wrist, at which the axes of joints 5 and 6 meet, from the plane through the axis of joint 1 that
    /// is parallel to the axis of joint 2, divided by [`Model::reach_mm`](super::Model::reach_mm). It is zero if the
    /// wrist is above the shoulder.
    pub shoulder: f64,
    /// Sine of the angle between upper arm and forearm; zero if the arm is stretched.
    pub elbow: f64,
    /// Sine of the angle between the axes of joints 4 and 6; zero if joint 5 puts them in line.
    ///
    /// On the A12 it is the determinant of the Jacobian for radians of the joints and mm, divided by the lengths of
    /// upper arm and forearm and by their sum; it is never above 0.85.
    pub wrist: f64,
    /// Smallest singular value of the Jacobian at the flange, for radians of the joints, with lengths divided by
    /// [`Model::reach_mm`](super::Model::reach_mm).
    pub smallest_singular_value: f64,
}

jaka_proto::worded! {
    /// Singularity of the arm: joint positions at which it loses a direction.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
    pub enum Singularity {
        /// The wrist is above the shoulder.
        Shoulder => "shoulder",
        /// The arm is stretched.
        Elbow => "elbow",
        /// Joint 5 puts the axes of joints 4 and 6 in line; on the A12 any singularity.
        Wrist => "wrist",
    }
}

impl Singularity {
    /// All three, in the order of the joints.
    pub(crate) const ALL: [Self; 3] = [Self::Shoulder, Self::Elbow, Self::Wrist];

    /// Returns the nearest singularity of these distances, and its distance.
    pub(crate) fn nearest(distances: &[f64; 3]) -> (Self, f64) {
        let distances = Self::ALL.into_iter().zip(*distances);
        distances.min_by(|one, other| one.1.total_cmp(&other.1)).unwrap_or((Self::Wrist, f64::NAN))
    }
}

/// Greatest number of rounds of the search for singular values. It takes about ten.
const ROUNDS: usize = 200;

/// Returns the smallest singular value of a matrix: NaN if the matrix is not finite, for which the search would not
/// end; zero, as at a singularity, if the search fails.
pub(super) fn smallest_singular_value(matrix: &Matrix6<f64>) -> f64 {
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return f64::NAN;
    }
    matrix.try_svd_unordered(false, false, f64::EPSILON, ROUNDS).map_or(0.0, |parts| parts.singular_values.min())
}
