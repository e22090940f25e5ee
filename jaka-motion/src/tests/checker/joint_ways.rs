//! Straight paths in joint space.

use super::{ELBOW_UP, PACE, bare, refused, with_region, zu5};
use crate::{Exceeded, JointSpeed, Model, Point, Region, RegionFrame};

#[test]
fn the_end_is_compared_with_the_ranges() {
    let checker = bare(zu5());
    let to = |third: f64| [10.0, 60.0, third, 190.0, -90.0, 5.0].into();
    assert_eq!(checker.check_joint_way(ELBOW_UP.into(), to(175.0), PACE), Ok(()));
    refused(
        &checker.check_joint_way(ELBOW_UP.into(), to(181.2), PACE),
        "joint 3 would be at 181.2 deg; limit 175 (Zu 5)",
    );
}

#[test]
fn a_start_beyond_a_range_may_lead_back_but_not_further_out() {
    let checker = bare(zu5().with_joint_range(1, -90.0, 90.0).expect("tighter"));
    let at = |first: f64| [first, 60.0, -80.0, 190.0, -90.0, 5.0].into();
    for to in [100.0, 99.0, 0.0, -90.0] {
        assert_eq!(checker.check_joint_way(at(100.0), at(to), PACE), Ok(()), "{to}");
    }
    for to in [100.5, -91.0] {
        assert!(checker.check_joint_way(at(100.0), at(to), PACE).is_err(), "{to}");
    }
}

#[test]
fn the_joint_with_the_longest_way_has_the_requested_speed() {
    let mut speeds = [180.0; 6];
    speeds[3] = 30.0;
    let checker = bare(zu5().with_joint_speeds(speeds).expect("tighter"));
    let to = [40.0, 60.0, -80.0, 210.0, -90.0, 5.0].into();
    let asked = |speed_deg_s: f64| JointSpeed { speed_deg_s, acceleration_deg_s2: Some(1.0) };
    assert_eq!(checker.check_joint_way(ELBOW_UP.into(), to, asked(45.0)), Ok(()));
    refused(
        &checker.check_joint_way(ELBOW_UP.into(), to, asked(60.0)),
        "joint 4 would turn at 40 deg/s; limit 30 (Zu 5)",
    );
}

#[test]
fn an_acceleration_must_be_given_and_within() {
    let checker = bare(zu5());
    let to = [40.0, 60.0, -80.0, 210.0, -90.0, 5.0].into();
    let asked = |acceleration_deg_s2: Option<f64>| JointSpeed { speed_deg_s: 20.0, acceleration_deg_s2 };
    assert_eq!(checker.check_joint_way(ELBOW_UP.into(), to, asked(Some(72.0))), Ok(()));
    refused(
        &checker.check_joint_way(ELBOW_UP.into(), to, asked(Some(80.0))),
        "joint 1 would accelerate by 80 deg/s²; limit 72 (Zu 5)",
    );
    refused(
        &checker.check_joint_way(ELBOW_UP.into(), to, asked(None)),
        "no acceleration given; the controller's own is not known; give at most 72 deg/s² (Zu 5)",
    );
    // The joint that accelerates less than another may be the limiting one.
    let mut most = [720.0; 6];
    most[3] = 10.0;
    let checker = bare(zu5().with_joint_accelerations(most).expect("above 0"));
    let found = checker.check_joint_way(ELBOW_UP.into(), to, asked(None)).unwrap_err();
    assert_eq!(found.exceeded, Exceeded::NoAcceleration { most_deg_s2: 15.0 });
}

#[test]
fn the_tool_is_not_faster_than_its_limit() {
    let checker = bare(zu5().with_tcp_speed(250.0).expect("a speed"));
    let from = [0.0, 0.0, 0.0, 0.0, -90.0, 0.0];
    let to = [90.0, 0.0, 0.0, 0.0, -90.0, 0.0].into();
    let asked = |speed_deg_s: f64| JointSpeed { speed_deg_s, acceleration_deg_s2: Some(1.0) };
    let flange = Model::default().forward(from).position_mm();
    let most = (250.0 / flange[0].hypot(flange[1])).to_degrees();
    assert_eq!(checker.check_joint_way(from.into(), to, asked(most - 0.001)), Ok(()));
    let found = checker.check_joint_way(from.into(), to, asked(most * 1.1)).unwrap_err();
    assert_eq!(found.to_string(), "the tool centre point would move at 275 mm/s at 0 % of the path; limit 250 (Zu 5)");
}

/// Both ends are far from the plate, and the elbow goes through it in between.
#[test]
fn a_thin_plate_in_the_way_is_not_passed() {
    let from = [-40.0, 60.0, -80.0, 190.0, -90.0, 5.0];
    let to = [40.0, 60.0, -80.0, 190.0, -90.0, 5.0];
    for thickness in [1.0, 1.5, 10.0] {
        for point in [Point::Tcp, Point::Elbow, Point::Wrist] {
            let plate = Region::outside_box("plate", [-2e3, 0.0, -2e3], [2e3, thickness, 2e3]);
            let limits = with_region(plate.map(|plate| plate.of(point).seen_from(RegionFrame::ArmBase)));
            let found = bare(limits).check_joint_way(from.into(), to.into(), PACE).expect_err("through the plate");
            assert!(matches!(found.exceeded, Exceeded::Region { point: found, .. } if found == point), "{found}");
            assert!(found.share > 0.2 && found.share < 0.8, "{found}");
        }
    }
}

/// Two turns of joint 1 reach the same place.
#[test]
fn a_way_that_ends_where_it_began_is_checked_all_round() {
    let from = [-350.0, 60.0, -80.0, 190.0, -90.0, 5.0];
    let to = [350.0, 60.0, -80.0, 190.0, -90.0, -360.0];
    let behind = Region::outside_box("post", [-700.0, -30.0, 0.0], [-300.0, 30.0, 2e3]);
    let checker = bare(with_region(behind));
    assert_eq!(checker.check_joint_way(from.into(), from.into(), PACE), Ok(()));
    assert!(checker.check_place(from.into()).is_ok() && checker.check_place(to.into()).is_ok());
    assert!(checker.check_joint_way(from.into(), to.into(), PACE).is_err());
}

/// The path cuts a corner by less than a step between samples.
#[test]
fn a_corner_is_grazed_by_a_millimetre_at_most() {
    let (from, to) = ([-30.0, 60.0, -80.0, 190.0, -90.0, 0.0], [30.0, 60.0, -80.0, 190.0, -90.0, 0.0]);
    let tip = Model::default().forward([0.0, 60.0, -80.0, 190.0, -90.0, 0.0]).position_mm();
    let radius = tip[0].hypot(tip[1]);
    // The tool turns about the base: it is furthest out in the direction of the box's nearest corner.
    let corner = |depth: f64| {
        let at = (radius - depth) / 2.0_f64.sqrt();
        let box_ = Region::outside_box("box", [at, at - 400.0 * 0.0, -2e3], [at + 300.0, at + 300.0, 2e3]);
        bare(with_region(box_))
    };
    let turned = |joints: [f64; 6]| {
        let aside = tip[1].atan2(tip[0]).to_degrees();
        let mut joints = joints;
        joints[0] += 45.0 - aside;
        joints.into()
    };
    let found = |depth: f64| corner(depth).check_joint_way(turned(from), turned(to), PACE);
    assert_eq!(found(-0.01), Ok(()));
    assert!(found(1.5).is_err() && found(20.0).is_err());
}
