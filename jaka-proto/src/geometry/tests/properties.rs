//! Random angles, many of them at gimbal lock or close to it.

use proptest::num::f64::ANY;
use proptest::prelude::*;

use super::{Matrix, apart, product, turn_about, turned};
use crate::geometry::Quaternion;
use crate::messages::types::{JointPosition, Pose};

fn angle() -> impl Strategy<Value = f64> {
    let quarter = (-8..=8_i8).prop_map(|quarters| f64::from(quarters) * 90.0);
    let near = (quarter.clone(), -18..=0_i32).prop_map(|(quarter, power)| quarter + 10_f64.powi(power));
    prop_oneof![2 => -720.0..720.0, 1 => quarter, 1 => near]
}

fn rotation() -> impl Strategy<Value = [f64; 3]> {
    [angle(), angle(), angle()]
}

/// Within two units in the last place.
fn same(one: f64, other: f64) -> bool {
    (one - other).abs() <= 2.0 * f64::EPSILON * one.abs()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    #[test]
    fn the_matrix_is_turns_about_fixed_x_then_y_then_z(angles in rotation()) {
        let [rx, ry, rz] = angles;
        let expected = product(turn_about(2, rz), product(turn_about(1, ry), turn_about(0, rx)));
        prop_assert!(apart(turned(angles).rotation_matrix(), expected) < 1e-13);
    }

    #[test]
    fn matrix_there_and_back(angles in rotation()) {
        let rows = turned(angles).rotation_matrix();
        let back = turned([0.0; 3]).with_rotation_matrix(rows).expect("a rotation");
        prop_assert!(apart(back.rotation_matrix(), rows) < 1e-9, "{:?}", back);
        prop_assert!(in_range(back.rotation_deg()), "{:?}", back);
    }

    /// The product of the test and its own sums are the witness. Near gimbal lock angles keep some 1e-10 rad.
    #[test]
    fn poses_compose_as_their_matrices(
        outer in rotation(),
        inner in rotation(),
        at in [-2e3..2e3, -2e3..2e3, -2e3..2e3],
        from in [-2e3..2e3, -2e3..2e3, -2e3..2e3],
    ) {
        let outer = Pose::from_millimetres_degrees(at, outer);
        let inner = Pose::from_millimetres_degrees(from, inner);
        let both = outer * inner;
        prop_assert!(apart(both.rotation_matrix(), product(outer.rotation_matrix(), inner.rotation_matrix())) < 1e-9);
        let rows = outer.rotation_matrix();
        for axis in 0..3 {
            let expected: f64 = at[axis] + (0..3).map(|part| rows[axis][part] * from[part]).sum::<f64>();
            prop_assert!((both.position_mm()[axis] - expected).abs() < 1e-9);
            prop_assert!((outer.transform_point(from)[axis] - expected).abs() < 1e-9);
        }
        let none = Pose::from([0.0; 6]);
        for closed in [outer * outer.inverse(), outer.inverse() * outer] {
            prop_assert!(closed.distance_mm(&none) < 1e-5 && closed.angle_deg(&none) < 1e-6, "{:?}", closed);
        }
    }

    #[test]
    fn quaternion_there_and_back(angles in rotation(), length in 0.991..1.009, sign in prop_oneof![Just(1.0), Just(-1.0)]) {
        let pose = turned(angles);
        let Quaternion { w, x, y, z } = pose.quaternion();
        prop_assert!(w >= 0.0 && (w * w + x * x + y * y + z * z - 1.0).abs() < 1e-12);
        let [w, x, y, z] = [w, x, y, z].map(|part| part * length * sign);
        let back = pose.with_quaternion(Quaternion { w, x, y, z }).expect("near one");
        prop_assert!(apart(back.rotation_matrix(), pose.rotation_matrix()) < 1e-9, "{:?}", back);
        prop_assert!(in_range(back.rotation_deg()), "{:?}", back);
    }

    #[test]
    fn angles_in_range_come_back(rx in -179.9..179.9, ry in -89.9..89.9, rz in -179.9..179.9) {
        let pose = turned([rx, ry, rz]);
        let back = pose.with_quaternion(pose.quaternion()).expect("a unit quaternion");
        super::assert_near(back.rotation_deg(), [rx, ry, rz]);
    }

    #[test]
    fn the_angle_is_that_of_the_one_turn(one in rotation(), axis in 0..3_usize, degrees in 0.0..180.0) {
        let rows = product(turned(one).rotation_matrix(), turn_about(axis, degrees));
        let other = turned(one).with_rotation_matrix(rows).expect("a rotation");
        prop_assert!((turned(one).angle_deg(&other) - degrees).abs() < 1e-7);
        prop_assert!((other.angle_deg(&turned(one)) - degrees).abs() < 1e-7);
    }

    #[test]
    fn units_there_and_back(numbers in [angle(), angle(), angle(), angle(), angle(), angle()]) {
        let joints = JointPosition::from_radians(JointPosition::from_degrees(numbers).radians());
        prop_assert!(numbers.iter().zip(joints.degrees()).all(|(one, other)| same(*one, other)), "{:?}", joints);
        let pose = Pose::from(numbers);
        let back = <[f64; 6]>::from(Pose::from_metres_radians(pose.position_m(), pose.rotation_rad()));
        prop_assert!(numbers.iter().zip(back).all(|(one, other)| same(*one, other)), "{:?}", back);
    }

    #[test]
    fn no_number_panics(numbers in [ANY; 6], rows in [[ANY; 3], [ANY; 3], [ANY; 3]]) {
        let (pose, joints) = (Pose::from(numbers), JointPosition(numbers));
        let [w, x, y, z, ..] = numbers;
        let accepted = [pose.with_quaternion(Quaternion { w, x, y, z }), pose.with_rotation_matrix(rows)];
        for pose in accepted.into_iter().flatten() {
            prop_assert!(pose.rotation_deg().iter().all(|angle| angle.is_finite()));
        }
        let _ = (pose.position_m(), pose.quaternion(), pose.distance_mm(&pose), pose.angle_deg(&pose));
        let _ = (JointPosition::from_radians(joints.radians()), joints.max_distance(&joints));
        let finite = |rows: Matrix| rows.as_flattened().iter().all(|entry| entry.is_finite());
        prop_assert_eq!(finite(pose.rotation_matrix()), pose.rotation_rad().iter().all(|angle| angle.is_finite()));
    }
}

fn in_range([rx, ry, rz]: [f64; 3]) -> bool {
    [rx, rz].iter().all(|angle| *angle > -180.0 && *angle <= 180.0) && ry.abs() <= 90.0
}
