//! Joint positions in degrees and radians.

use crate::messages::types::JointPosition;

/// Units; see [`geometry`](crate::geometry).
impl JointPosition {
    /// Joints 1 to 6 in degrees, as on the wire.
    pub const fn from_degrees(degrees: [f64; 6]) -> Self {
        Self(degrees)
    }

    /// Joints 1 to 6 in radians.
    pub fn from_radians(radians: [f64; 6]) -> Self {
        Self(radians.map(f64::to_degrees))
    }

    /// Joints 1 to 6 in degrees, as on the wire.
    pub const fn degrees(&self) -> [f64; 6] {
        self.0
    }

    /// Joints 1 to 6 in radians.
    pub fn radians(&self) -> [f64; 6] {
        self.0.map(f64::to_radians)
    }

    /// How far apart the joints are, in degrees: the largest difference of any joint.
    ///
    /// Turns count, since they do for the arm: 179 and -179 are 358 apart. NaN if the difference of any joint is, so that
    /// `position.max_distance(&target) < tolerance` is false then.
    ///
    /// ```
    /// use jaka_proto::messages::types::JointPosition;
    ///
    /// let target = JointPosition::from_degrees([0.0, 90.0, 90.0, 90.0, -90.0, 0.0]);
    /// let position = JointPosition::from_degrees([0.0, 90.0, 89.5, 90.0, -90.0, 0.25]);
    /// assert_eq!(position.max_distance(&target), 0.5);
    /// ```
    pub fn max_distance(&self, other: &Self) -> f64 {
        let distances = self.0.iter().zip(other.0).map(|(one, other)| (one - other).abs());
        // `f64::max` would drop NaN.
        distances.fold(0.0, |most, next| if most >= next || most.is_nan() { most } else { next })
    }
}
