//! Holes in limits that were found by attack, each shut.

use std::time::Duration;

use jaka_robot::motion::EndMove;
use jaka_robot::types::Pose;
use jaka_robot::{ErrorKind, ServoConfig, Unchecked};
use serde_json::json;

use super::{START, limits, motions, start_pose, turn, wall, with_limits, within};

#[test]
fn the_branch_that_a_controller_names_must_lead_to_the_pose() {
    let pose = start_pose();
    let (arm, mut robot) = with_limits(within(wall("floor", [0.0, 0.0, pose.z - 100.0], [0.0, 0.0, 1.0])));
    arm.set_reply("kine_inverse", [("jointPosition".to_owned(), json!(START))]);
    let low = EndMove::new(Pose { z: pose.z - 150.0, ..pose }, 10.0).acceleration(60.0);
    let error = robot.start(&low).expect_err("below the floor");
    assert!(error.to_string().contains("`floor`"), "{error}");
    assert_eq!(motions(&arm), Vec::<String>::new());
}

#[test]
fn a_set_point_after_a_pause_starts_from_standstill() {
    let (arm, mut robot) = with_limits(limits());
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is enabled");
    let mut at = START;
    // 0.5 deg/s: a faster arm ends its session after such a pause.
    at[0] += 0.5 * 0.008;
    session.send_joints(at).expect("within 72 deg/s²");
    arm.clock().sleep(Duration::from_millis(100));
    at[0] += 1.0 * 0.008;
    let error = session.send_joints(at).expect_err("1 deg/s at once");
    assert!(error.to_string().contains("deg/s²"), "{error}");
}

#[test]
fn a_stop_of_any_handle_is_known_to_a_queue() {
    let (arm, mut robot) = with_limits(limits());
    let stop = robot.client().stop_handle();
    robot.start(&turn(3, 60.0)).expect("to 140 deg");
    stop.stop().expect("the controller takes it");
    let error = robot.start(&turn(3, -300.0)).expect_err("nobody has acknowledged the stop");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    robot.acknowledge();
    let error = robot.start(&turn(3, -300.0)).expect_err("from 140 deg, where the arm is not");
    assert!(matches!(error.kind(), ErrorKind::BeyondLimit { .. }), "{error:?}");
    assert_eq!(motions(&arm).len(), 1);
}

#[test]
fn what_was_acknowledged_away_may_still_begin() {
    let (arm, mut robot) = with_limits(limits());
    robot.start(&turn(3, 60.0)).expect("to 140 deg");
    robot.acknowledge();
    let error = robot.start(&turn(3, 90.0)).expect_err("to 230 deg");
    assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::Start, .. }), "{error:?}");
    assert_eq!(motions(&arm).len(), 1);
}
