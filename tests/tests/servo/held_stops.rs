//! Stops hold for all handles of a connection, and one robot has it.

use jaka_proto::Command as _;
use jaka_robot::io::{DigitalOutputKind, SetDigitalOutput};
use jaka_robot::motion::{Jog, JogFrame, JointMove};
use jaka_robot::program::{PlayProgram, ResumeProgram, StopProgram};
use jaka_robot::servo::SetServoMode;
use jaka_robot::status::RobotStatus;
use jaka_robot::types::Switch;
use jaka_robot::{Cause, Client, ErrorKind, HasRobot, Robot, RobotConfig, ServoConfig, StreamConfig, jaka_sync};
use jaka_sim::{Delays, Port};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, CYCLE, Configured as _, LONG, text};
use std::time::Duration;

use crate::received::names;
use crate::stream;

fn turn(degrees: f64) -> JointMove {
    JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, degrees], 60.0).acceleration(70.0)
}

fn ready() -> (Arm, Robot, Client) {
    let (arm, robot) = Arm::simulated().status_period(CYCLE).with_robot();
    let mut robot = robot.configured(&RobotConfig::new().limits(stream::limits())).expect("it is this arm");
    let other = robot.client().try_clone().expect("the connection is there");
    (arm, robot, other)
}

fn because(error: &jaka_sync::Error) -> &'static str {
    match error.kind() {
        jaka_sync::ErrorKind::KeptBack { because, .. } if !error.may_have_run() => because,
        kind => panic!("{kind:?}"),
    }
}

/// Number of requests so far that move the arm, or let set-points move it.
fn moving(arm: &Arm) -> usize {
    let moves = ["joint_move", "jog", "play_program", "resume_program", "servo_j"];
    let is_entry = |request: &String| request.contains("servo_move") && request.contains(":1");
    let requests = arm.requests();
    requests.iter().filter(|request| moves.iter().any(|name| request.contains(name)) || is_entry(request)).count()
}

/// Asserts that no motion goes out through any handle, for this reason, but all else.
fn assert_held(arm: &Arm, other: &mut Client, expected: &str) {
    let before = moving(arm);
    let continuous = Jog::continuous(JogFrame::Joint, 1, 5.0);
    for error in [
        other.call(&turn(5.0)).expect_err("a motion"),
        other.call(&continuous).expect_err("a jog"),
        other.call(&PlayProgram::new()).expect_err("a program"),
        other.call(&ResumeProgram::new()).expect_err("a program"),
        other.call(&SetServoMode::new(Switch::On)).expect_err("servo mode"),
    ] {
        assert!(because(&error).contains(expected), "{error}");
    }
    let mut pipeline = other.pipeline(4);
    assert!(because(&pipeline.send(&turn(5.0)).expect_err("a motion")).contains(expected));
    drop(pipeline);
    assert_eq!(moving(arm), before, "nothing was sent");
    // The controller may refuse them.
    for passed in [
        other.call(&SetServoMode::new(Switch::Off)),
        other.call(&SetDigitalOutput::new(DigitalOutputKind::Cabinet, 1, Switch::On)),
        other.call(&Jog::stop(JogFrame::Joint, 1)),
    ] {
        assert!(passed.as_ref().map_or_else(jaka_sync::Error::is_refused, |()| true), "{passed:?}");
    }
}

#[test]
fn after_a_stop_no_motion_goes_out_until_it_is_acknowledged_and_the_arm_was_seen_at_rest() {
    let (arm, mut robot, mut other) = ready();
    let stop = robot.stop_handle();
    let stop = || {
        arm.clock().sleep(Duration::from_millis(800));
        stop.stop().expect("the controller takes it");
    };
    let end = beside(arm.clock(), stop, || robot.run(&turn(90.0), LONG)).expect("it is accepted");
    assert_eq!(end.cause(), Cause::Stopped);
    let before = moving(&arm);
    for error in [
        robot.run(&turn(5.0), LONG).map(drop).expect_err("a motion"),
        robot.start(&turn(5.0)).expect_err("a motion"),
        robot.enter_servo_mode(ServoConfig::new()).map(drop).expect_err("servo mode"),
        robot.stream(&StreamConfig::new()).map(drop).expect_err("a stream"),
    ] {
        assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }) && !error.may_have_run(), "{error:?}");
    }
    assert!(because(&robot.client().joint_move(&turn(5.0)).expect_err("its own client")).contains("acknowledged"));
    assert_eq!(moving(&arm), before, "nothing was sent");
    assert_held(&arm, &mut other, "acknowledged");
    robot.acknowledge();
    assert_held(&arm, &mut other, "at rest");
    // The robot waits until the arm rests: 60 deg/s are braked by 70 deg/s².
    robot.run(&turn(5.0), LONG).expect("it waits").at_rest().expect("it comes to rest");
    other.call(&turn(5.0)).expect("nothing keeps it back");
}

/// A loop over targets does not make a stop skip one of them.
#[test]
fn a_stop_ends_a_loop_over_targets() {
    let (arm, mut robot, _other) = ready();
    let stop = robot.stop_handle();
    let stop = || {
        arm.clock().sleep(Duration::from_millis(500));
        stop.stop().expect("the controller takes it");
    };
    let run = || [30.0, -30.0, 30.0].iter().try_for_each(|by| robot.run(&turn(*by), LONG).map(drop));
    let error = beside(arm.clock(), stop, run).expect_err("the second motion is refused");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    assert_eq!(names(&arm).iter().filter(|name| *name == "joint_move").count(), 1);
}

#[test]
fn an_arm_that_does_not_come_to_rest_after_a_stop_gets_no_motion() {
    let (arm, mut robot, mut other) = ready();
    robot.stop_handle().stop().expect("the controller takes it");
    // A raw request is not kept back.
    other.call_text(&text(&turn(350.0)), LONG).expect("the controller takes it");
    robot.acknowledge();
    let error = robot.run(&turn(5.0), LONG).expect_err("it moves");
    let moves = |kind: &ErrorKind| matches!(kind, ErrorKind::NotSent { because, .. } if matches!(because.kind(), ErrorKind::NotAtRest { .. }));
    assert!(moves(error.kind()), "{error:?}");
    assert!(because(&other.call(&turn(5.0)).expect_err("it moves")).contains("at rest"));
    assert_eq!(names(&arm).iter().filter(|name| *name == "joint_move").count(), 1, "the raw one");
}

#[test]
fn a_second_robot_of_a_connection_is_refused_and_closes_nothing() {
    let (arm, mut robot, mut other) = ready();
    let stream = robot.stream(&StreamConfig::new()).expect("the arm rests");
    let HasRobot { mut client, .. } =
        Robot::new(other.try_clone().expect("it is there"), arm.monitor::<RobotStatus>()).expect_err("it has a robot");
    client.get_joint_pos().expect("its connection is open");
    other.get_joint_pos().expect("its connection is open");
    stream.land().expect("nothing has ended the stream").at_rest().expect("it rests");
}

/// A robot of the connection of a client, which has no other one.
fn next_robot(arm: &Arm, client: &Client) -> Robot {
    Robot::new(client.try_clone().expect("it is there"), arm.monitor::<RobotStatus>()).expect("it is the only one")
}

/// The next robot moves after an acknowledgement, and not before.
fn assert_next_is_bound(arm: &Arm, client: &Client) {
    let mut robot = next_robot(arm, client);
    let error = robot.start(&turn(1.0)).expect_err("nobody has acknowledged the stop");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    robot.acknowledge();
    robot.run(&turn(1.0), LONG).expect("it rests").at_rest().expect("it ends");
}

/// Its client belongs to the program; a new robot of the same connection is bound by what was before.
#[test]
fn the_next_robot_of_a_connection_inherits_a_stop_and_a_client_alone_is_bound_by_it() {
    let (arm, mut first) = Arm::simulated().with_client();
    first.stop_handle().stop().expect("the controller takes it");
    first.joint_move(&turn(1.0)).expect("a connection without a robot has nobody to acknowledge a stop");
    let robot = next_robot(&arm, &first);
    robot.stop_handle().stop().expect("the controller takes it");
    drop(robot);
    assert!(because(&first.joint_move(&turn(1.0)).expect_err("it is stopped")).contains("acknowledged"));
    assert_next_is_bound(&arm, &first);
    first.joint_move(&turn(1.0)).expect("nothing keeps it back");
}

#[test]
fn a_stop_that_a_packet_shows_keeps_back_motions_of_all_handles() {
    let (arm, mut robot, mut other) = ready();
    arm.collide();
    robot.monitor().wait_until(|status| status.protective_stop == Some(true), LONG).expect("packets come");
    assert_held(&arm, &mut other, "acknowledged");
    other.clear_error().expect("it passes");
    robot.monitor().wait_until(|status| status.protective_stop == Some(false), LONG).expect("packets come");
    assert_held(&arm, &mut other, "acknowledged");
    robot.acknowledge();
    assert_held(&arm, &mut other, "at rest");
}

#[test]
fn the_next_robot_of_a_connection_inherits_a_stop_that_a_packet_has_shown() {
    let (arm, mut first) = Arm::simulated().with_client();
    let robot = next_robot(&arm, &first);
    arm.collide();
    robot.monitor().wait_until(|status| status.protective_stop == Some(true), LONG).expect("packets come");
    first.clear_error().expect("it passes");
    robot.monitor().wait_until(|status| status.protective_stop == Some(false), LONG).expect("packets come");
    assert!(because(&first.joint_move(&turn(1.0)).expect_err("a stop")).contains("acknowledged"));
    drop(robot);
    assert!(because(&first.joint_move(&turn(1.0)).expect_err("a stop")).contains("acknowledged"));
    assert_next_is_bound(&arm, &first);
}

/// The controller answers none of the commands before.
#[test]
fn a_stop_in_a_pipeline_waits_for_no_room_and_for_no_failure_before() {
    let (arm, mut robot, mut other) = ready();
    robot.start(&turn(90.0)).expect("it is accepted");
    let output = SetDigitalOutput::new(DigitalOutputKind::Cabinet, 1, Switch::On);
    other.call(&output).expect("it is accepted");
    arm.link(Port::Command).to_client().hold();
    let (before, since) = (arm.requests().len(), arm.clock().now());
    let mut pipeline = other.pipeline(1);
    pipeline.send(&output).expect("there is room");
    pipeline.send(&StopProgram::new()).expect("a stop waits for nothing");
    assert_eq!(arm.clock().now(), since);
    assert!(arm.wait_for_requests(before + 2, LONG), "both were sent");
    assert_eq!(names(&arm).last().map(String::as_str), Some(StopProgram::INFO.name));
    arm.link(Port::Command).release();
    drop(pipeline);
    assert_eq!(robot.wait(LONG).cause(), Cause::Stopped);
}

/// Set-points by `servo_j` that were received, and the place of the first stop among them.
fn set_points_and_stop(arm: &Arm) -> (Vec<String>, usize) {
    let names = names(arm);
    let is_stop = |name: &String| name == StopProgram::INFO.name;
    let kept: Vec<_> = names.into_iter().filter(|name| name == "servo_j" || is_stop(name)).collect();
    let place = kept.iter().position(is_stop).expect("the stop was received");
    (kept, place)
}

#[test]
fn a_stop_at_once_is_followed_by_no_set_point() {
    let (arm, mut robot, other) = {
        let builder = stream::arm().controller(|controller| controller.delays(Delays::NONE));
        let (arm, robot) = builder.with_robot();
        let mut robot = robot.configured(&RobotConfig::new().limits(stream::limits())).expect("it is this arm");
        let other = robot.client().try_clone().expect("the connection is there");
        (arm, robot, other)
    };
    let (now, later) = (other.stop_handle(), robot.stop_handle());
    let stream = robot.stream(&StreamConfig::new()).expect("the arm rests");
    stream.handle().set_joint_velocity([0.0, 0.0, 0.0, 0.0, 0.0, 30.0], Duration::from_millis(500)).expect("within");
    arm.clock().sleep(Duration::from_millis(400));
    now.stop_now().expect("the controller takes it");
    let (kept, place) = set_points_and_stop(&arm);
    assert_eq!(place, kept.len() - 1, "a set-point follows it");
    later.stop().expect("the controller takes it");
    let error = stream.land().expect_err("it was stopped");
    assert_eq!(error.cause(), Cause::Stopped, "{error:?}");
    let (kept, place) = set_points_and_stop(&arm);
    assert!(kept[place..].iter().all(|name| name == StopProgram::INFO.name), "{kept:?}");
    assert!(!arm.state().servo_mode, "servo mode is left all the same");
    robot.acknowledge();
    robot.run(&turn(1.0), LONG).expect("it rests").at_rest().expect("it ends");
}
