//! Holes in limits that were found by attack, each shut.

use std::time::Duration;

use jaka_robot::motion::{EndMove, JointMove, MoveL};
use jaka_robot::types::Pose;
use jaka_robot::{Cause, ErrorKind, MotionExt as _, Numbering, Robot, SessionConfig, Unchecked};
use jaka_sim::{Fault, State};
use jaka_tests::simulated::{beside, until};
use jaka_tests::{Arm, LONG};
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
    // The limits are the only check where the session makes none.
    for config in [SessionConfig::new(), SessionConfig::new().unchecked()] {
        let (arm, mut robot) = with_limits(limits());
        let mut session = robot.enter_servo_mode(config).expect("the arm is enabled");
        let mut at = START;
        // 0.5 deg/s: a faster arm ends its session after such a pause.
        at[0] += 0.5 * 0.008;
        session.send_joints(at).expect("within 72 deg/s²");
        arm.clock().sleep(Duration::from_millis(100));
        at[0] += 1.0 * 0.008;
        let error = session.send_joints(at).expect_err("1 deg/s at once");
        assert!(error.to_string().contains("deg/s²"), "{error}");
    }
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
fn a_motion_of_any_handle_is_known_to_a_queue() {
    let (arm, mut robot) = with_limits(limits());
    let mut other = robot.client().try_clone().expect("the connection is there");
    robot.start(&turn(3, 20.0)).expect("to 100 deg");
    other.joint_move(&turn(3, 60.0)).expect("to 160 deg");
    let error = robot.start(&turn(3, 60.0)).expect_err("from 100 deg, where the queue does not end");
    assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::Start, .. }), "{error:?}");
    assert_eq!(motions(&arm).len(), 2);
}

/// Packets that show it come later than the answer to one question.
#[test]
fn a_motion_of_any_handle_ends_the_rest_that_a_wait_has_seen() {
    let (arm, mut robot) = with_limits(limits());
    let mut other = robot.client().try_clone().expect("the connection is there");
    robot.run(&turn(3, 10.0), LONG).expect("to 90 deg").reached().expect("it ends there");
    other.joint_move(&turn(3, 80.0)).expect("to 170 deg");
    let error = robot.start(&turn(3, 60.0)).expect_err("from 90 deg, where the arm is not");
    assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::Start, .. }), "{error:?}");
    assert_eq!(motions(&arm).len(), 2);
}

/// It may run or not, and so the queue may end at 140 or at 80 deg.
#[test]
fn a_motion_whose_reply_was_lost_has_no_known_end() {
    let (arm, mut robot) = with_limits(limits());
    robot.start(&turn(3, 60.0)).expect("to 140 deg");
    arm.inject_for("joint_move", Fault::Drop);
    robot.start(&turn(3, -60.0)).expect_err("no reply comes");
    for by in [30.0, 90.0] {
        let error = robot.start(&turn(3, by)).expect_err("its start is not known");
        assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::Start, .. }), "{error:?}");
    }
    assert_eq!(motions(&arm).len(), 2);
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

/// Starts a motion. After 300 ms, which is longer than the questions before it take, the arm `moves`: the motion is not
/// sent.
fn assert_waits_for_late_motion(
    (arm, robot): (&Arm, &mut Robot),
    motion: &JointMove,
    moves: impl FnOnce(&mut State) + Send,
) {
    let sent = motions(arm).len();
    let late = || {
        arm.clock().sleep(Duration::from_millis(300));
        arm.set_state(moves);
    };
    let error = beside(arm.clock(), late, || robot.start(motion)).expect_err("where it begins is not known");
    assert!(!error.may_have_run(), "{error:?}");
    assert_eq!(motions(arm).len(), sent);
}

/// An arm that begins late rests when it is asked at once.
#[test]
fn what_was_acknowledged_away_may_begin_late() {
    let back = JointMove::absolute(START, 30.0).acceleration(60.0);
    for motion in [turn(3, 50.0), back] {
        let (arm, mut robot) = with_limits(limits());
        arm.set_state(|state| state.rapid_rate = 0.0);
        robot.start(&turn(3, 60.0)).expect("to 140 deg");
        robot.acknowledge();
        assert_waits_for_late_motion((&arm, &mut robot), &motion, |state| state.rapid_rate = 1.0);
        until(arm.clock(), || arm.state().at_rest);
        robot.start(&turn(3, -50.0)).expect("from 140 deg it is within");
    }
}

/// A stop that was accepted does not prove that the arm rests.
#[test]
fn an_arm_that_was_stopped_may_move_late() {
    let other_tool: fn(&mut State) = |state| state.tool_frame_id = 2;
    let input_high: fn(&mut State) = |state| state.digital_inputs[0] = true;
    let nothing: fn(&mut State) = |_| ();
    let cases = [(other_tool, Cause::FramesChanged), (input_high, Cause::Guard), (nothing, Cause::Deadline)];
    for (happens, cause) in cases {
        let (arm, mut robot) = with_limits(limits());
        let event = || {
            arm.clock().sleep(Duration::from_millis(300));
            arm.set_state(happens);
        };
        let up = MoveL::relative([0.0, 0.0, 30.0, 0.0, 0.0, 0.0], 20.0).guard(Numbering::FromOne.cabinet(1).is_high());
        let end = beside(arm.clock(), event, || robot.run(&up, Duration::from_secs(1))).expect("it is accepted");
        assert!(end.cause() == cause && matches!(end.stop, Some(Ok(()))), "{end:?}");
        let moves: fn(&mut State) = |state| state.joint_position.0[2] = 140.0;
        assert_waits_for_late_motion((&arm, &mut robot), &turn(3, 50.0), moves);
        // Nothing is left of the motion that was stopped.
        robot.start(&turn(3, -50.0)).expect("from 140 deg it is within");
    }
}
