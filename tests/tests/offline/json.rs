//! Limits, what is beyond them, and trajectories as JSON.

use expect_test::{Expect, expect};
use jaka_motion::{
    Checker, Exceeded, Frames, JointSpeed, Limits, Model, Point, Preset, Region, RegionFrame, TimedPoint, Trajectory,
    Via,
};
use jaka_proto::messages::kinematics::GetDhParamReply;
use jaka_proto::wire::{Fields, Reader};
use serde_json::{json, to_string, to_value};

const START: [f64; 6] = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];

fn check(written: serde_json::Result<String>, expected: &Expect) {
    expected.assert_eq(&written.expect("it is written"));
}

fn arm() -> &'static Model {
    Model::named("Zu 5").expect("a published arm")
}

fn limits() -> Limits {
    let limits = Limits::of(arm()).with_preset(Preset::Usual).with_joint_range(1, -90.0, 80.5);
    let table = Region::half_space("table", [0.0, 0.0, 20.0], [0.0, 0.0, 1.0]).expect("a half-space");
    let camera = Region::outside_box("camera", [300.0, -100.0, 0.0], [500.0, 100.0, 900.0]).expect("a box");
    let camera = camera.of(Point::Elbow).seen_from(RegionFrame::ArmBase);
    let cell = Region::inside_box("cell", [-900.0; 3], [900.0; 3]).expect("a box").of(Point::Wrist);
    let limits = limits.and_then(|limits| limits.with_tcp_speed(250.0)).expect("above 0");
    [camera, cell, table].into_iter().fold(limits, |limits, region| limits.with_region(region).expect("another name"))
}

#[test]
fn limits_are_tables_and_keys_of_a_file() {
    // A line for each key.
    check(
        to_string(&limits()).map(|text| text.replace(",\"", ",\n\"")),
        &expect![[r#"
        {"model":"Zu 5",
        "preset":"usual",
        "joints":{"min_deg":[-90.0,-85.0,-175.0,-85.0,-360.0,-360.0],
        "max_deg":[80.5,265.0,175.0,265.0,360.0,360.0],
        "speed_deg_s":[180.0,180.0,180.0,180.0,180.0,180.0],
        "acceleration_deg_s2":[240.0,240.0,240.0,240.0,240.0,240.0],
        "jerk_deg_s3":[2400.0,2400.0,2400.0,2400.0,2400.0,2400.0]},
        "tcp":{"speed_mm_s":250.0,
        "acceleration_mm_s2":2000.0},
        "stop":{"joint_acceleration_deg_s2":[570.0,570.0,570.0,570.0,570.0,570.0],
        "joint_jerk_deg_s3":[5700.0,5700.0,5700.0,5700.0,5700.0,5700.0],
        "tcp_acceleration_mm_s2":8000.0},
        "singularity":{"least_distance":0.01},
        "box":[{"name":"camera",
        "of":"elbow",
        "frame":"base",
        "keep":"outside",
        "min_mm":[300.0,-100.0,0.0],
        "max_mm":[500.0,100.0,900.0]},{"name":"cell",
        "of":"wrist",
        "frame":"user",
        "keep":"inside",
        "min_mm":[-900.0,-900.0,-900.0],
        "max_mm":[900.0,900.0,900.0]}],
        "half_space":[{"name":"table",
        "of":"tcp",
        "frame":"user",
        "point_mm":[0.0,0.0,20.0],
        "inward":[0.0,0.0,1.0]}]}"#]],
    );
}

#[test]
fn limits_are_read_as_they_were_written() {
    let (alpha, a) = (arm().alpha().map(|alpha| alpha + 0.01), arm().a().map(|a| a - 0.3));
    let (d, home) = (arm().d(), arm().joint_home_offset());
    let dh = format!(r#"{{"alpha":{alpha:?},"a":{a:?},"d":{d:?},"joint_homeoff":{home:?}}}"#);
    let dh = GetDhParamReply::read_fields(&mut Reader::new(&dh)).expect("it is a reply");
    let calibrated = arm().with_dh(&dh).expect("it is near");
    let harder = limits().with_joint_accelerations([500.0; 6]).and_then(|limits| limits.with_joint_jerks([9e3; 6]));
    let stops = limits().with_stop_accelerations([300.0; 6]).and_then(|limits| limits.with_stop_jerks([2e3; 6]));
    for limits in [
        limits(),
        Limits::of(arm()),
        Limits::of(&calibrated),
        limits().without_stop_tcp_acceleration(),
        harder.expect("above 0"),
        stops.and_then(|limits| limits.with_singularity_distance(0.0)).expect("above 0"),
    ] {
        let text = to_string(&limits).expect("it is written");
        assert_eq!(serde_json::from_str::<Limits>(&text).expect("it is read"), limits, "{text}");
    }
}

#[test]
fn keys_that_are_absent_have_the_defaults_of_a_file() {
    let json = json!({
        "model": "zu5",
        "preset": "quick",
        "joints": {"acceleration_deg_s2": [100, 100, 100, 100, 100, 100]},
        "stop": {"joint_acceleration_deg_s2": [400, 400, 400, 400, 400, 400]},
        "half_space": [{"name": "wall", "of": "tcp", "frame": "user", "point_mm": [0, 300, 0], "inward": [0, -2, 1]}],
    });
    let file = "model = 'zu5'\npreset = 'quick'\njoints.acceleration_deg_s2 = 100\nstop.joint_acceleration_deg_s2 = 400\n\
                [[half_space]]\nname = 'wall'\nof = 'tcp'\nframe = 'user'\npoint_mm = [0, 300, 0]\ninward = [0, -2, 1]";
    let read: Limits = serde_json::from_value(json).expect("it is read");
    assert_eq!(read, Limits::from_toml(file, "limits.toml").expect("it is read"));
}

#[test]
fn limits_that_make_no_sense_are_not_read() {
    for (key, value, message) in [
        (
            "model",
            json!("Zu 6"),
            "there is no arm `Zu 6`; the arms are Zu 5, Zu 3, Zu 7, Zu 12, Zu 18, Zu 20, Zu 30, Pro 5, Pro 7, Pro 12, Pro 16, Pro 18, S5, S7, S12, C5, C7, C12, A5, A12, MiniCobo",
        ),
        ("tcp", json!({"speed_mm_s": 0}), "speed of the tool centre point: 0 is not from 0.001 to 1e9"),
        ("tcp", json!({"speed_mms": 1}), "unknown field `speed_mms`, expected `speed_mm_s` or `acceleration_mm_s2`"),
        ("joints", json!({"speed_deg_s": [1, 1, 1]}), "expected a number, or a list of six"),
        (
            "joints",
            json!({"max_deg": [400, 0, 0, 0, 0, 0]}),
            "joint 1: 400 deg is beyond the 360 deg of the Zu 5; a limit can only be tighter",
        ),
        ("singularity", json!({"least_distance": 1}), "distance from a singularity: 1 is not from 0 to below 1"),
        (
            "box",
            json!([{"name": "a", "of": "tcp", "frame": "base", "keep": "outside", "min_mm": [0, 0, 0], "max_mm": [1, 1, 0]}]),
            "box `a`: a side of 0 mm; a side is at least 0 mm, and at least 1 mm if the arm stays outside",
        ),
        ("half_space", json!([{"name": "a", "of": "tcp"}]), "missing field `frame`"),
        (
            "dh",
            json!({"alpha_deg": [9, 0, 0, 0, 0, 0], "a_mm": arm().a(), "d_mm": arm().d(), "joint_home_offset_deg": [0, 0, 0, 0, 0, 0]}),
            "DH parameter alpha of joint 1 is 9 deg; that of the Zu 5 is 0 deg",
        ),
    ] {
        let mut json = json!({"model": "Zu 5"});
        json[key] = value;
        let error = serde_json::from_value::<Limits>(json).expect_err("it makes no sense");
        assert_eq!(error.to_string(), message);
    }
}

#[test]
fn what_is_beyond_a_limit_has_the_names_of_its_fields() {
    let checker = Checker::new(limits(), Frames::new());
    let asked = JointSpeed { speed_deg_s: 20.0, acceleration_deg_s2: Some(30.0) };
    let beyond = checker.check_joint_way(START.into(), [90.0, 60.0, -80.0, 190.0, -90.0, 0.0].into(), asked);
    check(
        to_string(&beyond.unwrap_err()),
        &expect![[
            r#"{"exceeded":{"kind":"joint_range","joint":1,"position_deg":90.0,"limit_deg":80.5},"way":"joint_way","share":1.0,"model":"Zu 5"}"#
        ]],
    );
    let region = Exceeded::Region { name: "cell".into(), point: Point::Wrist, by_mm: 1.5, tolerance_mm: 0.0 };
    check(
        to_string(&region),
        &expect![[r#"{"kind":"region","name":"cell","point":"wrist","by_mm":1.5,"tolerance_mm":0.0}"#]],
    );
    check(to_string(&Exceeded::NotConfirmed), &expect![[r#"{"kind":"not_confirmed"}"#]]);
}

#[test]
fn a_trajectory_is_described() {
    let checker = Checker::new(Limits::of(arm()), Frames::new());
    let aside = [5.0, 60.0, -80.0, 190.0, -90.0, 0.0];
    let points = [TimedPoint::new(0.0, START), TimedPoint::new(1.0, aside), TimedPoint::new(2.5, START)];
    let trajectory = Trajectory::timed(&points, &checker).expect("within limits");
    check(
        to_string(&trajectory),
        &expect![[
            r#"{"model":"Zu 5","duration_s":2.5,"start_deg":[0.0,60.0,-80.0,190.0,-90.0,0.0],"end_deg":[0.0,60.0,-80.0,190.0,-90.0,0.0],"way_points":[{"time_s":0.0,"passing":"stops"},{"time_s":1.0,"passing":"through"},{"time_s":2.5,"passing":"stops"}],"slow_places":[]}"#
        ]],
    );
    check(
        to_string(&trajectory.at(2.5)),
        &expect![[
            r#"{"joints_deg":[0,60,-80,190,-90,0],"velocity_deg_s":[0.0,0.0,0.0,0.0,0.0,0.0],"acceleration_deg_s2":[0.0,0.0,0.0,0.0,0.0,0.0]}"#
        ]],
    );
}

#[test]
fn a_slow_place_has_the_limit_that_allows_no_more() {
    let checker = Checker::new(Limits::of(arm()), Frames::new());
    let vias = [START, [20.0, 60.0, -80.0, 190.0, -90.0, 0.0], [20.0, 60.0, -80.0, 190.0, -80.0, 0.0]].map(Via::joints);
    let trajectory = Trajectory::through(vias).corner_deg(1.0).tcp_speed(250.0).build(&checker).expect("within limits");
    let mut written = to_value(&trajectory).expect("it is written");
    let place = &mut written["slow_places"][0];
    for key in ["time_s", "share"] {
        assert!(place[key].take().is_number(), "{place}");
    }
    assert_eq!(*place, json!({"time_s": null, "share": null, "by": {"kind": "acceleration", "joint": 5}}));
    assert_eq!(written["way_points"][1]["passing"], "rounded");
}

#[test]
fn points_with_times_are_those_of_a_file() {
    let joints = [0.0, 60.0, -80.0, 190.0, -90.0, 0.5];
    let points = [
        TimedPoint::new(0.0, joints).with_velocity([0.0; 6]),
        TimedPoint::new(1.5, joints).with_velocity([1.0; 6]).with_acceleration([2.0; 6]),
    ];
    check(
        to_string(&points),
        &expect![[
            r#"[{"time_s":0.0,"joints_deg":[0,60,-80,190,-90,0.5],"velocity_deg_s":[0.0,0.0,0.0,0.0,0.0,0.0]},{"time_s":1.5,"joints_deg":[0,60,-80,190,-90,0.5],"velocity_deg_s":[1.0,1.0,1.0,1.0,1.0,1.0],"acceleration_deg_s2":[2.0,2.0,2.0,2.0,2.0,2.0]}]"#
        ]],
    );
    let file = json!({"points": [TimedPoint::new(0.0, joints), TimedPoint::new(2.0, joints)]}).to_string();
    let read = TimedPoint::from_json(&file, "way.json").expect("it is read");
    assert_eq!(read, [TimedPoint::new(0.0, joints), TimedPoint::new(2.0, joints)]);
}
