//! Motions that are waited for, in simulated time: each outcome.

use std::io::Write;
use std::time::Duration;

use jaka_proto::check::{FieldLimits, NotSent, Place, Validate};
use jaka_proto::wire::{DecodeError, Fields, Reader, Writer};
use jaka_proto::{Change, Command, CommandInfo, Effect};
use jaka_robot::force::StartTorqSensorPayloadIdentify;
use jaka_robot::motion::{JointMove, MoveL};
use jaka_robot::types::{MoveMode, Pose};
use jaka_robot::{Cause, End, ErrorKind, Motion, Robot, RobotStop, StatusProblem, Target};
use jaka_sim::{Delays, Fault, Firmware, SimulatedClock};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, CYCLE, HandFed, LONG, text};

/// Time of the event after the start of the long motion, which is at its full speed then.
const MIDDLE: Duration = Duration::from_millis(200);

/// An arm that sends a packet each cycle, and its robot.
fn ready() -> (Arm, Robot) {
    Arm::simulated().status_period(CYCLE).with_robot()
}

/// Waits until the robot has a packet of the state as it is now.
fn show(arm: &Arm) {
    arm.clock().sleep(2 * CYCLE);
}

fn to(angle: f64) -> JointMove {
    let joint_position = [angle, 90.0, 90.0, 90.0, -90.0, 0.0];
    JointMove::absolute(joint_position, 90.0).acceleration(500.0)
}

fn run(robot: &mut Robot, motion: &impl Motion) -> End {
    robot.run(motion, LONG).expect("the motion is accepted")
}

/// Runs a long motion, and does something in its middle.
fn disturbed(arm: &Arm, robot: &mut Robot, disturb: impl FnOnce() + Send) -> End {
    let disturb = || {
        arm.clock().sleep(MIDDLE);
        assert!(!arm.state().at_rest, "the motion has begun");
        disturb();
    };
    beside(arm.clock(), disturb, || run(robot, &to(100.0)))
}

#[test]
fn a_motion_reaches_its_target_with_every_firmware() {
    for firmware in Firmware::ALL {
        let (arm, mut robot) = Arm::simulated().controller(|controller| controller.firmware(*firmware)).with_robot();
        let end = run(&mut robot, &to(30.0));
        assert_eq!(end.cause(), Cause::Reached, "{firmware}: {end}");
        assert!((arm.state().joint_position.0[0] - 30.0).abs() < 1e-9, "{firmware}");
    }
}

#[test]
fn a_motion_reaches_its_target() {
    let (arm, mut robot) = ready();
    let end = run(&mut robot, &to(30.0));
    assert!(end.cause() == Cause::Reached, "{:?}", end.cause());
    assert!((arm.state().joint_position.0[0] - 30.0).abs() < 1e-9);
    assert!(arm.state().in_position);
    assert!(end.packets.len() <= 10 && end.packets.last().is_some_and(|last| last.status.in_position == Some(true)));
    // A motion of no length ends too, and so does one that has an offset, or is Cartesian.
    assert!(run(&mut robot, &to(30.0)).cause() == Cause::Reached);
    let offset = {
        let mut changed = to(0.0);
        changed.mode = MoveMode::Relative;
        changed.joint_position = [5.0; 6].into();
        changed
    };
    assert!(run(&mut robot, &offset).cause() == Cause::Reached);
    let up = Pose { x: 0.0, y: 0.0, z: 20.0, rx: 0.0, ry: 0.0, rz: 0.0 };
    let line = MoveL::relative(up, 100.0);
    let height = arm.state().tcp_pose.z;
    let end = run(&mut robot, &line);
    assert!(end.cause() == Cause::Reached && (arm.state().tcp_pose.z - height - 20.0).abs() < 0.01);
}

#[test]
fn a_batch_is_waited_for_once() {
    let (arm, mut robot) = ready();
    for angle in [20.0, -20.0, 10.0] {
        robot.start(&to(angle)).expect("it is reachable");
    }
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::Reached);
    assert!((arm.state().joint_position.0[0] - 10.0).abs() < 1e-9);
    assert!(robot.wait(Duration::ZERO).cause() == Cause::NoMotion, "nothing is left to wait for");
}

#[test]
fn a_stop_ends_the_wait_immediately() {
    let (arm, mut robot) = ready();
    let stop = robot.stop_handle();
    let end = disturbed(&arm, &mut robot, || stop.stop().expect("the controller takes the stop"));
    assert!(end.cause() == Cause::Stopped, "{:?}", end.cause());
    assert_eq!(end.report.waited, MIDDLE);
    assert!(robot.unacknowledged().is_some_and(|stop| stop.cause == Cause::Stopped), "a report is no acknowledgement");
}

#[test]
fn a_stop_that_fails_keeps_the_next_motion_from_being_sent() {
    let (arm, mut robot) = ready();
    let stop = robot.stop_handle();
    let refusal = br#"{"errorCode": "2", "errorMsg": "call stop_program failed", "cmdName": "stop_program"}"#;
    arm.inject(Fault::Instead(refusal.to_vec()));
    stop.stop().expect_err("the controller refuses");
    let error = robot.run(&to(0.0), LONG).expect_err("somebody wanted the arm to stop");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { occurrence } if occurrence.cause == Cause::Stopped));
    robot.acknowledge();
    robot.wait_for_rest(LONG).expect("nothing moves it");
    // One that succeeds later ends a wait, whatever became of those before.
    let end = disturbed(&arm, &mut robot, || stop.stop().expect("the controller takes the stop"));
    assert!(end.cause() == Cause::Stopped, "{:?}", end.cause());
}

/// A motion during whose checks the arm is stopped: after the robot has looked whether it may send, before it does.
struct StoppedOnTheWay(RobotStop);

impl Command for StoppedOnTheWay {
    type Reply = ();
    const INFO: &'static CommandInfo = JointMove::INFO;
}

impl Motion for StoppedOnTheWay {
    fn target(&self) -> Target {
        Target::Unknown
    }
}

impl Validate for StoppedOnTheWay {
    fn validate(&self, _place: &Place<'_>, _limits: &FieldLimits) -> Result<(), NotSent> {
        self.0.stop().expect("the controller takes the stop");
        Ok(())
    }
}

impl Fields for StoppedOnTheWay {
    fn write_fields(&self, out: &mut Writer) {
        to(5.0).write_fields(out);
    }

    fn read_fields(_reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Err(DecodeError::unfit("nothing", ""))
    }
}

#[test]
fn no_motion_goes_out_after_a_stop() {
    let (arm, mut robot) = ready();
    let motion = StoppedOnTheWay(robot.stop_handle());
    let error = robot.run(&motion, LONG).expect_err("the stop came first");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { occurrence } if occurrence.cause == Cause::Stopped));
    let requests = arm.requests();
    assert!(requests.last().is_some_and(|last| last.contains("stop_program")), "{requests:?}");
    robot.acknowledge();
    assert!(run(&mut robot, &to(5.0)).cause() == Cause::Reached);
}

#[test]
fn a_stop_by_somebody_else_is_seen_where_the_target_is_known() {
    let (arm, mut robot) = ready();
    // As another client would: the state says that the arm rests, and it is not where it was sent.
    let end = disturbed(&arm, &mut robot, || {
        arm.set_state(|state| state.enabled = false);
        arm.set_state(|state| state.enabled = true);
    });
    assert!(end.cause() == Cause::Stopped, "{:?}", end.cause());
    assert!(end.reached().is_err_and(|error| {
        error.to_string().starts_with("the motion was stopped before its target; look at the arm")
    }));
}

#[test]
fn protective_and_emergency_stops_latch_until_acknowledged() {
    let (arm, mut robot) = ready();
    let end = disturbed(&arm, &mut robot, || arm.collide());
    assert!(end.cause() == Cause::ProtectiveStop, "{:?}", end.cause());
    robot.client().clear_error().expect("it answers");
    show(&arm);
    let sent = arm.requests().len();
    let error = robot.run(&to(0.0), LONG).expect_err("nobody has looked");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }) && !error.may_have_run());
    assert_eq!(arm.requests().len(), sent);
    robot.acknowledge();
    assert!(run(&mut robot, &to(5.0)).cause() == Cause::Reached);

    let end = disturbed(&arm, &mut robot, || arm.press_emergency_stop());
    assert!(end.cause() == Cause::EmergencyStop, "{:?}", end.cause());
    arm.release_emergency_stop();
    show(&arm);
    assert!(robot.start(&to(0.0)).is_err());
}

#[test]
fn information_and_warnings_end_no_motion() {
    let (arm, mut robot) = ready();
    // Servo mode is on; reduced mode; and one that no table has, at an arm that reaches its target.
    for (code, target) in [("0x10F0015", 40.0), ("0x10f0020", 0.0), ("0x7654321", 40.0)] {
        let show_code = || {
            arm.clock().sleep(5 * CYCLE);
            arm.set_state(|state| code.clone_into(&mut state.error_code));
        };
        let end = beside(arm.clock(), show_code, || run(&mut robot, &to(target)));
        assert!(end.cause() == Cause::Reached, "{code}: {:?}", end.cause());
        assert!((arm.state().joint_position.0[0] - target).abs() < 1e-6);
    }
    // An unknown code counts where the arm rests elsewhere; one that was shown before the motion does not.
    let end = disturbed(&arm, &mut robot, || {
        arm.set_state(|state| {
            state.error_code = "0x7654320".to_owned();
            state.enabled = false;
        });
        arm.set_state(|state| state.enabled = true);
    });
    assert!(end.cause() == Cause::ControllerError, "{:?}", end.cause());
    assert!(run(&mut robot, &to(0.0)).cause() == Cause::Reached);
}

#[test]
fn a_deadline_leaves_the_motion_to_be_waited_for_again() {
    let (_arm, mut robot) = ready();
    let end = robot.run(&to(40.0), Duration::from_millis(20)).expect("it is accepted");
    assert!(end.cause() == Cause::Deadline);
    let end = robot.wait(LONG);
    assert!(end.cause() == Cause::Reached, "{:?}", end.cause());
}

#[test]
fn power_up_follows_the_state() {
    let arm = Arm::simulated().without_power().controller(|controller| controller.delays(Delays::REAL));
    let (arm, mut robot) = arm.status_period(CYCLE).with_robot();
    robot.power_up(LONG).expect("the status follows");
    assert!(arm.state().enabled);
    assert!(arm.elapsed() > Delays::REAL.power_on + Delays::REAL.enable, "{:?}", arm.elapsed());
    let requests = arm.requests();
    let changes: Vec<_> = requests.iter().filter(|request| !request.contains("get_robot_state")).collect();
    assert_eq!(changes, [r#"{"cmdName":"power_on"}"#, r#"{"cmdName":"enable_robot"}"#]);
}

#[test]
fn power_up_sends_nothing_where_the_emergency_stop_cannot_be_read() {
    let clock = SimulatedClock::new();
    let (mut controller, mut robot) = HandFed::by_clock(&clock, LONG);
    let packets = robot.monitor().subscribe(1);
    let unreadable = br#"{"len": 100, "emergency_stop": "perhaps", "powered_on": 0, "enabled": false, "inpos": true}"#;
    controller.status.write_all(unreadable).expect("the robot is connected");
    packets.next_packet_within(LONG).expect("the packet comes");
    let error = robot.power_up(LONG).expect_err("it may be pressed");
    assert!(
        matches!(error.kind(), ErrorKind::StatusUnknown { problem: StatusProblem::Unreadable { .. } }),
        "{error:?}"
    );
    assert!(error.to_string().contains("emergency_stop"), "{error}");
    drop(robot);
    assert_eq!(controller.received(), "");
}

#[test]
fn power_down_follows_the_state() {
    let (arm, mut robot) = ready();
    robot.power_down(LONG).expect("the status follows");
    assert!(!arm.state().powered);
    let requests = arm.requests();
    let changes: Vec<_> = requests.iter().filter(|request| !request.contains(r#""get_"#)).collect();
    assert_eq!(changes, [r#"{"cmdName":"disable_robot"}"#, r#"{"cmdName":"power_off"}"#]);
    // What is done already is not sent, also while the emergency stop is pressed.
    arm.press_emergency_stop();
    robot.power_down(LONG).expect("it is down");
    let sent = arm.requests();
    assert!(sent[requests.len()..].iter().all(|request| request.contains("get_robot_state")), "{sent:?}");
}

#[test]
fn refusals_are_explained() {
    let (arm, mut robot) = ready();
    let mut why = |change: fn(&mut jaka_sim::State)| {
        arm.set_state(change);
        show(&arm);
        // A typed one would be kept back.
        let error = robot.client().call_text(&text(&to(0.0)), LONG).map(drop).expect_err("the controller refuses");
        robot.explain(&error).map(|reason| reason.cause)
    };
    assert_eq!(why(|state| state.protective_stop = true), Some(Cause::ProtectiveStop));
    assert_eq!(why(|state| state.emergency_stop = true), Some(Cause::EmergencyStop));
    let not_enabled = |state: &mut jaka_sim::State| {
        state.emergency_stop = false;
        state.protective_stop = false;
    };
    assert_eq!(why(not_enabled), Some(Cause::NotEnabled));
    assert_eq!(why(|state| state.powered = false), Some(Cause::NotPowered));
}

#[test]
fn the_motion_of_an_identification_is_waited_for() {
    let (arm, mut robot) = ready();
    let mut joints = arm.state().joint_position;
    joints.0[5] += 20.0;
    let request = StartTorqSensorPayloadIdentify::new(joints);
    let end = run(&mut robot, &request);
    assert!(end.cause() == Cause::Reached && (arm.state().joint_position.0[5] - joints.0[5]).abs() < 1e-6);
}

/// A setting of a pack that selects a tool, as its TOML says.
struct SwapTool;

impl Command for SwapTool {
    type Reply = ();
    const INFO: &'static CommandInfo = &{
        let mut info = CommandInfo::usual("demo_swap_tool", "{\"cmdName\":\"demo_swap_tool\"", "", Effect::Setting);
        info.changes = &[Change::Tool];
        info
    };
}

impl Validate for SwapTool {
    fn validate(&self, _place: &Place<'_>, _limits: &FieldLimits<'_>) -> Result<(), NotSent> {
        Ok(())
    }
}

impl Fields for SwapTool {
    fn write_fields(&self, _out: &mut Writer) {}

    fn read_fields(_reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        Ok(Self)
    }
}

/// A pose means something else after it: by the TOML of a pack, or since nobody knows what the command does.
#[test]
fn a_pose_is_not_reached_after_a_command_that_may_have_changed_its_frames() {
    type Meanwhile = fn(&mut Robot);
    let cases: [(Meanwhile, Cause); 5] = [
        (|_| (), Cause::Reached),
        (|robot| drop(robot.client().get_joint_pos()), Cause::Reached),
        (|robot| drop(robot.client().call_raw("get_joint_pos", &serde_json::Value::Null)), Cause::Reached),
        (|robot| drop(robot.client().call(&SwapTool)), Cause::AtRest),
        (|robot| drop(robot.client().call_raw("demo_unknown", &serde_json::Value::Null)), Cause::AtRest),
    ];
    for (number, (meanwhile, expected)) in cases.into_iter().enumerate() {
        let (_arm, mut robot) = ready();
        let pose = robot.client().get_tcp_pos().expect("it answers").pose;
        let line = MoveL::absolute(Pose { z: pose.z - 30.0, ..pose }, 50.0);
        robot.start(&line).expect("it is reachable");
        meanwhile(&mut robot);
        assert_eq!(robot.wait(LONG).cause(), expected, "case {number}");
    }
}
