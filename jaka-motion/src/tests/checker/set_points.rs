//! Set-points of a servo session.

use super::{ELBOW_UP, bare, moved, refused, with_region, zu5};
use crate::{Checker, Exceeded, Limits, Model, Region, Singularity};

const CYCLE: f64 = 0.008;

/// Returns the start, with joint 1 moved by this many degrees.
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

/// Both ends are far enough from the singularity between them. There is no case for the elbow: the pose is also reached
/// with the elbow bent as before, and that solution is nearer.
#[test]
fn a_pose_does_not_leap_over_a_singularity() {
    let model = Model::default();
    let step = |limits: Limits, from: [f64; 6], to: [f64; 6]| {
        bare(limits).check_pose_set_point([from.into(); 2], model.forward(to).into(), 0.1)
    };
    let with = |joint: usize, at: f64| {
        let mut joints = [0.0, 60.0, -80.0, 190.0, -40.0, 0.0];
        joints[joint] = at;
        joints
    };
    let shoulder = |second: &f64| model.singularity_distance(with(1, *second)).shoulder;
    let seconds = (0..1800).map(|step| f64::from(step) * 0.1);
    let above = seconds.min_by(|one, other| shoulder(one).total_cmp(&shoulder(other))).expect("some");
    assert!(shoulder(&above) < 0.001 && shoulder(&(above - 4.0)).min(shoulder(&(above + 4.0))) > 0.01);
    for (which, from, to) in [
        (Singularity::Wrist, with(4, -4.0), with(4, 4.0)),
        (Singularity::Wrist, with(4, 0.7), with(4, -0.7)),
        (Singularity::Shoulder, with(1, above - 4.0), with(1, above + 4.0)),
        (Singularity::Shoulder, with(1, above + 4.0), with(1, above - 4.0)),
    ] {
        let found = step(quick(), from, to).expect_err("over a singularity");
        assert!(matches!(found.exceeded, Exceeded::Singularity { which: passed, .. } if passed == which), "{found}");
        assert_eq!(found.to_string(), format!("the set-point passes the {which} singularity (Zu 5)"));
        assert!(step(quick().with_singularity_distance(0.0).expect("a distance"), from, to).is_ok());
        // Joint positions may pass.
        assert_eq!(bare(quick()).check_set_point([from.into(); 2], to.into(), 0.1), Ok(()));
    }
    // A pose may move away from a singularity to either side.
    for to in [with(4, 2.0), with(4, -2.0)] {
        assert!(step(quick(), with(4, 0.0), to).is_ok());
    }
}

/// Motions have 72 deg/s², stops 570.
#[test]
fn a_joint_may_slow_down_by_the_acceleration_of_stops_and_speed_up_by_that_of_motions() {
    let checker = bare(zu5());
    let at = |speed: f64| turned(speed * CYCLE);
    let set = |before: f64, deg_s2: f64| {
        let target = before + (before + deg_s2 * CYCLE);
        checker.check_set_point([turned(0.0), at(before)], at(target), CYCLE)
    };
    for (before, deg_s2) in [(60.0, 71.9), (60.0, -569.0), (-60.0, 569.0), (1.0, -190.0)] {
        assert_eq!(set(before, deg_s2), Ok(()), "from {before} deg/s by {deg_s2} deg/s²");
    }
    // From 1 deg/s a joint turns round: it gets more than 72 deg/s² from standstill.
    for (before, deg_s2, limit) in [(60.0, 73.0, 72.0), (60.0, -571.0, 570.0), (1.0, -199.0, 72.0), (-1.0, 199.0, 72.0)]
    {
        let found = set(before, deg_s2).expect_err("it is beyond").exceeded;
        let told =
            matches!(found, Exceeded::JointAcceleration { limit_deg_s2, .. } if (limit_deg_s2 - limit).abs() < 1e-9);
        assert!(told, "from {before} deg/s by {deg_s2} deg/s²: {found:?}");
    }
}

/// From 175 deg/s, a stop at 570 deg/s², reached in 0.1 s, takes 0.407 s and 35.6 degrees.
#[test]
fn there_is_room_to_stop() {
    let limits = zu5().with_joint_accelerations([300.0; 6]).expect("above 0");
    let checker = bare(limits.with_joint_range(1, -90.0, 90.0).expect("tighter"));
    let step = 175.0 * CYCLE;
    let at = |first: f64| {
        let mut joints = ELBOW_UP;
        joints[0] = first;
        joints.into()
    };
    let set = |target: f64| checker.check_set_point([at(target - 2.0 * step), at(target - step)], at(target), CYCLE);
    assert_eq!(set(54.38), Ok(()));
    refused(&set(54.5), "the arm could not stop before joint 1 is at 90.1 deg; limit 90 (Zu 5)");
    let back = checker.check_set_point([at(80.0), at(80.0 - step)], at(80.0 - 2.0 * step), CYCLE);
    assert_eq!(back, Ok(()));
}

/// The stop would end well behind a plate.
#[test]
fn landing_stays_in_the_regions() {
    let y = moved(ELBOW_UP, [0.0, 20.0, 0.0]).y;
    let plate = Region::outside_box("plate", [-2e3, y, -2e3], [2e3, y + 2.0, 2e3]).expect("a box");
    let checker = |acceleration: f64| {
        let limits = zu5().with_joint_accelerations([acceleration; 6]).expect("above 0");
        bare(limits.with_region(plate.clone()).expect("the only one"))
    };
    let set = |acceleration: f64| {
        let step = 60.0 * CYCLE;
        checker(acceleration).check_set_point([turned(-2.0 * step), turned(-step)], turned(0.0), CYCLE)
    };
    assert_eq!(set(3000.0), Ok(()));
    let found = set(300.0).expect_err("six degrees are 40 mm");
    assert!(matches!(&found.exceeded, Exceeded::LandingRegion { name, .. } if &**name == "plate"), "{found}");
    assert!(found.to_string().starts_with("the arm could not stop before the tool centre point is "), "{found}");
}

#[test]
fn an_odd_period_is_refused() {
    let checker: Checker = bare(quick());
    for period in [0.0, -CYCLE, f64::NAN, f64::INFINITY] {
        let found = checker.check_set_point([ELBOW_UP.into(); 2], ELBOW_UP.into(), period).unwrap_err();
        assert!(matches!(found.exceeded, Exceeded::Asked { what: "period", .. }), "{found}");
    }
}
