//! Streams: what the controller receives, read as JSON and differenced by index. By simulated clocks.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Duration;

use jaka_robot::jaka_motion::{Bound, Limits, Model, Region, TcpVelocity, VelocityFrame};
use jaka_robot::servo::SetServoMoveFilter;
use jaka_robot::types::JointPosition;
use jaka_robot::{
    Cause, End, ErrorKind, Numbering, Robot, RobotConfig, RobotStop, ServoConfig, StreamConfig, StreamHandle, Unchecked,
};
use jaka_sim::{Builder, Controller, Port, SimulatedClock, Trip, Underrun};
use jaka_tests::rig::Random;
use jaka_tests::simulated::{beside, side_by_side};
use jaka_tests::witness::curve::apart;
use jaka_tests::{Arm, ArmBuilder, Configured as _, LONG};
use serde_json::Value;

use crate::received::positions;

pub(crate) const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, 0.0];

const CYCLES: u32 = 4;
const PERIOD: f64 = 0.032;
const SERVO_PERIOD: Duration = Duration::from_millis(32);

/// Limits of each joint of a Zu 5: 180 deg/s, with accelerations and jerks of our choice.
const SPEED: f64 = 180.0;
const ACCELERATION: f64 = 720.0 / 10.0;
const JERK: f64 = ACCELERATION * 10.0;

pub(crate) fn arm() -> ArmBuilder {
    Arm::simulated().at(START).status_period(Duration::from_millis(10))
}

pub(crate) fn limits() -> Limits {
    Limits::of(Model::named("Zu 5").expect("a published arm"))
}

fn ready() -> (Arm, Robot) {
    ready_with(arm(), limits())
}

fn ready_with(arm: ArmBuilder, limits: Limits) -> (Arm, Robot) {
    let (arm, robot) = arm.with_robot();
    (arm, robot.configured(&RobotConfig::new().limits(limits)).expect("it is this arm"))
}

fn config() -> StreamConfig {
    StreamConfig::new().servo(ServoConfig::new().step_count(CYCLES))
}

/// The set-points that came, and the names of what came after the last of them.
fn set_points(controller: &Controller) -> (Vec<[f64; 6]>, Vec<String>) {
    positions(controller, CYCLES)
}

fn assert_smooth(set_points: &[[f64; 6]]) {
    let jump = jump(START, set_points);
    assert_eq!(jump, None, "{:?}", jump.map(|index| &set_points[..=index]));
}

/// The first set-point after standstill at which a joint is faster, or becomes so sooner, than it may. A joint that is
/// braked may have the acceleration and the jerk of stops.
pub(crate) fn jump(start: [f64; 6], set_points: &[[f64; 6]]) -> Option<usize> {
    let mut all = vec![start; 3];
    all.extend(set_points);
    all.windows(4).position(|four| {
        let [a, b, c, d] = four else { unreachable!("windows of four") };
        (0..6).any(|joint| {
            let [oldest, before, now] = [b[joint] - a[joint], c[joint] - b[joint], d[joint] - c[joint]];
            let (first, second) = (now / PERIOD, (now - before) / PERIOD.powi(2));
            let third = (now - 2.0 * before + oldest) / PERIOD.powi(3);
            let is_braked = now.abs() < before.abs() || before.abs() < oldest.abs() || third * now < 0.0;
            let most = if is_braked { [SPEED, 570.0, 5700.0] } else { [SPEED, ACCELERATION, JERK] };
            [first, second, third].iter().zip(most).any(|(is, most)| is.abs() > most + 1e-6)
        })
    })
}

fn turned(joint: usize, by: f64) -> [f64; 6] {
    let mut joints = START;
    joints[joint - 1] += by;
    joints
}

/// Waits until joint 6 is on its way to 60 deg further.
pub(crate) fn speed_up(stream: &StreamHandle, clock: &SimulatedClock) {
    stream.set_joints(turned(6, 60.0)).expect("within its range");
    wait_until(clock, || stream.joints()[5] - START[5] >= 5.0);
}

/// Waits until this is so.
fn wait_until(clock: &SimulatedClock, is_so: impl Fn() -> bool) {
    let until = clock.elapsed() + LONG;
    while !is_so() {
        assert!(clock.elapsed() < until, "it is not so after {LONG:?}");
        clock.sleep(Duration::from_millis(5));
    }
}

/// Its thread goes on, and a second one's set-points between its own would make the arm jump.
#[test]
fn a_stream_that_was_forgotten_keeps_a_second_one_from_beginning() {
    let (_arm, mut robot) = ready();
    let stream = robot.stream(&config()).expect("the arm is ready");
    let handle = stream.handle();
    std::mem::forget(stream);
    let error = robot.stream(&config()).expect_err("the first one goes on");
    assert!(
        matches!(error.kind(), ErrorKind::NotReady { occurrence } if occurrence.cause == Cause::ServoMode),
        "{error}"
    );
    handle.set_joints(turned(6, 1.0)).expect("it goes on");
    assert!(handle.wait_for_rest(LONG).expect("it goes on"));
}

#[test]
fn a_stream_says_what_holds_it() {
    let (arm, mut robot) = ready();
    let stream = robot.stream(&config()).expect("the arm is ready");
    assert_eq!(stream.handle().bound(), None);
    let upwards = TcpVelocity::new(VelocityFrame::ArmBase).with_linear([0.0, 0.0, 300.0]);
    wait_until(arm.clock(), || {
        stream.handle().set_tcp_velocity(upwards, Duration::from_millis(500)).expect("it goes on");
        stream.handle().bound().is_some()
    });
    let bound = stream.handle().bound().expect("the time stands still");
    assert!(matches!(bound, Bound::Limit(_)), "the arm's reach ends somewhere: {bound:?}");
    drop(stream.land().expect("it lands"));
}

#[test]
fn targets_and_velocities_of_many_threads_make_one_smooth_motion() {
    let (arm, mut robot) = ready();
    let stream = robot.stream(&config()).expect("the arm is ready");
    let clock = arm.clock();
    let many = (0..3).map(|seed| {
        let handle = stream.handle();
        move || {
            let mut random = Random::new(seed);
            let mut between = move |least: f64, most: f64| random.between(least, most);
            for _ in 0..100 {
                let wait = Duration::from_millis(100);
                let given = match between(0.0, 4.0) {
                    0.0..1.0 => handle.set_joints(START.map(|joint| joint + between(-20.0, 20.0))),
                    1.0..2.0 => handle.set_joint_velocity(START.map(|_| between(-60.0, 60.0)), wait),
                    2.0..3.0 => {
                        let linear_mm_s = [0.0; 3].map(|_: f64| between(-200.0, 200.0));
                        let angular_deg_s = [0.0; 3].map(|_: f64| between(-30.0, 30.0));
                        let frame = VelocityFrame::User;
                        handle.set_tcp_velocity(
                            TcpVelocity::new(frame).with_linear(linear_mm_s).with_angular(angular_deg_s),
                            wait,
                        )
                    }
                    _ => handle.rest(),
                };
                // Joint positions at random may be beyond a range.
                assert!(
                    given.is_ok() || given.is_err_and(|error| matches!(error.kind(), ErrorKind::BeyondLimit { .. }))
                );
                clock.sleep(Duration::from_secs_f64(between(0.0, 0.06)));
            }
        }
    });
    side_by_side(clock, many);
    let report = stream.land().expect("it comes to rest").report;
    let (set_points, after) = set_points(&arm);
    assert_smooth(&set_points);
    assert_eq!((report.late_cycles, report.gaps), (0, 0));
    assert!(set_points.iter().any(|joints| joints.iter().zip(START).any(|(at, from)| (at - from).abs() > 1.0)));
    assert_eq!(set_points.last(), set_points.get(set_points.len() - 2), "it is held at its end");
    assert_eq!((&*after[0], arm.state().servo_mode), ("servo_move", false));
    assert_eq!(set_points.len() as u64, report.cycles + report.landing_cycles);
}

#[test]
fn a_target_is_reached_and_the_arm_is_there() {
    let (arm, mut robot) = ready();
    let stream = robot.stream(&config()).expect("the arm is ready");
    stream.handle().set_joints(turned(6, 8.0)).expect("within its range");
    assert!(stream.handle().wait_for_rest(LONG).expect("it goes on"));
    assert!(stream.handle().joints().max_distance(&JointPosition(turned(6, 8.0))) < 1e-5);
    let pose = arm.state().tcp_pose;
    drop(stream);
    assert!(arm.state().joint_position.max_distance(&JointPosition(turned(6, 8.0))) < 1e-5);
    // To where it is, and 20 mm up, by the arm's own inverse.
    let stream = robot.stream(&config()).expect("the arm is ready");
    let before = arm.state().tcp_pose;
    stream.handle().set_pose(jaka_robot::types::Pose { z: before.z + 20.0, ..before }).expect("within reach");
    assert!(stream.handle().wait_for_rest(LONG).expect("it goes on"));
    stream.land().and_then(End::at_rest).expect("it is at rest");
    let up = arm.state().tcp_pose;
    assert!((up.z - before.z - 20.0).abs() < 0.01 && (up.x - before.x).abs() < 0.01, "{pose:?} {before:?} {up:?}");
}

#[test]
fn what_may_not_be_is_refused_at_once_and_the_stream_goes_on() {
    let floor = Region::half_space("floor", [0.0, 0.0, 50.0], [0.0, 0.0, 1.0]).expect("a plane");
    let (_arm, mut robot) = ready_with(arm(), limits().with_region(floor).expect("the only one"));
    let stream = robot.stream(&config()).expect("the arm is ready");
    let error = stream.handle().set_joints(turned(3, 120.0)).expect_err("beyond its range");
    assert!(error.to_string().starts_with("`servo_j` was not sent: joint 3 would be at 200 deg; limit"), "{error}");
    let error = stream
        .handle()
        .set_joint_velocity([200.0, 0.0, 0.0, 0.0, 0.0, 0.0], Duration::from_millis(100))
        .expect_err("too fast");
    assert!(matches!(error.kind(), ErrorKind::BeyondLimit { .. }) && error.to_string().contains("200"), "{error}");
    let error = stream.handle().set_joint_velocity([1.0; 6], Duration::from_secs(1)).expect_err("too long");
    assert_eq!(
        error.to_string(),
        "option `for_at_most` of `StreamHandle` is 1s, expected at most 500ms: give the velocity again before it expires"
    );
    stream.handle().set_joints(turned(6, 1.0)).expect("within its range");
    let handle = stream.handle();
    stream.land().and_then(End::at_rest).expect("it comes to rest");
    let error = handle.set_joints(START).expect_err("it has ended");
    assert_eq!(error.to_string(), "not sent, because the servo session has ended: it has landed");
}

#[test]
fn a_stream_needs_limits() {
    let (arm, mut robot) = arm().with_robot();
    let error = robot.stream(&config()).expect_err("it has none");
    assert!(matches!(error.kind(), ErrorKind::NotChecked { reason: Unchecked::NoLimits, .. }), "{error:?}");
    assert!(!arm.state().servo_mode);
    robot.client().get_version().expect("the connection works");
}

#[test]
fn a_velocity_ends_while_the_thread_that_gave_it_is_held_up() {
    let (arm, mut robot) = ready();
    let stream = robot.stream(&config()).expect("the arm is ready");
    stream
        .handle()
        .set_joint_velocity([0.0, 0.0, 0.0, 0.0, 0.0, 20.0], Duration::from_millis(200))
        .expect("slow enough");
    // This thread does nothing more for it.
    assert!(stream.handle().wait_for_rest(LONG).expect("it goes on"));
    let moved = stream.handle().joints()[5] - START[5];
    // 20 deg/s for at most 200 ms, and what braking takes.
    assert!(moved > 0.0 && moved < 20.0 * 0.2 + 20.0 * 20.0 / ACCELERATION, "{moved}");
    stream.land().and_then(End::at_rest).expect("it is at rest");
    assert_smooth(&set_points(&arm).0);
}

#[test]
fn a_stream_that_is_dropped_or_unwinds_at_speed_lands() {
    for panics in [false, true] {
        let (arm, mut robot) = ready();
        let end = catch_unwind(AssertUnwindSafe(|| {
            let stream = robot.stream(&config()).expect("the arm is ready");
            speed_up(&stream.handle(), arm.clock());
            assert!(!panics, "a bug in the user's program");
        }));
        assert_eq!(end.is_err(), panics);
        let (set_points, _) = set_points(&arm);
        assert_smooth(&set_points);
        let last = set_points.last().expect("there are some");
        assert!(last[5] - START[5] < 59.0, "{set_points:?}");
        assert_eq!(set_points.get(set_points.len() - 2), Some(last), "it is held at its end");
        assert!(!arm.state().servo_mode);
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

fn lagging(filter: &SetServoMoveFilter, underrun: Underrun, trip: Trip) -> (Arm, Robot, StreamConfig) {
    let lags = |arm: Builder| arm.lag(Duration::from_millis(80)).underrun(underrun).trips([trip]);
    let (arm, robot) = ready_with(arm().controller(lags), limits());
    let servo = ServoConfig::new().step_count(CYCLES).rest_timeout(LONG).filter(*filter);
    (arm, robot, StreamConfig::new().servo(servo).max_departure(1000.0))
}

fn lands_with_lag(filter: &SetServoMoveFilter, underrun: Underrun) {
    let (arm, mut robot, config) = lagging(filter, underrun, Trip::Deviation(60.0));
    let stream = robot.stream(&config).expect("the arm is ready");
    speed_up(&stream.handle(), arm.clock());
    stream.land().and_then(End::at_rest).unwrap_or_else(|error| panic!("{filter:?}, {underrun:?}: {error}"));
    let (state, (set_points, _)) = (arm.state(), set_points(&arm));
    let last = set_points.last().expect("there are some");
    let off = state.joint_position.max_distance(&JointPosition(*last));
    assert!(!state.servo_mode && state.enabled && off < 0.1, "{filter:?}, {underrun:?}: {off}, {state:?}");
}

fn trips_by_deviation(filter: &SetServoMoveFilter) {
    let (arm, mut robot, config) = lagging(filter, Underrun::Hold, Trip::Deviation(1.0));
    let stream = robot.stream(&config).expect("the arm is ready");
    stream.handle().set_joints(turned(6, 60.0)).expect("within its range");
    let error = stream.handle().wait_for_rest(LONG).expect_err("it trips before it is there");
    assert!(matches!(error.kind(), ErrorKind::SessionEnded { .. }), "{filter:?}: {error:?}");
    let error = stream.land().expect_err("it tripped");
    let state = arm.state();
    assert!(!state.servo_mode && state.error_code == "0x158611", "{filter:?}: {error}");
}

#[test]
fn a_stop_of_the_program_brakes_a_stream_first() {
    let (arm, mut robot) = ready();
    let stop = robot.stop_handle();
    let stream = robot.stream(&config()).expect("the arm is ready");
    speed_up(&stream.handle(), arm.clock());
    stop.stop().expect("the controller takes it");
    let error = stream.land().expect_err("it was stopped");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
    let (set_points, after) = set_points(&arm);
    // The arm stands after the last one.
    let stands = [set_points[set_points.len() - 1]; 3];
    assert_smooth(&[&set_points[..], &stands].concat());
    assert_eq!(after[0], "stop_program");
    assert!(robot.stream(&config()).is_err_and(|error| matches!(error.kind(), ErrorKind::NotAcknowledged { .. })));
    robot.acknowledge();
    robot.stream(&config()).expect("it was acknowledged").land().and_then(End::at_rest).expect("it is at rest");
}

#[test]
fn packets_may_fail_to_show_the_joints_for_less_than_half_a_second() {
    let (arm, mut robot) = ready();
    let stream = robot.stream(&config()).expect("the arm is ready");
    let show = |joints: Value| arm.set_status([("joint_actual_position".to_owned(), joints)]);
    show(Value::from("x"));
    arm.clock().sleep(Duration::from_millis(300));
    show(Value::from(START.to_vec()));
    arm.clock().sleep(Duration::from_secs(1));
    show(Value::from("x"));
    arm.clock().sleep(Duration::from_millis(300));
    show(Value::from(START.to_vec()));
    stream.land().and_then(End::at_rest).expect("the joints were shown again in time");
}

#[test]
fn joints_that_do_not_follow_end_the_stream() {
    let (arm, mut robot) = ready();
    // The arm is not where it is held.
    let servo = ServoConfig::new().step_count(CYCLES).rest_timeout(Duration::from_millis(200));
    let stream = robot.stream(&config().servo(servo).max_departure(2.0)).expect("the arm is ready");
    stream.handle().set_joints(turned(6, 1.0)).expect("within its range");
    wait_until(arm.clock(), || {
        arm.set_state(|state| state.joint_position.0[0] = START[0] + 5.0);
        stream.handle().rest().is_err()
    });
    let error = stream.handle().rest().expect_err("it has ended");
    assert!(error.to_string().contains("a joint does not follow its set-points: joint 1 is at"), "{error}");
    let error = stream.land().expect_err("it has ended");
    assert!(
        error.to_string().contains("a joint does not follow its set-points: joint 1 is at 15.00 deg, 5.00 deg from"),
        "{error}"
    );
    assert!(!arm.state().servo_mode);
}

#[test]
fn a_status_that_is_no_longer_known_lands_a_stream() {
    let soon_stale = arm().config(|config| config.stale_after(Duration::from_millis(500)));
    let (arm, mut robot) = ready_with(soon_stale, limits());
    let stream = robot.stream(&config()).expect("the arm is ready");
    speed_up(&stream.handle(), arm.clock());
    arm.link(Port::Status).to_client().hold();
    stream.handle().wait_for_rest(LONG).expect_err("it ends before it is there");
    let error = stream.land().expect_err("the status is stale");
    assert!(matches!(error.kind(), ErrorKind::StatusUnknown { .. }), "{error:?}");
    assert_smooth(&set_points(&arm).0);
    assert!(!arm.state().servo_mode);
}

#[test]
fn a_link_that_is_held_or_cut_ends_a_stream_and_no_set_point_follows() {
    for cut in [false, true] {
        let (arm, mut robot) = ready();
        let stream = robot.stream(&config()).expect("the arm is ready");
        speed_up(&stream.handle(), arm.clock());
        if cut {
            arm.disconnect();
        } else {
            arm.links().hold();
        }
        let since = arm.clock().now();
        stream.handle().wait_for_rest(LONG).expect_err("it ends before it is there");
        // By the next set-point; or by the fourth, three of which have no answer, and the end of servo mode within a
        // second.
        let most = if cut { SERVO_PERIOD } else { SERVO_PERIOD * 4 + Duration::from_secs(1) };
        assert!(arm.clock().now() - since <= most, "{cut}: {:?}", arm.clock().now() - since);
        let error = stream.land().expect_err("it has ended");
        let ErrorKind::ServoModeNotLeft { first: Some(first), .. } = error.kind() else { panic!("{cut}: {error:?}") };
        assert!(error.is_disconnected() && error.may_have_run(), "{cut}: {error:?}");
        assert!(cut || matches!(first.kind(), ErrorKind::SetPointsUnanswered { count: 3, .. }), "{error:?}");
        let came = || set_points(&arm).0.len();
        let before = came();
        arm.links().release();
        arm.clock().sleep(LONG);
        // What was outstanding may still come.
        assert!(came() <= before + if cut { 0 } else { 3 }, "{cut}: {} after {before}", came());
    }
}

#[test]
fn handles_tell_the_set_points_of_a_landing() {
    let (arm, mut robot) = ready();
    let stop = robot.stop_handle();
    let stream = robot.stream(&config()).expect("the arm is ready");
    speed_up(&stream.handle(), arm.clock());
    let handle = stream.handle();
    let at_speed = handle.joints()[5];
    beside(
        arm.clock(),
        || stop.stop().expect("the controller takes it"),
        || {
            for _ in 0..100 {
                arm.clock().sleep(SERVO_PERIOD);
                let ((set_points, _), told) = (positions(&arm, CYCLES), handle.joints().0);
                // At the moment in which one goes out, that is the last or the last but one.
                assert!(
                    set_points.iter().rev().take(2).any(|last| apart(last, &told) == 0.0),
                    "{told:?}: {set_points:?}"
                );
            }
        },
    );
    assert!(handle.joints()[5] - at_speed > 1.0, "it went on while it landed");
    stream.land().expect_err("it was stopped");
    let (set_points, _) = positions(&arm, CYCLES);
    assert!(apart(&handle.joints().0, &set_points[set_points.len() - 1]) == 0.0);
}

/// Nobody would follow a goal that is given to it.
#[test]
fn a_stream_that_lands_because_of_an_error_takes_no_goals_from_when_it_begins_to_land() {
    type Cause = fn(&Arm, &RobotStop);
    let causes: [(&str, Cause); 3] = [
        ("digital input 1", |arm, _| arm.set_state(|state| state.digital_inputs[0] = true)),
        ("the last status packet came", |arm, _| arm.link(Port::Status).to_client().hold()),
        ("stop", |_, stop| stop.stop().expect("the controller takes it")),
    ];
    for (because, cause) in causes {
        let soon_stale = arm().config(|config| config.stale_after(Duration::from_millis(500)));
        let (arm, mut robot) = ready_with(soon_stale, limits());
        let (clock, stop) = (arm.clock(), robot.stop_handle());
        let input = Numbering::FromOne.cabinet(1).rises();
        let stream = robot.stream(&config().guard(input)).expect("the arm is ready");
        let handle = stream.handle();
        speed_up(&handle, clock);
        let refused = || {
            let since = clock.elapsed();
            let error = loop {
                clock.sleep(Duration::from_millis(5));
                match handle.set_joint_velocity([0.0, 0.0, 0.0, 0.0, 0.0, 20.0], Duration::from_millis(500)) {
                    Ok(()) => assert!(clock.elapsed() < since + LONG, "{because}: it goes on"),
                    Err(error) => break error,
                }
            };
            assert!(matches!(error.kind(), ErrorKind::SessionEnded { .. }), "{because}: {error:?}");
            assert!(error.to_string().contains(because), "{because}: {error}");
            let since = clock.elapsed();
            let error = handle.wait_for_rest(LONG).expect_err("it lands");
            assert!(matches!(error.kind(), ErrorKind::SessionEnded { .. }), "{because}: {error:?}");
            assert_eq!(clock.elapsed(), since, "{because}");
            assert!(arm.state().servo_mode, "{because}: it has only begun to land");
            handle.joints()[5]
        };
        let at_speed = beside(clock, || cause(&arm, &stop), refused);
        stream.land().expect_err("it has landed because of an error");
        assert!(handle.joints()[5] - at_speed > 0.5, "{because}: it was still to be braked");
        assert!(arm.state().at_rest && !arm.state().servo_mode, "{because}");
        assert_smooth(&set_points(&arm).0);
    }
}

/// Also where the wait has begun before the landing.
#[test]
fn a_wait_for_rest_ends_when_the_landing_begins() {
    let (arm, mut robot) = ready();
    let clock = arm.clock();
    let input = Numbering::FromOne.cabinet(1).rises();
    let stream = robot.stream(&config().guard(input)).expect("the arm is ready");
    let handle = stream.handle();
    speed_up(&handle, clock);
    let trip = || {
        clock.sleep(Duration::from_millis(20));
        arm.set_state(|state| state.digital_inputs[0] = true);
    };
    let error = beside(clock, trip, || handle.wait_for_rest(LONG).expect_err("it lands"));
    assert!(error.to_string().contains("digital input 1"), "{error}");
    assert!(arm.state().servo_mode, "it has only begun to land");
    let at_speed = handle.joints()[5];
    stream.land().expect_err("the guard has ended it");
    assert!(handle.joints()[5] - at_speed > 0.5, "it was still to be braked");
}

/// Its robot can be used again, and may acknowledge what the stream has not seen yet.
#[test]
fn a_stop_ends_a_stream_that_was_forgotten_whatever_is_acknowledged() {
    let (arm, mut robot) = ready();
    let stream = robot.stream(&config()).expect("the arm is ready");
    let handle = stream.handle();
    std::mem::forget(stream);
    robot.stop_handle().stop().expect("it is taken");
    robot.acknowledge();
    let before = arm.state().joint_position;
    arm.clock().sleep(Duration::from_millis(100));
    assert!(handle.set_joints(turned(6, 5.0)).is_err(), "it has ended");
    arm.clock().sleep(Duration::from_secs(3));
    assert_eq!(before, arm.state().joint_position);
}
