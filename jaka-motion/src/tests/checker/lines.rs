//! Lines.

use jaka_proto::messages::types::Pose;

use super::{ELBOW_UP, SLOW, bare, moved, refused, with_region, zu5};
use crate::{Checker, Exceeded, Frames, Model, Point, Region, RegionFrame, Singularity, TcpSpeed, Transform};

#[test]
fn the_joints_at_the_end_reach_the_pose() {
    let (model, to) = (Model::default(), moved(ELBOW_UP, [-100.0, 50.0, -80.0]));
    let end = bare(zu5()).check_line(ELBOW_UP.into(), to, SLOW).expect("within all limits");
    assert!(model.forward(end).distance_mm(&to.into()) < 1e-6);
    assert!(end.max_distance(&model.inverse(to, ELBOW_UP).expect("reachable")) < 1e-6);
}

#[test]
fn a_line_to_where_it_starts_stays_there() {
    let checker = bare(zu5());
    let here = moved(ELBOW_UP, [0.0; 3]);
    let end = checker.check_line(ELBOW_UP.into(), here, SLOW).expect("nothing moves");
    assert!(end.max_distance(&ELBOW_UP.into()) < 1e-6);
}

#[test]
fn what_is_out_of_reach_is_refused_by_millimetres() {
    let checker = bare(zu5());
    let from = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];
    let far = |x: f64| Pose { x, ..moved(from, [0.0; 3]) };
    let at = |by_mm: f64| {
        let found = checker.check_line(from.into(), far(900.0 + by_mm), SLOW).unwrap_err();
        match found.exceeded {
            Exceeded::OutOfReach { by_mm } => by_mm,
            _ => panic!("{found}"),
        }
    };
    let further = at(300.0) - at(200.0);
    assert!(at(200.0) > 50.0 && further > 50.0 && further < 100.0, "{further}");
    let words = checker.check_line(from.into(), far(1200.0), SLOW).unwrap_err().to_string();
    assert!(words.starts_with("out of reach by ") && words.ends_with(" mm (Zu 5)"), "{words}");
}

/// Both ends are in reach, and the path between them is too near to the axis of joint 1.
#[test]
fn a_line_through_the_base_axis_is_out_of_reach_on_the_way() {
    let from = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];
    let start = moved(from, [0.0; 3]);
    let across = Pose { x: -start.x, y: -start.y, ..start };
    let found = bare(zu5().with_singularity_distance(0.0).expect("a distance"))
        .check_line(from.into(), across, SLOW)
        .unwrap_err();
    assert!(found.share > 0.2 && found.share < 0.8, "{found}");
    let slow = TcpSpeed { speed_mm_s: 0.001, ..SLOW };
    let found = bare(zu5().with_singularity_distance(0.0).expect("a distance"))
        .check_line(from.into(), across, slow)
        .unwrap_err();
    assert!(matches!(found.exceeded, Exceeded::OutOfReach { by_mm } if by_mm > 10.0), "{found:?}");
}

/// Joint 5 goes through zero, where the axes of joints 4 and 6 are in line.
#[test]
fn a_line_through_a_singularity_names_it() {
    let model = Model::default();
    let (from, to) = ([0.0, 60.0, -80.0, 190.0, -20.0, 0.0], [5.0, 60.0, -75.0, 190.0, 20.0, 0.0]);
    let asked = TcpSpeed { speed_mm_s: 0.5, ..SLOW };
    let found = bare(zu5()).check_line(from.into(), model.forward(to).into(), asked).unwrap_err();
    assert!(matches!(found.exceeded, Exceeded::Singularity { which: Singularity::Wrist, .. }), "{found}");
    let words = format!("the line passes the wrist singularity at {:.0} % of its path (Zu 5)", found.share * 100.0);
    assert_eq!(found.to_string(), words);
    // The joints may go there on a straight path.
    let asked = super::PACE;
    assert_eq!(bare(zu5()).check_joint_way(from.into(), to.into(), asked), Ok(()));
}

#[test]
fn joints_are_too_fast_near_a_singularity() {
    let from = [0.0, 60.0, -80.0, 190.0, -4.0, 0.0];
    let checker = bare(zu5());
    let found = [[30.0, 0.0, 0.0], [0.0, 30.0, 0.0], [0.0, 0.0, 30.0]].into_iter().filter_map(|turn| {
        let by = Pose::from_millimetres_degrees([0.0, 0.0, 60.0], turn);
        let to = Model::default().forward(from).displaced(&by.into()).into();
        checker.check_line(from.into(), to, TcpSpeed { speed_mm_s: 250.0, ..SLOW }).err()
    });
    let near = |exceeded: &Exceeded| matches!(exceeded, Exceeded::JointSpeed { near: Some(Singularity::Wrist), .. });
    let found = found.filter(|found| near(&found.exceeded)).map(|found| found.to_string()).collect::<Vec<_>>();
    assert!(!found.is_empty());
    for words in found {
        assert!(words.ends_with(" % of the line, near the wrist singularity; limit 180 (Zu 5)"), "{words}");
    }
}

#[test]
fn the_tool_is_not_faster_than_its_limit() {
    let checker = bare(zu5().with_tcp_speed(49.0).expect("a speed"));
    refused(
        &checker.check_line(ELBOW_UP.into(), moved(ELBOW_UP, [0.0, 0.0, 50.0]), SLOW),
        "the tool centre point would move at 50 mm/s; limit 49 (Zu 5)",
    );
}

#[test]
fn a_joint_that_leaves_its_range_on_the_way_is_named() {
    let end = Model::default().inverse(moved(ELBOW_UP, [0.0, -300.0, 0.0]), ELBOW_UP).expect("reachable").0;
    let middle = f64::midpoint(ELBOW_UP[0], end[0]);
    let checker = bare(zu5().with_joint_range(1, middle, 90.0).expect("tighter"));
    let found = checker.check_line(ELBOW_UP.into(), moved(ELBOW_UP, [0.0, -300.0, 0.0]), SLOW).unwrap_err();
    assert!(matches!(found.exceeded, Exceeded::JointRange { joint: 1, .. }), "{found}");
    assert!(found.share > 0.3 && found.share < 0.7, "{found}");
}

/// The speed of a tool that turns in place is not known: joint speeds are not checked, and all the rest is.
#[test]
fn a_line_that_only_turns_is_checked_but_for_joint_speeds() {
    let model = Model::default();
    let turned = |joints: [f64; 6], deg: f64| {
        model.forward(joints) * Transform::from(Pose::from_millimetres_degrees([0.0; 3], [0.0, 0.0, deg]))
    };
    let fast = TcpSpeed { speed_mm_s: 1e6, ..SLOW };
    let checker = bare(zu5());
    let end = checker.check_line(ELBOW_UP.into(), turned(ELBOW_UP, 170.0).into(), fast).expect("only joint 6 turns");
    assert!((end.0[5] - 175.0).abs() < 1e-6, "{end:?}");
    let tight = bare(zu5().with_joint_range(6, -90.0, 90.0).expect("tighter"));
    let found = tight.check_line(ELBOW_UP.into(), turned(ELBOW_UP, 170.0).into(), fast).unwrap_err();
    assert!(matches!(found.exceeded, Exceeded::JointRange { joint: 6, .. }), "{found}");
    refused(
        &checker.check_line(ELBOW_UP.into(), turned(ELBOW_UP, 180.0).into(), SLOW),
        "the tool would turn by 180 deg, and the direction is not known (Zu 5)",
    );
}

#[test]
fn a_box_is_smaller_by_the_tolerance() {
    let wall = moved(ELBOW_UP, [0.0, 0.0, 100.0]).z;
    let checker = bare(with_region(Region::half_space("ceiling", [0.0, 0.0, wall], [0.0, 0.0, -1.0])));
    let line = |up: f64, tolerance_mm: f64| {
        checker.check_line(ELBOW_UP.into(), moved(ELBOW_UP, [0.0, 0.0, up]), TcpSpeed { tolerance_mm, ..SLOW })
    };
    assert!(line(99.9, 0.0).is_ok() && line(89.9, 10.0).is_ok());
    refused(
        &line(99.0, 10.0),
        "the tool centre point would be 9 mm beyond `ceiling`, including 10 mm of blending (Zu 5)",
    );
}

/// The start is within the region, and blending may move the arm out of it at once.
#[test]
fn a_start_nearer_to_a_border_than_the_tolerance_is_refused() {
    let floor = moved(ELBOW_UP, [0.0, 0.0, -5.0]).z;
    let checker = bare(with_region(Region::half_space("floor", [0.0, 0.0, floor], [0.0, 0.0, 1.0])));
    let line = |by: [f64; 3], tolerance_mm: f64| {
        checker.check_line(ELBOW_UP.into(), moved(ELBOW_UP, by), TcpSpeed { tolerance_mm, ..SLOW })
    };
    let along = [0.0, 50.0, 0.0];
    assert!(line(along, 0.0).is_ok() && line(along, 4.9).is_ok());
    refused(
        &line(along, 20.0),
        "the tool centre point would be 15 mm beyond `floor` at 0 % of its path, including 20 mm of blending (Zu 5)",
    );
    assert!(line([0.0, 0.0, 10.0], 20.0).is_err());
}

/// Such a long tolerance swamps the lengths that it is added to.
#[test]
fn a_tolerance_longer_than_the_arm_is_refused() {
    let floor = moved(ELBOW_UP, [0.0, 0.0, -50.0]).z;
    let region = Region::half_space("floor", [0.0, 0.0, floor], [0.0, 0.0, 1.0]).expect("a region");
    let reach = Model::default().reach_mm();
    let tool = Frames::new().with_tool(Pose::from_millimetres_degrees([0.0, 300.0, 400.0], [0.0; 3]));
    for (frames, longest) in [(Frames::new(), reach), (tool, reach + 500.0)] {
        let from = frames.pose(Model::default().forward(ELBOW_UP));
        for limits in [zu5(), zu5().with_region(region.clone()).expect("the only one")] {
            let (anywhere, checker) = (limits.regions().is_empty(), Checker::new(limits, frames));
            for (tolerance_mm, is_one) in [(longest - 0.1, true), (longest + 0.1, false), (1e19, false), (1e300, false)]
            {
                let to = Pose { z: from.z - 30.0, ..from };
                let found = checker.check_line(ELBOW_UP.into(), to, TcpSpeed { tolerance_mm, ..SLOW });
                let asked = matches!(&found, Err(beyond) if matches!(beyond.exceeded, Exceeded::Asked { what: "tolerance", .. }));
                assert_eq!((asked, found.is_ok()), (!is_one, is_one && anywhere), "{tolerance_mm}: {found:?}");
            }
        }
    }
}

/// The tool starts under the table and may come back up, at a slant too, but not go deeper.
#[test]
fn a_start_beyond_a_region_may_lead_back_but_not_further_out() {
    let start = moved(ELBOW_UP, [0.0; 3]).z;
    let checker = bare(with_region(Region::half_space("table", [0.0, 0.0, start + 30.0], [0.0, 0.0, 1.0])));
    let line = |by: [f64; 3]| checker.check_line(ELBOW_UP.into(), moved(ELBOW_UP, by), SLOW);
    assert!(line([0.0, 0.0, 50.0]).is_ok() && line([50.0, 0.0, 10.0]).is_ok() && line([50.0, 0.0, 0.0]).is_ok());
    refused(&line([0.0, 0.0, -1.5]), "the tool centre point would be 31.5 mm beyond `table` (Zu 5)");
}

#[test]
fn a_thin_plate_in_the_way_is_not_passed() {
    for thickness in [1.0, 1.5, 10.0] {
        let x = moved(ELBOW_UP, [-150.0, 0.0, 0.0]).x;
        let plate = Region::outside_box("plate", [x, -2e3, -2e3], [x + thickness, 2e3, 2e3]);
        let line = |region: Region, by: f64| {
            bare(with_region(Ok(region))).check_line(ELBOW_UP.into(), moved(ELBOW_UP, [by, 0.0, 0.0]), SLOW)
        };
        let plate = plate.expect("a region");
        let found = line(plate.clone(), -200.0).expect_err("through the plate");
        assert!((found.share - 0.75).abs() < 0.06, "{found}");
        assert!(line(plate, -149.9 + thickness).is_ok());
        // The wrist is where the flange is, along the flange's axis.
        let wrist = Model::default().joint_frames(ELBOW_UP)[4].position_mm()[0] - 150.0;
        let plate = Region::outside_box("plate", [wrist, -2e3, -2e3], [wrist + thickness, 2e3, 2e3]);
        let plate = plate.expect("a region").of(Point::Wrist).seen_from(RegionFrame::ArmBase);
        let found = line(plate, -200.0).expect_err("through the plate");
        assert!((found.share - 0.75).abs() < 0.06, "{found}");
    }
}

/// A line that is given with a tool and in a user frame ends at the same pose.
#[test]
fn frames_are_taken_off() {
    let model = Model::default();
    let tool = Pose::from_millimetres_degrees([0.0, 50.0, 100.0], [30.0, 0.0, 0.0]);
    let user = Pose::from_millimetres_degrees([100.0, 200.0, 300.0], [0.0, 0.0, 90.0]);
    let frames = Frames::new().with_tool(tool).with_user_frame(user);
    let goal = moved(ELBOW_UP, [30.0, 40.0, 50.0]);
    let end =
        Checker::new(zu5(), frames).check_line(ELBOW_UP.into(), frames.pose(goal), SLOW).expect("within all limits");
    assert!(model.forward(end).distance_mm(&goal.into()) < 1e-6);
}
