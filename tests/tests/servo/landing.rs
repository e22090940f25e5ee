//! Ends of servo sessions while the arm moves: the controller's requests, read as JSON and differenced by index. By
//! simulated clocks.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::time::Duration;

use jaka_robot::jaka_motion::{Frames, Model};
use jaka_robot::types::Pose;
use jaka_robot::{
    Cause, End, Error, ErrorKind, Occurrence, Robot, RobotConfig, ServoConfig, ServoSession, SessionConfig,
};
use jaka_sim::{Controller, Fault, Port, Trip, Underrun};
use jaka_tests::simulated::beside;
use jaka_tests::{Arm, ArmBuilder, CYCLE, Configured as _, LONG};
use serde_json::Value;

use crate::follow;
use crate::received::{names, offsets, positions, requests};

const CYCLES: u32 = 4;
const PERIOD: f64 = 0.032;
const SERVO_PERIOD: Duration = Duration::from_millis(32);

/// Accelerations that the checks allow, and that the ramps here ask for, in deg/s².
const MOST: f64 = 720.0;
const ASKED: f64 = 600.0;

/// The last speed of a ramp is 115 deg/s, which takes five periods to brake.
const STEPS: u32 = 6;
/// The last step of a ramp, in degrees.
const FASTEST: f64 = STEPS as f64 * ASKED * PERIOD * PERIOD;

fn arm() -> ArmBuilder {
    Arm::simulated().status_period(Duration::from_millis(10))
}

fn config() -> SessionConfig {
    SessionConfig::new().servo(servo())
}

fn servo() -> ServoConfig {
    ServoConfig::new().step_count(CYCLES)
}

fn entered(robot: &mut Robot) -> ServoSession<'_> {
    robot.enter_servo_mode(config()).expect("the arm is enabled")
}

/// Moves joint 3 by a step.
fn send(session: &mut ServoSession<'_>, step: f64) -> Result<(), Error> {
    session.send_joint_offset([0.0, 0.0, step, 0.0, 0.0, 0.0])
}

/// Goes faster by the same each period.
fn speed_up(session: &mut ServoSession<'_>) {
    for n in 1..=STEPS {
        send(session, f64::from(n) * ASKED * PERIOD * PERIOD).expect("it is within the limits");
    }
}

/// Goes on at full speed until the session ends, and returns why it does.
fn go_on(session: &mut ServoSession<'_>) -> Error {
    (0..100).find_map(|_| send(session, FASTEST).err()).expect("the session ends")
}

/// The steps of joint 3, and nothing else that moves, in the order in which they came; and the names of what came after
/// the last of them.
fn steps(controller: &Controller) -> (Vec<f64>, Vec<String>) {
    let (offsets, after) = offsets(controller, CYCLES);
    assert!(offsets.iter().all(|step| (0..6).all(|joint| joint == 2 || step[joint] == 0.0)), "{offsets:?}");
    (offsets.iter().map(|step| step[2]).collect(), after)
}

/// No speed changes faster than it may, and the last one is none. The distance of the landing, in degrees.
fn braked(steps: &[f64]) -> f64 {
    let changes = steps.windows(2).map(|two| (two[1] - two[0]).abs() / PERIOD / PERIOD);
    let worst = changes.fold(0.0, f64::max);
    assert!(worst <= MOST * (1.0 + 1e-6), "{worst} deg/s²: {steps:?}");
    assert_eq!(steps.last(), Some(&0.0), "{steps:?}");
    let begins = steps.iter().rposition(|step| (step - FASTEST).abs() < 1e-9).expect("it was fast");
    steps[begins + 1..].iter().sum()
}

/// A refusal of a set-point.
fn refusal() -> Fault {
    Fault::Instead(br#"{"errorCode":"3","errorMsg":"no","cmdName":"servo_j"}"#.to_vec())
}

/// Poses and offsets of poses that the controller received.
fn poses(controller: &Controller) -> Vec<[f64; 6]> {
    let requests = requests(controller).into_iter().filter(|request| request["cmdName"] == "servo_p");
    let pose = |request: Value| std::array::from_fn(|axis| request["catPosition"][axis].as_f64().expect("a number"));
    requests.map(pose).collect()
}

#[test]
fn a_session_that_lands_at_speed_brakes_and_holds_the_arm() {
    let (arm, mut robot) = arm().with_robot();
    let mut session = entered(&mut robot);
    speed_up(&mut session);
    let report = session.land().expect("it comes to rest").report;
    let (steps, after) = steps(&arm);
    // From v in N periods: v T (N - 1) / 2.
    let (speed, periods) = (f64::from(STEPS) * ASKED * PERIOD, f64::from(STEPS) * ASKED / MOST);
    assert!((braked(&steps) - speed * PERIOD * (periods.ceil() - 1.0) / 2.0).abs() < 1e-9, "{steps:?}");
    assert_eq!((report.cycles, report.gaps, report.late_cycles), (u64::from(STEPS), 0, 0));
    assert_eq!(report.cycles + report.landing_cycles, steps.len() as u64);
    assert_eq!(after[0], "servo_move");
    assert!(!arm.state().servo_mode);
}

#[test]
fn a_session_that_is_dropped_or_unwinds_at_speed_lands() {
    for panics in [false, true] {
        let (arm, mut robot) = arm().with_robot();
        let end = catch_unwind(AssertUnwindSafe(|| {
            let mut session = entered(&mut robot);
            speed_up(&mut session);
            if panics {
                resume_unwind(Box::new("a bug in the user's program"));
            }
        }));
        assert_eq!(end.is_err(), panics);
        assert!(!arm.state().servo_mode);
        braked(&steps(&arm).0);
    }
}

#[test]
fn a_set_point_that_is_refused_at_speed_ends_in_a_landing() {
    let (arm, mut robot) = arm().with_robot();
    let mut session = entered(&mut robot);
    speed_up(&mut session);
    let error = send(&mut session, 0.0).expect_err("it would stop at once");
    let text = error.to_string();
    assert!(error.is_invalid_argument() && text.contains("differs by 3.686 deg from the step before"), "{text}");
    assert!(text.contains("(720 deg/s²)"), "{text}");
    assert!(!arm.state().servo_mode);
    let next = send(&mut session, 0.0).expect_err("it has ended");
    assert!(matches!(next.kind(), ErrorKind::SessionEnded { .. }), "{next:?}");
    braked(&steps(&arm).0);
}

#[test]
fn a_stop_of_the_program_brakes_first_and_nothing_goes_out_after_it() {
    let (arm, mut robot) = arm().with_robot();
    let (clock, stop) = (arm.clock(), robot.stop_handle());
    let mut session = entered(&mut robot);
    let since = clock.now();
    let stopping = || {
        // While the session waits for its tenth set-point.
        clock.sleep(SERVO_PERIOD * 8 + SERVO_PERIOD / 2);
        stop.stop().expect("the controller takes the stop");
        // The tenth is the first of four that brake the arm. The stop goes out a period after the last of these, at
        // rest.
        assert_eq!(clock.now() - since, SERVO_PERIOD * 13);
    };
    let error = beside(clock, stopping, || {
        speed_up(&mut session);
        go_on(&mut session)
    });
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    let (steps, after) = steps(&arm);
    assert_eq!(steps.len(), 14);
    // Nothing holds the arm after the stop: it stands.
    braked(&steps);
    assert_eq!(after[0], "stop_program");
}

#[test]
fn a_stop_does_not_wait_for_a_session_whose_thread_is_held_up() {
    let (arm, mut robot) = arm().with_robot();
    let (clock, stop) = (arm.clock(), robot.stop_handle());
    let mut session = entered(&mut robot);
    speed_up(&mut session);
    // This thread does nothing more for the session.
    let since = clock.now();
    beside(clock, || stop.stop().expect("the controller takes the stop"), || ());
    assert!(names(&arm).contains(&"stop_program".to_owned()));
    // Twice as long as the arm may be without set-points before it is taken to stand.
    assert_eq!(clock.now() - since, SERVO_PERIOD * 6);
    let before = steps(&arm).0.len();
    let error = send(&mut session, 0.0).expect_err("it was stopped");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    drop(session);
    assert_eq!(steps(&arm).0.len(), before, "a set-point went out after the stop");
}

#[test]
fn a_landing_ends_at_rest_on_an_arm_that_lags_whatever_it_does_without_set_points() {
    for underrun in [Underrun::Hold, Underrun::Fault(Duration::from_millis(500))] {
        // Its drives fault at twice what is sent, and where the arm is left alone at speed.
        let drives = [Trip::CommandAcceleration(2.0 * MOST), Trip::CommandSpeed(180.0)];
        let lags = arm().controller(|arm| arm.lag(Duration::from_millis(80)).underrun(underrun).trips(drives));
        let (arm, mut robot) = lags.with_robot();
        let start = arm.state().joint_position.0[2];
        let mut session = entered(&mut robot);
        speed_up(&mut session);
        session.land().and_then(End::at_rest).expect("it comes to rest");
        let (steps, _) = steps(&arm);
        braked(&steps);
        let (state, moved) = (arm.state(), steps.iter().sum::<f64>());
        // Seen at rest, not only told to be: the arm lags by 9 deg at full speed.
        assert!((state.joint_position.0[2] - start - moved).abs() <= 0.1, "{underrun:?}: {state:?}");
        assert!(!state.servo_mode && state.enabled, "{underrun:?}: {state:?}");
    }
}

#[test]
fn a_stop_goes_out_in_time_though_the_arm_brakes_slowly_and_no_set_point_after_it() {
    let (arm, mut robot) = arm().with_robot();
    let (clock, stop) = (arm.clock(), robot.stop_handle());
    // From 100 deg/s with 20 deg/s²: five seconds.
    let config = config().unchecked().max_joint_acceleration(20.0);
    let jump = 100.0 * PERIOD;
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    send(&mut session, jump).expect("it is sent");
    send(&mut session, -jump).expect("it is sent");
    let since = clock.now();
    let stopping = || {
        stop.stop().expect("the controller takes it");
        assert_eq!(clock.now() - since, Duration::from_secs(3));
    };
    let error = beside(clock, stopping, || {
        let mut to_and_fro = (0..1000).map(|n| if n % 2 == 0 { jump } else { -jump });
        let error = to_and_fro.find_map(|step| send(&mut session, step).err()).expect("it is stopped");
        drop(session);
        error
    });
    assert!(matches!(error.kind(), ErrorKind::NotLanded { .. }) && error.may_have_run(), "{error:?}");
    let (_, after) = steps(&arm);
    assert!(after.contains(&"stop_program".to_owned()), "a set-point went out after the stop");
    assert!(!arm.state().servo_mode);
}

#[test]
fn after_three_periods_without_a_set_point_the_arm_is_taken_to_stand() {
    // The next set-point is due after one period.
    let almost = SERVO_PERIOD * 3 + Duration::from_millis(31);
    for (pause, stands) in [(almost, false), (SERVO_PERIOD * 4, true)] {
        let at_speed_and_paused = |session: &mut ServoSession<'_>, arm: &Arm| {
            speed_up(session);
            arm.clock().sleep(pause);
        };
        let (arm, mut robot) = arm().with_robot();
        let mut session = entered(&mut robot);
        at_speed_and_paused(&mut session, &arm);
        let sent = send(&mut session, FASTEST);
        let is_late =
            |error: &Error| matches!(error.kind(), ErrorKind::SetPointLate { late } if *late == SERVO_PERIOD * 3);
        assert!(if stands { sent.is_err_and(|error| is_late(&error)) } else { sent.is_ok() }, "{pause:?}");
        drop(session);
        // A landing brakes an arm that moves, and holds one that stands.
        let mut session = entered(&mut robot);
        let before = steps(&arm).0.len();
        at_speed_and_paused(&mut session, &arm);
        let report = session.land().expect("it comes to rest").report;
        let (steps, _) = steps(&arm);
        let next = steps[before + STEPS as usize];
        assert_eq!((next == 0.0, report.gaps), (stands, u64::from(stands)), "{pause:?}: {steps:?}");
    }
}

#[test]
fn a_landing_sends_no_more_into_a_link_that_does_not_answer() {
    let (arm, mut robot) = arm().with_robot();
    // From 100 deg/s with 20 deg/s²: five seconds.
    let config = config().unchecked().max_joint_acceleration(20.0);
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    send(&mut session, 100.0 * PERIOD).expect("it is sent");
    // It has been answered.
    arm.clock().sleep(CYCLE);
    arm.link(Port::Command).hold();
    let since = arm.clock().now();
    let error = session.land().expect_err("nothing is answered");
    assert!(matches!(error.kind(), ErrorKind::ServoModeNotLeft { .. }) && error.is_disconnected(), "{error:?}");
    // Three set-points that are not answered, a second for their answers, and one for the end of servo mode.
    let took = arm.clock().now() - since;
    assert!(took <= SERVO_PERIOD * 4 + Duration::from_secs(2), "{took:?}");
    arm.link(Port::Command).release();
    arm.clock().sleep(LONG);
    assert!(steps(&arm).0.len() <= 4, "{:?}", steps(&arm).0);
}

#[test]
fn a_refusal_that_comes_during_the_landing_is_told() {
    let (arm, mut robot) = arm().with_robot();
    let mut session = entered(&mut robot);
    // Of all set-points this one alone is refused.
    arm.inject_for("servo_j", refusal());
    send(&mut session, 0.1).expect("it is sent");
    let error = session.land().expect_err("it was refused");
    assert!(error.is_refused(), "{error:?}");
    assert!(!arm.state().servo_mode);
}

#[test]
fn a_jump_that_no_arm_makes_is_not_taken_for_a_speed() {
    let (arm, mut robot) = arm().with_robot();
    let config = config().servo(servo().rest_timeout(Duration::from_millis(200))).unchecked();
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    send(&mut session, 1.0).expect("it is sent");
    send(&mut session, 8.0).expect("it is sent, and a filter may smooth it");
    drop(session);
    let (steps, _) = steps(&arm);
    assert_eq!(steps[..2], [1.0, 8.0]);
    assert!(steps[2..].iter().all(|step| *step == 0.0), "{steps:?}");
}

#[test]
fn a_way_that_is_not_known_is_not_gone() {
    let (arm, mut robot) = arm().with_robot();
    let pose = arm.state().tcp_pose;
    let mut session = entered(&mut robot);
    session.send_pose(Pose { z: pose.z + 0.5, ..pose }).expect("a small step");
    let error = session.send_joints(arm.state().joint_position).expect_err("where the joints are is not known");
    assert!(error.to_string().contains("a set-point at an unknown distance from the previous one"), "{error}");
    assert!(!names(&arm).contains(&"servo_j".to_owned()));
}

#[test]
fn a_status_that_is_no_longer_known_ends_in_a_landing() {
    let (arm, mut robot) = arm().config(|config| config.stale_after(Duration::from_millis(500))).with_robot();
    let mut session = entered(&mut robot);
    speed_up(&mut session);
    arm.link(Port::Status).to_client().hold();
    let error = go_on(&mut session);
    assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{error:?}");
    assert!(!arm.state().servo_mode);
    braked(&steps(&arm).0);
}

#[test]
fn a_protective_stop_ends_the_session_without_a_landing() {
    let (arm, mut robot) = arm().with_robot();
    let mut session = entered(&mut robot);
    speed_up(&mut session);
    // The controller has taken the last set-point, and a packet shows the stop before the next one.
    arm.clock().sleep(CYCLE);
    arm.collide();
    let error = send(&mut session, FASTEST).expect_err("it is stopped");
    assert!(
        matches!(
            error.kind(),
            ErrorKind::NotAcknowledged { occurrence: Occurrence { cause: Cause::ProtectiveStop, .. } }
        ),
        "{error:?}"
    );
    drop(session);
    assert_eq!(steps(&arm).0.len(), STEPS as usize, "no set-point followed");
}

#[test]
fn rest_that_no_packet_shows_is_an_error_that_says_so() {
    let (_arm, mut robot) = arm().with_robot();
    let config = servo().rest_timeout(Duration::ZERO);
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    session.send_joint_offset([0.001; 6]).expect("a small step");
    let error = session.land().expect_err("nothing was seen");
    assert!(matches!(error.kind(), ErrorKind::RestNotSeen { first: None, .. }), "{error:?}");
    assert!(error.may_have_run());
    let mut session = robot.enter_servo_mode(&config).expect("the arm is enabled");
    session.send_joint_offset([0.001; 6]).expect("a small step");
    let error = session.send_joint_offset([10.0; 6]).expect_err("too fast");
    let ErrorKind::RestNotSeen { first: Some(first), .. } = error.kind() else { panic!("{error:?}") };
    assert!(first.is_invalid_argument() && error.to_string().contains(&first.to_string()), "{error}");
}

#[test]
fn a_refusal_and_rest_that_no_packet_shows_are_both_told() {
    let (arm, mut robot) = arm().with_robot();
    let mut session = robot.enter_servo_mode(servo().rest_timeout(Duration::ZERO)).expect("the arm is enabled");
    arm.inject_for("servo_j", refusal());
    session.send_joint_offset([0.001; 6]).expect("a small step");
    let error = session.land().expect_err("it was refused");
    let ErrorKind::RestNotSeen { first: Some(first), .. } = error.kind() else { panic!("{error:?}") };
    assert!(first.is_refused(), "{error:?}");
}

#[test]
fn offsets_of_a_pose_are_braked() {
    let (arm, mut robot) = arm().with_robot();
    let mut session = entered(&mut robot);
    for step in 1..=5 {
        session.send_pose_offset([0.0, 0.0, 4.0 * f64::from(step), 0.0, 0.0, 0.0]).expect("it is within the limits");
    }
    session.land().and_then(End::at_rest).expect("it comes to rest");
    let steps: Vec<f64> = poses(&arm).iter().map(|pose| pose[2]).collect();
    let most = 8000.0 * PERIOD * PERIOD;
    assert!(steps.windows(2).all(|two| (two[1] - two[0]).abs() <= most + 1e-6), "{steps:?}");
    assert!(steps.len() > 5 && steps.last() == Some(&0.0), "{steps:?}");
}

#[test]
fn set_points_that_are_poses_are_compared_and_braked_along_their_line() {
    let (arm, mut robot) = arm().with_robot();
    let start = arm.state().tcp_pose;
    let mut session = entered(&mut robot);
    let (mut pose, mut step) = (start, [0.0, 0.0]);
    for _ in 0..5 {
        // 210 mm/s and 16 deg/s more each period.
        step = [step[0] + 6.0, step[1] + 0.5];
        pose = Pose {
            x: pose.x + 0.4 * step[0],
            y: pose.y - 0.3 * step[0],
            z: pose.z + step[0],
            rz: pose.rz + step[1],
            ..pose
        };
        session.send_pose(pose).expect("it is within the limits");
    }
    let error = session.send_pose(Pose { z: pose.z + 100.0, ..pose }).expect_err("3125 mm/s");
    let text = error.to_string();
    assert!(text.contains("field `pose` is a step of 100.000 mm") && text.contains("(3000 mm/s)"), "{text}");
    let poses = poses(&arm);
    let all = [start.into(), start.into()].into_iter().chain(poses.iter().copied()).collect::<Vec<[f64; 6]>>();
    for three in all.windows(3) {
        let change = |axis: usize| (three[2][axis] - 2.0 * three[1][axis] + three[0][axis]) / PERIOD / PERIOD;
        assert!(change(2).abs() <= 8000.0 * (1.0 + 1e-6), "{} mm/s²", change(2));
        assert!(change(5).abs() <= 2160.0 * (1.0 + 1e-6), "{} deg/s²", change(5));
        let [x, y, up] = [three[2][0] - start.x, three[2][1] - start.y, three[2][2] - start.z];
        assert!((x - 0.4 * up).abs() < 1e-6 && (y + 0.3 * up).abs() < 1e-6, "off its line");
    }
    assert!(poses.len() > 5 && poses.last() == poses.get(poses.len() - 2), "{poses:?}");
}

/// The way on in joints was checked against the limits, that along the line of the poses was not.
#[test]
fn poses_within_limits_are_braked_in_joints() {
    let (arm, robot) = arm().at(follow::START).with_robot();
    let mut robot = robot.configured(&RobotConfig::new().limits(follow::limits())).expect("it is this arm");
    let start = arm.state().tcp_pose;
    let mut session = entered(&mut robot);
    // 375 mm/s in the end.
    let mut pose = start;
    for n in 1..=10 {
        pose.z -= 1.2 * f64::from(n);
        session.send_pose(pose).expect("it is within the limits");
    }
    session.land().and_then(End::at_rest).expect("it comes to rest");
    let (joints, _) = positions(&arm, CYCLES);
    let model = Model::named("Zu 5").expect("a published arm");
    let braked = joints.iter().map(|joints| Frames::new().pose(model.forward(*joints)).z);
    let heights: Vec<f64> = poses(&arm).iter().map(|pose| pose[2]).chain(braked).collect();
    let steps: Vec<f64> = heights.windows(2).map(|two| two[1] - two[0]).collect();
    // 570 deg/s² of each joint; an arm that is left at speed would stop from 12 mm a period.
    assert!(steps.windows(2).all(|two| (two[1] - two[0]).abs() < 6.0), "{steps:?}");
    assert!(steps.last().is_some_and(|step| step.abs() < 1e-6), "{steps:?}");
}

#[test]
fn set_points_may_jump_where_the_program_says_so() -> Result<(), Error> {
    let (arm, mut robot) = arm().with_robot();
    let mut session = robot.enter_servo_mode(config().unchecked())?;
    for _ in 0..5 {
        send(&mut session, 0.8)?;
    }
    session.land().and_then(End::at_rest)?;
    let (steps, _) = steps(&arm);
    assert_eq!(steps[..5], [0.8; 5]);
    // Braked all the same, by 720 deg/s² at most.
    assert!(steps[4..].windows(2).all(|two| (two[1] - two[0]).abs() <= MOST * PERIOD * PERIOD + 1e-9), "{steps:?}");
    Ok(())
}

#[test]
fn accelerations_of_a_session_are_no_less_than_a_thousandth() {
    let (arm, mut robot) = arm().with_robot();
    for config in [
        SessionConfig::new().max_joint_acceleration(0.0),
        SessionConfig::new().max_tcp_speed(f64::NAN),
        SessionConfig::new().max_tcp_acceleration(-1.0),
    ] {
        let error = robot.enter_servo_mode(&config).expect_err("not a rate");
        assert!(error.is_invalid_argument() && error.to_string().contains("at least 0.001"), "{error}");
    }
    assert!(!names(&arm).contains(&"servo_move".to_owned()));
}
