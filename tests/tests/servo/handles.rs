//! Other handles of a connection, while a session, a stream or a trajectory leads the arm and otherwise.

use std::time::Duration;

use jaka_proto::Command;
use jaka_robot::io::{DigitalOutputKind, SetDigitalOutput};
use jaka_robot::motion::JointMove;
use jaka_robot::power::{DisableRobot, PowerOff};
use jaka_robot::program::StopProgram;
use jaka_robot::status::RobotStatus;
use jaka_robot::types::Switch;
use jaka_robot::{
    Client, ErrorKind, FollowConfig, Robot, RobotConfig, ServoConfig, StreamConfig, Unchecked, jaka_sync,
};
use jaka_sim::{Fault, Port};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, Configured as _, LONG};
use serde_json::json;

use crate::follow::{self, to_and_fro};
use crate::received::names;
use crate::stream;

fn output() -> SetDigitalOutput {
    SetDigitalOutput::new(DigitalOutputKind::Cabinet, 1, Switch::On)
}

fn turn() -> JointMove {
    JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 5.0], 20.0).acceleration(50.0)
}

/// A robot with limits, and another handle of its connection.
fn ready() -> (Arm, Robot, Client) {
    let (arm, robot) = Arm::simulated().with_robot();
    let mut robot = robot.configured(&RobotConfig::new().limits(stream::limits())).expect("it is this arm");
    let other = robot.client().try_clone().expect("the connection is there");
    (arm, robot, other)
}

fn is_kept_back(error: &jaka_sync::Error) -> bool {
    matches!(error.kind(), jaka_sync::ErrorKind::KeptBack { .. }) && !error.may_have_run()
}

/// Asserts that outputs and short queries pass, and that other commands are refused with the reason and are not sent.
fn assert_outputs_alone_pass(arm: &Arm, other: &mut Client) {
    other.call(&output()).expect("an output passes");
    assert!(other.get_joint_pos().is_ok() && other.get_robot_state().is_ok(), "short queries pass");
    let before = names(arm).iter().filter(|name| !name.starts_with("servo_")).count();
    let errors = [
        other.call(&turn()).expect_err("a motion"),
        other.call(&PowerOff::new()).expect_err("power"),
        other.call(&DisableRobot::new()).expect_err("enabling"),
        other.call_raw("nobody_knows_it", &json!({})).expect_err("an unknown command"),
        other.call_text(r#"{"cmdName":"servo_move","relFlag":0}"#, LONG).map(drop).expect_err("servo mode"),
    ];
    for error in errors {
        assert!(is_kept_back(&error), "{error:?}");
        assert!(error.to_string().contains("moves the arm"), "{error}");
    }
    assert_eq!(names(arm).iter().filter(|name| !name.starts_with("servo_")).count(), before, "nothing was sent");
}

#[test]
fn outputs_pass_while_a_session_leads_the_arm_and_all_passes_afterwards() {
    let (arm, mut robot, mut other) = ready();
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm rests");
    for _ in 0..20 {
        session.send_joint_offset([0.0; 6]).expect("the arm stands");
    }
    assert_outputs_alone_pass(&arm, &mut other);
    session.land().expect("nothing is wrong").at_rest().expect("it rests");
    other.call(&turn()).expect("nobody leads the arm");
}

#[test]
fn outputs_pass_while_a_stream_and_a_trajectory_lead_the_arm() {
    let (arm, mut robot, mut other) = ready();
    let stream = robot.stream(&StreamConfig::new()).expect("the arm rests");
    assert_outputs_alone_pass(&arm, &mut other);
    stream.land().expect("nothing is wrong").at_rest().expect("it rests");

    let (arm, mut robot) = follow::ready();
    let mut other = robot.client().try_clone().expect("the connection is there");
    let trajectory = follow::made(&to_and_fro());
    let run = robot.start_follow(&trajectory, &FollowConfig::new()).expect("the arm is at its start");
    follow::wait_for(&arm, &run.handle(), 0.5);
    assert_outputs_alone_pass(&arm, &mut other);
    let end = run.wait();
    assert_eq!(end.report.gaps, 0, "{end:?}");
    end.reached().expect("it ends there");
}

#[test]
fn a_stop_by_another_handle_passes() {
    let (arm, mut robot, mut other) = ready();
    let stream = robot.stream(&StreamConfig::new()).expect("the arm rests");
    other.call(&StopProgram::new()).expect("it passes");
    other.stop_handle().stop().expect("it passes");
    assert_eq!(names(&arm).iter().filter(|name| *name == StopProgram::INFO.name).count(), 2);
    drop(stream);
}

#[test]
fn an_end_of_a_session_by_an_error_lets_all_pass() {
    let (arm, mut robot, mut other) = ready();
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm rests");
    let error = session.send_joint_offset([90.0; 6]).expect_err("no arm jumps");
    assert!(error.is_invalid_argument() || matches!(error.kind(), ErrorKind::BeyondLimit { .. }), "{error:?}");
    other.call(&turn()).expect("nobody leads the arm");
    assert_eq!(names(&arm).last().map(String::as_str), Some(JointMove::INFO.name));
    drop(session);
}

#[test]
fn what_another_handle_sends_is_known_where_motions_are_checked() {
    let (arm, mut robot, mut other) = ready();
    robot.start(&turn()).expect("within the limits");
    other.get_robot_state().expect("a query");
    robot.start(&turn()).expect("a query changes nothing");
    other.call(&output()).expect("an output");
    let error = robot.start(&turn()).expect_err("it may have been a motion");
    assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::Start, .. }), "{error:?}");
    robot.wait(LONG).at_rest().expect("they end");
    // Nor is the arm taken to rest any more.
    let asked = |arm: &Arm| names(arm).iter().filter(|name| *name == "get_joint_pos").count();
    let before = asked(&arm);
    robot.start(&turn()).expect("within the limits");
    let known_to_rest = asked(&arm) - before;
    robot.wait(LONG).reached().expect("it ends");
    other.call(&output()).expect("an output");
    let before = asked(&arm);
    robot.start(&turn()).expect("within the limits");
    assert_eq!((known_to_rest, asked(&arm) - before), (1, 3));
}

#[test]
fn the_first_handle_closes_the_connection_and_no_other_does() {
    let (_arm, mut robot, mut other) = ready();
    drop(other.try_clone().expect("of a clone, too"));
    drop(robot.client().try_clone().expect("the connection is there"));
    assert!(other.get_robot_state().is_ok() && robot.client().get_robot_state().is_ok());
    drop(robot);
    let error = other.get_robot_state().expect_err("its owner is gone");
    assert!(error.is_disconnected(), "{error:?}");
    assert!(other.try_clone().is_err_and(|error| error.is_disconnected()));
}

/// One request is written at a time: the set-point comes after it, and is late by as long as it takes.
#[test]
fn a_long_request_of_another_handle_ends_no_session() {
    let (_arm, mut robot, mut other) = ready();
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm rests");
    let long = format!(r#"{{"cmdName":"get_joint_pos","pad":"{}"}}"#, "x".repeat(60_000));
    for number in 0..50 {
        session.send_joint_offset([0.0; 6]).expect("the arm stands");
        if number % 10 == 5 {
            other.call_text(&long, LONG).map(drop).expect("it is a query");
        }
    }
    let end = session.land().expect("nothing is wrong");
    assert_eq!((end.report.gaps, end.report.refused), (0, 0), "{end:?}");
    end.at_rest().expect("it rests");
}

/// Its thread goes on to lead the arm.
#[test]
fn a_second_session_that_is_refused_frees_nothing_that_a_forgotten_stream_keeps_back() {
    let (arm, mut robot, mut other) = ready();
    std::mem::forget(robot.stream(&StreamConfig::new()).expect("the arm rests"));
    robot.enter_servo_mode(ServoConfig::new()).expect_err("servo mode is on");
    assert_outputs_alone_pass(&arm, &mut other);
}

/// It is one of another handle as well as the first one's robot is.
#[test]
fn a_robot_of_another_handle_leads_the_arm_as_the_first_one_does() {
    let (arm, mut first) = Arm::simulated().with_client();
    let other = first.try_clone().expect("the connection is there");
    let robot = Robot::new(other, arm.monitor::<RobotStatus>()).expect("it is the only robot");
    let mut robot = robot.configured(&RobotConfig::new().limits(stream::limits())).expect("it is this arm");
    let stream = robot.stream(&StreamConfig::new()).expect("the arm rests");
    assert_outputs_alone_pass(&arm, &mut first);
    stream.land().expect("nothing is wrong").at_rest().expect("it rests");
    robot.start(&turn()).expect("within the limits");
    robot.start(&turn()).expect("its own motions are known");
    robot.wait(LONG).at_rest().expect("they end");
}

/// Replies are 30 ms on their way, so that all outputs are outstanding at once if they go out at once.
#[test]
fn outputs_of_another_handles_pipeline_end_no_stream_at_speed_and_no_command_goes_out_late() {
    let (arm, mut robot, mut other) = ready();
    let stream = robot.stream(&StreamConfig::new()).expect("the arm rests");
    stream::speed_up(&stream.handle(), arm.clock());
    arm.link(Port::Command).to_client().delay(Duration::from_millis(30));
    let mut pipeline = other.pipeline(256);
    pipeline.send_all(&vec![output(); 200]).expect("outputs pass");
    assert_eq!(pipeline.finish().expect("all are accepted"), 200);
    assert!(other.call(&PowerOff::new()).is_err_and(|error| is_kept_back(&error)));
    let end = stream.land().expect("nothing is wrong");
    assert_eq!((end.report.gaps, end.report.refused, end.report.unanswered), (0, 0, 0), "{end:?}");
    assert_eq!(end.report.accepted, end.report.cycles + end.report.landing_cycles, "{end:?}");
    assert!(!names(&arm).iter().any(|name| *name == PowerOff::INFO.name) && arm.state().powered);
    end.at_rest().expect("it rests");
}

fn refusal(command: &str) -> Fault {
    let text = format!(r#"{{"errorCode": "2", "errorMsg": "call {command} failed", "cmdName": "{command}"}}"#);
    Fault::Instead(text.into_bytes())
}

#[test]
fn a_refusal_of_a_set_point_is_told_to_the_session_and_to_no_pipeline() {
    let (arm, mut robot, mut other) = ready();
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm rests");
    arm.inject_for("servo_j", refusal("servo_j"));
    session.send_joint_offset([0.0; 6]).expect("its reply has not been read");
    let mut pipeline = other.pipeline(8);
    pipeline.send(&output()).expect("an output passes");
    assert_eq!(pipeline.finish().expect("the output is accepted"), 1);
    let error = session.send_joint_offset([0.0; 6]).expect_err("a set-point was refused");
    assert!(error.is_refused(), "{error:?}");
    assert_eq!(session.report().refused, 1);
}

#[test]
fn a_refused_output_of_a_pipeline_ends_no_stream_and_is_told_to_its_sender() {
    let (arm, mut robot, mut other) = ready();
    let stream = robot.stream(&StreamConfig::new()).expect("the arm rests");
    stream::speed_up(&stream.handle(), arm.clock());
    arm.inject_for(SetDigitalOutput::INFO.name, refusal(SetDigitalOutput::INFO.name));
    let mut pipeline = other.pipeline(8);
    pipeline.send_all(&[output(), output()]).expect("outputs pass");
    // The thread of the stream reads both replies.
    arm.clock().sleep(Duration::from_millis(100));
    let error = pipeline.finish().expect_err("the first one is refused");
    assert_eq!(error.refusal().expect("the controller refuses").command, SetDigitalOutput::INFO.name);
    let end = stream.land().expect("nothing is wrong");
    assert_eq!((end.report.refused, end.report.unanswered), (0, 0), "{end:?}");
    end.at_rest().expect("it rests");
}

/// A query that passes beside set-points, and that the connection has not seen answered.
const LACKED: &str = "get_funcdi_status";

/// The firmware refuses the next request without its name: it does not have the command. The reply is 30 ms on its way,
/// so that several requests are outstanding when it comes.
fn lack(arm: &Arm) {
    arm.link(Port::Command).to_client().delay(Duration::from_millis(30));
    arm.inject_for(LACKED, Fault::Instead(br#"{"errorCode": "1", "errorMsg": "no such command"}"#.to_vec()));
}

fn assert_lacked(other: &mut Client, command: &str) {
    let error = other.call_raw(command, &json!({})).expect_err("the firmware does not have it");
    assert_eq!(error.refusal().unwrap_or_else(|| panic!("{error:?}")).command, command);
}

#[test]
fn a_command_that_the_firmware_lacks_ends_no_stream_and_no_session() {
    let (arm, mut robot, mut other) = ready();
    let stream = robot.stream(&StreamConfig::new()).expect("the arm rests");
    stream::speed_up(&stream.handle(), arm.clock());
    for _ in 0..5 {
        lack(&arm);
        assert_lacked(&mut other, LACKED);
    }
    let end = stream.land().expect("nothing is wrong");
    assert_eq!((end.report.gaps, end.report.refused, end.report.unanswered), (0, 0, 0), "{end:?}");
    end.at_rest().expect("it rests");

    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm rests");
    lack(&arm);
    let mut go = || (0..20).try_for_each(|_| session.send_joint_offset([0.002; 6]));
    beside(arm.clock(), || assert_lacked(&mut other, LACKED), &mut go).expect("nothing is wrong");
    let end = session.land().expect("nothing is wrong");
    assert_eq!((end.report.refused, end.report.unanswered), (0, 0), "{end:?}");
    other.stop_handle().stop().expect("the connection works");
}

#[test]
fn a_command_that_the_firmware_lacks_ends_no_wait() {
    let (arm, mut robot, mut other) = ready();
    robot.start(&turn()).expect("within the limits");
    arm.link(Port::Command).to_client().delay(Duration::from_millis(30));
    let lacked = || (0..100).for_each(|_| assert_lacked(&mut other, "nobody_knows_it"));
    let end = beside(arm.clock(), lacked, || robot.wait(LONG));
    end.reached().expect("it ends there");
    other.stop_handle().stop().expect("the connection works");
}
