//! Trajectories, followed: what the controller receives, read as JSON and compared with a curve that is computed here.
//! By simulated clocks.

mod ends;
mod filters;
mod random;

use std::time::Duration;

use jaka_robot::jaka_motion::{Checker, Frames, Limits, Model, TimedPoint, Trajectory, TrajectoryError};
use jaka_robot::types::JointPosition;
use jaka_robot::{Cause, End, ErrorKind, FollowConfig, FollowHandle, Robot, RobotConfig, ServoConfig, Unchecked};
use jaka_sim::Controller;
use jaka_tests::simulated::clock_of;
use jaka_tests::witness::curve::{Curve, Point, apart};
use jaka_tests::{Arm, ArmBuilder, Configured as _, LONG, followed};
use serde_json::Value;

use crate::received::{names, positions};

pub(crate) const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, 0.0];

const CYCLES: u32 = 4;
const PERIOD: f64 = 0.032;

/// In deg/s²; ours.
const ACCELERATION: f64 = 300.0;
/// In deg/s²; the default.
const STOP_ACCELERATION: f64 = 570.0;

pub(crate) fn limits() -> Limits {
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    limits.with_joint_accelerations([ACCELERATION; 6]).expect("above 0")
}

fn arm() -> ArmBuilder {
    Arm::simulated().at(START).status_period(Duration::from_millis(10))
}

pub(crate) fn ready() -> (Arm, Robot) {
    ready_with(arm(), limits())
}

fn ready_with(arm: ArmBuilder, limits: Limits) -> (Arm, Robot) {
    let (arm, robot) = arm.with_robot();
    (arm, robot.configured(&RobotConfig::new().limits(limits)).expect("it is this arm"))
}

/// An arm that lags by so much.
fn lagging(by: Duration) -> (Arm, Robot) {
    ready_with(arm().controller(|arm| arm.lag(by)), limits())
}

fn config() -> FollowConfig {
    FollowConfig::new().servo(ServoConfig::new().step_count(CYCLES))
}

/// For an arm that lags: it may be far behind its set-points, and takes its time to come to rest.
fn patient() -> FollowConfig {
    config().servo(ServoConfig::new().step_count(CYCLES).rest_timeout(LONG)).max_departure(1000.0)
}

/// To and fro with joints 1 and 6, from where the arm is.
pub(crate) fn to_and_fro() -> Curve {
    let at = |joint_1: f64, joint_6: f64| turned([joint_1, 0.0, 0.0, 0.0, 0.0, joint_6]);
    Curve::through(&[(0.0, at(0.0, 0.0)), (1.0, at(15.0, -20.0)), (2.0, at(-5.0, 10.0)), (3.0, at(5.0, 0.0))])
}

fn turned(by: [f64; 6]) -> [f64; 6] {
    std::array::from_fn(|joint| START[joint] + by[joint])
}

pub(crate) fn made(curve: &Curve) -> Trajectory {
    trajectory(curve, &Checker::new(limits(), Frames::new())).expect("within the limits")
}

pub(crate) fn trajectory(curve: &Curve, checker: &Checker) -> Result<Trajectory, TrajectoryError> {
    let point = |point: &Point| {
        TimedPoint::new(point.time_s, point.joints).with_velocity(point.speeds).with_acceleration([0.0; 6])
    };
    Trajectory::timed(&curve.points().iter().map(point).collect::<Vec<_>>(), checker)
}

/// The set-points that came, and the names of what came after the last of them.
fn set_points(controller: &Controller) -> (Vec<[f64; 6]>, Vec<String>) {
    positions(controller, CYCLES)
}

/// All that the controller received lies on the curve and within the limits.
fn judge(controller: &Controller, curve: &Curve, end: &End) -> Vec<[f64; 6]> {
    let (set_points, _) = set_points(controller);
    curve.has(&set_points).unwrap_or_else(|what| panic!("{what}: {end:?}"));
    assert_eq!(jump(START, &set_points), None, "{end:?}: {set_points:?}");
    let tail = &set_points[set_points.len().saturating_sub(2)..];
    assert!(end.error.is_some() || JointPosition(tail[0]) == JointPosition(tail[1]), "it is held at its end: {end:?}");
    assert_eq!((end.report.late_cycles, end.report.gaps), (0, 0), "{end:?}");
    set_points
}

/// The first set-point after standstill at which a joint is faster, or becomes so sooner, than it may.
pub(crate) fn jump(start: [f64; 6], set_points: &[[f64; 6]]) -> Option<usize> {
    let mut all = vec![start; 2];
    all.extend(set_points);
    let speeds = *limits().joint_speeds();
    all.windows(3).position(|three| {
        (0..6).any(|joint| {
            let first = (three[2][joint] - three[1][joint]) / PERIOD;
            let second = (three[2][joint] - 2.0 * three[1][joint] + three[0][joint]) / PERIOD.powi(2);
            let slows = first.abs() < (three[1][joint] - three[0][joint]).abs() / PERIOD;
            let most = if slows { STOP_ACCELERATION } else { ACCELERATION };
            first.abs() > speeds[joint] + 1e-6 || second.abs() > most + 1e-3
        })
    })
}

/// Waits until the trajectory is followed for so long of its own time.
pub(crate) fn wait_for(controller: &Controller, run: &FollowHandle, time_s: f64) {
    wait_until(controller, || run.progress().time.as_secs_f64() >= time_s || run.has_ended());
}

/// Waits until this is so.
fn wait_until(controller: &Controller, is_so: impl Fn() -> bool) {
    let clock = clock_of(controller);
    let since = clock.elapsed();
    while !is_so() {
        assert!(clock.elapsed().saturating_sub(since) < LONG);
        clock.sleep(Duration::from_millis(5));
    }
}

/// Nothing was sent that could move the arm, or lead to that.
fn assert_nothing_sent(controller: &Controller) {
    let names = names(controller);
    assert!(!names.iter().any(|name| name.contains("servo_")), "{names:?}");
    assert!(!controller.state().servo_mode);
}

#[test]
fn a_trajectory_is_followed_to_its_end() {
    let (arm, mut robot) = ready();
    let curve = to_and_fro();
    let config = config().deadline(LONG);
    let end = robot.start_follow(&made(&curve), &config).expect("the arm is at its start").wait();
    let set_points = judge(&arm, &curve, &end);
    assert_eq!(
        (end.cause(), followed(&end).reached, followed(&end).has_left_curve),
        (Cause::Reached, followed(&end).duration, false)
    );
    // One at the start, 94 on the way, and one that finds nothing more to do.
    assert!(end.rest.was_seen() && end.report.cycles == 96, "{end:?}");
    let there = curve.at(3.0);
    assert!(apart(set_points.last().expect("there are some"), &there) < 1e-9);
    assert!(arm.state().joint_position.max_distance(&JointPosition(there)) < 1e-6);
    assert!(!arm.state().servo_mode);
    let lag = followed(&end).lag.expect("the arm has moved");
    assert!(lag.packets > 50 && lag.residual_deg.iter().all(|degrees| *degrees < 1.5), "{lag:?}");
    end.reached().expect("it was");
    // From where it is now, with the defaults.
    let error = robot.follow(&made(&curve), LONG).expect_err("it is at the end");
    assert!(matches!(error.kind(), ErrorKind::NotAtStart { joint: 1, .. }), "{error:?}");
}

#[test]
fn it_pauses_goes_slower_and_goes_on_along_the_trajectory() {
    let (arm, mut robot) = ready();
    let curve = to_and_fro();
    let run = robot.start_follow(&made(&curve), &config().speed_scale(0.8)).expect("the arm is at its start");
    let handle = run.handle();
    wait_for(&arm, &handle, 0.7);
    handle.pause().expect("it goes on");
    wait_until(&arm, || run.handle().progress().rate == 0.0);
    let stands = run.handle().progress();
    // A pause goes on whatever the speed is.
    handle.set_speed_scale(0.4).expect("it goes on");
    arm.clock().sleep(Duration::from_millis(200));
    assert_eq!(run.handle().progress(), stands);
    handle.resume().expect("it goes on");
    wait_for(&arm, &handle, 1.5);
    assert!(run.handle().progress().rate <= 0.4 + 1e-12);
    handle.set_speed_scale(1.0).expect("it goes on");
    let end = run.wait();
    judge(&arm, &curve, &end);
    assert_eq!(end.cause(), Cause::Reached, "{end}");
    let error = handle.pause().expect_err("it has ended");
    assert_eq!(error.to_string(), "not sent, because the servo session has ended: the motion has reached its target");
    assert!(handle.has_ended());
}

#[test]
fn a_scale_that_is_none_is_refused_and_the_run_goes_on() {
    let (_arm, mut robot) = ready();
    let run = robot.start_follow(&made(&to_and_fro()), &config()).expect("the arm is at its start");
    for scale in [-0.1, 1.01, f64::NAN] {
        let error = run.handle().set_speed_scale(scale).expect_err("it is not from 0 to 1");
        assert!(error.to_string().starts_with("option `speed_scale` of `FollowHandle` is "), "{error}");
    }
    run.handle().stop().expect("it goes on");
    assert_eq!(run.wait().cause(), Cause::Stopped);
    for config in [config().speed_scale(2.0), config().approach(0.0), config().max_departure(f64::NAN)] {
        let error = robot.start_follow(&made(&to_and_fro()), &config).expect_err("it makes no sense");
        assert!(error.is_invalid_argument(), "{error}");
    }
}

#[test]
fn a_start_elsewhere_is_refused_unless_an_approach_is_asked_for() {
    let (arm, mut robot) = ready();
    arm.set_state(|state| state.joint_position = JointPosition(turned([0.0, 0.0, -2.0, 0.0, 0.0, 1.5])));
    let curve = to_and_fro();
    let error = robot.start_follow(&made(&curve), &config()).expect_err("the arm is elsewhere");
    assert_eq!(
        error.to_string(),
        "the trajectory was not started: it starts with joint 3 at 80.000 deg, but the joint is at 78.000 deg, 2.000 deg away; move the arm there \
         first, or set an approach (`FollowConfig::approach`)"
    );
    assert_nothing_sent(&arm);
    let end = robot.start_follow(&made(&curve), &config().approach(10.0)).expect("the way is free").wait();
    assert_eq!(end.cause(), Cause::Reached, "{end}");
    let (set_points, _) = set_points(&arm);
    let begins = set_points.iter().position(|joints| *joints == START).expect("it was at the start");
    assert_eq!(JointPosition(set_points[begins + 1]), JointPosition(START), "it stands there before it goes on");
    curve.has(&set_points[begins..]).expect("from there on it is on the curve");
    let steps = set_points[..=begins].windows(2);
    let fastest = steps.flat_map(|two| (0..6).map(|joint| (two[1][joint] - two[0][joint]).abs())).fold(0.0, f64::max);
    assert!(fastest > 0.0 && fastest <= 10.0 * PERIOD + 1e-9, "{fastest}");
}

#[test]
fn an_approach_gets_to_a_start_that_rounding_has_beyond_a_limit() {
    let (arm, robot) = arm().with_robot();
    arm.set_state(|state| state.joint_position.0[5] = 14.0);
    let narrow = limits().with_joint_range(6, -15.0, 15.0).expect("a range");
    let mut robot = robot.configured(&RobotConfig::new().limits(narrow)).expect("it is this arm");
    // Within what the check takes for rounding.
    let [start, end] = [15.000_005, 5.0].map(|joint_6| turned([0.0, 0.0, 0.0, 0.0, 0.0, joint_6]));
    let curve = Curve::through(&[(0.0, start), (2.0, end)]);
    let trajectory = trajectory(&curve, robot.limits().expect("it has some")).expect("within the limits");
    let config = config().approach(10.0).deadline(Duration::from_secs(20));
    let end = robot.start_follow(&trajectory, &config).expect("the way is free").wait();
    assert_eq!(end.cause(), Cause::Reached, "{end:?}");
    let (set_points, _) = set_points(&arm);
    let begins = set_points.iter().position(|joints| apart(joints, &start) == 0.0).expect("it was at the start");
    curve.has(&set_points[begins..]).expect("from there on it is on the curve");
}

#[test]
fn a_hundredth_of_a_degree_is_what_controllers_round_off() {
    let (arm, mut robot) = ready();
    arm.set_state(|state| state.joint_position = JointPosition(turned([0.0, 0.004, 0.0, 0.0, -0.009, 0.0])));
    let end = robot.start_follow(&made(&to_and_fro()), &config()).expect("the arm is at its start").wait();
    assert_eq!(end.cause(), Cause::Reached, "{end}");
    let (mut all, _) = set_points(&arm);
    all.insert(0, turned([0.0, 0.004, 0.0, 0.0, -0.009, 0.0]));
    let jumps = all.windows(2).take(5).flat_map(|two| (0..6).map(|joint| (two[1][joint] - two[0][joint]).abs()));
    assert!(jumps.fold(0.0, f64::max) < ACCELERATION * PERIOD * PERIOD);
}

#[test]
fn what_is_beyond_a_limit_is_refused_before_anything_is_sent() {
    let (arm, robot) = arm().with_robot();
    let narrow = limits().with_joint_range(6, -15.0, 15.0).expect("a range");
    let mut robot = robot.configured(&RobotConfig::new().limits(narrow)).expect("it is this arm");
    let error = robot.start_follow(&made(&to_and_fro()), &config()).expect_err("joint 6 goes to -20 deg");
    let text = error.to_string();
    assert!(matches!(error.kind(), ErrorKind::Trajectory { .. }), "{error:?}");
    assert!(text.starts_with("the trajectory was not started: after way-point 1, at 0."), "{text}");
    assert!(text.contains("joint 6 would be at -") && text.ends_with("; limit -15 (Zu 5)"), "{text}");
    assert_nothing_sent(&arm);
    // Nor on the way to its start.
    let within = Curve::through(&[(0.0, START), (1.0, turned([3.0, 0.0, 0.0, 0.0, 0.0, 0.0]))]);
    arm.set_state(|state| state.joint_position.0[5] = -20.0);
    let error = robot.start_follow(&made(&within), &config()).expect_err("it is 20 deg away");
    assert!(matches!(error.kind(), ErrorKind::NotAtStart { joint: 6, .. }), "{error:?}");
    assert_nothing_sent(&arm);
}

#[test]
fn a_robot_without_limits_follows_nothing() {
    let (arm, mut robot) = arm().with_robot();
    let error = robot.start_follow(&made(&to_and_fro()), &config()).expect_err("it has none");
    assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::NoLimits, .. }), "{error:?}");
    assert_nothing_sent(&arm);
}

#[test]
fn what_is_off_the_curve_is_noticed() {
    let curve = Curve::through(&[(0.0, [0.0; 6]), (1.0, [10.0, 0.0, 0.0, 0.0, 0.0, -5.0]), (2.0, [0.0; 6])]);
    let times = [0.0, 0.1, 0.5, 0.9, 1.3, 2.0];
    let on_it = times.map(|time_s| curve.at(time_s));
    let found = curve.has(&on_it).expect("they are on it");
    assert!(found.iter().zip(times).all(|(found, time_s)| (found - time_s).abs() < 1e-2), "{found:?}");
    for (index, joint) in [(1, 0), (2, 3), (4, 5)] {
        let mut off = on_it;
        off[index][joint] += 3e-6;
        assert!(curve.has(&off).is_err_and(|what| what.starts_with(&format!("set-point {index} "))));
    }
    // Nor may it go back.
    assert!(curve.has(&[on_it[2], on_it[1], on_it[3]]).is_err());
}
