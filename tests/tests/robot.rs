//! Motions that are waited for, with a clock that the test moves on: each outcome, and many at random.

use std::cell::RefCell;
use std::net::TcpStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use jaka_proto::check::{Limits, NotSent, Place, Validate};
use jaka_proto::wire::{DecodeError, Fields, Reader, Writer};
use jaka_proto::{Command, CommandInfo};
use jaka_sim::{Controller, Delays, Fault, StatusFault};
use jaka_sync::force::StartTorqSensorPayloadIdentify;
use jaka_sync::motion::{EndMove, JointMove, MoveC, MoveL};
use jaka_sync::types::{MoveMode, Pose};
use jaka_sync::{
    Client, Config, ErrorKind, Explanation, Monitor, Motion, MotionEnd, Outcome, Robot, RobotStop, Target,
};

const CYCLE: Duration = Duration::from_millis(8);
const LONG: Duration = Duration::from_secs(60);

/// A controller that sends a packet each cycle, and a robot that is powered up.
///
/// The robot's grace is counted in packets alone, so that nothing depends on how fast this machine is.
fn ready() -> (Controller, Robot) {
    let controller = Controller::builder()
        .delays(Delays::NONE)
        .stepped_clock()
        .status_period(CYCLE)
        .start()
        .expect("loopback has free ports");
    controller.set_state(|state| {
        state.powered = true;
        state.enabled = true;
    });
    let monitor: Monitor =
        Config::new().stale_after(LONG).connect_monitor(controller.status_addr()).expect("the controller listens");
    monitor.wait_until(|_| true, LONG).expect("the first packet comes at once");
    let client = Client::connect(controller.command_addr()).expect("the controller listens");
    let robot = Robot::new(client, monitor).with_start_grace(Duration::ZERO, 4).with_status_silence(LONG);
    (controller, robot)
}

/// Lets a cycle pass, and waits until the monitor has its packet, so that it is never more than one behind.
fn step(controller: &Controller, monitor: &Monitor) {
    let before = monitor.last_known_packet().map_or(0, |snapshot| snapshot.number);
    controller.advance(CYCLE);
    let since = Instant::now();
    while monitor.disconnect_cause().is_none()
        && monitor.last_known_packet().is_none_or(|snapshot| snapshot.number == before)
    {
        assert!(since.elapsed() < LONG, "the packet does not come");
        thread::yield_now();
    }
}

/// Runs `work` while time goes on; `each` is called before each cycle with its number.
fn while_time_goes_on<T: Send>(
    controller: &Controller,
    monitor: &Arc<Monitor>,
    work: impl FnOnce() -> T + Send,
    mut each: impl FnMut(u32),
) -> T {
    let done = AtomicBool::new(false);
    thread::scope(|scope| {
        let working = scope.spawn(|| {
            let result = work();
            done.store(true, Ordering::SeqCst);
            result
        });
        let mut cycle = 0;
        while !done.load(Ordering::SeqCst) && !working.is_finished() {
            each(cycle);
            step(controller, monitor);
            cycle += 1;
        }
        working.join().expect("the work does not panic")
    })
}

fn to(angle: f64) -> JointMove {
    let joint_position = [angle, 90.0, 90.0, 90.0, -90.0, 0.0];
    JointMove::absolute(joint_position, 90.0).acceleration(500.0)
}

fn run(controller: &Controller, robot: &mut Robot, motion: &JointMove, each: impl FnMut(u32)) -> MotionEnd {
    let monitor = Arc::clone(robot.monitor());
    let run = || robot.run(motion, LONG);
    while_time_goes_on(controller, &monitor, run, each).expect("the motion is accepted")
}

/// Runs a long motion, and does something in its middle.
fn disturbed(controller: &Controller, robot: &mut Robot, disturb: impl Fn()) -> MotionEnd {
    let mut moving = 0;
    run(controller, robot, &to(100.0), |_| {
        let is_moving = !controller.state().at_rest;
        moving += u32::from(is_moving);
        if is_moving && moving == 20 {
            disturb();
        }
    })
}

#[test]
fn a_motion_reaches_its_target() {
    let (controller, mut robot) = ready();
    let end = run(&controller, &mut robot, &to(30.0), |_| ());
    assert!(end.outcome.is_reached(), "{:?}", end.outcome);
    assert!((controller.state().joint_position.0[0] - 30.0).abs() < 1e-9);
    assert!(controller.state().in_position);
    assert!(end.packets.len() <= 10 && end.packets.last().is_some_and(|last| last.status.in_position == Some(true)));
    // A motion of no length ends too, and so does one that has an offset, or is Cartesian.
    assert!(run(&controller, &mut robot, &to(30.0), |_| ()).outcome.is_reached());
    let offset = {
        let mut changed = to(0.0);
        changed.mode = MoveMode::Relative;
        changed.joint_position = [5.0; 6].into();
        changed
    };
    assert!(run(&controller, &mut robot, &offset, |_| ()).outcome.is_reached());
    let up = Pose { x: 0.0, y: 0.0, z: 20.0, rx: 0.0, ry: 0.0, rz: 0.0 };
    let line = MoveL::relative(up, 100.0);
    let monitor = Arc::clone(robot.monitor());
    let height = controller.state().tcp_pose.z;
    let end = while_time_goes_on(&controller, &monitor, || robot.run(&line, LONG), |_| ()).expect("it is reachable");
    assert!(end.outcome.is_reached() && (controller.state().tcp_pose.z - height - 20.0).abs() < 0.01);
}

#[test]
fn a_batch_is_waited_for_once() {
    let (controller, mut robot) = ready();
    for angle in [20.0, -20.0, 10.0] {
        robot.start(&to(angle)).expect("it is reachable");
    }
    let monitor = Arc::clone(robot.monitor());
    let end = while_time_goes_on(&controller, &monitor, || robot.wait(LONG), |_| ());
    assert!(end.outcome.is_reached());
    assert!((controller.state().joint_position.0[0] - 10.0).abs() < 1e-9);
    assert!(matches!(robot.wait(Duration::ZERO).outcome, Outcome::NoMotion), "nothing is left to wait for");
}

#[test]
fn a_stop_ends_the_wait_immediately() {
    let (controller, mut robot) = ready();
    let stop = robot.stop_handle();
    let end = disturbed(&controller, &mut robot, || stop.stop().expect("the controller takes the stop"));
    assert!(matches!(end.outcome, Outcome::Stopped), "{:?}", end.outcome);
    assert!(robot.unacknowledged().is_none(), "a stop that was asked for needs no acknowledgement");
}

#[test]
fn a_client_that_takes_the_seat_ends_the_wait_while_the_arm_moves() {
    for stops in [false, true] {
        let (controller, mut robot) = ready();
        let stop = robot.stop_handle();
        let seat = RefCell::new(None);
        let end = disturbed(&controller, &mut robot, || {
            let other = TcpStream::connect(controller.command_addr()).expect("the controller listens");
            seat.replace(Some(other));
            if stops {
                assert!(stop.stop().is_err_and(|error| error.is_disconnected()));
            }
        });
        assert!(matches!(end.outcome, Outcome::ConnectionLost { .. }), "{:?}", end.outcome);
        assert!(!controller.state().at_rest, "it goes on: {:?}", controller.state().joint_position);
    }
}

#[test]
fn a_stop_that_fails_keeps_the_next_motion_from_being_sent() {
    let (controller, mut robot) = ready();
    let stop = robot.stop_handle();
    let refusal = br#"{"errorCode": "2", "errorMsg": "call stop_program failed", "cmdName": "stop_program"}"#;
    controller.inject(Fault::Instead(refusal.to_vec()));
    stop.stop().expect_err("the controller refuses");
    let error = robot.run(&to(0.0), LONG).expect_err("somebody wanted the arm to stop");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { outcome } if matches!(outcome, Outcome::Stopped)));
    robot.acknowledge();
    // One that succeeds later ends a wait, whatever became of those before.
    let end = disturbed(&controller, &mut robot, || stop.stop().expect("the controller takes the stop"));
    assert!(matches!(end.outcome, Outcome::Stopped), "{:?}", end.outcome);
}

#[test]
fn a_stop_between_motions_keeps_the_next_from_being_sent() {
    let (controller, mut robot) = ready();
    robot.stop_handle().stop().expect("the controller takes the stop");
    let sent = controller.requests().len();
    let error = robot.run(&to(5.0), LONG).expect_err("somebody wanted the arm to stop");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { outcome } if matches!(outcome, Outcome::Stopped)));
    assert_eq!(controller.requests().len(), sent);
    robot.acknowledge();
    assert!(run(&controller, &mut robot, &to(5.0), |_| ()).outcome.is_reached());
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
    fn validate(&self, _place: &Place<'_>, _limits: &Limits) -> Result<(), NotSent> {
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
    let (controller, mut robot) = ready();
    let motion = StoppedOnTheWay(robot.stop_handle());
    let error = robot.run(&motion, LONG).expect_err("the stop came first");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { outcome } if matches!(outcome, Outcome::Stopped)));
    let requests = controller.requests();
    assert!(requests.last().is_some_and(|last| last.contains("stop_program")), "{requests:?}");
    robot.acknowledge();
    assert!(run(&controller, &mut robot, &to(5.0), |_| ()).outcome.is_reached());
}

#[test]
fn a_stop_by_somebody_else_is_seen_where_the_target_is_known() {
    let (controller, mut robot) = ready();
    // As another client would: the state says that the arm rests, and it is not where it was sent.
    let end = disturbed(&controller, &mut robot, || {
        controller.set_state(|state| state.enabled = false);
        controller.set_state(|state| state.enabled = true);
    });
    assert!(matches!(end.outcome, Outcome::Stopped), "{:?}", end.outcome);
    assert!(end.reached().is_err_and(|error| error.to_string() == "the motion was stopped before its target"));
}

#[test]
fn protective_and_emergency_stops_latch_until_acknowledged() {
    let (controller, mut robot) = ready();
    let end = disturbed(&controller, &mut robot, || controller.collide());
    assert!(matches!(end.outcome, Outcome::ProtectiveStop), "{:?}", end.outcome);
    robot.client().clear_error().expect("it answers");
    step(&controller, &Arc::clone(robot.monitor()));
    let sent = controller.requests().len();
    let error = robot.run(&to(0.0), LONG).expect_err("nobody has looked");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }) && !error.may_have_run());
    assert_eq!(controller.requests().len(), sent);
    robot.acknowledge();
    assert!(run(&controller, &mut robot, &to(5.0), |_| ()).outcome.is_reached());

    let end = disturbed(&controller, &mut robot, || controller.press_emergency_stop());
    assert!(matches!(end.outcome, Outcome::EmergencyStop), "{:?}", end.outcome);
    controller.release_emergency_stop();
    step(&controller, &Arc::clone(robot.monitor()));
    assert!(robot.start(&to(0.0)).is_err());
}

#[test]
fn a_stop_between_motions_latches_too() {
    let (controller, mut robot) = ready();
    let monitor = Arc::clone(robot.monitor());
    controller.collide();
    step(&controller, &monitor);
    robot.client().clear_error().expect("it answers");
    step(&controller, &monitor);
    assert!(matches!(robot.unacknowledged(), Some(Outcome::ProtectiveStop)));
    assert!(robot.start(&to(0.0)).is_err());
    robot.acknowledge();
    assert!(robot.unacknowledged().is_none());
}

#[test]
fn an_arm_that_is_disabled_ends_its_motion() {
    let (controller, mut robot) = ready();
    let end = disturbed(&controller, &mut robot, || controller.cut_power());
    assert!(matches!(end.outcome, Outcome::Disabled), "{:?}", end.outcome);
}

#[test]
fn an_error_of_the_controller_ends_a_motion_with_its_code() {
    let (controller, mut robot) = ready();
    let end = disturbed(&controller, &mut robot, || {
        controller.set_state(|state| {
            state.error_code = "0x0F0034".to_owned();
            state.error_message = "joint 3 hit something".to_owned();
        });
    });
    let told = end.outcome.to_string();
    assert!(told.contains("0x0f0034 (error") && told.ends_with("joint 3 hit something"), "{told}");
}

#[test]
fn information_and_warnings_end_no_motion() {
    let (controller, mut robot) = ready();
    // Servo mode is on; reduced mode; and one that no table has, at an arm that reaches its target.
    for (code, target) in [("0x10F0015", 40.0), ("0x10f0020", 0.0), ("0x7654321", 40.0)] {
        let end = run(&controller, &mut robot, &to(target), |cycle| {
            if cycle == 5 {
                controller.set_state(|state| code.clone_into(&mut state.error_code));
            }
        });
        assert!(end.outcome.is_reached(), "{code}: {:?}", end.outcome);
        assert!((controller.state().joint_position.0[0] - target).abs() < 1e-6);
    }
    // An unknown code counts where the arm rests elsewhere; one that was shown before the motion does not.
    let end = disturbed(&controller, &mut robot, || {
        controller.set_state(|state| {
            state.error_code = "0x7654320".to_owned();
            state.enabled = false;
        });
        controller.set_state(|state| state.enabled = true);
    });
    assert!(matches!(end.outcome, Outcome::ControllerError { .. }), "{:?}", end.outcome);
    assert!(run(&controller, &mut robot, &to(0.0), |_| ()).outcome.is_reached());
}

#[test]
fn a_deadline_leaves_the_motion_to_be_waited_for_again() {
    let (controller, mut robot) = ready();
    let end = robot.run(&to(40.0), Duration::from_millis(20)).expect("it is accepted");
    assert!(matches!(end.outcome, Outcome::Deadline));
    let monitor = Arc::clone(robot.monitor());
    let end = while_time_goes_on(&controller, &monitor, || robot.wait(LONG), |_| ());
    assert!(end.outcome.is_reached(), "{:?}", end.outcome);
}

#[test]
fn a_lost_status_is_reported_and_latches() {
    let (controller, mut robot) = ready();
    robot.start(&to(40.0)).expect("it is accepted");
    controller.status_fault(StatusFault::CloseAfter(10));
    controller.advance(CYCLE);
    let end = robot.wait(LONG);
    assert!(matches!(end.outcome, Outcome::StatusLost { cause: Some(_), .. }), "{:?}", end.outcome);
    assert!(robot.start(&to(0.0)).is_err_and(|error| matches!(error.kind(), ErrorKind::NotAcknowledged { .. })));

    let (controller, robot) = ready();
    let mut robot = robot.with_status_silence(Duration::from_millis(50));
    controller.status_fault(StatusFault::Silent);
    robot.start(&to(40.0)).expect("it is accepted");
    assert!(matches!(robot.wait(LONG).outcome, Outcome::StatusLost { cause: None, .. }));
}

#[test]
fn power_up_follows_the_state() {
    let controller = Controller::builder().stepped_clock().status_period(CYCLE).start().expect("there are ports");
    let monitor: Monitor = Config::new().connect_monitor(controller.status_addr()).expect("the controller listens");
    let client = Client::connect(controller.command_addr()).expect("the controller listens");
    let mut robot = Robot::new(client, monitor);
    let monitor = Arc::clone(robot.monitor());
    let power_up = || robot.power_up(LONG);
    while_time_goes_on(&controller, &monitor, power_up, |_| ()).expect("the status follows");
    assert!(controller.state().enabled);
    assert!(controller.elapsed() > Duration::from_secs(11), "{:?}", controller.elapsed());
    let requests = controller.requests();
    let changes: Vec<_> = requests.iter().filter(|request| !request.contains("get_robot_state")).collect();
    assert_eq!(changes, [r#"{"cmdName":"power_on"}"#, r#"{"cmdName":"enable_robot"}"#]);
}

#[test]
fn power_down_follows_the_state() {
    let (controller, mut robot) = ready();
    let monitor = Arc::clone(robot.monitor());
    let before = controller.requests().len();
    let power_down = || robot.power_down(LONG);
    while_time_goes_on(&controller, &monitor, power_down, |_| ()).expect("the status follows");
    assert!(!controller.state().powered);
    let requests = controller.requests();
    let changes: Vec<_> = requests[before..].iter().filter(|request| !request.contains("get_robot_state")).collect();
    assert_eq!(changes, [r#"{"cmdName":"disable_robot"}"#, r#"{"cmdName":"power_off"}"#]);
    // What is done already is not sent, also while the emergency stop is pressed.
    controller.press_emergency_stop();
    while_time_goes_on(&controller, &monitor, || robot.power_down(LONG), |_| ()).expect("it is down");
    let sent = controller.requests();
    assert!(sent[requests.len()..].iter().all(|request| request.contains("get_robot_state")), "{sent:?}");
}

#[test]
fn refusals_are_explained() {
    let (controller, mut robot) = ready();
    let mut why = |change: fn(&mut jaka_sim::State)| {
        controller.set_state(change);
        step(&controller, &Arc::clone(robot.monitor()));
        let error = robot.client().joint_move(&to(0.0)).expect_err("the controller refuses");
        robot.explain(&error)
    };
    assert_eq!(why(|state| state.protective_stop = true), Some(Explanation::ProtectiveStop));
    assert_eq!(why(|state| state.emergency_stop = true), Some(Explanation::EmergencyStop));
    let not_enabled = |state: &mut jaka_sim::State| {
        state.emergency_stop = false;
        state.protective_stop = false;
    };
    assert_eq!(why(not_enabled), Some(Explanation::NotEnabled));
    assert_eq!(why(|state| state.powered = false), Some(Explanation::NotPowered));
}

#[test]
fn a_refused_motion_says_why_in_its_error() {
    let (controller, mut robot) = ready();
    controller.set_state(|state| state.enabled = false);
    step(&controller, &Arc::clone(robot.monitor()));
    let error = robot.run(&to(5.0), LONG).expect_err("the arm is not enabled");
    assert!(error.is_refused() && !error.may_have_run());
    assert_eq!(
        error.to_string(),
        "the controller refused `joint_move` with code 2: call joint_move failed; \
         the arm is not enabled: call `enable_robot`"
    );
}

#[test]
fn arcs_joint_targets_by_pose_and_identification_are_waited_for() {
    let (controller, mut robot) = ready();
    let monitor = Arc::clone(robot.monitor());
    let start = controller.state().tcp_pose;
    let side = Pose { y: start.y + 40.0, ..start };
    let request = EndMove::new(side, 60.0).acceleration(400.0);
    let end = while_time_goes_on(&controller, &monitor, || robot.run(&request, LONG), |_| ()).expect("it goes");
    assert!(end.outcome.is_reached() && (controller.state().tcp_pose.y - side.y).abs() < 0.01);
    let mid_pose = Pose { y: start.y + 20.0, z: start.z + 20.0, ..start };
    let (mode, speed, acceleration, tolerance) = (MoveMode::Absolute, 60.0, 400.0, 0.0);
    let request = MoveC::new(mode, mid_pose, start, speed, acceleration, tolerance);
    let end = while_time_goes_on(&controller, &monitor, || robot.run(&request, LONG), |_| ()).expect("it goes");
    assert!(end.outcome.is_reached() && (controller.state().tcp_pose.y - start.y).abs() < 0.01);
    let mut joints = controller.state().joint_position;
    joints.0[5] += 20.0;
    let request = StartTorqSensorPayloadIdentify::new(joints);
    let end = while_time_goes_on(&controller, &monitor, || robot.run(&request, LONG), |_| ()).expect("it goes");
    assert!(end.outcome.is_reached() && (controller.state().joint_position.0[5] - joints.0[5]).abs() < 1e-6);
}
