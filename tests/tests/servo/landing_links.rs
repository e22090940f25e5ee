//! Landings by the simulated clock: what goes out while the link stalls, after a gap, after a refusal and beside a
//! stop; when rest counts as seen, and servo mode
//! as left. The requests that the controller received are the witness.

use std::sync::Arc;
use std::time::Duration;

use jaka_robot::{
    Cause, End, ErrorKind, Occurrence, Rest, Robot, RobotConfig, ServoConfig, ServoSession, SessionConfig,
};
use jaka_sim::{Controller, Fault, Port};
use jaka_tests::simulated::{beside, until};
use jaka_tests::{Arm, CYCLE, Configured as _, LONG};
use serde_json::Value;

/// Period of status packets.
const PERIOD: Duration = Duration::from_millis(10);

/// Acceleration of ramps and of landings, in deg/s²: a ramp of 40 set-points takes as many to brake.
const ACCELERATION: f64 = 50.0;

/// Set-points of a ramp.
const RAMP: u32 = 40;

/// Least delay of a set-point after which the arm is taken to stand: three periods.
const GAP: Duration = Duration::from_millis(24);

fn ready() -> (Arm, Robot) {
    Arm::simulated().status_period(PERIOD).with_robot()
}

fn config() -> SessionConfig {
    SessionConfig::new().max_joint_acceleration(ACCELERATION)
}

/// The `n`-th step of a ramp, in degrees.
fn step(n: u32) -> f64 {
    f64::from(n) * ACCELERATION * CYCLE.as_secs_f64() * CYCLE.as_secs_f64()
}

fn send(session: &mut ServoSession<'_>, step: f64) -> Result<(), jaka_robot::Error> {
    session.send_joint_offset([0.0, 0.0, step, 0.0, 0.0, 0.0])
}

/// A session at 16 deg/s.
fn at_speed(robot: &mut Robot) -> ServoSession<'_> {
    let mut session = robot.enter_servo_mode(config()).expect("the arm is at rest");
    for n in 1..=RAMP {
        send(&mut session, step(n)).expect("answers come");
    }
    session
}

/// Requests that the controller received, as JSON.
fn requests(controller: &Controller) -> Vec<Value> {
    controller.requests().iter().map(|text| serde_json::from_str(text).expect("requests are JSON")).collect()
}

/// Steps of joint 3, in the order in which they came.
fn steps(controller: &Controller) -> Vec<f64> {
    let set_points = requests(controller).into_iter().filter(|request| request["cmdName"] == "servo_j");
    set_points.map(|request| request["jointPosition"][2].as_f64().expect("a number")).collect()
}

fn count(controller: &Controller, command: &str) -> usize {
    requests(controller).iter().filter(|request| request["cmdName"] == command).count()
}

/// A reply to `is_in_servomove`.
fn in_servo_mode(is_on: bool) -> Fault {
    let text =
        format!(r#"{{"errorCode": "0", "errorMsg": "", "in_servomove": {is_on}, "cmdName": "is_in_servomove"}}"#);
    Fault::Instead(text.into_bytes())
}

#[test]
fn servo_mode_counts_as_left_once_the_controller_says_so() {
    let (arm, mut robot) = ready();
    let session = robot.enter_servo_mode(config()).expect("the arm is at rest");
    let asked = count(&arm, "is_in_servomove");
    for _ in 0..5 {
        arm.inject_for("is_in_servomove", in_servo_mode(true));
    }
    session.land().and_then(End::at_rest).expect("it is left at last");
    assert_eq!(count(&arm, "is_in_servomove"), asked + 6);
}

/// After a gap the arm stands: a set-point that goes on would make it jump. It is guarded twice, where the braking
/// begins (`brake`) and
/// before each of its set-points (`send_landing`): the test fails where both are missing.
#[test]
fn a_landing_after_a_gap_holds_the_arm_and_one_just_before_brakes_it() {
    for (late, is_gap) in [(Duration::from_millis(23), false), (GAP, true)] {
        let (arm, mut robot) = ready();
        let session = at_speed(&mut robot);
        arm.clock().sleep(CYCLE + late);
        let report = session.land().expect("it comes to rest").report;
        let steps = &steps(&arm)[RAMP as usize..];
        let brakes = steps.iter().filter(|step| **step != 0.0).count();
        let expected = if is_gap { 0 } else { RAMP as usize - 1 };
        assert_eq!((brakes, report.gaps), (expected, u64::from(is_gap)), "late by {late:?}: {steps:?}");
        assert_eq!(steps.last(), Some(&0.0), "it is held");
    }
}

#[test]
fn a_landing_ends_when_its_set_points_are_refused() {
    let (arm, mut robot) = ready();
    let session = at_speed(&mut robot);
    // Those before are answered when time goes on.
    arm.clock().sleep(CYCLE / 2);
    let refusal = br#"{"errorCode": "2", "errorMsg": "call servo_j failed", "cmdName": "servo_j"}"#;
    for _ in 0..1000 {
        arm.inject_for("servo_j", Fault::Instead(refusal.to_vec()));
    }
    let before = count(&arm, "servo_j");
    let error = session.land().expect_err("the controller follows none");
    assert!(error.is_refused(), "{error:?}");
    // The first refusal may be that of a set-point from before the landing.
    let sent = count(&arm, "servo_j") - before;
    assert!((1..=3).contains(&sent), "{sent} set-points");
    assert!(!arm.state().servo_mode);
}

/// A stop waits while the session brakes, and goes out as soon as the arm is held; nothing follows it.
#[test]
fn a_stop_goes_out_as_soon_as_the_arm_is_braked_and_no_set_point_after_it() {
    let (arm, mut robot) = ready();
    let (clock, stop) = (arm.clock().clone(), robot.stop_handle());
    // One of some time ago, for which nothing had to be braked.
    stop.stop().expect("the controller takes the stop");
    robot.acknowledge();
    clock.sleep(Duration::from_secs(5));
    let mut session = at_speed(&mut robot);
    let since = clock.elapsed();
    let mut stopped = Duration::ZERO;
    let stops = || {
        stop.stop().expect("the controller takes the stop");
        stopped = clock.elapsed().saturating_sub(since);
    };
    let error = beside(&clock, stops, || {
        let error = (0..100).find_map(|_| send(&mut session, step(RAMP)).err()).expect("it is stopped");
        drop(session);
        error
    });
    assert!(
        matches!(error.kind(), ErrorKind::NotAcknowledged { occurrence: Occurrence { cause: Cause::Stopped, .. } }),
        "{error:?}"
    );
    let names: Vec<_> = requests(&arm).into_iter().map(|request| request["cmdName"].clone()).collect();
    let stop_at = names.iter().rposition(|name| name == "stop_program").expect("it came");
    assert!(!names[stop_at..].iter().any(|name| name == "servo_j"), "{names:?}");
    let mut sent = steps(&arm);
    assert_eq!(sent.pop(), Some(0.0), "the last step takes its period: {sent:?}");
    assert!(!sent.contains(&0.0), "it is not held by set-points: {sent:?}");
    let braking = sent.iter().rev().take_while(|step_sent| **step_sent < step(RAMP) - 1e-9).count();
    assert_eq!(braking, RAMP as usize - 1, "{sent:?}");
    // It goes out a period after the last set-point that brakes, at the latest in the cycle after that.
    let cycles = u32::try_from(sent.len() - RAMP as usize).expect("few");
    assert!(stopped <= CYCLE * (cycles + 2), "after {stopped:?}, {cycles} cycles");
}

/// The arm is held by set-points while no packet shows rest. It is guarded twice, by each of the gates of set-points
/// that hold and that brake: the test
/// fails where both let them pass.
#[test]
fn no_set_point_that_holds_the_arm_follows_a_stop() {
    let (arm, mut robot) = Arm::simulated().status_period(Duration::from_millis(400)).with_robot();
    let (clock, stop) = (arm.clock().clone(), robot.stop_handle());
    let mut session = robot.enter_servo_mode(config()).expect("the arm is at rest");
    send(&mut session, 0.001).expect("answers come");
    let stops = || {
        // In the middle of a cycle.
        clock.sleep(10 * CYCLE + CYCLE / 2);
        stop.stop().expect("the controller takes the stop");
    };
    let landed = beside(&clock, stops, || session.land().and_then(End::at_rest));
    landed.expect("rest is seen");
    let names: Vec<_> = requests(&arm).into_iter().map(|request| request["cmdName"].clone()).collect();
    let stop_at = names.iter().position(|name| name == "stop_program").expect("it came");
    assert_eq!(names[stop_at - 1], "servo_j", "it was held: {names:?}");
    assert!(!names[stop_at..].iter().any(|name| name == "servo_j"), "{names:?}");
}

/// Packets from before the arm is held, and one packet alone, show no rest.
#[test]
fn rest_is_seen_by_two_packets_that_came_while_the_arm_was_held() {
    let period = Duration::from_millis(200);
    let (arm, mut robot) = Arm::simulated().status_period(period).with_robot();
    let monitor = Arc::clone(robot.monitor());
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest");
    send(&mut session, 0.001).expect("answers come");
    let before = monitor.statistics().packets;
    let since = arm.clock().elapsed();
    let end = session.land().expect("two packets show it");
    let took = arm.clock().elapsed().saturating_sub(since);
    assert!(end.cause() == Cause::Landed && end.rest == Rest::Packets && took >= period, "{took:?}");
    assert!(monitor.statistics().packets >= before + 2);
}

/// An arm that hangs behind its last set-point is not at rest there.
#[test]
fn an_arm_that_stands_somewhere_else_than_it_is_held_is_not_seen_at_rest() {
    let (arm, mut robot) = ready();
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest");
    send(&mut session, 0.001).expect("answers come");
    let mut elsewhere = arm.state().joint_position.0;
    elsewhere[2] += 1.0;
    arm.set_status([("joint_actual_position".to_owned(), Value::from(elsewhere.to_vec()))]);
    let error = session.land().expect_err("packets show it elsewhere");
    assert!(matches!(error.kind(), ErrorKind::RestNotSeen { .. }), "{error:?}");
    assert!(!arm.state().servo_mode);
}

/// A session whose switch was refused changes nothing: what another program needs is left as it is.
#[test]
fn servo_mode_that_was_refused_is_not_left() {
    let (arm, mut robot) = ready();
    let refusal = br#"{"errorCode": "2", "errorMsg": "call servo_move failed", "cmdName": "servo_move"}"#;
    arm.inject_for("servo_move", Fault::Instead(refusal.to_vec()));
    let error = robot.enter_servo_mode(config()).map(drop).expect_err("it is refused");
    assert!(error.is_refused(), "{error:?}");
    assert_eq!(count(&arm, "servo_move"), 1);
}

/// The last set-point before the landing is refused, which is not known when the landing begins: it goes on all the
/// same.
#[test]
fn a_refusal_of_a_set_point_from_before_the_landing_does_not_end_it() {
    let (arm, mut robot) = ready();
    let mut session = at_speed(&mut robot);
    // Those before are answered when time goes on.
    arm.clock().sleep(CYCLE / 2);
    let refusal = br#"{"errorCode": "2", "errorMsg": "call servo_j failed", "cmdName": "servo_j"}"#;
    arm.inject_for("servo_j", Fault::Instead(refusal.to_vec()));
    send(&mut session, step(RAMP)).expect("the refusal is noticed later");
    let error = session.land().expect_err("it is told at the end");
    assert!(error.is_refused(), "{error:?}");
    let steps = &steps(&arm)[RAMP as usize + 1..];
    let brakes = steps.iter().filter(|step| **step != 0.0).count();
    assert_eq!(brakes, RAMP as usize - 1, "{steps:?}");
}

/// Without packets rest is not seen: that is an error, unless the program has allowed motion without them. It is not
/// waited for longer than
/// until the status is stale.
#[test]
fn a_landing_without_packets_says_that_rest_was_not_seen() {
    for is_allowed in [false, true] {
        let (arm, robot) = ready();
        let mut robot = if is_allowed {
            robot.configured(&RobotConfig::new().allow_motion_without_status()).expect("it has no limits")
        } else {
            robot
        };
        let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest");
        arm.link(Port::Status).to_client().hold();
        send(&mut session, 0.001).expect("the last packet is fresh");
        let since = arm.clock().elapsed();
        let landed = session.land();
        let took = arm.clock().elapsed().saturating_sub(since);
        match landed {
            Ok(end) => {
                assert!(is_allowed && end.cause() == Cause::RestNotSeen && !end.rest.was_seen(), "{end:?}");
            }
            Err(error) => {
                assert!(matches!(error.kind(), ErrorKind::RestNotSeen { first: None, .. }), "{error:?}");
                assert!(!is_allowed);
            }
        }
        assert!((Duration::from_millis(400)..Duration::from_millis(700)).contains(&took), "{took:?}");
    }
}

/// From 100 deg/s the arm takes five seconds to brake.
#[test]
fn a_stop_waits_for_three_seconds_at_most_while_the_arm_brakes() {
    let (arm, mut robot) = ready();
    let (clock, stop) = (arm.clock().clone(), robot.stop_handle());
    let config = SessionConfig::new().unchecked().max_joint_acceleration(20.0);
    let mut session = robot.enter_servo_mode(&config).expect("the arm is at rest");
    let mut go = || session.send_joint_offset([0.0, 0.0, 0.0, 0.0, 0.0, 0.8]);
    go().expect("answers come");
    let (since, mut stopped) = (clock.elapsed(), Duration::ZERO);
    let stops = || {
        stop.stop().expect("the controller takes the stop");
        stopped = clock.elapsed().saturating_sub(since);
    };
    beside(&clock, stops, || (0..100).find_map(|_| go().err())).expect("it is stopped");
    assert_eq!(stopped, Duration::from_secs(3));
    let names: Vec<_> = requests(&arm).into_iter().map(|request| request["cmdName"].clone()).collect();
    let stop_at = names.iter().position(|name| name == "stop_program").expect("it came");
    // 3 s are 375 cycles.
    assert!(names[..stop_at].iter().filter(|name| *name == "servo_j").count() > 370, "it was braked");
    assert!(!names[stop_at..].iter().any(|name| name == "servo_j"), "{names:?}");
}

/// A stop on a link whose replies are held.
struct Stopped {
    /// Time from the call until the controller has the stop.
    came: Duration,
    /// Time from the call until it returns.
    took: Duration,
    accepted: Result<(), jaka_robot::Error>,
}

/// Stops a slow session on a link that holds replies for this long from then on, while the session does something.
fn stopped_without_replies(held: Duration, go_on: impl FnOnce(ServoSession<'_>)) -> Stopped {
    let (arm, mut robot) = ready();
    let (clock, stop) = (arm.clock().clone(), robot.stop_handle());
    let mut session = robot.enter_servo_mode(config()).expect("the arm is at rest");
    for _ in 0..10 {
        send(&mut session, 0.001).expect("answers come");
    }
    arm.link(Port::Command).to_client().hold();
    send(&mut session, 0.001).expect("it goes out");
    let since = clock.elapsed();
    let passed = || clock.elapsed().saturating_sub(since);
    let (mut came, mut stopped) = (Duration::ZERO, None);
    let watch = || {
        until(&clock, || requests(&arm).iter().any(|request| request["cmdName"] == "stop_program"));
        came = passed();
        clock.sleep(held.saturating_sub(came));
        arm.link(Port::Command).to_client().release();
    };
    let stops = || {
        let accepted = stop.stop();
        stopped = Some((passed(), accepted));
    };
    beside(&clock, watch, || beside(&clock, stops, || go_on(session)));
    let (took, accepted) = stopped.expect("the call has returned");
    Stopped { came, took, accepted }
}

/// The stop is written at once, and learns its outcome as soon as there is one. Where none comes, the session resets
/// the connection a second after it has asked to leave servo mode; a landing waits for the last answers before, as
/// long again.
#[test]
fn a_stop_on_a_link_that_stalls_goes_out_at_once_and_waits_no_longer_than_the_session() {
    let ms = Duration::from_millis;
    let goes_on = |mut session: ServoSession<'_>| {
        drop((0..2000).find_map(|_| send(&mut session, 0.001).err()).expect("it is stopped"));
    };
    let lands = |session: ServoSession<'_>| drop(session.land());
    for (held, reset_while_it_goes_on, reset_while_it_lands) in
        [(ms(300), None, None), (ms(1_500), Some(ms(1_100)), None), (LONG / 6, Some(ms(1_100)), Some(ms(2_100)))]
    {
        let cases = [
            ("goes on", stopped_without_replies(held, goes_on), reset_while_it_goes_on),
            ("lands", stopped_without_replies(held, lands), reset_while_it_lands),
        ];
        for (session, Stopped { came, took, accepted }, reset) in cases {
            let told =
                format!("{session}, replies held for {held:?}: came after {came:?}, took {took:?}: {accepted:?}");
            assert!(came <= CYCLE, "{told}");
            match reset {
                None => assert!(accepted.is_ok() && took == held, "{told}"),
                Some(reset) => {
                    assert!(accepted.is_err_and(|error| error.is_disconnected() && error.may_have_run()), "{told}");
                    assert!(took >= reset && took <= reset + CYCLE * 4, "{told}");
                }
            }
        }
    }
}
