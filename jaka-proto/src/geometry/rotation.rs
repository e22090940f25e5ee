//! The three forms of a rotation: roll, pitch and yaw, matrix, quaternion.

/// An orientation as a quaternion, `w + xi + yj + zk`; a unit quaternion if it comes from a pose.
///
/// There is no conversion from an array on purpose: some libraries put `w` first, others last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quaternion {
    /// Scalar part: the cosine of half the angle.
    pub w: f64,
    /// The axis' x times the sine of half the angle.
    pub x: f64,
    /// The axis' y times the sine of half the angle.
    pub y: f64,
    /// The axis' z times the sine of half the angle.
    pub z: f64,
}

crate::worded! {
    /// A quaternion or matrix that is not a rotation.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum NotARotation {
        /// The quaternion's length is not near one.
        Quaternion => "the quaternion is not a rotation: its length is not near one",
        /// The matrix mirrors, or its rows are not nearly of length one and at right angles.
        Matrix => "the matrix is not a rotation: its rows are not near a right-handed set of unit vectors",
    }
}

impl std::error::Error for NotARotation {}

/// Tolerance for a length that should be one, and for the product of two rows that should be zero. The quaternion of
/// the vendor's own example is 0.003 too long.
const TOLERANCE: f64 = 0.01;

/// Bound of the gimbal lock: `rz` is zero for a smaller cosine of `ry`, as in the simulator.
const LOCKED: f64 = 1e-10;

type Matrix = [[f64; 3]; 3];

pub(super) fn matrix_from_rpy(rpy: [f64; 3]) -> Matrix {
    let [(sx, cx), (sy, cy), (sz, cz)] = rpy.map(f64::sin_cos);
    [
        [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
        [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
        [-sy, cy * sx, cy * cx],
    ]
}

pub(super) fn quaternion_from_rpy(rpy: [f64; 3]) -> Quaternion {
    let [(sx, cx), (sy, cy), (sz, cz)] = rpy.map(|angle| (angle / 2.0).sin_cos());
    let w = cx * cy * cz + sx * sy * sz;
    let sign = if w < 0.0 { -1.0 } else { 1.0 };
    Quaternion {
        w: sign * w,
        x: sign * (sx * cy * cz - cx * sy * sz),
        y: sign * (cx * sy * cz + sx * cy * sz),
        z: sign * (cx * cy * sz - sx * sy * cz),
    }
}

pub(super) fn matrix_from_quaternion(quaternion: Quaternion) -> Result<Matrix, NotARotation> {
    let Quaternion { w, x, y, z } = quaternion;
    let length = (w * w + x * x + y * y + z * z).sqrt();
    if !near(length, 1.0) {
        return Err(NotARotation::Quaternion);
    }
    let [w, x, y, z] = [w, x, y, z].map(|part| part / length);
    Ok([
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ])
}

pub(super) fn check_matrix(rows: &Matrix) -> Result<(), NotARotation> {
    let [first, second, third] = rows;
    let unit = rows.iter().all(|row| near(dot(row, row), 1.0));
    let square = near(dot(first, second), 0.0) && near(dot(second, third), 0.0) && near(dot(third, first), 0.0);
    let right_handed = dot(&cross(first, second), third) > 0.0;
    if unit && square && right_handed { Ok(()) } else { Err(NotARotation::Matrix) }
}

/// Roll, pitch and yaw in degrees. `rx` is read off after `rz` is undone, so that the rotation survives near gimbal
/// lock too.
pub(super) fn rpy_deg_from_matrix(rows: &Matrix) -> [f64; 3] {
    let [[x_x, y_x, z_x], [x_y, y_y, z_y], [x_z, ..]] = rows;
    let level = x_x.hypot(*x_y);
    let rz = if level < LOCKED { 0.0 } else { x_y.atan2(*x_x) };
    let ry = (-x_z).atan2(level);
    let (sin, cos) = rz.sin_cos();
    let rx = (sin * z_x - cos * z_y).atan2(cos * y_y - sin * y_x);
    // Adding zero turns -0 into 0.
    [rx, ry, rz].map(f64::to_degrees).map(|angle| if angle <= -180.0 { 180.0 } else { angle + 0.0 })
}

/// Product of two matrices.
pub(super) fn product(one: &Matrix, other: &Matrix) -> Matrix {
    let columns = transposed(other);
    one.map(|row| columns.map(|column| dot(&row, &column)))
}

pub(super) fn transposed(rows: &Matrix) -> Matrix {
    [0, 1, 2].map(|column| rows.map(|row| row[column]))
}

/// Vector turned by a rotation.
pub(super) fn turned(rows: &Matrix, vector: [f64; 3]) -> [f64; 3] {
    rows.map(|row| dot(&row, &vector))
}

/// The angle in radians, 0 to pi, between the orientations of two unit quaternions; exact also for small angles.
pub(super) fn angle_between(one: Quaternion, other: Quaternion) -> f64 {
    let (one, other) = ([one.w, one.x, one.y, one.z], [other.w, other.x, other.y, other.z]);
    let length = |sign: f64| one.iter().zip(other).map(|(a, b)| (a + sign * b).powi(2)).sum::<f64>().sqrt();
    // Two quaternions represent an orientation: this takes the nearer one.
    let (apart, together) = (length(-1.0), length(1.0));
    4.0 * apart.min(together).atan2(apart.max(together))
}

/// False for NaN.
fn near(value: f64, wanted: f64) -> bool {
    (value - wanted).abs() <= TOLERANCE
}

fn dot(one: &[f64; 3], other: &[f64; 3]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

fn cross(one: &[f64; 3], other: &[f64; 3]) -> [f64; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(next, last)| one[next] * other[last] - one[last] * other[next])
}
