//! Set-points of a servo session.

use super::{ELBOW_UP, bare, moved, refused, with_region, zu5};
use crate::{Checker, Exceeded, Limits, Model, Region, Singularity};

const CYCLE: f64 = 0.008;

/// The start, with joint 1 moved by so many degrees.
fn turned(by: f64) -> jaka_proto::messages::types::JointPosition {
    let mut joints = ELBOW_UP;
    joints[0] += by;
    joints.into()
}

fn quick() -> Limits {
    zu5().with_joint_accelerations([1e9; 6]).expect("above 0")
}

#[test]
fn a_step_is_not_faster_than_a_joint() {
    let checker = bare(quick());
    let step = |by: f64| checker.check_set_point([ELBOW_UP.into(); 2], turned(by), CYCLE);
    assert_eq!(step(180.0 * CYCLE), Ok(()));
    refused(&step(1.6), "joint 1 would turn at 200 deg/s; limit 180 (Zu 5)");
}

#[test]
fn the_change_of_speed_is_bounded() {
    let checker = bare(zu5());
    let per_cycle = 72.0 * CYCLE * CYCLE;
    let at_rest = [ELBOW_UP.into(); 2];
    assert_eq!(checker.check_set_point(at_rest, turned(per_cycle), CYCLE), Ok(()));
    refused(
        &checker.check_set_point(at_rest, turned(0.016), CYCLE),
        "joint 1 would accelerate by 250 deg/s²; limit 72 (Zu 5)",
    );
    // A stop from speed is a change too.
    let moving = [turned(-0.1), turned(0.0)];
    assert_eq!(checker.check_set_point(moving, turned(0.1), CYCLE), Ok(()));
    assert!(checker.check_set_point(moving, turned(0.0), CYCLE).is_err());
}

#[test]
fn three_hundred_millimetres_in_one_set_point_are_refused() {
    let checker = bare(quick());
    let found = checker.check_pose_set_point([ELBOW_UP.into(); 2], moved(ELBOW_UP, [0.0, 300.0, 0.0]), CYCLE);
    assert!(matches!(found.as_ref().unwrap_err().exceeded, Exceeded::JointSpeed { .. }), "{found:?}");
    let near = moved(ELBOW_UP, [0.0, 3.0, 0.0]);
    let joints = checker.check_pose_set_point([ELBOW_UP.into(); 2], near, CYCLE).expect("within all limits");
    assert!(Model::default().forward(joints).distance_mm(&near.into()) < 1e-6);
    let checker = bare(quick().with_tcp_speed(300.0).expect("a speed"));
    refused(
        &checker.check_pose_set_point([ELBOW_UP.into(); 2], near, CYCLE).map(|_| ()),
        "the tool centre point would move at 375 mm/s; limit 300 (Zu 5)",
    );
}

#[test]
fn ranges_and_regions_hold_and_lead_back() {
    let wall = moved(ELBOW_UP, [0.0, 0.5, 0.0]).y;
    let limits = with_region(Region::half_space("wall", [0.0, wall, 0.0], [0.0, -1.0, 0.0]));
    let checker = bare(limits.with_joint_accelerations([1e9; 6]).expect("above 0"));
    let set =
        |from: [f64; 6], y: f64| checker.check_pose_set_point([from.into(); 2], moved(from, [0.0, y, 0.0]), CYCLE);
    assert!(set(ELBOW_UP, 0.4).is_ok());
    assert!(matches!(set(ELBOW_UP, 2.0).unwrap_err().exceeded, Exceeded::Region { .. }));
    let beyond = Model::default().inverse(moved(ELBOW_UP, [0.0, 2.0, 0.0]), ELBOW_UP).expect("reachable").0;
    assert!(set(beyond, -1.0).is_ok() && set(beyond, 0.0).is_ok() && set(beyond, 0.1).is_err());
    let checker = bare(quick().with_joint_range(1, -90.0, 10.5).expect("tighter"));
    let step = |from: f64, by: f64| checker.check_set_point([turned(from); 2], turned(by), CYCLE);
    assert!(step(0.0, 0.5).is_ok() && step(2.0, 1.9).is_ok() && step(2.0, 2.0).is_ok() && step(2.0, 2.1).is_err());
    refused(&step(0.0, 0.75), "joint 1 would be at 10.8 deg; limit 10.5 (Zu 5)");
}

/// A plate thinner than the step.
#[test]
fn a_step_does_not_leap_over_a_plate() {
    let y = moved(ELBOW_UP, [0.0, 4.0, 0.0]).y;
    let limits = with_region(Region::outside_box("plate", [-2e3, y, -2e3], [2e3, y + 1.0, 2e3]));
    let checker = bare(limits.with_joint_accelerations([1e9; 6]).expect("above 0"));
    let found = checker.check_pose_set_point([ELBOW_UP.into(); 2], moved(ELBOW_UP, [0.0, 9.0, 0.0]), CYCLE);
    assert!(matches!(found.unwrap_err().exceeded, Exceeded::Region { .. }));
}

#[test]
fn a_pose_keeps_its_distance_from_singularities() {
    let from = [0.0, 60.0, -80.0, 190.0, -0.7, 0.0];
    let target = |fifth: f64| {
        let mut joints = from;
        joints[4] = fifth;
        Model::default().forward(joints).into()
    };
    let checker = bare(quick());
    assert!(checker.check_pose_set_point([from.into(); 2], target(-0.6), CYCLE).is_ok());
    let found = checker.check_pose_set_point([from.into(); 2], target(-0.5), CYCLE).unwrap_err();
    assert!(matches!(found.exceeded, Exceeded::Singularity { which: Singularity::Wrist, .. }), "{found}");
    // Joint positions may go there.
    let mut joints = from;
    joints[4] = -0.5;
    assert_eq!(checker.check_set_point([from.into(); 2], joints.into(), CYCLE), Ok(()));
}

#[test]
fn an_odd_period_is_refused() {
    let checker: Checker = bare(quick());
    for period in [0.0, -CYCLE, f64::NAN, f64::INFINITY] {
        let found = checker.check_set_point([ELBOW_UP.into(); 2], ELBOW_UP.into(), period).unwrap_err();
        assert!(matches!(found.exceeded, Exceeded::Pace { what: "period", .. }), "{found}");
    }
}
