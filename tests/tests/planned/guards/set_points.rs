//! Contact with a plane on a trajectory and in a stream: how far the tool goes in, at each period of the packets, by a
//! simulated clock.

use std::time::Duration;

use expect_test::expect;
use jaka_robot::jaka_motion::{Exceeded, TcpVelocity, TimedPoint, Trajectory, TrajectoryError, VelocityFrame, Via};
use jaka_robot::servo::{ServoJ, SetServoMode};
use jaka_robot::types::Pose;
use jaka_robot::{
    Cause, Command, End, Error, ErrorKind, FollowConfig, ForceComponent, ForceLimit, Guard, GuardTrip, NotGuarded,
    Robot, StatusProblem, StreamConfig, StreamHandle,
};
use jaka_sim::Port;
use jaka_tests::{Arm, LONG, followed};

use super::{CHANGE, IO, STIFFNESS, above_a_plane, count, lagging_above_a_plane, limited};

/// Share of the permitted speed that is used; the reported permitted speed is approximate.
const USED: f64 = 0.95;

/// An arm and its robot, with the limits of the arm.
fn bench(period: Duration, above_mm: f64) -> (Arm, Robot) {
    let (arm, robot) = above_a_plane(period, above_mm);
    (arm, limited(robot))
}

fn force(overtravel: f64) -> ForceLimit {
    ForceLimit::new(ForceComponent::Force, CHANGE).overtravel(overtravel)
}

fn below(arm: &Arm, mm: f64) -> Pose {
    let pose = arm.state().tcp_pose;
    Pose { z: pose.z - mm, ..pose }
}

/// A line down with a speed of the tool.
fn down(arm: &Arm, robot: &Robot, speed: f64) -> Trajectory {
    let points = [Via::joints(arm.state().joint_position), Via::line(below(arm, 20.0))];
    let trajectory = Trajectory::through(points).tcp_speed(speed).build(robot.limits().expect("it has some"));
    trajectory.unwrap_or_else(|error: TrajectoryError| panic!("{error}"))
}

fn refused(arm: &Arm, robot: &mut Robot, trajectory: &Trajectory, limit: ForceLimit) -> (Error, f64) {
    let error = robot.start_follow(trajectory, &FollowConfig::new().guard(limit)).expect_err("it is too fast");
    assert_eq!(count(arm, SetServoMode::INFO.name), 0, "{error}");
    assert!(!error.may_have_run());
    match error.kind() {
        ErrorKind::NotGuarded { reason: NotGuarded::TooFastAlong { permitted_mm_s, .. }, .. } => {
            let permitted = *permitted_mm_s;
            (error, permitted)
        }
        _ => panic!("{error:?}"),
    }
}

/// Penetration of the tool in mm, and its speed in mm/s.
type Depth = (f64, f64);

fn assert_rests(arm: &Arm, overtravel: f64) -> f64 {
    let (state, deepest) = (arm.state(), arm.deepest_penetration());
    assert!(deepest > CHANGE / STIFFNESS && deepest <= overtravel, "{deepest} mm");
    assert!(state.at_rest && !state.servo_mode, "{state:?}");
    deepest
}

fn depth_of_trajectory(period: Duration, phase: f64, overtravel: f64) -> Depth {
    let (arm, mut robot) = bench(period, 2.0);
    let fast = down(&arm, &robot, 200.0);
    let (_, permitted) = refused(&arm, &mut robot, &fast, force(overtravel));
    drop(robot);
    let speed = USED * permitted;
    let (arm, mut robot) = bench(period, 2.0 + phase * speed * period.as_secs_f64());
    let trajectory = down(&arm, &robot, speed);
    let run = robot.start_follow(&trajectory, &FollowConfig::new().guard(force(overtravel)));
    let end: End = run.unwrap_or_else(|error| panic!("{period:?}: {error}")).wait();
    assert_eq!(end.cause(), Cause::Guard, "{period:?}: {end}");
    assert!(
        end.rest.was_seen() && !followed(&end).has_left_curve && followed(&end).reached < followed(&end).duration,
        "{end}"
    );
    (assert_rests(&arm, overtravel), speed)
}

/// The highest speed that a stream takes.
fn top_speed(stream: &StreamHandle) -> f64 {
    let error = stream.set_tcp_velocity(downwards(1000.0), Duration::from_millis(100)).expect_err("it is too fast");
    match error.kind() {
        ErrorKind::BeyondLimit { beyond, .. } => match beyond.exceeded {
            Exceeded::TcpSpeed { limit_mm_s, .. } => limit_mm_s,
            _ => panic!("{error}"),
        },
        _ => panic!("{error:?}"),
    }
}

fn downwards(speed: f64) -> TcpVelocity {
    TcpVelocity::new(VelocityFrame::ArmBase).with_linear([0.0, 0.0, -speed])
}

/// Goal of a stream.
#[derive(Debug, Clone, Copy)]
enum Told {
    Velocity,
    Target,
}

fn streamed(period: Duration, phase: f64, overtravel: f64, told: Told) -> Depth {
    let (arm, mut robot) = bench(period, 2.0 + phase * 0.3);
    let clock = arm.clock();
    let target = below(&arm, 20.0);
    let stream = robot.stream(&StreamConfig::new().guard(force(overtravel))).expect("the sensor works");
    let (handle, speed) = (stream.handle(), top_speed(&stream.handle()));
    let give = || match told {
        Told::Velocity => handle.set_tcp_velocity(downwards(speed), Duration::from_millis(200)),
        Told::Target => handle.set_pose(target),
    };
    give().expect("it is within the limits");
    let since = clock.elapsed();
    while give().is_ok() {
        assert!(clock.elapsed().saturating_sub(since) < LONG, "{period:?}, {told:?}: nothing is touched");
        clock.sleep(Duration::from_millis(100));
    }
    let error = stream.land().expect_err("the guard has ended it");
    assert!(matches!(error.kind(), ErrorKind::GuardTripped { .. }), "{period:?}, {told:?}: {error}");
    (assert_rests(&arm, overtravel), speed)
}

#[test]
fn on_a_trajectory_and_in_a_stream_the_tool_goes_no_further_in_than_is_allowed_at_every_period() {
    let mut cases = vec![(8, 1.0), (30, 1.0), (30, 0.25), (100, 1.0)];
    if jaka_tests::reliability_times() > 1 {
        cases.extend((12..100).step_by(4).map(|period_ms| (period_ms, 1.0)));
    }
    for (period_ms, overtravel) in cases {
        let period = Duration::from_millis(period_ms);
        let deepest = |run: &dyn Fn(f64) -> Depth| {
            [0.0, 0.35, 0.7].into_iter().map(run).fold((0.0, 0.0), |most: Depth, one| (most.0.max(one.0), one.1))
        };
        for (name, (deepest, speed)) in [
            ("trajectory", deepest(&|phase| depth_of_trajectory(period, phase, overtravel))),
            ("stream, velocity", deepest(&|phase| streamed(period, phase, overtravel, Told::Velocity))),
            ("stream, target", deepest(&|phase| streamed(period, phase, overtravel, Told::Target))),
        ] {
            println!("packets each {period_ms} ms, {overtravel} mm allowed, {name}: {speed:.1} mm/s, {deepest:.3} mm");
            // What is permitted is not much less than what could be.
            assert!(deepest > 0.2 * overtravel, "{name}, {period_ms} ms: {deepest} mm of {overtravel} mm");
        }
    }
}

/// The trajectory starts below the plane, and would be slow enough.
#[test]
fn on_an_approach_the_tool_goes_no_further_in_than_is_allowed_at_every_period() {
    for (period_ms, overtravel) in [(8, 1.0), (30, 1.0), (30, 0.25), (100, 1.0)] {
        let period = Duration::from_millis(period_ms);
        let mut deepest = 0.0_f64;
        for phase in [0.0, 0.35, 0.7] {
            let (arm, mut robot) = bench(period, 2.0 + 0.3 * phase);
            let start = down(&arm, &robot, 4.0).end();
            let aside = [start.0[0] + 1.0, start.0[1], start.0[2], start.0[3], start.0[4], start.0[5]];
            let points = [Via::joints(start), Via::from(aside)];
            let trajectory = Trajectory::through(points).tcp_speed(1.0).build(robot.limits().expect("it has some"));
            let config = FollowConfig::new().approach(180.0).guard(force(overtravel));
            let run = robot.start_follow(&trajectory.expect("it is within them"), &config);
            let end: End = run.unwrap_or_else(|error| panic!("{period:?}: {error}")).wait();
            assert_eq!((end.cause(), followed(&end).reached), (Cause::Guard, Duration::ZERO), "{period:?}: {end}");
            deepest = deepest.max(assert_rests(&arm, overtravel));
        }
        println!("packets each {period_ms} ms, {overtravel} mm allowed, approach: {deepest:.3} mm");
    }
}

#[test]
fn a_trajectory_that_is_too_fast_somewhere_is_refused_with_the_place_and_the_figures() {
    let (arm, mut robot) = bench(Duration::from_millis(30), 5.0);
    let start = arm.state().joint_position;
    let aside = [start.0[0] + 2.0, start.0[1], start.0[2], start.0[3], start.0[4], start.0[5]];
    // Slow to the second way-point, and fast from there on.
    let points = [TimedPoint::new(0.0, start), TimedPoint::new(4.0, aside), TimedPoint::new(4.5, start)];
    let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some")).expect("it is within them");
    let (error, _) = refused(&arm, &mut robot, &trajectory, force(1.0));
    let ErrorKind::NotGuarded { reason: NotGuarded::TooFastAlong { after, time_s, speed_mm_s, period, .. }, .. } =
        error.kind()
    else {
        panic!("{error:?}")
    };
    assert!(*after == 2 && (4.0..4.5).contains(time_s), "{error}");
    assert!((20.0..100.0).contains(speed_mm_s) && *period == Duration::from_millis(30), "{error}");
    let text = error.to_string();
    let begin = "`servo_j` was not sent under a guard: after way-point 2, at 4.";
    assert!(text.starts_with(begin) && text.contains(" mm/s the tool moves "), "{text}");
    assert!(text.contains(", and 1 mm are allowed; permitted are "), "{text}");
    assert!(
        text.contains(" mm/s there, with up to 30.0ms between packets, 20.0ms of reaction and braking with "),
        "{text}"
    );
    assert_eq!(count(&arm, ServoJ::INFO.name), 0);
}

#[test]
fn without_packets_in_time_an_arm_under_a_limit_of_force_is_braked() {
    let (arm, mut robot) = bench(Duration::from_millis(30), 15.0);
    let trajectory = down(&arm, &robot, 4.0);
    let run = robot.start_follow(&trajectory, &FollowConfig::new().guard(force(1.0))).expect("it is slow enough");
    let clock = arm.clock();
    clock.sleep(Duration::from_secs(1));
    arm.link(Port::Status).to_client().hold();
    let since = clock.elapsed();
    let end = run.wait();
    assert_eq!(end.cause(), Cause::StatusLost, "{end}");
    // Without such a limit it would be stale after 500 ms, and be braked and held from then on.
    let took = clock.elapsed().saturating_sub(since);
    assert!(took < Duration::from_millis(600), "{took:?}: {end}");
    let age = match end.error.as_ref().map(Error::kind) {
        Some(ErrorKind::StatusUnknown { problem: StatusProblem::Stale { age } }) => *age,
        _ => panic!("{end:?}"),
    };
    assert!((Duration::from_millis(100)..Duration::from_millis(120)).contains(&age), "{age:?}");
    assert!(!followed(&end).has_left_curve && arm.state().at_rest, "{end}");
}

#[test]
fn an_arm_is_braked_as_soon_by_one_guard_as_by_another() {
    let rest_after = |is_limited: bool| {
        let (arm, mut robot) = bench(Duration::from_millis(30), 25.0);
        let trajectory = down(&arm, &robot, 10.0);
        let input = Guard::from(IO.cabinet(1).rises());
        let guard = if is_limited { input.or(force(2.0)) } else { input };
        let run = robot.start_follow(&trajectory, &FollowConfig::new().guard(guard)).expect("it is slow enough");
        arm.clock().sleep(Duration::from_secs(1));
        arm.set_state(|state| state.digital_inputs[0] = true);
        let since = arm.clock().elapsed();
        let end = run.wait();
        assert_eq!(end.cause(), Cause::Guard, "{end}");
        arm.clock().elapsed().saturating_sub(since)
    };
    let [limited, other] = [true, false].map(rest_after);
    assert!(limited == other && limited < Duration::from_millis(200), "{limited:?}, {other:?}");
}

/// The trip that has ended something.
fn trip(error: &Error) -> &GuardTrip {
    let ErrorKind::GuardTripped { trip } = error.kind() else { panic!("{error:?}") };
    trip
}

/// The depth is what the plane has felt. An arm that lags is further behind the packets' forces than the limit allows
/// for.
#[test]
fn a_lag_longer_than_the_reaction_is_told_at_the_trip() {
    let ms = Duration::from_millis;
    for (lag, reaction, is_longer) in [(ms(80), ms(20), true), (ms(100), ms(20), true), (ms(60), ms(120), false)] {
        let limit = force(1.0).reaction(reaction);
        let (arm, mut robot) = lagging_above_a_plane(lag, ms(8), 15.0);
        robot = limited(robot);
        let fast = down(&arm, &robot, 200.0);
        let permitted = refused(&arm, &mut robot, &fast, limit).1;
        let trajectory = down(&arm, &robot, USED * permitted);
        let run = robot.start_follow(&trajectory, &FollowConfig::new().guard(limit)).expect("it is slow enough");
        let end = run.wait();
        assert_eq!(end.cause(), Cause::Guard, "{end}");
        let error = end.error.as_ref().expect("the guard has ended it");
        let found = trip(error).lag;
        assert_eq!(found.is_some(), is_longer, "{lag:?}, {reaction:?}: {end:?}");
        let deepest = arm.deepest_penetration();
        assert_eq!(deepest > 1.0, is_longer, "{deepest} mm, with a lag of {lag:?} and a reaction of {reaction:?}");
        let Some(found) = found else { continue };
        // Packets take their time, too.
        assert!(found.reaction == reaction && found.lag >= lag && found.lag < lag + ms(40), "{found:?}");
        let text = error.to_string();
        assert!(text.contains(&format!("the arm lagged {:?} behind its set-points", found.lag)), "{text}");
        assert!(text.contains("the tool may have moved further than the overtravel"), "{text}");
        // Streams, too.
        let (arm, robot) = lagging_above_a_plane(lag, ms(8), 15.0);
        let mut robot = limited(robot);
        let stream = robot.stream(&StreamConfig::new().guard(limit)).expect("the sensor works");
        let target = below(&arm, 20.0);
        while stream.handle().set_pose(target).is_ok() {
            arm.clock().sleep(ms(100));
        }
        let error = stream.land().expect_err("the guard has ended it");
        let found = trip(&error).lag.expect("the arm lags");
        assert!(found.lag >= lag && found.lag < lag + ms(40), "{found:?}");
    }
}

/// Runs down to the plane on a trajectory under a guard that consists of these limits.
fn touched(lag: Duration, speed: f64, guard: Guard) -> End {
    let (arm, robot) = lagging_above_a_plane(lag, Duration::from_millis(8), 15.0);
    let mut robot = limited(robot);
    let trajectory = down(&arm, &robot, speed);
    let run = robot.start_follow(&trajectory, &FollowConfig::new().guard(guard)).expect("it is slow enough");
    let end = run.wait();
    assert_eq!(end.cause(), Cause::Guard, "{end}");
    end
}

#[test]
fn a_lag_is_compared_with_the_reaction_of_the_limit_that_tripped() {
    let ms = Duration::from_millis;
    // Forces of the plane stay far below this.
    let never = || ForceLimit::new(ForceComponent::Force, 1e6);
    let either = |one: ForceLimit, other: ForceLimit| Guard::from(one).or(other);
    for (guard, tripped, expected) in [
        (either(never().reaction(ms(20)), force(1.0).reaction(ms(120))), 1, None),
        (either(never().reaction(ms(120)), force(1.0).reaction(ms(20))), 1, Some(ms(20))),
        (either(force(1.0).reaction(ms(40)), never().reaction(ms(20))), 0, Some(ms(40))),
        // Another condition stands before the limit.
        (Guard::from(IO.cabinet(1).rises()).or(force(1.0).reaction(ms(20))), 1, Some(ms(20))),
    ] {
        let end = touched(ms(60), 4.0, guard);
        let trip = trip(end.error.as_ref().expect("the guard has ended it"));
        assert_eq!((trip.condition, trip.lag.map(|found| found.reaction)), (tripped, expected), "{end}");
    }
}

#[test]
fn no_lag_is_told_where_the_condition_that_tripped_has_no_reaction() {
    let ms = Duration::from_millis;
    let (arm, robot) = lagging_above_a_plane(ms(60), ms(8), 25.0);
    let mut robot = limited(robot);
    let trajectory = down(&arm, &robot, 4.0);
    let guard = Guard::from(force(1.0).reaction(ms(20))).or(IO.cabinet(1).rises());
    let run = robot.start_follow(&trajectory, &FollowConfig::new().guard(guard)).expect("it is slow enough");
    arm.clock().sleep(Duration::from_secs(2));
    arm.set_state(|state| state.digital_inputs[0] = true);
    let end = run.wait();
    assert_eq!(end.cause(), Cause::Guard, "{end}");
    let trip = trip(end.error.as_ref().expect("the guard has ended it"));
    assert_eq!((trip.condition, trip.lag), (1, None), "{end}");
}

/// Delays of up to 500 ms are compared: a longer one is known to be at least that.
#[test]
fn a_lag_beyond_what_is_measured_is_told_as_at_least_that() {
    let ms = Duration::from_millis;
    for (lag, reaction, text) in [
        (ms(700), ms(20), "at least 500ms behind its set-points, longer than the limit's reaction of 20ms"),
        (ms(900), ms(600), "at least 500ms behind its set-points, perhaps longer than the limit's reaction of 600ms"),
    ] {
        let end = touched(lag, 1.0, force(1.0).reaction(reaction).into());
        assert_eq!(followed(&end).lag, None, "{end}");
        let error = end.error.as_ref().expect("the guard has ended it");
        let found = trip(error).lag.expect("the arm lags");
        assert_eq!((found.lag, found.is_lower_bound, found.reaction), (ms(500), true, reaction), "{end}");
        assert!(error.to_string().contains(text), "{error}");
    }
    let end = touched(ms(60), 4.0, force(1.0).into());
    let found = trip(end.error.as_ref().expect("the guard has ended it")).lag.expect("the arm lags");
    assert!(!found.is_lower_bound && found.lag < ms(100), "{found:?}");
    expect![[r#"{"lag_s":0.076,"is_lower_bound":false,"reaction_s":0.02}"#]]
        .assert_eq(&serde_json::to_string(&found).expect("it is written"));
}
