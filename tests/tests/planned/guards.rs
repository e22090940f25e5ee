//! Motions under a guard: what the controller receives, and how the motion ends.

mod contact;
mod set_points;
mod streams;

use std::panic::resume_unwind;
use std::sync::Arc;
use std::time::Duration;

use jaka_proto::wire::{Decode, DecodeError, Reader};
use jaka_robot::jaka_motion::{Limits, Model};
use jaka_robot::motion::JointMove;
use jaka_robot::program::StopProgram;
use jaka_robot::status::RobotStatus;
use jaka_robot::{
    Cause, Command, End, ErrorKind, Evidence, Guard, GuardTrip, MotionExt as _, MotionStatus, NotShown, Numbering,
    Occurrence, Robot, RobotConfig, TcpBox, TripReason,
};
use jaka_sim::{Contact, Fault, Port, StatusFault};
use jaka_tests::simulated::{beside, until};
use jaka_tests::{Arm, ArmBuilder, Configured as _, HandFed, LONG};

const IO: Numbering = Numbering::FromOne;

/// Travel of the motion in degrees: some four seconds.
const FAR: f64 = 100.0;

/// Time between two packets.
const PERIOD: Duration = Duration::from_millis(10);

/// Time until the controller has a request of a robot above a plane. With the cycle in which it begins to act, that is
/// the reaction of 20 ms.
const ON_ITS_WAY: Duration = Duration::from_millis(12);

/// Change of force of a limit in N, and force of a plane in N/mm: 0.0025 mm is the depth at which the limit is reached.
const CHANGE: f64 = 5.0;
const STIFFNESS: f64 = 2000.0;

fn simulated() -> ArmBuilder {
    Arm::simulated().status_period(PERIOD)
}

fn ready() -> (Arm, Robot) {
    simulated().with_robot()
}

/// An arm this far above a plane, which the torque sensor feels, and a robot that knows how often packets come.
fn above_a_plane(period: Duration, above_mm: f64) -> (Arm, Robot) {
    lagging_above_a_plane(Duration::ZERO, period, above_mm)
}

/// An arm above a plane that lags behind what it is told.
fn lagging_above_a_plane(lag: Duration, period: Duration, above_mm: f64) -> (Arm, Robot) {
    let (arm, robot) = Arm::simulated().controller(|it| it.lag(lag)).status_period(period).with_robot();
    arm.set_state(|state| state.torque_sensor.working = true);
    let pose = arm.state().tcp_pose;
    let plane = Contact::plane([pose.x, pose.y, pose.z - above_mm], [0.0, 0.0, 1.0], STIFFNESS);
    arm.set_contact(Some(plane)).expect("it is one");
    arm.link(Port::Command).to_controller().delay(ON_ITS_WAY);
    until(arm.clock(), || robot.monitor().statistics().recent_gap.is_some());
    (arm, robot)
}

fn motion() -> JointMove {
    JointMove::absolute([FAR, 90.0, 90.0, 90.0, -90.0, 0.0], 25.0).acceleration(500.0)
}

/// The names of the requests that have come.
fn names(arm: &Arm) -> Vec<String> {
    let name = |text: &String| jaka_proto::Envelope::read(text).ok()?.command.map(std::borrow::Cow::into_owned);
    arm.requests().iter().filter_map(name).collect()
}

/// A robot with the limits of its arm.
fn limited(robot: Robot) -> Robot {
    robot.configured(&arm_limits()).expect("it is this arm")
}

/// Options with the limits of the arm.
fn arm_limits() -> RobotConfig {
    RobotConfig::new().limits(Limits::of(Model::named("Zu 5").expect("a published arm")))
}

/// Number of requests of a command.
fn count(arm: &Arm, command: &str) -> usize {
    names(arm).iter().filter(|name| *name == command).count()
}

/// Waits until the arm moves.
fn wait_for_motion(arm: &Arm) {
    until(arm.clock(), || arm.state().joint_position.0[0] >= 1.0);
}

/// Runs the motion under a guard, and does something once the arm moves.
fn disturbed(arm: &Arm, robot: &mut Robot, guard: impl Into<Guard> + Send, disturb: impl FnOnce() + Send) -> End {
    let disturb = || {
        wait_for_motion(arm);
        disturb();
    };
    beside(arm.clock(), disturb, || robot.run(&motion().guard(guard), LONG).expect("the motion is accepted"))
}

/// The arm is at rest, and not where the motion leads.
fn assert_stopped_on_the_way(arm: &Arm) {
    let state = arm.state();
    let at = state.joint_position.0[0];
    assert!(state.at_rest && at > 0.0 && at < FAR - 1.0, "it is at {at}");
    assert_eq!(count(arm, StopProgram::INFO.name), 1, "{:?}", names(arm));
}

fn trip(end: End) -> Arc<GuardTrip> {
    end.guarded().unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_guard_that_holds_before_the_start_sends_nothing() {
    let (mut controller, mut robot) = HandFed::new(LONG);
    controller.packet_to(&robot, r#""din": [1], "actual_position": [10, 0, 500, 0, 0, 0]"#);
    let outside = TcpBox::from_corners([0.0, -1.0, 0.0], [9.0, 1.0, 900.0]);
    let guards = [
        Guard::from(IO.cabinet(1).is_high()),
        Guard::from(IO.cabinet(1).rises()).or(outside.is_left()),
        Guard::when("always", |_| true),
        Guard::when("a question that panics", |_| panic!("as it should")),
    ];
    for (guard, expected) in guards.into_iter().zip([0, 1, 0, 0]) {
        let text = guard.to_string();
        let end = robot.run(&motion().guard(guard), LONG).expect("that is an end");
        let Evidence::Trip(trip) = end.evidence() else { panic!("{text}: {end:?}") };
        assert!(trip.is_before_start && trip.reaction.is_none() && end.stop.is_none(), "{end:?}");
        assert_eq!((trip.condition, trip.packet.number), (expected, 1), "{text}");
    }
    drop(robot);
    assert_eq!(controller.received(), "");
}

#[test]
fn a_guard_that_packets_do_not_show_is_an_error_before_the_start() {
    let (mut controller, mut robot) = HandFed::new(LONG);
    controller.packet_to(&robot, r#""din": [0, 0], "tio_ain": ["a"]"#);
    let the_box = TcpBox::from_corners([0.0; 3], [1.0; 3]);
    let absent = |field: &str| NotShown::Absent { field: field.to_owned() };
    for (guard, expected) in [
        (Guard::from(IO.tool(1).is_high()), absent("tool_digital_inputs")),
        (IO.cabinet(3).rises().into(), NotShown::TooShort { field: "digital_inputs".to_owned(), count: 2 }),
        (the_box.is_entered(), absent("actual_position")),
        (Guard::when("never", |_| false).or(the_box.is_left()), absent("actual_position")),
    ] {
        let error = robot.run(&motion().guard(guard.clone()), LONG).expect_err("it cannot be judged");
        let ErrorKind::NotShown { what, reason } = error.kind() else { panic!("{guard}: {error:?}") };
        assert_eq!((what, reason), (&guard.to_string(), &expected));
        assert!(!error.may_have_run());
    }
    let error = robot.run(&motion().guard(IO.tool_analog(1).is_above(2.0)), LONG).expect_err("it cannot be read");
    assert!(matches!(error.kind(), ErrorKind::NotShown { reason: NotShown::Unfit { .. }, .. }), "{error:?}");
    let odd = TcpBox::from_corners([0.0, f64::NAN, 0.0], [1.0; 3]).is_left();
    for guard in [IO.cabinet(0).is_high().into(), odd] {
        let error = robot.run(&motion().guard(guard), LONG).expect_err("there is no such thing");
        assert!(error.is_invalid_argument(), "{error:?}");
    }
    drop(robot);
    assert_eq!(controller.received(), "");
}

#[test]
fn without_a_known_status_nothing_is_sent_under_a_guard_whatever_is_allowed() {
    let (controller, robot) = HandFed::new(Duration::from_millis(50));
    let mut robot = robot.configured(&RobotConfig::new().allow_motion_without_status()).expect("it has no limits");
    let error = robot.run(&motion().guard(Guard::when("never", |_| false)), LONG).expect_err("no packet has come");
    assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{error:?}");
    drop(robot);
    assert_eq!(controller.received(), "");
}

#[test]
fn an_input_stops_the_motion() {
    let (arm, mut robot) = ready();
    let high = || arm.set_state(|state| state.digital_inputs[4] = true);
    let guard = Guard::from(IO.tool(1).rises()).or(IO.cabinet(5).rises());
    let end = disturbed(&arm, &mut robot, guard, high);
    assert!(matches!(end.stop, Some(Ok(()))), "{end:?}");
    let trip = trip(end);
    assert_eq!((trip.condition, &*trip.text), (1, "digital input 5 of the cabinet (counted from 1) goes high"));
    assert_eq!(trip.packet.status.digital_inputs.as_ref().and_then(|inputs| inputs.get(4)), Some(&true));
    assert!(trip.is_at_rest && !trip.is_before_start, "{trip:?}");
    assert_eq!(trip.reaction, Some(Duration::ZERO), "{trip:?}");
    assert_stopped_on_the_way(&arm);
    // The stop was told: the next motion goes out, and reaches its target.
    let back = JointMove::absolute([0.0, 90.0, 90.0, 90.0, -90.0, 0.0], 90.0).acceleration(500.0);
    let guard = IO.tool(1).rises();
    robot.run(&back.guard(guard), LONG).expect("nothing keeps it back").reached().expect("the guard does not trip");
    assert_eq!(count(&arm, StopProgram::INFO.name), 1);
}

#[test]
fn a_guard_is_watched_also_where_no_packet_is_ever_too_old() {
    let (arm, mut robot) = simulated().config(|config| config.stale_after(Duration::MAX)).with_robot();
    let high = || arm.set_state(|state| state.digital_inputs[4] = true);
    let end = disturbed(&arm, &mut robot, IO.cabinet(5).rises(), high);
    assert!(trip(end).is_at_rest);
    assert_stopped_on_the_way(&arm);
}

#[test]
fn a_box_and_a_question_stop_the_motion() {
    let (arm, mut robot) = ready();
    let pose = arm.state().tcp_pose;
    let around = TcpBox::from_corners([pose.x - 20.0, pose.y - 20.0, 0.0], [pose.x + 20.0, pose.y + 20.0, 2000.0]);
    let end = robot.run(&motion().guard(around.is_left()), LONG).expect("the motion is accepted");
    let trip = trip(end);
    let at = trip.packet.status.actual_position.expect("packets have it");
    assert!((at.x - pose.x).abs().max((at.y - pose.y).abs()) > 20.0, "{at:?}");
    assert_stopped_on_the_way(&arm);

    let (arm, mut robot) = ready();
    let question = Guard::when("joint 1 is beyond 5 deg", |status| {
        status.joint_actual_position.is_some_and(|joints| joints.0[0] > 5.0)
    });
    let end = robot.run(&motion().guard(question), LONG).expect("the motion is accepted");
    assert!(end.guarded().is_ok_and(|trip| trip.text == "joint 1 is beyond 5 deg"));
    assert_stopped_on_the_way(&arm);
}

#[test]
fn what_cannot_be_judged_stops_the_motion() {
    let (arm, mut robot) = ready();
    let panics = Guard::when("joint 1 is small", |status| {
        assert!(status.joint_actual_position.is_none_or(|joints| joints.0[0] < 5.0));
        false
    });
    let end = robot.run(&motion().guard(panics), LONG).expect("the motion is accepted");
    let Evidence::Trip(trip) = end.evidence() else { panic!("{end:?}") };
    assert_eq!(trip.reason, TripReason::Panicked);
    assert!(end.guarded().is_err(), "it is not known whether it holds");
    assert_stopped_on_the_way(&arm);

    let (arm, mut robot) = ready();
    let unfit = || arm.set_status([("din".to_owned(), "on".into())]);
    let end = disturbed(&arm, &mut robot, IO.cabinet(1).rises(), unfit);
    let Evidence::Trip(trip) = end.evidence() else { panic!("{end:?}") };
    assert!(matches!(trip.reason, TripReason::NotShown(NotShown::Unfit { .. })), "{trip:?}");
    assert_stopped_on_the_way(&arm);
}

#[test]
fn a_status_that_is_silent_or_lost_stops_the_motion() {
    let (arm, mut robot) = ready();
    let silent = || arm.status_fault(StatusFault::Silent);
    let end = disturbed(&arm, &mut robot, IO.cabinet(1).rises(), silent);
    assert!(matches!(end.evidence(), Evidence::Status { cause: None, .. }), "{end:?}");
    assert!(matches!(end.stop, Some(Ok(()))), "{end:?}");
    assert_eq!(count(&arm, StopProgram::INFO.name), 1);
    let error = robot.start(&motion()).expect_err("nobody has looked");
    assert!(
        matches!(error.kind(), ErrorKind::NotAcknowledged { occurrence: Occurrence { cause: Cause::StatusLost, .. } }),
        "{error:?}"
    );

    let (arm, mut robot) = ready();
    let lost = || arm.status_fault(StatusFault::CloseAfter(0));
    let end = disturbed(&arm, &mut robot, IO.cabinet(1).rises(), lost);
    assert!(matches!(end.evidence(), Evidence::Status { cause: Some(_), .. }), "{end:?}");
    assert!(matches!(end.stop, Some(Ok(()))), "{end:?}");
    assert_eq!(count(&arm, StopProgram::INFO.name), 1);
}

#[test]
fn the_deadline_stops_the_motion() {
    let (arm, mut robot) = ready();
    let end = robot.run(&motion().guard(IO.cabinet(1).rises()), Duration::from_millis(800));
    let end = end.expect("the motion is accepted");
    assert!(end.cause() == Cause::Deadline && matches!(end.stop, Some(Ok(()))), "{end:?}");
    let text = end.reached().expect_err("it was not").to_string();
    assert!(text.ends_with("; a stop was sent and accepted"), "{text}");
    until(arm.clock(), || arm.state().at_rest);
    assert_stopped_on_the_way(&arm);
}

#[test]
fn the_stop_does_not_wait_for_the_reply_to_the_motion() {
    let (arm, mut robot) = ready();
    arm.inject_for(JointMove::INFO.name, Fault::Hold);
    let high = || {
        arm.set_state(|state| state.digital_inputs[0] = true);
        assert!(arm.wait_for_requests(2, LONG), "the stop comes");
        // The reply to the motion goes with the next one: that to the stop.
        assert_eq!(names(&arm)[..2], [JointMove::INFO.name, StopProgram::INFO.name]);
        arm.release();
    };
    let end = disturbed(&arm, &mut robot, IO.cabinet(1).rises(), high);
    assert!(trip(end).is_at_rest);
    assert_stopped_on_the_way(&arm);
}

#[test]
fn a_stop_that_is_refused_is_told_at_once() {
    let (arm, mut robot) = ready();
    let refusal = br#"{"errorCode": "2", "errorMsg": "call stop_program failed", "cmdName": "stop_program"}"#;
    arm.inject_for(StopProgram::INFO.name, Fault::Instead(refusal.to_vec()));
    let high = || arm.set_state(|state| state.digital_inputs[0] = true);
    let end = disturbed(&arm, &mut robot, IO.cabinet(1).rises(), high);
    assert!(matches!(&end.stop, Some(Err(error)) if error.is_refused()), "{end:?}");
    assert!(matches!(end.evidence(), Evidence::Trip(trip) if !trip.is_at_rest), "{end:?}");
    // The motion takes four seconds.
    assert!(end.report.waited < Duration::from_secs(1), "{end:?}");
    let text = end.guarded().expect_err("the arm may still move").to_string();
    assert!(text.contains("the stop that followed was not accepted, so the arm may still move"), "{text}");
    let error = robot.start(&motion()).expect_err("nobody has looked");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
}

/// Waits until a stop has come.
fn wait_for_stop(arm: &Arm) {
    until(arm.clock(), || count(arm, StopProgram::INFO.name) > 0);
}

/// A stop of the program's own keeps the next motion back, unless the end has reported it.
fn assert_kept_back(robot: &mut Robot, end: &End) {
    assert!(robot.unacknowledged().is_some_and(|found| found.cause == Cause::Stopped), "{end:?}");
    let error = robot.start(&motion()).expect_err("nobody has looked");
    assert!(
        matches!(error.kind(), ErrorKind::NotAcknowledged { occurrence: Occurrence { cause: Cause::Stopped, .. } }),
        "{error:?}"
    );
    robot.acknowledge();
    assert!(robot.unacknowledged().is_none());
}

#[test]
fn a_stop_of_the_program_while_the_guard_stops_the_arm_keeps_the_next_motion_back() {
    let (arm, mut robot) = ready();
    let stop = robot.stop_handle();
    arm.inject_for(StopProgram::INFO.name, Fault::Delay(Duration::from_millis(300)));
    let end = disturbed(&arm, &mut robot, IO.cabinet(5).rises(), || {
        arm.set_state(|state| state.digital_inputs[4] = true);
        wait_for_stop(&arm);
        stop.stop().expect("the controller accepts it");
    });
    assert!(end.cause() == Cause::Guard, "{end:?}");
    assert_kept_back(&mut robot, &end);
    drop(robot);

    let (arm, mut robot) = ready();
    let stop = robot.stop_handle();
    arm.inject_for(StopProgram::INFO.name, Fault::Delay(Duration::from_millis(300)));
    let stop = || {
        wait_for_stop(&arm);
        stop.stop().expect("the controller accepts it");
    };
    let run = || robot.run(&motion().guard(IO.cabinet(5).rises()), Duration::from_secs(2)).expect("it is accepted");
    let end = beside(arm.clock(), stop, run);
    assert!(end.cause() == Cause::Deadline && matches!(end.stop, Some(Ok(()))), "{end:?}");
    assert_kept_back(&mut robot, &end);
}

#[test]
fn a_stop_of_the_program_that_an_end_by_the_guard_does_not_report_keeps_the_next_motion_back() {
    let (arm, mut robot) = ready();
    let stop = robot.stop_handle();
    arm.inject_for(StopProgram::INFO.name, Fault::Delay(Duration::from_millis(300)));
    let end = disturbed(&arm, &mut robot, IO.cabinet(5).rises(), || {
        let trip = || {
            wait_for_stop(&arm);
            arm.set_state(|state| state.digital_inputs[4] = true);
        };
        beside(arm.clock(), trip, || stop.stop().expect("the controller accepts it"));
    });
    assert!(end.cause() == Cause::Guard, "{end:?}");
    assert_kept_back(&mut robot, &end);
}

#[test]
fn a_refused_motion_is_an_error_and_a_protective_stop_goes_first() {
    let (arm, mut robot) = ready();
    // Beyond what joint 3 of a Zu 5 can do.
    let beyond = JointMove::absolute([0.0, 90.0, 180.0, 90.0, -90.0, 0.0], 25.0);
    let error = robot.run(&beyond.guard(IO.cabinet(1).rises()), LONG).expect_err("it is refused");
    assert!(error.is_refused(), "{error:?}");
    assert_eq!(count(&arm, StopProgram::INFO.name), 0);
    let collide = || arm.collide();
    let end = disturbed(&arm, &mut robot, IO.cabinet(1).rises(), collide);
    assert!(end.cause() == Cause::ProtectiveStop, "{end:?}");
}

/// Packets of a type of the user's own, which says what it means by code that panics at the end.
struct Odd(RobotStatus);

impl Decode for Odd {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        RobotStatus::decode(reader).map(Self)
    }
}

impl MotionStatus for Odd {
    fn robot_status(&self) -> RobotStatus {
        if self.0.joint_actual_position.is_some_and(|joints| joints.0[0] >= 5.0) {
            // A panic without a message, which could take longer than the motion.
            resume_unwind(Box::new("as it should"));
        }
        self.0.clone()
    }
}

#[test]
fn a_type_of_packets_that_panics_leaves_no_motion_without_its_guard() {
    let arm = simulated().start();
    let (monitor, client) = (arm.monitor::<Odd>(), arm.client());
    let mut robot = Robot::<Odd>::with_monitor(client, monitor).expect("it is the only robot");
    let end = robot.run(&motion().guard(Guard::when("never", |_| false)), LONG).expect("the motion is accepted");
    assert!(matches!(end.evidence(), Evidence::Status { unreadable: Some(_), .. }), "{end:?}");
    assert!(matches!(end.stop, Some(Ok(()))), "{end:?}");
    assert_eq!(count(&arm, StopProgram::INFO.name), 1, "{:?}", names(&arm));
}
