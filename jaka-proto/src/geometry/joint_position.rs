//! Joint positions in degrees and radians.

use std::fmt;
use std::ops::{Index, IndexMut};

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

    /// Distance between two joint positions, in degrees: the largest difference of any joint.
    ///
    /// Turns count, since they do for the arm: 179 and -179 are 358 apart. NaN if the difference of any joint is, so
    /// that `position.max_distance(&target) < tolerance` is false then.
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

/// A joint by its index, 0 to 5 for joints 1 to 6, in degrees.
///
/// # Panics
/// The index is greater than 5, as for an array.
///
/// ```
/// use jaka_proto::messages::types::JointPosition;
///
/// let mut joints = JointPosition::from_degrees([0.0, 90.0, 90.0, 90.0, -90.0, 0.0]);
/// joints[0] += 10.0;
/// assert_eq!(joints[0], 10.0);
/// ```
impl Index<usize> for JointPosition {
    type Output = f64;

    fn index(&self, index: usize) -> &f64 {
        &self.0[index]
    }
}

/// As `Index`.
impl IndexMut<usize> for JointPosition {
    fn index_mut(&mut self, index: usize) -> &mut f64 {
        &mut self.0[index]
    }
}

/// The six angles with their unit; a precision applies to each number.
///
/// ```
/// use jaka_proto::messages::types::JointPosition;
///
/// let joints = JointPosition::from_degrees([0.0, 90.5, 90.0, 90.0, -90.0, 0.0]);
/// assert_eq!(joints.to_string(), "[0, 90.5, 90, 90, -90, 0] deg");
/// assert_eq!(format!("{joints:.1}"), "[0.0, 90.5, 90.0, 90.0, -90.0, 0.0] deg");
/// ```
impl fmt::Display for JointPosition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_list(&self.0, f)?;
        f.write_str(" deg")
    }
}

/// The numbers in brackets, each with the formatter's precision.
pub(super) fn write_list(numbers: &[f64], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    f.write_str("[")?;
    for (at, number) in numbers.iter().enumerate() {
        if at > 0 {
            f.write_str(", ")?;
        }
        fmt::Display::fmt(number, f)?;
    }
    f.write_str("]")
}
