//! Servo sessions by simulated clocks.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Duration;

use jaka_robot::io::SetDigitalOutput;
use jaka_robot::jaka_motion::{Limits, Model};
use jaka_robot::servo::SetServoMoveFilter;
use jaka_robot::types::{JointPosition, Pose, Switch};
use jaka_robot::{
    Cause, Client, End, Error, ErrorCode, ErrorKind, Robot, RobotConfig, ServoConfig, ServoSession, SessionConfig,
    Unchecked,
};
use jaka_sim::Fault;
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, CYCLE, LONG};

use crate::received::offsets;

fn ready() -> (Arm, Robot) {
    Arm::simulated().with_robot()
}

const LEFT: &str = r#"{"cmdName":"servo_move","relFlag":0}"#;

/// The last request that is not a query.
fn last_change(requests: &[String]) -> &str {
    let queries = ["is_in_servomove", "get_joint_pos", "get_robot_state"];
    let is_query = |request: &&String| queries.iter().any(|query| request.contains(query));
    requests.iter().rev().find(|request| !is_query(request)).expect("something was changed")
}

/// Set-points may jump.
fn unchecked() -> SessionConfig {
    SessionConfig::new().unchecked()
}

const STEP: [f64; 6] = [0.1, 0.0, 0.0, 0.0, 0.0, -0.1];

/// Another program's set-points and ours together would make the arm jump.
#[test]
fn a_session_does_not_begin_where_servo_mode_is_on() {
    let (arm, mut robot) = ready();
    arm.set_state(|state| state.servo_mode = true);
    let error = robot.enter_servo_mode(unchecked()).expect_err("it is on");
    assert!(
        matches!(error.kind(), ErrorKind::NotReady { occurrence } if occurrence.cause == Cause::ServoMode),
        "{error}"
    );
    assert!(arm.state().servo_mode, "what another program needs is left as it is");
    assert!(!arm.requests().iter().any(|request| request.contains("servo_move")), "nothing was sent to change it");
    robot.client().set_servo_mode(Switch::Off).expect("it is left");
    drop(robot.enter_servo_mode(unchecked()).expect("it is off"));
}

#[test]
fn every_set_point_is_sent_in_order_and_answered() {
    let (arm, mut robot) = ready();
    let start = arm.state().joint_position.0;
    let filter = SetServoMoveFilter::joint_low_pass(0.5);
    let config = unchecked().servo(ServoConfig::new().filter(filter).rest_timeout(LONG));
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    assert!(arm.state().servo_mode);
    for _ in 0..100 {
        session.send_joint_offset(STEP).expect("servo mode is on");
    }
    let report = session.land().expect("all were accepted").report;
    assert_eq!((report.cycles, report.refused, report.unanswered), (100, 0, 0));
    assert_eq!((report.late_cycles, report.gaps, report.lateness(1.0)), (0, 0, Duration::ZERO));
    assert_eq!(report.accepted, 100 + report.landing_cycles);
    let (came, _) = offsets(&arm, 1);
    assert!(came[..100].iter().all(|step| *step == STEP), "{came:?}");
    assert_eq!((came.len() as u64, came.last()), (100 + report.landing_cycles, Some(&[0.0; 6])));
    // The filter smooths its way, and it is seen at rest where it is as good as there.
    let (moved, sent) = (arm.state().joint_position.0[0] - start[0], came.iter().map(|step| step[0]).sum::<f64>());
    assert!((moved - sent).abs() < 0.1, "{moved} of {sent} deg");
    assert_eq!(arm.state().servo_filter, filter);
    let sent = arm.requests();
    assert_eq!(last_change(&sent), LEFT);
    let place = |part: &str| sent.iter().position(|request| request.contains(part)).expect("it was sent");
    let asked = sent.iter().rposition(|request| request.contains("get_joint_pos"));
    // From where the arm is in servo mode, not from where it was before.
    assert!(place("set_servo_move_filter") < place("\"servo_move\"") && Some(place("\"servo_move\"")) < asked);
}

#[test]
fn a_closure_gives_set_points_until_it_breaks() {
    let (arm, mut robot) = ready();
    let start = arm.state().joint_position.0;
    let mut session =
        robot.enter_servo_mode(unchecked().servo(ServoConfig::new().step_count(2))).expect("the arm is enabled");
    let mut times = Vec::new();
    let since = arm.clock().now();
    let end = session.run(|time, status| {
        assert!(status.is_some(), "the monitor has packets");
        times.push(time);
        let mut target = start;
        target[2] += 0.05 * f64::from(u32::try_from(times.len()).expect("it is small"));
        if times.len() > 20 { ControlFlow::Break("done") } else { ControlFlow::Continue(JointPosition(target)) }
    });
    assert_eq!(end.expect("servo mode is on"), "done");
    // A set-point is due every two cycles, the first one at once.
    assert!(times.iter().zip(0..).all(|(time, number)| *time == CYCLE * 2 * number), "{times:?}");
    assert_eq!(arm.clock().now() - since, CYCLE * 2 * 19);
    let report = session.land().expect("all were accepted").report;
    assert_eq!(report.accepted, 20 + report.landing_cycles);
    assert!((arm.state().joint_position.0[2] - start[2] - 1.0).abs() < 1e-6);
}

#[test]
fn the_tool_centre_point_follows_set_points_too() {
    let (arm, mut robot) = ready();
    let start = arm.state().tcp_pose;
    let mut session = robot.enter_servo_mode(unchecked()).expect("the arm is enabled");
    for n in 1..=20 {
        session.send_pose(Pose { z: start.z + 0.1 * f64::from(n), ..start }).expect("servo mode is on");
    }
    for _ in 0..10 {
        session.send_pose_offset([0.0, 0.2, 0.0, 0.0, 0.0, 0.0]).expect("servo mode is on");
    }
    let report = session.land().expect("all were accepted").report;
    assert_eq!((report.cycles, report.accepted), (30, 30 + report.landing_cycles));
    let at = arm.state().tcp_pose;
    assert!((at.z - start.z - 2.0).abs() < 0.01 && (at.y - start.y - 2.0).abs() < 0.01, "{at:?} from {start:?}");
}

#[test]
fn a_step_that_is_too_fast_is_not_sent() {
    let (arm, mut robot) = ready();
    let config = ServoConfig::new();
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    let error = session.send_joint_offset([1.5, 0.0, 0.0, 0.0, 0.0, 0.0]).expect_err("that is 187.5 deg/s");
    assert_eq!(
        error.to_string(),
        "`servo_j` was not sent: field `joint_position[0]` is a step of 1.500 deg, \
         allowed is a step of at most 1.440 deg each 8ms (180 deg/s)"
    );
    drop(session);
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    assert!(session.send_joints([0.0; 6]).is_err_and(|error| error.is_invalid_argument()));
    drop(session);
    assert_eq!(arm.requests().iter().filter(|request| request.contains("servo_j")).count(), 0);
}

#[test]
fn a_refusal_is_reported_soon_and_servo_mode_is_left() {
    let (arm, mut robot) = ready();
    let mut session = robot.enter_servo_mode(unchecked()).expect("the arm is enabled");
    session.send_joint_offset(STEP).expect("servo mode is on");
    // The controller has taken that one.
    arm.clock().sleep(CYCLE / 2);
    arm.set_state(|state| state.servo_mode = false);
    session.send_joint_offset(STEP).expect("its answer is taken with the next one");
    let error = session.send_joint_offset(STEP).expect_err("the controller is not in servo mode");
    let refusal = error.refusal().expect("the controller refuses");
    assert_eq!(refusal.code, ErrorCode(-1));
    // The next one would start from where the arm is not.
    let ended = session.send_joint_offset(STEP).expect_err("the session has ended");
    assert!(matches!(ended.kind(), ErrorKind::SessionEnded { .. }), "{ended:?}");
    drop(session);
    assert_eq!(last_change(&arm.requests()), LEFT);
    robot.client().get_joint_pos().expect("the connection works");
}

#[test]
fn answers_that_another_call_reads_count_too() {
    let (arm, mut robot) = ready();
    let mut other = robot.client().try_clone().expect("the connection is there");
    let mut session = robot.enter_servo_mode(unchecked()).expect("the arm is enabled");
    session.send_joint_offset(STEP).expect("servo mode is on");
    other.get_robot_state().expect("its reply comes after that of the set-point");
    let report = session.land().expect("the set-point was accepted").report;
    assert_eq!((report.cycles, report.accepted, report.unanswered), (1, 1 + report.landing_cycles, 0));

    let mut session = robot.enter_servo_mode(unchecked()).expect("the arm is enabled");
    arm.set_state(|state| state.servo_mode = false);
    session.send_joint_offset(STEP).expect("its answer has not come");
    other.get_robot_state().expect("its reply comes after that of the set-point");
    let error = session.land().expect_err("the set-point was refused");
    assert_eq!(error.refusal().map(|refusal| refusal.code), Some(ErrorCode(-1)));
}

#[test]
fn servo_mode_is_left_on_drop_and_on_panic() {
    let (arm, mut robot) = ready();
    drop(robot.enter_servo_mode(unchecked()).expect("the arm is enabled"));
    assert_eq!(last_change(&arm.requests()), LEFT);
    robot.client().is_in_servomove().expect("it answers");
    let panicked = catch_unwind(AssertUnwindSafe(|| {
        let mut session = robot.enter_servo_mode(unchecked()).expect("the arm is enabled");
        session.send_joint_offset(STEP).expect("servo mode is on");
        panic!("a bug in the user's program");
    }));
    assert!(panicked.is_err());
    assert_eq!(last_change(&arm.requests()), LEFT);
}

#[test]
fn answers_that_never_come_are_counted_and_hold_nothing_up() {
    let (arm, mut robot) = ready();
    let mut session = robot.enter_servo_mode(unchecked()).expect("the arm is enabled");
    for _ in 0..3 {
        arm.inject_for("servo_j", Fault::Drop);
    }
    for _ in 0..20 {
        session.send_joint_offset(STEP).expect("nothing is refused");
    }
    let report = session.land().expect("nothing was refused").report;
    assert_eq!((report.cycles, report.accepted, report.unanswered), (20, 17 + report.landing_cycles, 3));
    robot.client().get_joint_pos().expect("the connection works");
}

#[test]
fn an_answer_that_a_later_reply_overtakes_counts_as_missing() {
    let (arm, mut robot) = ready();
    let mut other = robot.client().try_clone().expect("the connection is there");
    let mut session = robot.enter_servo_mode(unchecked()).expect("the arm is enabled");
    arm.inject_for("servo_j", Fault::Drop);
    session.send_joint_offset(STEP).expect("servo mode is on");
    other.get_robot_state().expect("its reply comes, and that to the set-point does not");
    let report = session.land().expect("nothing was refused").report;
    assert_eq!((report.cycles, report.accepted, report.unanswered), (1, report.landing_cycles, 1));
}

/// Sends a set-point whose reply a later one overtakes, so that it is lost: the controller may have taken it or not.
fn send_and_lose_reply(arm: &Arm, other: &mut Client, send: impl FnOnce() -> Result<(), Error>) {
    arm.inject_for("servo_j", Fault::Drop);
    send().expect("servo mode is on");
    other.set_digital_output(&SetDigitalOutput::cabinet(1, Switch::On)).expect("its reply comes");
}

fn turn(session: &mut ServoSession<'_>, by: f64) -> Result<(), Error> {
    session.send_joint_offset([by, 0.0, 0.0, 0.0, 0.0, 0.0])
}

/// Number of absolute set-points that the controller received.
fn absolute_set_points(arm: &Arm) -> usize {
    let is_absolute = |request: &&String| request.contains("servo_j") && request.contains(r#""relFlag":0"#);
    arm.requests().iter().filter(is_absolute).count()
}

#[test]
fn after_the_lost_reply_to_an_absolute_set_point_the_next_one_goes_out() {
    let (arm, mut robot) = ready();
    let mut other = robot.client().try_clone().expect("the connection is there");
    let mut target = arm.state().joint_position;
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is enabled");
    send_and_lose_reply(&arm, &mut other, || session.send_joints(target));
    target.0[0] += 0.004;
    session.send_joints(target).expect("its distance is known");
    session.land().and_then(End::at_rest).expect("it rests");
    assert!((arm.state().joint_position.0[0] - target.0[0]).abs() < 1e-6);
}

#[test]
fn after_the_lost_reply_to_an_offset_only_offsets_go_out() {
    for followed in [0, 1] {
        let (arm, mut robot) = ready();
        let mut other = robot.client().try_clone().expect("the connection is there");
        let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is enabled");
        send_and_lose_reply(&arm, &mut other, || turn(&mut session, 0.004));
        for _ in 0..followed {
            turn(&mut session, 0.004).expect("its distance is known");
        }
        let error = session.send_joints(arm.state().joint_position).expect_err("its distance is not known");
        assert!(error.to_string().contains("at an unknown distance"), "{error}");
        drop(session);
        assert_eq!(absolute_set_points(&arm), 0, "after {followed} offsets");
    }
}

#[test]
fn after_the_lost_reply_to_an_offset_no_offset_is_within_limits() {
    let (arm, mut robot) = ready();
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    robot.configure(&RobotConfig::new().limits(limits)).expect("it is this arm");
    let mut other = robot.client().try_clone().expect("the connection is there");
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is enabled");
    send_and_lose_reply(&arm, &mut other, || turn(&mut session, 0.004));
    let error = turn(&mut session, 0.004).expect_err("its start is not known");
    assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::Start, .. }), "{error:?}");
    drop(session);
    // The landing holds the arm.
    let (steps, _) = offsets(&arm, 1);
    assert_eq!(steps.iter().filter(|step| step[0] != 0.0).count(), 1, "{steps:?}");
}

/// The controller has not taken it, and the arm rests where no set-point has led it.
#[test]
fn a_landing_after_the_lost_reply_to_an_offset_sees_rest_wherever_the_arm_is() {
    let (arm, mut robot) = ready();
    let mut other = robot.client().try_clone().expect("the connection is there");
    let mut session = robot.enter_servo_mode(unchecked()).expect("the arm is enabled");
    send_and_lose_reply(&arm, &mut other, || turn(&mut session, 0.4));
    arm.set_state(|state| state.joint_position.0[0] -= 0.4);
    session.land().and_then(End::at_rest).expect("it rests");
}

#[test]
fn a_stop_or_a_lost_connection_ends_the_session() {
    let (arm, mut robot) = ready();
    let mut session = robot.enter_servo_mode(unchecked()).expect("the arm is enabled");
    arm.collide();
    session.send_joint_offset(STEP).expect("its answer is taken with the next one");
    let error = session.send_joint_offset(STEP).expect_err("the stop is noticed");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    assert_eq!(error.cause(), Cause::ProtectiveStop);
    drop(session);
    assert!(robot.enter_servo_mode(unchecked()).is_err(), "nobody has looked");

    let (arm, mut robot) = ready();
    let mut session = robot.enter_servo_mode(unchecked()).expect("the arm is enabled");
    session.send_joint_offset(STEP).expect("servo mode is on");
    arm.disconnect();
    let error = session.send_joint_offset(STEP).expect_err("the connection is lost");
    assert!(matches!(error.kind(), ErrorKind::ServoModeNotLeft { .. }) && error.is_disconnected(), "{error:?}");
    let error = session.land().expect_err("servo mode cannot be left").to_string();
    assert!(error.contains("servo mode may be on"), "{error}");
}

#[test]
fn no_set_point_goes_out_after_a_stop() {
    let (arm, mut robot) = ready();
    let stop = robot.stop_handle();
    let clock = arm.clock();
    let mut session =
        robot.enter_servo_mode(unchecked().servo(ServoConfig::new().step_count(12))).expect("the arm is enabled");
    // Set-points are due each 96 ms: the stop comes while the session waits for the third one.
    let stopping = || {
        clock.sleep(Duration::from_millis(150));
        stop.stop().expect("the controller takes the stop");
    };
    let go_on = || (0..10).find_map(|number| Some((number, session.send_joint_offset(STEP).err()?)));
    let (number, error) = beside(clock, stopping, go_on).expect("the session has ended");
    assert!(number == 2 && matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{number}: {error:?}");
    let (steps, after) = offsets(&arm, 12);
    // The last step takes its period.
    assert_eq!(steps, [STEP, STEP, [0.0; 6]]);
    assert_eq!(after[0], "stop_program");
}
