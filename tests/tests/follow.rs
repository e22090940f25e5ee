//! Trajectories, followed: what the controller receives, read as JSON and compared with a curve that is computed here. By simulated clocks, where nothing
//! is about real ones.

mod curve;
mod ends;
mod filters;
mod random;

use std::time::Duration;

use jaka_sim::{Builder, Controller, Delays, SimulatedClock};
use jaka_sync::jaka_motion::{Checker, Frames, Limits, Model, Trajectory};
use jaka_sync::types::JointPosition;
use jaka_sync::{
    Config, ErrorKind, FollowConfig, FollowEnd, FollowHandle, FollowOutcome, Robot, ServoConfig, Unchecked,
};
use jaka_tests::simulated::clock_of;
use serde_json::Value;

use self::curve::Curve;

const LONG: Duration = Duration::from_secs(60);
const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, 0.0];

/// Four cycles, so that a busy machine seldom leaves the arm without a set-point for three periods.
const CYCLES: u32 = 4;
const PERIOD: f64 = 0.032;

/// In deg/s²; ours.
const ACCELERATION: f64 = 300.0;

fn limits() -> Limits {
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    limits.with_joint_accelerations([ACCELERATION; 6]).expect("above 0")
}

fn ready() -> (Controller, Robot) {
    ready_of(Controller::builder(), Config::new())
}

fn ready_of(builder: Builder, config: Config) -> (Controller, Robot) {
    with_limits(plain_of(builder, config))
}

/// By the clock of the system.
fn ready_in_real_time() -> (Controller, Robot) {
    with_limits(connected(Controller::builder(), &Config::new().stale_after(LONG)))
}

fn with_limits((controller, robot): (Controller, Robot)) -> (Controller, Robot) {
    (controller, robot.with_limits(limits()).expect("it is this arm"))
}

fn plain() -> (Controller, Robot) {
    plain_of(Controller::builder(), Config::new())
}

fn plain_of(builder: Builder, config: Config) -> (Controller, Robot) {
    let clock = SimulatedClock::new();
    connected(builder.clock(&clock), &config.clock(&clock))
}

fn connected(builder: Builder, config: &Config) -> (Controller, Robot) {
    let controller = builder.delays(Delays::NONE).status_period(Duration::from_millis(10)).start();
    let controller = controller.expect("loopback has free ports");
    controller.set_state(|state| {
        (state.powered, state.enabled) = (true, true);
        state.joint_position = JointPosition(START);
    });
    let monitor = config.connect_monitor(controller.status_addr()).expect("the controller listens");
    let client = config.connect_client(controller.command_addr()).expect("the controller listens");
    (controller, Robot::new(client, monitor))
}

fn patient() -> FollowConfig {
    let servo = ServoConfig::new().step_count(CYCLES).max_unanswered(LONG).rest_timeout(LONG);
    FollowConfig::new().servo(servo).max_gap(LONG).max_departure(1000.0)
}

/// To and fro with joints 1 and 6, from where the arm is.
fn to_and_fro() -> Curve {
    let at = |joint_1: f64, joint_6: f64| turned([joint_1, 0.0, 0.0, 0.0, 0.0, joint_6]);
    Curve::through(&[(0.0, at(0.0, 0.0)), (1.0, at(15.0, -20.0)), (2.0, at(-5.0, 10.0)), (3.0, at(5.0, 0.0))])
}

fn turned(by: [f64; 6]) -> [f64; 6] {
    std::array::from_fn(|joint| START[joint] + by[joint])
}

fn made(curve: &Curve) -> Trajectory {
    curve.trajectory(&Checker::new(limits(), Frames::new())).expect("within the limits")
}

/// The set-points that came, all absolute; and the names of what came after the last of them.
fn set_points(controller: &Controller) -> (Vec<[f64; 6]>, Vec<String>) {
    let requests: Vec<Value> =
        controller.requests().iter().map(|text| serde_json::from_str(text).expect("requests are JSON")).collect();
    let is_set_point = |request: &&Value| request["cmdName"] == "servo_j";
    let last = requests.iter().rposition(|request| is_set_point(&request)).expect("set-points came");
    let joints = |request: &Value| {
        assert_eq!((&request["relFlag"], &request["stepNum"]), (&0.into(), &CYCLES.into()));
        std::array::from_fn(|joint| request["jointPosition"][joint].as_f64().expect("a number"))
    };
    let name = |request: &Value| request["cmdName"].as_str().expect("a name").to_owned();
    (requests.iter().filter(is_set_point).map(joints).collect(), requests[last + 1..].iter().map(name).collect())
}

/// All that the controller received lies on the curve and within the limits; so many set-points at the end may be off the curve.
fn judge(controller: &Controller, curve: &Curve, end: &FollowEnd) -> Vec<[f64; 6]> {
    let (set_points, _) = set_points(controller);
    curve.has(&set_points).unwrap_or_else(|what| panic!("{what}: {end:?}"));
    let stood = within_limits(&set_points);
    assert!(stood <= end.report.gaps, "{end:?}");
    let tail = &set_points[set_points.len().saturating_sub(2)..];
    assert!(end.error.is_some() || JointPosition(tail[0]) == JointPosition(tail[1]), "it is held at its end: {end:?}");
    set_points
}

/// Fails where a joint is faster, or becomes so sooner, than it may. Says how often the arm stood because the machine was too busy to send
/// set-points: then it begins again from standstill.
fn within_limits(set_points: &[[f64; 6]]) -> u64 {
    let mut all = vec![START; 2];
    all.extend(set_points);
    let speeds = *limits().joint_speeds();
    let mut stood = 0;
    for (index, three) in all.windows(3).enumerate() {
        let first = |joint: usize| (three[2][joint] - three[1][joint]) / PERIOD;
        let second = |joint: usize| (three[2][joint] - 2.0 * three[1][joint] + three[0][joint]) / PERIOD.powi(2);
        let fits = |value: &dyn Fn(usize) -> f64| (0..6).all(|joint| value(joint).abs() <= ACCELERATION + 1e-3);
        assert!((0..6).all(|joint| first(joint).abs() <= speeds[joint] + 1e-6), "set-point {index}: {three:?}");
        if !fits(&second) {
            assert!(fits(&|joint| first(joint) / PERIOD), "set-point {index} jumps: {three:?}");
            stood += 1;
        }
    }
    stood
}

/// How far two joint positions are apart, in degrees.
fn apart(one: &[f64; 6], other: &[f64; 6]) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

/// Waits until the trajectory is followed for so long of its own time.
fn wait_for(controller: &Controller, run: &FollowHandle, time_s: f64) {
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

fn names(controller: &Controller) -> Vec<String> {
    let name = |text: &String| {
        let request: Value = serde_json::from_str(text).expect("requests are JSON");
        request["cmdName"].as_str().expect("a name").to_owned()
    };
    controller.requests().iter().map(name).collect()
}

/// Nothing was sent that could move the arm, or lead to that.
fn assert_nothing_sent(controller: &Controller) {
    let names = names(controller);
    assert!(!names.iter().any(|name| name.contains("servo_")), "{names:?}");
    assert!(!controller.state().servo_mode);
}

#[test]
fn a_trajectory_is_followed_to_its_end() {
    let (controller, mut robot) = ready_in_real_time();
    let curve = to_and_fro();
    let config = patient().deadline(LONG);
    let end = robot.start_follow(&made(&curve), &config).expect("the arm is at its start").wait();
    let set_points = judge(&controller, &curve, &end);
    assert_eq!((end.outcome, end.reached, end.has_left_curve), (FollowOutcome::Completed, end.duration, false));
    assert!(end.is_at_rest() && end.report.cycles >= 94, "{end:?}");
    let there = curve.at(3.0);
    assert!(apart(set_points.last().expect("there are some"), &there) < 1e-9);
    assert!(controller.state().joint_position.max_distance(&JointPosition(there)) < 1e-6);
    assert!(!controller.state().servo_mode);
    let lag = end.lag.expect("the arm has moved");
    assert!(lag.packets > 50 && lag.residual_deg.iter().all(|degrees| *degrees < 1.5), "{lag:?}");
    end.completed().expect("it was");
    // From where it is now, with the defaults, on a machine that may be busy.
    let error = robot.follow(&made(&curve), LONG).expect_err("it is at the end");
    assert!(matches!(error.kind(), ErrorKind::NotAtStart { joint: 1, .. }), "{error:?}");
}

#[test]
fn it_pauses_goes_slower_and_goes_on_along_the_trajectory() {
    let (controller, mut robot) = ready();
    let curve = to_and_fro();
    let run = robot.start_follow(&made(&curve), &patient().speed_scale(0.8)).expect("the arm is at its start");
    let handle = run.handle();
    wait_for(&controller, &handle, 0.7);
    handle.pause().expect("it goes on");
    wait_until(&controller, || run.progress().rate == 0.0);
    let stands = run.progress();
    // A pause goes on whatever the speed is.
    handle.set_speed_scale(0.4).expect("it goes on");
    clock_of(&controller).sleep(Duration::from_millis(200));
    assert_eq!(run.progress(), stands);
    handle.resume().expect("it goes on");
    wait_for(&controller, &handle, 1.5);
    assert!(run.progress().rate <= 0.4 + 1e-12);
    handle.set_speed_scale(1.0).expect("it goes on");
    let end = run.wait();
    judge(&controller, &curve, &end);
    assert_eq!(end.outcome, FollowOutcome::Completed, "{end}");
    let error = handle.pause().expect_err("it has ended");
    assert_eq!(error.to_string(), "not sent, because the servo session has ended: the trajectory was completed");
    assert!(handle.has_ended());
}

#[test]
fn a_scale_that_is_none_is_refused_and_the_run_goes_on() {
    let (_controller, mut robot) = ready();
    let run = robot.start_follow(&made(&to_and_fro()), &patient()).expect("the arm is at its start");
    for scale in [-0.1, 1.01, f64::NAN] {
        let error = run.set_speed_scale(scale).expect_err("it is not from 0 to 1");
        assert!(error.to_string().contains("field `speed_scale`"), "{error}");
    }
    run.stop().expect("it goes on");
    assert_eq!(run.wait().outcome, FollowOutcome::Stopped);
    for config in [patient().speed_scale(2.0), patient().approach(0.0), patient().max_departure(f64::NAN)] {
        let error = robot.start_follow(&made(&to_and_fro()), &config).expect_err("it makes no sense");
        assert!(error.is_invalid_argument(), "{error}");
    }
}

#[test]
fn a_start_elsewhere_is_refused_unless_an_approach_is_asked_for() {
    let (controller, mut robot) = ready();
    controller.set_state(|state| state.joint_position = JointPosition(turned([0.0, 0.0, -2.0, 0.0, 0.0, 1.5])));
    let curve = to_and_fro();
    let error = robot.start_follow(&made(&curve), &patient()).expect_err("the arm is elsewhere");
    assert_eq!(
        error.to_string(),
        "the trajectory was not started: it starts with joint 3 at 80.000 deg, and the arm has it at 78.000 deg, 2.000 deg away; move the arm there \
         first, or ask for an approach"
    );
    assert_nothing_sent(&controller);
    let end = robot.start_follow(&made(&curve), &patient().approach(10.0)).expect("the way is free").wait();
    assert_eq!(end.outcome, FollowOutcome::Completed, "{end}");
    let (set_points, _) = set_points(&controller);
    let begins = set_points.iter().position(|joints| *joints == START).expect("it was at the start");
    assert_eq!(JointPosition(set_points[begins + 1]), JointPosition(START), "it stands there before it goes on");
    curve.has(&set_points[begins..]).expect("from there on it is on the curve");
    let steps = set_points[..=begins].windows(2);
    let fastest = steps.flat_map(|two| (0..6).map(|joint| (two[1][joint] - two[0][joint]).abs())).fold(0.0, f64::max);
    assert!(fastest > 0.0 && fastest <= 10.0 * PERIOD + 1e-9, "{fastest}");
}

#[test]
fn an_approach_that_does_not_get_to_the_start_ends() {
    let (controller, robot) = plain();
    controller.set_state(|state| state.joint_position.0[5] = 14.0);
    let narrow = limits().with_joint_range(6, -15.0, 15.0).expect("a range");
    let mut robot = robot.with_limits(narrow).expect("it is this arm");
    // Within what the check takes for rounding.
    let [start, end] = [15.000_005, 5.0].map(|joint_6| turned([0.0, 0.0, 0.0, 0.0, 0.0, joint_6]));
    let curve = Curve::through(&[(0.0, start), (2.0, end)]);
    let trajectory = curve.trajectory(robot.limits().expect("it has some")).expect("within the limits");
    let config = patient().approach(10.0).deadline(Duration::from_secs(20));
    let end = robot.start_follow(&trajectory, &config).expect("the way is free").wait();
    assert_eq!((end.outcome, end.reached), (FollowOutcome::Failed, Duration::ZERO), "{end:?}");
    assert!(end.is_at_rest(), "{end:?}");
    let error = end.error.as_ref().expect("it says why");
    assert!(matches!(error.kind(), ErrorKind::NotAtStart { joint: 6, .. }), "{error:?}");
    assert!(error.to_string().contains("at 15.000005 deg, and the arm has it at 15.000000 deg"), "{error}");
}

#[test]
fn a_hundredth_of_a_degree_is_what_controllers_round_off() {
    let (controller, mut robot) = ready();
    controller.set_state(|state| state.joint_position = JointPosition(turned([0.0, 0.004, 0.0, 0.0, -0.009, 0.0])));
    let end = robot.start_follow(&made(&to_and_fro()), &patient()).expect("the arm is at its start").wait();
    assert_eq!(end.outcome, FollowOutcome::Completed, "{end}");
    let (mut all, _) = set_points(&controller);
    all.insert(0, turned([0.0, 0.004, 0.0, 0.0, -0.009, 0.0]));
    let jumps = all.windows(2).take(5).flat_map(|two| (0..6).map(|joint| (two[1][joint] - two[0][joint]).abs()));
    assert!(jumps.fold(0.0, f64::max) < ACCELERATION * PERIOD * PERIOD);
}

#[test]
fn what_is_beyond_a_limit_is_refused_before_anything_is_sent() {
    let (controller, robot) = plain();
    let narrow = limits().with_joint_range(6, -15.0, 15.0).expect("a range");
    let mut robot = robot.with_limits(narrow).expect("it is this arm");
    let error = robot.start_follow(&made(&to_and_fro()), &patient()).expect_err("joint 6 goes to -20 deg");
    let text = error.to_string();
    assert!(matches!(error.kind(), ErrorKind::Trajectory { .. }), "{error:?}");
    assert!(text.starts_with("the trajectory was not started: after way-point 1, at 0."), "{text}");
    assert!(text.contains("joint 6 would be at -") && text.ends_with("; limit -15 (Zu 5)"), "{text}");
    assert_nothing_sent(&controller);
    // Nor on the way to its start.
    let within = Curve::through(&[(0.0, START), (1.0, turned([3.0, 0.0, 0.0, 0.0, 0.0, 0.0]))]);
    controller.set_state(|state| state.joint_position.0[5] = -20.0);
    let error = robot.start_follow(&made(&within), &patient()).expect_err("it is 20 deg away");
    assert!(matches!(error.kind(), ErrorKind::NotAtStart { joint: 6, .. }), "{error:?}");
    assert_nothing_sent(&controller);
}

#[test]
fn a_robot_without_limits_follows_nothing() {
    let (controller, mut robot) = plain();
    let error = robot.start_follow(&made(&to_and_fro()), &patient()).expect_err("it has none");
    assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::NoLimits, .. }), "{error:?}");
    assert_nothing_sent(&controller);
}
