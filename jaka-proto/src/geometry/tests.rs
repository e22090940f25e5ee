//! Every form of an orientation against turns about single axes, every way there and back.

#[cfg(feature = "mint")]
mod mint_conversions;
mod properties;

use super::{NotARotation, Quaternion};
use crate::messages::types::{JointPosition, Pose};

type Matrix = [[f64; 3]; 3];

/// One quarter turn is x to y for z, and so on: what a turn about a single axis is, without the formulas under test.
fn turn_about(axis: usize, degrees: f64) -> Matrix {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut rows = [[0.0; 3]; 3];
    rows[axis][axis] = 1.0;
    (rows[next][next], rows[next][last]) = (cos, -sin);
    (rows[last][next], rows[last][last]) = (sin, cos);
    rows
}

fn product(one: Matrix, other: Matrix) -> Matrix {
    one.map(|row| [0, 1, 2].map(|column| (0..3).map(|inner| row[inner] * other[inner][column]).sum()))
}

/// The largest difference of two entries, infinite if any is NaN.
fn apart(one: Matrix, other: Matrix) -> f64 {
    let differences = one.as_flattened().iter().zip(other.as_flattened()).map(|(one, other)| (one - other).abs());
    differences.fold(0.0, |most: f64, next| if next.is_nan() { f64::INFINITY } else { most.max(next) })
}

fn turned(rotation: [f64; 3]) -> Pose {
    Pose::from_millimetres_degrees([0.0; 3], rotation)
}

#[track_caller]
fn assert_near(found: [f64; 3], expected: [f64; 3]) {
    let near = found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-9);
    assert!(near, "found {found:?}, expected {expected:?}");
}

#[test]
fn the_vendors_example() {
    let pose = Pose::from_metres_radians([0.0; 3], [-1.81826, -0.834_253, -2.30243]);
    // Given to four digits, and too long by 0.003.
    let quaternion = Quaternion { w: 0.0629, x: 0.522_886, y: -0.5592, z: 0.6453 };
    let found = pose.with_quaternion(quaternion).expect("near enough to one");
    assert!(pose.angle_deg(&found) < 0.05, "{found:?}");
}

#[test]
fn units_of_a_pose() {
    let pose = Pose::from_metres_radians([0.5, -0.25, 1.0], [0.0, std::f64::consts::FRAC_PI_2, -std::f64::consts::PI]);
    assert_eq!(pose, [500.0, -250.0, 1000.0, 0.0, 90.0, -180.0].into());
    assert_near(pose.position_mm(), [500.0, -250.0, 1000.0]);
    assert_near(pose.position_m(), [0.5, -0.25, 1.0]);
    assert_near(pose.rotation_deg(), [0.0, 90.0, -180.0]);
    assert_near(pose.rotation_rad(), [0.0, std::f64::consts::FRAC_PI_2, -std::f64::consts::PI]);
    let up = Quaternion { w: 1.0, x: 0.0, y: 0.0, z: 0.0 };
    let moved = Pose::from_metres_quaternion([0.5, -0.25, 1.0], up);
    assert_eq!(moved, Ok([500.0, -250.0, 1000.0, 0.0, 0.0, 0.0].into()));
    assert_eq!(moved, Pose::from_millimetres_quaternion([500.0, -250.0, 1000.0], up));
}

#[test]
fn distances() {
    let near = Pose::from_millimetres_degrees([1.0, 2.0, 3.0], [10.0, 0.0, 0.0]);
    let far = Pose::from_millimetres_degrees([3.0, 5.0, 9.0], [-170.0, 0.0, 0.0]);
    assert!((near.distance_mm(&far) - 7.0).abs() < 1e-12);
    assert!((near.angle_deg(&far) - 180.0).abs() < 1e-9);
    let barely = Pose { rz: 1e-9, ..near };
    assert!((near.angle_deg(&barely) - 1e-9).abs() < 1e-13, "small angles are exact");
}

#[test]
fn distance_of_joints() {
    let one = JointPosition::from_degrees([0.0, 1.0, 2.0, 3.0, 4.0, 179.0]);
    let other = JointPosition::from_degrees([0.5, 1.0, 2.0, 3.0, 4.0, -179.0]);
    assert!((one.max_distance(&other) - 358.0).abs() < f64::EPSILON, "turns count");
    for joint in 0..6 {
        let mut unknown = other;
        unknown.0[joint] = f64::NAN;
        assert!(one.max_distance(&unknown).is_nan(), "joint {joint}");
    }
}

#[test]
fn gimbal_lock_has_one_answer() {
    for (rotation, expected) in [
        ([30.0, 90.0, 50.0], [-20.0, 90.0, 0.0]),
        ([30.0, -90.0, 50.0], [80.0, -90.0, 0.0]),
        ([0.0, 90.0, 180.0], [180.0, 90.0, 0.0]),
    ] {
        let pose = turned(rotation);
        let from_quaternion = pose.with_quaternion(pose.quaternion()).expect("a unit quaternion");
        let from_matrix = pose.with_rotation_matrix(pose.rotation_matrix()).expect("a rotation matrix");
        for found in [from_quaternion, from_matrix] {
            assert!(found.angle_deg(&turned(expected)) < 1e-9, "{rotation:?} gave {found:?}");
            assert!(found.rz == 0.0 && (found.ry - expected[1]).abs() < 1e-6, "{rotation:?} gave {found:?}");
        }
    }
}

#[test]
fn half_turns_are_180_and_zeros_have_no_sign() {
    let pose = turned([0.0; 3]);
    for rows in [
        [[-1.0, -0.0, 0.0], [-0.0, -1.0, 0.0], [-0.0, 0.0, 1.0]],
        [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]],
    ] {
        let found = pose.with_rotation_matrix(rows).expect("half a turn about z").rotation_deg();
        assert_eq!(found.map(f64::to_bits), [0.0, 0.0, 180.0].map(f64::to_bits), "{found:?}");
    }
    let found = pose.with_quaternion(Quaternion { w: -0.5, x: -0.5, y: -0.5, z: -0.5 }).expect("a unit quaternion");
    assert_near(found.rotation_deg(), [90.0, 0.0, 90.0]);
}

#[test]
fn what_is_not_a_rotation() {
    let pose = turned([0.0; 3]);
    for length in [0.0, 0.98, 1.02, 2.0, 1e-200, 1e200, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = pose.with_quaternion(Quaternion { w: 0.0, x: length, y: 0.0, z: 0.0 });
        assert_eq!(refused, Err(NotARotation::Quaternion), "{length}");
    }
    for length in [0.995, 1.005] {
        let found = pose.with_quaternion(Quaternion { w: 0.0, x: 0.0, y: 0.6 * length, z: 0.8 * length });
        let expected = pose.with_quaternion(Quaternion { w: 0.0, x: 0.0, y: 0.6, z: 0.8 });
        assert!(found.expect("near one").angle_deg(&expected.expect("one")) < 1e-6, "{length}");
    }
    for rows in [
        [[0.0; 3]; 3],
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
        [[1.0, 0.0, 0.0], [0.0, 1.02, 0.0], [0.0, 0.0, 1.0]],
        [[1.0, 0.02, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        [[f64::NAN, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[f64::INFINITY; 3]; 3],
    ] {
        assert_eq!(pose.with_rotation_matrix(rows), Err(NotARotation::Matrix), "{rows:?}");
    }
}
