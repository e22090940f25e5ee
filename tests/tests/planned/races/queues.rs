//! Motions that are waited for together: what was so before the first of them, and what changes between two.

use std::time::Duration;

use jaka_robot::motion::{JointMove, MoveL};
use jaka_robot::{Cause, Robot, RobotConfig, ServoConfig};
use jaka_sim::Habit;
use jaka_tests::simulated::{beside, until};
use jaka_tests::{Arm, Configured as _, LONG};

use super::{PERIOD, arm, changes, to};

/// A code of an error in the vendor's table.
const ERROR: &str = "0x0F0034";

/// Lets packets show the state as it is now.
fn show(arm: &Arm) {
    arm.clock().sleep(3 * PERIOD);
}

fn show_error(arm: &Arm) {
    arm.set_state(|state| ERROR.clone_into(&mut state.error_code));
    show(arm);
}

/// Somebody else selects another tool frame.
fn select_another(arm: &Arm) {
    arm.set_state(|state| state.tool_frame_id = 1);
    show(arm);
}

fn start_line(robot: &mut Robot) {
    let down = MoveL::relative([0.0, 0.0, -40.0, 0.0, 0.0, 0.0], 40.0).acceleration(400.0);
    robot.start(&down).expect("it is accepted");
}

fn start_turn(robot: &mut Robot) {
    let turn = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 20.0], 20.0).acceleration(400.0);
    robot.start(&turn).expect("it is accepted");
}

fn selections_and_stops(arm: &Arm) -> Vec<String> {
    changes(arm).into_iter().filter(|name| !["moveL", "joint_move"].contains(&&**name)).collect()
}

/// Joint 1 of an arm that does not move for a second.
fn rests_at(arm: &Arm) -> f64 {
    let angle = arm.state().joint_position.0[0];
    arm.clock().sleep(Duration::from_secs(1));
    let later = arm.state().joint_position.0[0];
    assert!((later - angle).abs() < 1e-9, "the arm has moved from {angle} to {later} deg");
    angle
}

/// The robot knows of no motion before this one, which ends where the arm pauses on its way.
#[test]
fn an_answer_at_the_target_of_a_motion_that_was_sent_to_a_moving_arm_is_not_its_end() {
    let pause = Habit::Pause(Duration::from_millis(200));
    let (arm, mut robot) = arm().controller(|controller| controller.habits([pause])).with_robot();
    for angle in [20.0, 40.0] {
        robot.client().joint_move(&to(angle)).expect("it is accepted");
    }
    show(&arm);
    let end = robot.run(&to(20.0), LONG).expect("it is accepted");
    assert!(end.cause() == Cause::Reached, "{:?}", end.cause());
    assert!((rests_at(&arm) - 20.0).abs() < 1e-6);
}

/// It would begin where the arm pauses, and end elsewhere.
#[test]
fn a_motion_by_an_offset_that_is_sent_in_the_pause_of_a_queue_has_no_known_target() {
    let pause = Habit::Pause(Duration::from_secs(1));
    let (arm, mut robot) = arm().controller(|controller| controller.habits([pause])).with_robot();
    for angle in [20.0, 40.0] {
        robot.start(&to(angle)).expect("it is accepted");
    }
    until(arm.clock(), || arm.state().joint_position.0[0] >= 20.0 - 1e-9);
    show(&arm);
    robot.start(&JointMove::relative([10.0, 0.0, 0.0, 0.0, 0.0, 0.0], 25.0)).expect("it is accepted");
    let end = robot
        .configured(&RobotConfig::new().start_grace(Duration::from_secs(2), 3))
        .expect("it has no limits")
        .wait(LONG);
    assert!(end.cause() == Cause::AtRest, "{:?}", end.cause());
    assert!((rests_at(&arm) - 50.0).abs() < 1e-6);
}

#[test]
fn an_error_that_was_shown_before_the_first_motion_ends_none() {
    let (arm, mut robot) = arm().with_robot();
    show_error(&arm);
    let end = robot.run(&to(20.0), LONG).expect("it is accepted");
    assert!(end.cause() == Cause::Reached, "{:?}", end.cause());
    assert!((rests_at(&arm) - 20.0).abs() < 1e-6);
}

#[test]
fn an_error_that_comes_between_two_motions_ends_both() {
    let (arm, mut robot) = arm().with_robot();
    robot.start(&to(40.0)).expect("it is accepted");
    show_error(&arm);
    robot.start(&to(20.0)).expect("it is accepted");
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::ControllerError, "{:?}", end.cause());
    let angle = arm.state().joint_position.0[0];
    assert!(angle < 5.0, "it is told at once, at {angle} deg");
}

/// Of a queue, each motion goes elsewhere in other frames than those of its start.
#[test]
fn a_frame_that_others_select_ends_a_queue_if_any_motion_depends_on_it() {
    type Start = fn(&mut Robot);
    let cases: [([Start; 2], bool); 4] = [
        ([start_line, start_line], true),
        ([start_line, start_turn], true),
        ([start_turn, start_line], true),
        ([start_turn, start_turn], false),
    ];
    for (number, (starts, is_stopped)) in cases.into_iter().enumerate() {
        for is_between in [true, false] {
            let what = format!("case {number}, between the two: {is_between}");
            let (arm, mut robot) = arm().with_robot();
            arm.set_state(|state| state.tool_frames[1].offset.z = 300.0);
            starts[0](&mut robot);
            if is_between {
                select_another(&arm);
            }
            starts[1](&mut robot);
            if !is_between {
                select_another(&arm);
            }
            let end = robot.wait(LONG);
            assert_eq!(end.cause(), if is_stopped { Cause::FramesChanged } else { Cause::AtRest }, "{what}");
            assert_eq!(selections_and_stops(&arm), vec!["stop_program"; is_stopped.into()], "{what}");
        }
    }
}

/// The motions before and after mean the frames of their time.
#[test]
fn a_frame_that_the_program_selects_between_two_motions_or_after_them_ends_none() {
    for is_between in [true, false] {
        let (arm, mut robot) = arm().with_robot();
        start_line(&mut robot);
        let select = |robot: &mut Robot| robot.client().set_tool_id(1).expect("it is selected");
        if is_between {
            select(&mut robot);
        }
        start_line(&mut robot);
        if !is_between {
            select(&mut robot);
        }
        let end = robot.wait(LONG);
        assert!(end.cause() == Cause::AtRest, "between the two: {is_between}, {:?}", end.cause());
        assert_eq!(selections_and_stops(&arm), ["set_tool_id"]);
    }
}

#[test]
fn a_frame_that_a_clone_selects_after_the_motions_ends_them() {
    let (arm, mut robot) = arm().with_robot();
    let mut other = robot.client().try_clone().expect("the connection is there");
    start_line(&mut robot);
    start_line(&mut robot);
    other.set_tool_id(1).expect("it is selected");
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::FramesChanged, "{:?}", end.cause());
    assert_eq!(selections_and_stops(&arm), ["set_tool_id", "stop_program"]);
}

/// An arm to whose controller `start` has sent motions that were acknowledged away before it began with them, and that
/// pauses between two; its robot.
fn given_up(start: impl FnOnce(&mut Robot)) -> (Arm, Robot) {
    let pause = Habit::Pause(Duration::from_millis(200));
    let (arm, mut robot) = arm().controller(|controller| controller.habits([pause])).with_robot();
    arm.set_state(|state| state.rapid_rate = 0.0);
    start(&mut robot);
    robot.acknowledge();
    (arm, robot)
}

/// Does something while the arm begins with its motions, later than two questions take.
fn beside_late_begin<T>(arm: &Arm, act: impl FnOnce() -> T) -> T {
    let begins = || {
        arm.clock().sleep(Duration::from_millis(300));
        arm.set_state(|state| state.rapid_rate = 1.0);
    };
    beside(arm.clock(), begins, act)
}

#[test]
fn an_answer_at_the_target_of_a_motion_after_some_that_were_given_up_is_not_its_end() {
    let absolute = to(20.0);
    let relative = JointMove::relative([10.0, 0.0, 0.0, 0.0, 0.0, 0.0], 25.0).acceleration(500.0);
    for (before, motion, rest) in [([to(20.0), to(40.0)], absolute, 20.0), ([relative, relative], relative, 30.0)] {
        let (arm, mut robot) =
            given_up(|robot| before.iter().for_each(|motion| robot.start(motion).expect("it is accepted")));
        let end = beside_late_begin(&arm, || robot.run(&motion, LONG)).expect("it is accepted");
        end.at_rest().expect("nothing stops it");
        assert!((rests_at(&arm) - rest).abs() < 1e-6, "{motion:?}");
        // Nothing is left of them, and so the next motion has ended once one answer says so: after 400 ms.
        let end = robot.run(&to(rest - 10.0), LONG).expect("it is accepted");
        assert!(end.cause() == Cause::Reached, "{:?}", end.cause());
        assert!(end.report.waited < Duration::from_millis(600), "{:?}", end.report.waited);
    }
}

#[test]
fn servo_mode_is_not_entered_before_motions_that_were_given_up_begin() {
    let (arm, mut robot) = given_up(|robot| robot.start(&to(20.0)).expect("it is accepted"));
    let entered = beside_late_begin(&arm, || {
        robot.enter_servo_mode(ServoConfig::new()).map(|session| {
            let angle = arm.state().joint_position.0[0];
            drop(session);
            angle
        })
    });
    // Either it waits for their end, or it is not entered.
    assert!(entered.as_ref().map_or(true, |angle| (angle - 20.0).abs() < 1e-6), "{entered:?}");
}

/// No motion of before, nor one of a client, is left when set-points begin.
#[test]
fn servo_mode_is_not_asked_for_in_the_pause_of_a_queue_and_not_while_the_arm_moves() {
    type Start = fn(&mut Robot, &JointMove);
    let starts: [(Start, f64); 2] = [
        (|robot, motion| robot.start(motion).expect("it is accepted"), 20.0),
        (|robot, motion| robot.client().joint_move(motion).expect("it is accepted"), 10.0),
    ];
    for (start, angle) in starts {
        let pause = Habit::Pause(Duration::from_secs(1));
        let (arm, mut robot) = arm().controller(|controller| controller.habits([pause])).with_robot();
        for angle in [20.0, 40.0] {
            start(&mut robot, &to(angle));
        }
        until(arm.clock(), || arm.state().joint_position.0[0] >= angle - 1e-9);
        let config = ServoConfig::new().enter_timeout(Duration::from_millis(300));
        let error = robot.enter_servo_mode(config).expect_err("motions are left");
        assert!(error.cause() == Cause::Moving && !error.may_have_run(), "{error:?}");
        assert_eq!(changes(&arm), ["joint_move"; 2]);
    }
}
