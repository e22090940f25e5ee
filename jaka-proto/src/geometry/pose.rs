//! Poses in other units, and their orientations in other forms.

use std::fmt;

use super::joint_position::write_list;
use super::rotation::{self, NotARotation, Quaternion};
use crate::messages::types::Pose;

const MM_PER_METRE: f64 = 1000.0;

/// Units and orientation; see [`geometry`](crate::geometry) for the convention.
impl Pose {
    /// The position x, y, z in millimetres and the rotation rx, ry, rz in degrees, as on the wire.
    pub const fn from_millimetres_degrees(position: [f64; 3], rotation: [f64; 3]) -> Self {
        let ([x, y, z], [rx, ry, rz]) = (position, rotation);
        Self { x, y, z, rx, ry, rz }
    }

    /// The position x, y, z in metres and the rotation rx, ry, rz in radians.
    pub fn from_metres_radians(position: [f64; 3], rotation: [f64; 3]) -> Self {
        Self::from_millimetres_degrees(position.map(|metres| metres * MM_PER_METRE), rotation.map(f64::to_degrees))
    }

    /// The position x, y, z in millimetres and the orientation as a quaternion.
    ///
    /// # Errors
    /// The quaternion is not a rotation; see [`with_quaternion`](Self::with_quaternion).
    pub fn from_millimetres_quaternion(
        position: [f64; 3],
        orientation: impl Into<Quaternion>,
    ) -> Result<Self, NotARotation> {
        Self::from_millimetres_degrees(position, [0.0; 3]).with_quaternion(orientation)
    }

    /// The position x, y, z in metres and the orientation as a quaternion.
    ///
    /// # Errors
    /// The quaternion is not a rotation; see [`with_quaternion`](Self::with_quaternion).
    pub fn from_metres_quaternion(
        position: [f64; 3],
        orientation: impl Into<Quaternion>,
    ) -> Result<Self, NotARotation> {
        Self::from_metres_radians(position, [0.0; 3]).with_quaternion(orientation)
    }

    /// The position x, y, z in millimetres, as on the wire.
    pub const fn position_mm(&self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }

    /// The position x, y, z in metres.
    pub fn position_m(&self) -> [f64; 3] {
        self.position_mm().map(|mm| mm / MM_PER_METRE)
    }

    /// The rotation rx, ry, rz in degrees, as on the wire.
    pub const fn rotation_deg(&self) -> [f64; 3] {
        [self.rx, self.ry, self.rz]
    }

    /// The rotation rx, ry, rz in radians.
    pub fn rotation_rad(&self) -> [f64; 3] {
        self.rotation_deg().map(f64::to_radians)
    }

    /// The orientation as a rotation matrix, row by row; its columns are the axes of the posed frame.
    ///
    /// ```
    /// use jaka_proto::messages::types::Pose;
    ///
    /// let pose = Pose::from_millimetres_degrees([0.0; 3], [0.0, 0.0, 30.0]);
    /// let [[x_x, ..], [x_y, ..], [x_z, ..]] = pose.rotation_matrix();
    /// assert!((x_x - 0.75_f64.sqrt()).abs() < 1e-15 && (x_y - 0.5).abs() < 1e-15 && x_z == 0.0);
    /// ```
    pub fn rotation_matrix(&self) -> [[f64; 3]; 3] {
        rotation::matrix_from_rpy(self.rotation_rad())
    }

    /// The orientation as a unit quaternion, with `w` not below zero.
    pub fn quaternion(&self) -> Quaternion {
        rotation::quaternion_from_rpy(self.rotation_rad())
    }

    /// This position with the orientation of a rotation matrix, given row by row.
    ///
    /// # Errors
    /// The matrix mirrors, or a product of two of its rows differs by more than 0.01 from the product of orthogonal
    /// unit vectors.
    pub fn with_rotation_matrix(self, rows: [[f64; 3]; 3]) -> Result<Self, NotARotation> {
        rotation::check_matrix(&rows)?;
        Ok(self.with_rotation_deg(rotation::rpy_deg_from_matrix(&rows)))
    }

    /// This position with the orientation of a quaternion, which is brought to length one; its sign does not matter.
    ///
    /// ```
    /// use jaka_proto::geometry::Quaternion;
    /// use jaka_proto::messages::types::Pose;
    ///
    /// let pose = Pose::from_millimetres_degrees([300.0, 0.0, 200.0], [180.0, 0.0, 45.0]);
    /// let turned = pose.with_quaternion(Quaternion { w: 0.5, x: 0.5, y: 0.5, z: 0.5 })?;
    /// assert_eq!(turned.rotation_deg().map(f64::round), [90.0, 0.0, 90.0]);
    /// assert!(pose.with_quaternion(Quaternion { w: 0.0, x: 0.0, y: 0.0, z: 0.0 }).is_err());
    /// # Ok::<(), jaka_proto::geometry::NotARotation>(())
    /// ```
    ///
    /// # Errors
    /// Its length differs from one by more than one in a hundred: it is zero, not finite, or something else.
    pub fn with_quaternion(self, orientation: impl Into<Quaternion>) -> Result<Self, NotARotation> {
        let matrix = rotation::matrix_from_quaternion(orientation.into())?;
        Ok(self.with_rotation_deg(rotation::rpy_deg_from_matrix(&matrix)))
    }

    /// Pose in this frame of a pose that is given in the frame posed so: `tool_in_base * part_in_tool`.
    ///
    /// `a * b` is the same.
    ///
    /// ```
    /// use jaka_proto::messages::types::Pose;
    ///
    /// // The tool points down; the part is 50 mm in front of it along its z.
    /// let tool = Pose::from_millimetres_degrees([300.0, 0.0, 200.0], [180.0, 0.0, 0.0]);
    /// let part = Pose::from_millimetres_degrees([0.0, 0.0, 50.0], [0.0; 3]);
    /// assert_eq!((tool * part).position_mm().map(f64::round), [300.0, 0.0, 150.0]);
    /// assert!((tool * tool.inverse()).distance_mm(&Pose::from([0.0; 6])) < 1e-9);
    /// ```
    #[must_use]
    pub fn compose(&self, inner: &Self) -> Self {
        let rows = rotation::product(&self.rotation_matrix(), &inner.rotation_matrix());
        Self::from_millimetres_degrees(self.transform_point(inner.position_mm()), rotation::rpy_deg_from_matrix(&rows))
    }

    /// Pose of the outer frame in the frame posed so: `pose * pose.inverse()` is the zero pose.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let rows = rotation::transposed(&self.rotation_matrix());
        let position = rotation::turned(&rows, self.position_mm()).map(|part| 0.0 - part);
        Self::from_millimetres_degrees(position, rotation::rpy_deg_from_matrix(&rows))
    }

    /// Position in this frame, in mm, of a point that is given in the frame posed so.
    #[must_use]
    pub fn transform_point(&self, point_mm: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = rotation::turned(&self.rotation_matrix(), point_mm);
        [self.x + x, self.y + y, self.z + z]
    }

    /// Distance between the positions, in millimetres.
    pub fn distance_mm(&self, other: &Self) -> f64 {
        (self.x - other.x).hypot(self.y - other.y).hypot(self.z - other.z)
    }

    /// The angle in degrees, 0 to 180, of the one turn that takes one orientation to the other.
    ///
    /// ```
    /// use jaka_proto::messages::types::Pose;
    ///
    /// // Different angles, the same orientation.
    /// let pose = Pose::from_millimetres_degrees([0.0; 3], [180.0, 180.0, 180.0]);
    /// let other = Pose::from_millimetres_degrees([0.0; 3], [0.0, 0.0, 360.0]);
    /// assert!(pose.angle_deg(&other) < 1e-9);
    /// ```
    pub fn angle_deg(&self, other: &Self) -> f64 {
        rotation::angle_between(self.quaternion(), other.quaternion()).to_degrees()
    }

    const fn with_rotation_deg(self, rotation: [f64; 3]) -> Self {
        Self::from_millimetres_degrees(self.position_mm(), rotation)
    }
}

/// [`Pose::compose`].
impl std::ops::Mul for Pose {
    type Output = Self;

    fn mul(self, inner: Self) -> Self {
        self.compose(&inner)
    }
}

/// The position x, y, z and the rotation rx, ry, rz with their units; a precision applies to each number.
///
/// ```
/// use jaka_proto::messages::types::Pose;
///
/// let pose = Pose::from_millimetres_degrees([300.0, 0.0, 200.5], [180.0, 0.0, 45.0]);
/// assert_eq!(pose.to_string(), "[300, 0, 200.5] mm, [180, 0, 45] deg");
/// ```
impl fmt::Display for Pose {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_list(&self.position_mm(), f)?;
        f.write_str(" mm, ")?;
        write_list(&self.rotation_deg(), f)?;
        f.write_str(" deg")
    }
}
