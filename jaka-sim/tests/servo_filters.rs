//! The filters of servo mode, by what the arm does.

use std::f64::consts::TAU;

use crate::common::servo::{Arm, CYCLE, actual, builder, greatest};
use crate::common::{Peer, assert_accepted, assert_refused, document};
use jaka_sim::State;

/// The first joint of an arm that is told to be 1 deg further, from the moment before.
fn one_degree(filter: &str) -> Vec<f64> {
    let mut arm = Arm::with_filter(builder(), filter);
    let mut places = vec![actual(&arm.controller.state())];
    places.extend(arm.follow([1.0]).iter().map(actual));
    if !arm.controller.state().at_rest {
        places.extend(arm.until_rest().iter().map(actual));
    }
    assert!(places.is_sorted(), "it does not turn back");
    assert!((places.last().expect("there are places") - 1.0).abs() < 1e-9, "it arrives, and goes no further");
    places
}

fn assert_close(value: f64, expected: f64) {
    assert!((value / expected - 1.0).abs() < 1e-6, "{value} is not {expected}");
}

#[test]
fn without_a_filter_the_arm_is_there_in_a_cycle() {
    let places = one_degree(r#""filter_type":0"#);
    assert_eq!(places.len(), 2);
    assert_close(greatest(&places)[0], 125.0);
}

#[test]
fn a_low_pass_goes_the_same_share_of_what_is_left_in_each_cycle() {
    let places = one_degree(r#""filter_type":1,"lpf_cf":2"#);
    let share = 1.0 - (-TAU * 2.0 * CYCLE.as_secs_f64()).exp();
    assert_close(greatest(&places)[0], share / CYCLE.as_secs_f64());
    for pair in places.windows(2).take(50) {
        assert_close(1.0 - pair[1], (1.0 - pair[0]) * (1.0 - share));
    }
}

#[test]
fn limits_of_the_joints_bound_speed_acceleration_and_jerk() {
    let places = one_degree(r#""filter_type":2,"nlf_max_vr":5,"nlf_max_ar":50,"nlf_max_jr":1000"#);
    let [speed, acceleration, jerk] = greatest(&places);
    assert!((4.9..5.000_01).contains(&speed), "{speed}");
    assert!((49.0..50.01).contains(&acceleration), "{acceleration}");
    assert!((990.0..1001.0).contains(&jerk), "{jerk}");
}

#[test]
fn set_points_within_the_limits_pass_as_they_are() {
    let mut arm =
        Arm::with_filter(builder(), r#""filter_type":2,"nlf_max_vr":100,"nlf_max_ar":500,"nlf_max_jr":50000"#);
    let course: Vec<_> = (0..200).map(|n| 10.0 - 10.0 * (f64::from(n) * 0.04).cos()).collect();
    let places: Vec<_> = arm.follow(course.iter().copied()).iter().map(actual).collect();
    for (place, expected) in places.iter().zip(&course) {
        assert!((place - expected).abs() < 1e-9, "{place} is not {expected}");
    }
}

#[test]
fn a_mean_takes_as_many_cycles_as_its_window_has() {
    for filter in [r#""filter_type":3,"mmf_max_buf":20,"mmf_kp":0.1,"mmf_kv":0.2,"mmf_ka":0.6"#, LOOKAHEAD] {
        let places = one_degree(filter);
        assert_close(greatest(&places)[0], 1.0 / 20.0 / CYCLE.as_secs_f64());
        let moving = places.windows(2).filter(|pair| pair[1] - pair[0] > 1e-9).count();
        assert_eq!(moving, 20, "{filter}");
    }
}

const LOOKAHEAD: &str = r#""filter_type":5,"mmf_max_buf":20,"mmf_kp":0.1"#;

const CARTESIAN: &str = r#""filter_type":4,"nlf_max_vr":20,"nlf_max_ar":200,"nlf_max_jr":4000,"nlf_max_vp":30,"nlf_max_ap":300,"nlf_max_jp":6000"#;

fn pose(state: &State) -> [f64; 6] {
    state.tcp_pose.into()
}

/// The poses of an arm that is told to be at one, from the moment before.
fn to_pose(filter: &str, by: [f64; 6]) -> Vec<[f64; 6]> {
    let mut arm = Arm::with_filter(builder(), filter);
    let start = pose(&arm.controller.state());
    let target: [f64; 6] = std::array::from_fn(|i| start[i] + by[i]);
    let request = format!(r#"{{"cmdName":"servo_p","relFlag":0,"catPosition":{target:?},"stepNum":1}}"#);
    assert_accepted(&arm.peer.ask(&request), "servo_p");
    let mut poses = vec![start];
    poses.extend(arm.until_rest().iter().map(pose));
    let last = poses.last().expect("there are poses");
    let turned = |i: usize| (last[i] - target[i] + 540.0).rem_euclid(360.0) - 180.0;
    assert!((0..3).all(|i| (last[i] - target[i]).abs() < 1e-6) && (3..6).all(|i| turned(i).abs() < 1e-6), "{last:?}");
    poses
}

#[test]
fn limits_of_the_tool_bound_its_motion_by_poses_alone() {
    let poses = to_pose(CARTESIAN, [3.0, -2.0, 4.0, 0.0, 0.0, 0.0]);
    let length = |pose: &[f64; 6]| (0..3).map(|i| (pose[i] - poses[0][i]).powi(2)).sum::<f64>().sqrt();
    let [speed, acceleration, jerk] = greatest(&poses.iter().map(length).collect::<Vec<_>>());
    assert!((10.0..30.01).contains(&speed), "{speed}");
    assert!((100.0..300.1).contains(&acceleration), "{acceleration}");
    assert!((2000.0..6010.0).contains(&jerk), "{jerk}");

    let poses = to_pose(CARTESIAN, [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    let turned = |pose: &[f64; 6]| (pose[5] - poses[0][5] + 540.0).rem_euclid(360.0) - 180.0;
    let [speed, acceleration, jerk] = greatest(&poses.iter().map(turned).collect::<Vec<_>>());
    assert!((5.0..20.01).contains(&speed), "{speed}");
    assert!((50.0..200.1).contains(&acceleration), "{acceleration}");
    assert!((1000.0..4010.0).contains(&jerk), "{jerk}");

    assert_eq!(one_degree(CARTESIAN).len(), 2, "joints pass");
}

#[test]
fn filters_of_joints_act_on_poses_too() {
    assert_eq!(to_pose(r#""filter_type":0"#, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]).len(), 2);
    assert_eq!(to_pose(LOOKAHEAD, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]).len(), 21);
}

#[test]
fn a_filter_with_which_no_arm_follows_is_refused() {
    let controller = document().start().expect("loopback has ports");
    let mut peer = Peer::commands(&controller);
    let before = controller.state().servo_filter;
    for filter in [
        r#""filter_type":1,"lpf_cf":0"#,
        r#""filter_type":2,"nlf_max_vr":5,"nlf_max_ar":0,"nlf_max_jr":10"#,
        r#""filter_type":3,"mmf_max_buf":2,"mmf_kp":0.1,"mmf_kv":0.2,"mmf_ka":0.6"#,
        r#""filter_type":5,"mmf_max_buf":2,"mmf_kp":0.1"#,
        &CARTESIAN.replace(r#""nlf_max_jp":6000"#, r#""nlf_max_jp":0"#),
    ] {
        let reply = peer.ask(&format!(r#"{{"cmdName":"set_servo_move_filter",{filter}}}"#));
        assert_refused(&reply, "set_servo_move_filter");
    }
    assert_eq!(controller.state().servo_filter, before);
}

#[test]
fn what_is_left_in_the_filter_is_given_up_with_servo_mode() {
    let mut arm = Arm::with_filter(builder(), LOOKAHEAD);
    arm.follow([1.0]);
    assert_accepted(&arm.peer.ask(r#"{"cmdName":"servo_move","relFlag":0}"#), "servo_move");
    let state = arm.step();
    assert!(state.at_rest && (actual(&state) - 0.05).abs() < 1e-9, "{}", actual(&state));
}
