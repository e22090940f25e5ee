//! An arm that moves keeps its power, and a stop ends the steps.

use std::time::Duration;

use jaka_proto::Envelope;
use jaka_robot::motion::JointMove;
use jaka_robot::{Cause, Client, Error, ErrorKind, PowerStep, Remedy, Robot, RobotConfig, RobotStop};
use jaka_sim::{Fault, Firmware};
use jaka_tests::{Arm, Configured as _, LONG};

fn arm() -> (Arm, Robot) {
    let arm = Arm::simulated().at([0.0, 90.0, 90.0, 90.0, -90.0, 0.0]);
    arm.controller(|controller| controller.firmware(Firmware::V1_5_14)).with_robot()
}

fn to(angle: f64, speed: f64) -> JointMove {
    JointMove::absolute([angle, 90.0, 90.0, 90.0, -90.0, 0.0], speed).acceleration(400.0)
}

/// Names of the requests that change something.
fn changes(arm: &Arm) -> Vec<String> {
    let name = |text: &String| Envelope::read(text).ok()?.command.map(std::borrow::Cow::into_owned);
    arm.requests().iter().filter_map(name).filter(|name| !name.starts_with("get_")).collect()
}

/// The command that was not sent, and why.
fn not_sent(error: &Error) -> (&str, &Error) {
    let ErrorKind::NotSent { command, because, .. } = error.kind() else { panic!("{error:?}") };
    assert!(!error.may_have_run(), "{error:?}");
    (command, because)
}

fn refusal(command: &str) -> Fault {
    let reply = format!(r#"{{"errorCode": "2", "errorMsg": "no", "cmdName": "{command}"}}"#);
    Fault::Instead(reply.into_bytes())
}

/// Its controller would take the power from it.
#[test]
fn an_arm_that_moves_keeps_its_power() {
    for speed in [0.6, 2.0, 47.0] {
        let (arm, mut robot) = arm();
        robot.start(&to(90.0, speed)).expect("it is reachable");
        arm.clock().sleep(Duration::from_millis(300));
        let error = robot.power_down(LONG).expect_err("it moves");
        let (command, because) = not_sent(&error);
        assert!(
            command == "disable_robot" && matches!(because.kind(), ErrorKind::NotAtRest { joint: 1, .. }),
            "{error:?}"
        );
        assert_eq!((error.cause(), error.remedy()), (Cause::Moving, Remedy::WaitForRest));
        assert_eq!(changes(&arm), ["joint_move"]);
        let state = arm.state();
        assert!(state.powered && state.enabled && !state.at_rest, "{speed} deg/s");
        // The remedy.
        robot.stop_handle().stop().expect("it is accepted");
        robot.wait_for_rest(LONG).expect("it brakes");
        robot.power_down(LONG).expect("it rests");
        assert_eq!(changes(&arm), ["joint_move", "stop_program", "disable_robot", "power_off"]);
        assert!(!arm.state().powered);
    }
}

#[test]
fn an_arm_that_comes_to_rest_in_time_is_powered_down_then() {
    let (arm, mut robot) = arm();
    robot.start(&to(5.0, 47.0)).expect("it is reachable");
    robot.power_down(LONG).expect("it comes to rest");
    assert!(!arm.state().powered && (arm.state().joint_position.0[0] - 5.0).abs() < 1e-6);
}

/// Calls something just before a step is sent, and returns the error that follows.
fn disturbed(robot: &mut Robot, at: &str, act: impl Fn(), power: Power) -> Error {
    let disturb = |step: PowerStep| {
        if step.command == at && step.took.is_none() {
            act();
        }
    };
    match power {
        Power::Up => robot.power_up_with(LONG, disturb),
        Power::Down => robot.power_down_with(LONG, disturb),
    }
    .expect_err("something keeps the step back")
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Power {
    Up,
    Down,
}

#[test]
fn a_motion_that_was_sent_since_the_arm_was_seen_at_rest_keeps_a_step_back() {
    let (arm, mut robot) = arm();
    let other = std::cell::RefCell::new(robot.client().try_clone().expect("the connection is there"));
    let send = |act: fn(&mut Client)| act(&mut other.borrow_mut());
    let motion = |client: &mut Client| client.call(&to(90.0, 47.0)).map(drop).expect("it is reachable");
    let error = disturbed(&mut robot, "disable_robot", || send(motion), Power::Down);
    let (command, because) = not_sent(&error);
    assert!(command == "disable_robot" && because.cause() == Cause::Moving, "{error:?}");
    assert_eq!(error.remedy(), Remedy::WaitForRest);
    assert_eq!(changes(&arm), ["joint_move"]);
    // A command that nobody knows may move it, too.
    robot.stop_handle().stop().expect("it is accepted");
    robot.acknowledge();
    let unknown = |client: &mut Client| drop(client.call_text(r#"{"cmdName":"unheard_of"}"#, LONG));
    let error = disturbed(&mut robot, "power_off", || send(unknown), Power::Down);
    assert_eq!(not_sent(&error).0, "power_off");
    assert_eq!(changes(&arm)[1..], ["stop_program", "disable_robot", "unheard_of"]);
    assert!(arm.state().powered);
    // What moves nothing keeps nothing back.
    robot.power_down_with(LONG, |_| send(|client| drop(client.get_version().expect("it answers")))).expect("it rests");
    assert!(!arm.state().powered);
}

#[test]
fn joints_that_cannot_be_read_keep_the_power_unless_the_program_says_otherwise() {
    for fault in [Fault::Drop, refusal("get_joint_pos")] {
        let (arm, mut robot) = arm();
        let unreadable = || (0..20).for_each(|_| arm.inject_for("get_joint_pos", fault.clone()));
        unreadable();
        let error = robot.power_down(LONG).expect_err("it is not known whether it moves");
        assert_eq!((not_sent(&error).0, error.remedy()), ("disable_robot", Remedy::PowerDownUnseen));
        assert!(error.to_string().contains("`RobotConfig::allow_power_down_without_joints`"), "{error}");
        assert_eq!(changes(&arm), [""; 0]);
        arm.clear_faults();
        // An arm that is seen to move keeps its power all the same.
        let mut robot =
            robot.configured(&RobotConfig::new().allow_power_down_without_joints()).expect("it is an option");
        robot.start(&to(40.0, 47.0)).expect("it is reachable");
        arm.clock().sleep(Duration::from_millis(300));
        let error = robot.power_down(LONG).expect_err("it moves");
        assert_eq!((error.cause(), error.remedy()), (Cause::Moving, Remedy::WaitForRest));
        robot.wait(LONG).reached().expect("nothing stops it");
        unreadable();
        robot.power_down(LONG).expect("the program says so");
        assert!(!arm.state().powered);
    }
}

/// Between the check and the write.
#[test]
fn a_stop_that_begins_just_before_a_step_is_written_keeps_it_back() {
    for (power, at) in [
        (Power::Up, "power_on"),
        (Power::Up, "enable_robot"),
        (Power::Down, "disable_robot"),
        (Power::Down, "power_off"),
    ] {
        let (arm, mut robot) = arm();
        if power == Power::Up {
            arm.set_state(|state| (state.powered, state.enabled) = (false, false));
            arm.clock().sleep(Duration::from_millis(200));
        }
        let stop: RobotStop = robot.stop_handle();
        let error = disturbed(&mut robot, at, || stop.stop().expect("it is accepted"), power);
        let ErrorKind::Stopped { not_sent, .. } = error.kind() else { panic!("{error:?}") };
        assert_eq!(not_sent.first().map(String::as_str), Some(at), "{error}");
        let sent = changes(&arm);
        assert!(sent.last().is_some_and(|last| last == "stop_program") && !sent.contains(&at.to_owned()), "{sent:?}");
    }
}
