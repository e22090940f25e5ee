//! Streams: what the controller receives, read as JSON and differenced by index.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::thread;
use std::time::{Duration, Instant};

use jaka_sim::{Builder, Controller, Delays, Port, SimulatedClock, Trip, Underrun};
use jaka_sync::jaka_motion::{Bound, Limits, Model, Region, TcpVelocity, VelocityFrame};
use jaka_sync::servo::SetServoMoveFilter;
use jaka_sync::types::JointPosition;
use jaka_sync::{Config, ErrorKind, Explanation, Robot, ServoConfig, StreamConfig, StreamHandle, Unchecked};
use jaka_tests::simulated::clock_of;
use serde_json::Value;

use crate::limits::random::Random;

const LONG: Duration = Duration::from_secs(60);
const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, 0.0];

/// Four cycles, so that a busy machine seldom leaves the arm without a set-point for three periods.
const CYCLES: u32 = 4;
const PERIOD: f64 = 0.032;

/// What the limits allow of each joint of a Zu 5: 180 deg/s, and accelerations and jerks that are ours.
const SPEED: f64 = 180.0;
const ACCELERATION: f64 = 720.0 / 10.0;
const JERK: f64 = ACCELERATION * 10.0;

fn ready() -> (Controller, Robot) {
    ready_with(limits(), &Config::new().stale_after(LONG))
}

fn limits() -> Limits {
    Limits::of(Model::named("Zu 5").expect("a published arm"))
}

fn ready_with(limits: Limits, config: &Config) -> (Controller, Robot) {
    let (controller, robot) = plain(config);
    (controller, robot.with_limits(limits).expect("it is this arm"))
}

fn plain(config: &Config) -> (Controller, Robot) {
    of_builder(Controller::builder(), config)
}

fn of_builder(builder: Builder, config: &Config) -> (Controller, Robot) {
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

fn patient() -> StreamConfig {
    let servo = ServoConfig::new().step_count(CYCLES).max_unanswered(LONG).rest_timeout(LONG);
    StreamConfig::new().servo(servo).max_gap(LONG).max_departure(1000.0)
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

/// Fails where a joint is faster, or becomes so sooner, than it may. Says how often the arm stood because the machine was too busy to send
/// set-points: then it stops at once and begins again from standstill.
fn smooth(set_points: &[[f64; 6]]) -> usize {
    let mut all = vec![START; 3];
    all.extend(set_points);
    let rounding = 1e-6;
    let (mut stood, mut since) = (0, 3);
    for (index, four) in all.windows(4).enumerate() {
        let [a, b, c, d] = four else { unreachable!("windows of four") };
        let first = |joint: usize| (d[joint] - c[joint]) / PERIOD;
        let second = |joint: usize| (d[joint] - 2.0 * c[joint] + b[joint]) / PERIOD.powi(2);
        let third = |joint: usize| (d[joint] - 3.0 * c[joint] + 3.0 * b[joint] - a[joint]) / PERIOD.powi(3);
        // After a standstill: as if it had been where it is for long.
        let anew = |joint: usize| (d[joint] - c[joint]) / PERIOD.powi(2);
        since += 1;
        assert!((0..6).all(|joint| first(joint).abs() <= SPEED + rounding), "set-point {index} is too fast: {four:?}");
        let is_within = (0..6).all(|joint| {
            let second_fits = since < 2 || second(joint).abs() <= ACCELERATION + rounding;
            let third_fits = since < 3 || third(joint).abs() <= JERK + rounding;
            second_fits && third_fits
        });
        if !is_within {
            assert!(
                (0..6).all(|joint| anew(joint).abs() <= ACCELERATION + rounding),
                "set-point {index} jumps: {four:?}"
            );
            (stood, since) = (stood + 1, 1);
        }
    }
    stood
}

fn turned(joint: usize, by: f64) -> [f64; 6] {
    let mut joints = START;
    joints[joint - 1] += by;
    joints
}

/// Until joint 6 is on its way to 60 deg further.
fn speed_up(stream: &StreamHandle) {
    speed_up_by(stream, thread::sleep);
}

fn speed_up_by(stream: &StreamHandle, sleep: impl Fn(Duration)) {
    stream.set_joints(turned(6, 60.0)).expect("within its range");
    let since = Instant::now();
    while stream.joints()[5] - START[5] < 5.0 {
        assert!(since.elapsed() < LONG);
        sleep(Duration::from_millis(5));
    }
}

/// Its thread goes on, and a second one's set-points between its own would make the arm jump.
#[test]
fn a_stream_that_was_forgotten_keeps_a_second_one_from_beginning() {
    let (_controller, mut robot) = ready();
    let stream = robot.stream(&patient()).expect("the arm is ready");
    let handle = stream.handle();
    std::mem::forget(stream);
    let error = robot.stream(&patient()).expect_err("the first one goes on");
    assert!(matches!(error.kind(), ErrorKind::NotReady { explanation: Explanation::ServoModeOn }), "{error}");
    handle.set_joints(turned(6, 1.0)).expect("it goes on");
    assert!(handle.wait_for_rest(LONG).expect("it goes on"));
}

#[test]
fn a_stream_says_what_holds_it() {
    let (_controller, mut robot) = ready();
    let stream = robot.stream(&patient()).expect("the arm is ready");
    assert_eq!(stream.bound(), None);
    let upwards =
        TcpVelocity { linear_mm_s: [0.0, 0.0, 300.0], angular_deg_s: [0.0; 3], frame: VelocityFrame::ArmBase };
    let since = Instant::now();
    let bound = loop {
        stream.set_tcp_velocity(upwards, Duration::from_millis(500)).expect("it goes on");
        if let Some(bound) = stream.bound() {
            break bound;
        }
        assert!(since.elapsed() < LONG);
        thread::sleep(Duration::from_millis(20));
    };
    assert!(matches!(bound, Bound::Limit(_)), "the arm's reach ends somewhere: {bound:?}");
    drop(stream.land().expect("it lands"));
}

#[test]
fn targets_and_velocities_of_many_threads_make_one_smooth_motion() {
    let (controller, mut robot) = ready();
    let stream = robot.stream(&patient()).expect("the arm is ready");
    thread::scope(|scope| {
        for seed in 0..3 {
            let handle = stream.handle();
            scope.spawn(move || {
                let mut random = Random::new(seed);
                let mut between = move |least: f64, most: f64| random.between(least, most);
                for _ in 0..25 {
                    let wait = Duration::from_millis(100);
                    let given = match between(0.0, 4.0) {
                        0.0..1.0 => handle.set_joints(START.map(|joint| joint + between(-20.0, 20.0))),
                        1.0..2.0 => handle.set_joint_velocity(START.map(|_| between(-60.0, 60.0)), wait),
                        2.0..3.0 => {
                            let linear_mm_s = [0.0; 3].map(|_: f64| between(-200.0, 200.0));
                            let angular_deg_s = [0.0; 3].map(|_: f64| between(-30.0, 30.0));
                            let frame = VelocityFrame::User;
                            handle.set_tcp_velocity(TcpVelocity { linear_mm_s, angular_deg_s, frame }, wait)
                        }
                        _ => handle.rest(),
                    };
                    // Joint positions at random may be beyond a range.
                    assert!(
                        given.is_ok()
                            || given.is_err_and(|error| matches!(error.kind(), ErrorKind::BeyondLimit { .. }))
                    );
                    thread::sleep(Duration::from_millis(30));
                }
            });
        }
    });
    let report = stream.land().expect("it comes to rest");
    let (set_points, after) = set_points(&controller);
    assert!(smooth(&set_points) as u64 <= report.gaps, "{report:?}");
    assert!(set_points.iter().any(|joints| joints.iter().zip(START).any(|(at, from)| (at - from).abs() > 1.0)));
    assert_eq!(set_points.last(), set_points.get(set_points.len() - 2), "it is held at its end");
    assert_eq!((&*after[0], controller.state().servo_mode), ("servo_move", false));
    assert_eq!(set_points.len() as u64, report.cycles + report.landing_cycles);
}

#[test]
fn a_target_is_reached_and_the_arm_is_there() {
    let (controller, mut robot) = ready();
    let stream = robot.stream(&patient()).expect("the arm is ready");
    stream.set_joints(turned(6, 8.0)).expect("within its range");
    assert!(stream.wait_for_rest(LONG).expect("it goes on"));
    assert!(stream.joints().max_distance(&JointPosition(turned(6, 8.0))) < 1e-5);
    let pose = controller.state().tcp_pose;
    drop(stream);
    assert!(controller.state().joint_position.max_distance(&JointPosition(turned(6, 8.0))) < 1e-5);
    // To where it is, and 20 mm up, by the arm's own inverse.
    let stream = robot.stream(&patient()).expect("the arm is ready");
    let before = controller.state().tcp_pose;
    stream.set_pose(jaka_sync::types::Pose { z: before.z + 20.0, ..before }).expect("within reach");
    assert!(stream.wait_for_rest(LONG).expect("it goes on"));
    stream.land().expect("it is at rest");
    let up = controller.state().tcp_pose;
    assert!((up.z - before.z - 20.0).abs() < 0.01 && (up.x - before.x).abs() < 0.01, "{pose:?} {before:?} {up:?}");
}

#[test]
fn what_may_not_be_is_refused_at_once_and_the_stream_goes_on() {
    let floor = Region::half_space("floor", [0.0, 0.0, 50.0], [0.0, 0.0, 1.0]).expect("a plane");
    let (_controller, mut robot) =
        ready_with(limits().with_region(floor).expect("the only one"), &Config::new().stale_after(LONG));
    let stream = robot.stream(&patient()).expect("the arm is ready");
    let error = stream.set_joints(turned(3, 120.0)).expect_err("beyond its range");
    assert!(error.to_string().starts_with("`servo_j` was not sent: joint 3 would be at 200 deg; limit"), "{error}");
    let error =
        stream.set_joint_velocity([200.0, 0.0, 0.0, 0.0, 0.0, 0.0], Duration::from_millis(100)).expect_err("too fast");
    assert!(matches!(error.kind(), ErrorKind::BeyondLimit { .. }) && error.to_string().contains("200"), "{error}");
    let error = stream.set_joint_velocity([1.0; 6], Duration::from_secs(1)).expect_err("too long");
    assert_eq!(
        error.to_string(),
        "`servo_j` was not sent: field `for_at_most` is 1s, allowed is at most 500ms: give the velocity again for as long as it is wanted"
    );
    stream.set_joints(turned(6, 1.0)).expect("within its range");
    let handle = stream.handle();
    stream.land().expect("it comes to rest");
    let error = handle.set_joints(START).expect_err("it has ended");
    assert_eq!(error.to_string(), "not sent, because the servo session has ended: it has landed");
}

#[test]
fn a_stream_needs_limits() {
    let (controller, mut robot) = plain(&Config::new().stale_after(LONG));
    let error = robot.stream(&patient()).expect_err("it has none");
    assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::NoLimits, .. }), "{error:?}");
    assert!(!controller.state().servo_mode);
    robot.client().get_version().expect("the connection works");
}

#[test]
fn a_velocity_ends_while_the_thread_that_gave_it_is_held_up() {
    let (controller, mut robot) = ready();
    let stream = robot.stream(&patient()).expect("the arm is ready");
    stream.set_joint_velocity([0.0, 0.0, 0.0, 0.0, 0.0, 20.0], Duration::from_millis(200)).expect("slow enough");
    // This thread does nothing more for it.
    assert!(stream.wait_for_rest(LONG).expect("it goes on"));
    let moved = stream.joints()[5] - START[5];
    // 20 deg/s for at most 200 ms, and what braking takes; a busy machine may end it sooner.
    assert!(moved > 0.0 && moved < 20.0 * 0.2 + 20.0 * 20.0 / ACCELERATION, "{moved}");
    let report = stream.land().expect("it is at rest");
    assert!(smooth(&set_points(&controller).0) as u64 <= report.gaps);
}

#[test]
fn a_stream_that_is_dropped_or_unwinds_at_speed_lands() {
    for panics in [false, true] {
        let (controller, mut robot) = ready();
        let end = catch_unwind(AssertUnwindSafe(|| {
            let stream = robot.stream(&patient()).expect("the arm is ready");
            speed_up(&stream);
            assert!(!panics, "a bug in the user's program");
        }));
        assert_eq!(end.is_err(), panics);
        let (set_points, _) = set_points(&controller);
        assert!(smooth(&set_points) <= set_points.len() / 10, "{set_points:?}");
        let last = set_points.last().expect("there are some");
        assert!(last[5] - START[5] < 59.0, "{set_points:?}");
        assert_eq!(set_points.get(set_points.len() - 2), Some(last), "it is held at its end");
        assert!(!controller.state().servo_mode);
        robot.client().get_version().expect("the connection works");
    }
}

/// No filter, and each of 4.60.
pub(crate) fn filters() -> [SetServoMoveFilter; 6] {
    [
        SetServoMoveFilter::disabled(),
        SetServoMoveFilter::joint_low_pass(10.0),
        SetServoMoveFilter::joint_nonlinear(180.0, 500.0, 5000.0),
        SetServoMoveFilter::joint_mean(10, 0.1, 0.2, 0.6),
        SetServoMoveFilter::cartesian_nonlinear(1000.0, 5000.0, 50_000.0, 180.0, 500.0, 5000.0),
        SetServoMoveFilter::speed_lookahead(10, 0.1),
    ]
}

/// By each filter of 4.60, or none, on an arm that lags, by simulated clocks.
#[test]
fn on_an_arm_that_lags_the_end_of_a_landing_is_seen_and_a_deviation_trips_only_then() {
    let filters = filters();
    let underruns = [Underrun::Hold, Underrun::Fault(Duration::from_millis(500)), Underrun::RunOut(300.0)];
    filters.iter().zip(underruns.iter().cycle()).for_each(|(filter, underrun)| lands_with_lag(filter, *underrun));
    filters.iter().for_each(trips_by_deviation);
}

fn lagging(filter: &SetServoMoveFilter, underrun: Underrun, trip: Trip) -> (Controller, Robot, StreamConfig) {
    let clock = SimulatedClock::new();
    let builder = Controller::builder().clock(&clock).lag(Duration::from_millis(80)).underrun(underrun).trips([trip]);
    let (controller, robot) = of_builder(builder, &Config::new().clock(&clock));
    let servo = ServoConfig::new().step_count(CYCLES).max_unanswered(LONG).rest_timeout(LONG).filter(*filter);
    let robot = robot.with_limits(limits()).expect("it is this arm");
    (controller, robot, StreamConfig::new().servo(servo).max_gap(LONG).max_departure(1000.0))
}

fn lands_with_lag(filter: &SetServoMoveFilter, underrun: Underrun) {
    let (controller, mut robot, config) = lagging(filter, underrun, Trip::Deviation(60.0));
    let stream = robot.stream(&config).expect("the arm is ready");
    speed_up_by(&stream, |time| clock_of(&controller).sleep(time));
    stream.land().unwrap_or_else(|error| panic!("{filter:?}, {underrun:?}: {error}"));
    let (state, (set_points, _)) = (controller.state(), set_points(&controller));
    let last = set_points.last().expect("there are some");
    let off = state.joint_position.max_distance(&JointPosition(*last));
    assert!(!state.servo_mode && state.enabled && off < 0.1, "{filter:?}, {underrun:?}: {off}, {state:?}");
}

fn trips_by_deviation(filter: &SetServoMoveFilter) {
    let (controller, mut robot, config) = lagging(filter, Underrun::Hold, Trip::Deviation(1.0));
    let stream = robot.stream(&config).expect("the arm is ready");
    let turned = stream.set_joints(turned(6, 60.0));
    turned.expect("within its range");
    let error = loop {
        if let Err(error) = stream.wait_for_rest(LONG) {
            break error;
        }
    };
    assert!(matches!(error.kind(), ErrorKind::SessionEnded { .. }), "{filter:?}: {error:?}");
    let error = stream.land().expect_err("it tripped");
    let state = controller.state();
    assert!(!state.servo_mode && state.error_code == "0x158611", "{filter:?}: {error}");
}

#[test]
fn a_stop_of_the_program_brakes_a_stream_first() {
    let (controller, mut robot) = ready();
    let stop = robot.stop_handle();
    let stream = robot.stream(&patient()).expect("the arm is ready");
    speed_up(&stream);
    stop.stop().expect("the controller takes it");
    let error = stream.land().expect_err("it was stopped");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    let (set_points, after) = set_points(&controller);
    smooth(&set_points);
    assert!(after.contains(&"stop_program".to_owned()), "{after:?}");
    assert!(robot.stream(&patient()).is_err_and(|error| matches!(error.kind(), ErrorKind::NotAcknowledged { .. })));
    robot.acknowledge();
    robot.stream(&patient()).expect("it was acknowledged").land().expect("it is at rest");
}

#[test]
fn joints_that_do_not_follow_end_the_stream() {
    let (controller, mut robot) = ready();
    // The arm is not where it is held.
    let servo = ServoConfig::new().step_count(CYCLES).max_unanswered(LONG).rest_timeout(Duration::from_millis(200));
    let stream = robot.stream(&patient().servo(servo).max_departure(2.0)).expect("the arm is ready");
    stream.set_joints(turned(6, 1.0)).expect("within its range");
    let error = loop {
        controller.set_state(|state| state.joint_position.0[0] = START[0] + 5.0);
        if let Err(error) = stream.rest() {
            break error;
        }
    };
    assert!(error.to_string().contains("joint 1 does not follow its set-points"), "{error}");
    let error = stream.land().expect_err("it has ended");
    assert!(
        error.to_string().contains("joint 1 does not follow its set-points: it is at 15.00 deg, 5.00 deg from"),
        "{error}"
    );
    assert!(!controller.state().servo_mode);
}

#[test]
fn a_status_that_is_no_longer_known_lands_a_stream() {
    let (controller, mut robot) = ready_with(limits(), &Config::new().stale_after(Duration::from_millis(500)));
    let Ok(stream) = robot.stream(&patient()) else {
        // So busy a machine shows the same by itself.
        return;
    };
    stream.set_joints(turned(6, 60.0)).expect("within its range");
    controller.link(Port::Status).to_client().hold();
    let since = Instant::now();
    while stream.rest().is_ok() {
        assert!(since.elapsed() < LONG);
        thread::sleep(Duration::from_millis(20));
    }
    let error = stream.land().expect_err("the status is stale");
    assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{error:?}");
    smooth(&set_points(&controller).0);
    assert!(!controller.state().servo_mode);
}

#[test]
fn a_link_that_is_held_or_cut_ends_a_stream_and_no_set_point_follows() {
    for cut in [false, true] {
        let (controller, mut robot) = ready();
        let config = patient().servo(ServoConfig::new().step_count(CYCLES));
        let stream = robot.stream(&config).expect("the arm is ready");
        // A machine that is too busy to answer within 100 ms ends it as a held link does.
        let _ = stream.set_joints(turned(6, 60.0));
        let since = Instant::now();
        while stream.joints()[5] - START[5] < 2.0 && stream.rest().is_ok() {
            assert!(stream.set_joints(turned(6, 60.0)).is_ok() || since.elapsed() < LONG);
            thread::sleep(Duration::from_millis(20));
        }
        if cut {
            controller.disconnect();
        } else {
            controller.links().hold();
        }
        while stream.rest().is_ok() {
            assert!(since.elapsed() < LONG, "the stream goes on");
            thread::sleep(Duration::from_millis(20));
        }
        let error = stream.land().expect_err("it has ended");
        let is_told = error.is_disconnected() || matches!(error.kind(), ErrorKind::SetPointsUnanswered { .. });
        assert!(is_told && error.may_have_run(), "{cut}: {error:?}");
        let came = || controller.requests().iter().filter(|request| request.contains("servo_j")).count();
        let before = came();
        controller.links().release();
        thread::sleep(Duration::from_millis(300));
        // What was outstanding may still come: three set-points, and the one that was on its way.
        assert!(came() <= before + 4, "{cut}: {} after {before}", came());
    }
}
