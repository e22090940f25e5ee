//! Early ends of trajectories.

use std::panic::{AssertUnwindSafe, catch_unwind};

use jaka_robot::jaka_motion::TimedPoint;
use jaka_robot::status::RobotStatus;
use jaka_robot::types::JointPosition;
use jaka_robot::{Cause, End, Guard, RobotStop, StreamConfig};
use jaka_sim::{Fault, Port};

use super::*;

/// A run on its way, and what becomes of it.
fn ended_by(config: &FollowConfig, act: impl FnOnce(&Arm, &FollowHandle)) -> (Arm, Robot, End) {
    let (arm, mut robot) = ready();
    let run = robot.start_follow(&made(&to_and_fro()), config).expect("the arm is at its start");
    wait_for(&arm, &run.handle(), 0.5);
    act(&arm, &run.handle());
    let end = run.wait();
    (arm, robot, end)
}

fn assert_ended_on_the_way(end: &End, cause: Cause) {
    assert_eq!(end.cause(), cause, "{end}");
    assert!(
        followed(end).reached < followed(end).duration && followed(end).reached >= Duration::from_millis(500),
        "{end:?}"
    );
}

#[test]
fn a_stop_brakes_along_the_trajectory() {
    let (arm, mut robot, end) = ended_by(&config(), |_, run| run.stop().expect("it goes on"));
    assert_ended_on_the_way(&end, Cause::Stopped);
    assert!(end.error.is_none() && end.rest.was_seen() && !followed(&end).has_left_curve, "{end:?}");
    let set_points = judge(&arm, &to_and_fro(), &end);
    let last = set_points.last().expect("there are some");
    assert!(apart(&to_and_fro().at(followed(&end).reached.as_secs_f64()), last) < 1e-6);
    assert!(!names(&arm).iter().any(|name| name == "stop_program") && !arm.state().servo_mode);
    let text = end.reached().expect_err("it was stopped").to_string();
    assert!(
        text.starts_with("the motion was stopped before its target (")
            && text.contains(" s of 3.000 s of the trajectory), and the arm is at rest; look at the arm"),
        "{text}"
    );
    // Nothing must be acknowledged.
    robot
        .start_follow(&made(&to_and_fro()), &config().approach(60.0))
        .expect("the way is free")
        .handle()
        .stop()
        .expect("it runs");
}

#[test]
fn a_run_in_a_pause_can_be_stopped_and_so_can_one_on_the_way_to_its_start() {
    let (_, _, end) = ended_by(&config(), |_, run| {
        run.pause().expect("it goes on");
        run.stop().expect("it goes on");
    });
    assert_ended_on_the_way(&end, Cause::Stopped);
    let (arm, mut robot) = ready();
    arm.set_state(|state| state.joint_position.0[0] += 60.0);
    let run = robot.start_follow(&made(&to_and_fro()), &config().approach(20.0)).expect("the way is free");
    arm.clock().sleep(Duration::from_millis(300));
    assert!(run.handle().progress().time.is_zero() && run.handle().progress().rate == 0.0);
    run.handle().stop().expect("it goes on");
    let end = run.wait();
    assert_eq!((end.cause(), followed(&end).reached), (Cause::Stopped, Duration::ZERO));
    let at = arm.state().joint_position.0[0] - START[0];
    assert!((10.0..60.0).contains(&at), "{at}");
}

#[test]
fn a_deadline_stops_along_the_trajectory() {
    let (arm, mut robot) = ready();
    let config = config().deadline(Duration::from_millis(1500));
    let end = robot.start_follow(&made(&to_and_fro().slower(3.0)), &config).expect("the arm is at its start").wait();
    assert_eq!(end.cause(), Cause::Deadline, "{end}");
    assert!(end.error.is_none() && followed(&end).reached < followed(&end).duration && end.rest.was_seen(), "{end:?}");
    judge(&arm, &to_and_fro().slower(3.0), &end);
    assert!(end.to_string().starts_with("the motion has not ended in time ("), "{end}");
}

#[test]
fn a_stop_of_the_robot_brakes_along_the_trajectory_before_it_goes_out() {
    let (arm, mut robot) = ready();
    let stop = robot.stop_handle();
    let run = robot.start_follow(&made(&to_and_fro()), &config()).expect("the arm is at its start");
    wait_for(&arm, &run.handle(), 0.5);
    stop.stop().expect("the controller takes it");
    let end = run.wait();
    assert_ended_on_the_way(&end, Cause::Stopped);
    assert!(
        end.rest.was_seen()
            && matches!(end.error.as_ref().expect("it says so").kind(), ErrorKind::NotAcknowledged { .. })
    );
    judge(&arm, &to_and_fro(), &end);
    assert!(set_points(&arm).1.contains(&"stop_program".to_owned()));
    let error = robot.start_follow(&made(&to_and_fro()), &config()).expect_err("nobody has acknowledged it");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
}

#[test]
fn a_protective_stop_ends_it_at_once() {
    let (arm, _robot, end) = ended_by(&config(), |arm, _| arm.collide());
    assert_ended_on_the_way(&end, Cause::ProtectiveStop);
    assert!(!end.rest.was_seen() && !followed(&end).has_left_curve && end.report.landing_cycles == 0, "{end:?}");
    to_and_fro().has(&set_points(&arm).0).expect("no set-point was sent off the curve");
    let (_, _, end) = ended_by(&config(), |arm, _| arm.press_emergency_stop());
    assert_ended_on_the_way(&end, Cause::EmergencyStop);
}

#[test]
fn a_status_that_is_no_longer_known_brakes_it_along_the_trajectory() {
    let soon_stale = arm().config(|config| config.stale_after(Duration::from_millis(500)));
    let (arm, mut robot) = ready_with(soon_stale, limits());
    let run = robot.start_follow(&made(&to_and_fro().slower(2.0)), &config()).expect("the arm is at its start");
    arm.link(Port::Status).to_client().hold();
    let end = run.wait();
    assert_eq!(end.cause(), Cause::StatusLost, "{end}");
    assert!(
        !end.rest.was_seen() && !followed(&end).has_left_curve && followed(&end).reached < followed(&end).duration,
        "{end:?}"
    );
    judge(&arm, &to_and_fro().slower(2.0), &end);
    assert!(!arm.state().servo_mode);
}

#[test]
fn a_refused_set_point_ends_it_on_the_trajectory() {
    let refusal = br#"{"errorCode":"3","errorMsg":"no","cmdName":"servo_j"}"#.to_vec();
    let (arm, _robot, end) = ended_by(&config(), |arm, _| arm.inject_for("servo_j", Fault::Instead(refusal)));
    assert_ended_on_the_way(&end, Cause::NoRemoteControl);
    assert!(end.report.refused == 1 && end.error.as_ref().is_some_and(jaka_robot::Error::is_refused), "{end:?}");
    judge(&arm, &to_and_fro(), &end);
}

#[test]
fn an_arm_that_does_not_follow_departs_and_one_that_lags_shows_by_how_much() {
    let run = |lag: Duration, config: &FollowConfig| {
        let (arm, mut robot) = lagging(lag);
        let end = robot.start_follow(&made(&to_and_fro()), config).expect("the arm is at its start").wait();
        judge(&arm, &to_and_fro(), &end);
        end
    };
    let end = run(Duration::from_millis(1500), &patient().max_departure(3.0));
    assert_ended_on_the_way(&end, Cause::Departed);
    assert!(!end.rest.was_seen() && !followed(&end).has_left_curve, "it is not held: {end:?}");
    let [quick, slow] = [0, 150].map(|lag| run(Duration::from_millis(lag), &patient()));
    assert!(matches!((quick.cause(), slow.cause()), (Cause::Reached, Cause::Reached)));
    let [quick, slow] = [quick, slow].map(|end| followed(&end).lag.expect("the arm has moved"));
    let more = slow.delay.saturating_sub(quick.delay);
    assert!((80..=220).contains(&more.as_millis()), "{quick:?} {slow:?}");
    assert!(slow.residual_deg[5] > 0.0 && slow.worst_deg[5] >= slow.residual_deg[5], "{slow:?}");
    assert_eq!([slow.worst_deg[1], slow.worst_deg[2]].map(|degrees| degrees < 1e-3), [true; 2], "they stand: {slow:?}");
}

#[test]
fn a_link_that_is_held_or_cut_ends_it() {
    for cut in [false, true] {
        let (arm, mut robot) = ready();
        let run = robot.start_follow(&made(&to_and_fro().slower(3.0)), &config()).expect("the arm is at its start");
        wait_for(&arm, &run.handle(), 0.2);
        if cut {
            arm.disconnect();
        } else {
            arm.links().hold();
        }
        let end = run.wait();
        assert_eq!(end.cause(), if cut { Cause::CommandsLost } else { Cause::Unanswered }, "{cut}: {end}");
        assert!(
            !end.rest.was_seen() && end.error.as_ref().is_some_and(jaka_robot::Error::may_have_run),
            "{cut}: {end:?}"
        );
        arm.links().release();
        to_and_fro().slower(3.0).has(&set_points(&arm).0).expect("they are on the curve");
    }
}

#[test]
fn a_run_that_is_dropped_or_unwinds_stops_along_the_trajectory() {
    for panics in [false, true] {
        let (arm, mut robot) = ready();
        let end = catch_unwind(AssertUnwindSafe(|| {
            let run = robot.start_follow(&made(&to_and_fro()), &config()).expect("the arm is at its start");
            wait_for(&arm, &run.handle(), 0.5);
            assert!(!panics, "a bug in the user's program");
        }));
        assert_eq!(end.is_err(), panics);
        let (set_points, _) = set_points(&arm);
        to_and_fro().has(&set_points).expect("they are on the curve");
        assert!(
            set_points.len() < 90
                && JointPosition(set_points[set_points.len() - 2]) == JointPosition(set_points[set_points.len() - 1])
        );
        assert!(!arm.state().servo_mode);
        robot.client().get_version().expect("the connection works");
    }
}

/// Way, speed and acceleration at a time of a joint that gains speed from a start on for so long, and loses it for as
/// long, with an acceleration that is reached in [`RAMP_S`].
fn hump(time_s: f64, start_s: f64, half_s: f64, acceleration: f64) -> [f64; 3] {
    let (jerk, held_s) = (acceleration / RAMP_S, half_s - 2.0 * RAMP_S);
    let phases = [(RAMP_S, jerk), (held_s, 0.0), (2.0 * RAMP_S, -jerk), (held_s, 0.0), (RAMP_S, jerk)];
    let (mut left_s, mut state) = ((time_s - start_s).max(0.0), [0.0; 3]);
    for (seconds, jerk) in phases {
        let (passed, [way, speed, gains]) = (left_s.min(seconds), state);
        left_s -= passed;
        state = [
            way + passed * (speed + passed * (gains / 2.0 + passed * jerk / 6.0)),
            speed + passed * (gains + passed * jerk / 2.0),
            gains + passed * jerk,
        ];
    }
    // Rounding leaves some of it.
    if time_s >= start_s + 2.0 * half_s { [state[0], 0.0, 0.0] } else { state }
}

/// In seconds.
const RAMP_S: f64 = 0.02;

/// Times at which the jerk of a hump changes.
fn changes(start_s: f64, half_s: f64) -> [f64; 6] {
    let end_s = start_s + 2.0 * half_s;
    let middle_s = start_s + half_s;
    [start_s, start_s + RAMP_S, middle_s - RAMP_S, middle_s + RAMP_S, end_s - RAMP_S, end_s]
}

/// Points at the times at which the jerk of one of these humps, by their joint, start and half of their time, changes.
fn humps(humps: &[(usize, f64, f64, f64)], start: [f64; 6]) -> Vec<TimedPoint> {
    let mut times: Vec<f64> = humps.iter().flat_map(|(_, start_s, half_s, _)| changes(*start_s, *half_s)).collect();
    times.sort_by(f64::total_cmp);
    times.dedup_by(|one, other| (*one - *other).abs() < 1e-9);
    let at = |time_s: f64| {
        let (mut joints, mut speeds, mut accelerations) = (start, [0.0; 6], [0.0; 6]);
        for (joint, start_s, half_s, acceleration) in humps {
            let [way, speed, gains] = hump(time_s, *start_s, *half_s, *acceleration);
            joints[*joint] += way;
            speeds[*joint] += speed;
            accelerations[*joint] += gains;
        }
        TimedPoint::new(time_s, joints).with_velocity(speeds).with_acceleration(accelerations)
    };
    times.into_iter().map(at).collect()
}

/// Motions have this acceleration and any jerk.
fn with_accelerations(acceleration: f64) -> Limits {
    let limits = limits().with_joint_accelerations([acceleration; 6]).expect("above 0");
    limits.with_joint_jerks([1.01 * acceleration / RAMP_S; 6]).expect("above 0")
}

/// From 1 s to the end at 4 s one joint or another loses speed by all of its acceleration: joint 6 before it turns
/// round at 2 s and before the end, joints 4 and 5 in between.
fn without_reserve() -> (Limits, Vec<TimedPoint>) {
    let limits = with_accelerations(25.0).with_stop_accelerations([25.0; 6]).expect("above 0");
    let of_joints = [(5, 0.0, 1.0, -25.0), (5, 2.0, 1.0, 25.0), (3, 0.7, 1.0, 25.0), (4, 1.4, 1.0, 25.0)];
    (limits, humps(&of_joints, START))
}

/// End of such a run after a stop near the point where joint 6 turns round, and that point.
fn stopped_without_reserve(stop: impl FnOnce(&RobotStop, &FollowHandle)) -> (End, f64) {
    let (limits, points) = without_reserve();
    let (arm, mut robot) = ready_with(arm(), limits);
    let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some")).expect("within the limits");
    let handle = robot.stop_handle();
    let run = robot.start_follow(&trajectory, &config()).expect("the arm is at its start");
    wait_for(&arm, &run.handle(), 1.9);
    stop(&handle, &run.handle());
    let end = run.wait();
    let (set_points, _) = set_points(&arm);
    let second = |three: &[[f64; 6]], joint: usize| three[2][joint] - 2.0 * three[1][joint] + three[0][joint];
    let worst =
        |three: &[[f64; 6]]| (3..6).map(|joint| second(three, joint).abs()).fold(0.0, f64::max) / PERIOD.powi(2);
    let worst = set_points.windows(3).map(worst).fold(0.0, f64::max);
    assert!(worst <= 25.0 * (1.0 + 1e-6) && end.report.gaps == 0, "{worst}: {end:?}");
    let last = set_points.last().expect("there are some")[5];
    (end, last)
}

#[test]
fn where_the_trajectory_leaves_no_room_an_error_brakes_straight_on_and_a_stop_goes_on_until_there_is() {
    let (end, last) = stopped_without_reserve(|robot, _| robot.stop().expect("the controller takes it"));
    assert_eq!((end.cause(), followed(&end).has_left_curve), (Cause::Stopped, true), "{end:?}");
    assert!(end.rest.was_seen() && last < -20.0, "next to where it turns: {last}");
    let (end, last) = stopped_without_reserve(|_, run| run.stop().expect("it goes on"));
    // It has stopped at the end, or as good as there.
    assert!(
        !followed(&end).has_left_curve && followed(&end).reached > Duration::from_secs(3) && last > -1.0,
        "{end:?} {last}"
    );
}

/// A stop of the robot finds a run in which joint 1 slows down and joint 6 gets faster, with all of their acceleration.
/// How it ended, the set-points that came, and how many of these came before the stop.
fn stopped_in_between(stop_deg_s2: f64) -> (End, Vec<[f64; 6]>, usize) {
    let limits = with_accelerations(70.0).with_stop_accelerations([stop_deg_s2; 6]).expect("above 0");
    let mut start = START;
    (start[0], start[5]) = (-220.0, -220.0);
    let points = humps(&[(0, 0.0, 2.5, 70.0), (5, 2.2, 2.5, 70.0)], start);
    let (arm, mut robot) = ready_with(arm().at(points[0].joints.0), limits);
    let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some")).expect("within the limits");
    let stop = robot.stop_handle();
    let run = robot.start_follow(&trajectory, &config()).expect("the arm is at its start");
    wait_for(&arm, &run.handle(), 3.8);
    let before = set_points(&arm).0.len();
    stop.stop().expect("the controller takes it");
    (run.wait(), set_points(&arm).0, before)
}

/// Braking along the trajectory would take longer than the stop waits, and not much longer than braking straight on.
#[test]
fn a_stop_of_the_robot_that_would_go_out_before_the_arm_is_braked_along_the_trajectory_brakes_it_straight_on() {
    let (end, set_points, _) = stopped_in_between(70.0);
    assert_eq!((end.cause(), followed(&end).has_left_curve), (Cause::Stopped, true), "{end:?}");
    let speeds: Vec<f64> = set_points.windows(2).map(|two| (two[1][5] - two[0][5]) / PERIOD).collect();
    let (fastest, last) = (speeds.iter().copied().fold(0.0, f64::max), speeds[speeds.len() - 1]);
    assert!(end.rest.was_seen() && fastest > 100.0 && last < 70.0 * PERIOD * 1.01, "from {fastest} to {last}: {end:?}");
}

/// From some 115 deg/s.
#[test]
fn a_stop_with_its_own_acceleration_brakes_along_a_trajectory_that_leaves_motions_none() {
    let (end, set_points, before) = stopped_in_between(570.0);
    assert_eq!((end.cause(), followed(&end).has_left_curve), (Cause::Stopped, false), "{end:?}");
    assert!(end.rest.was_seen(), "{end:?}");
    assert_eq!(jump(set_points[0], &set_points), None);
    let braked_s = f64::from(u32::try_from(set_points.len() - before).expect("some")) * PERIOD;
    assert!((0.2..0.5).contains(&braked_s), "{braked_s} s: {end:?}");
}

#[test]
fn a_guard_stops_it_along_the_trajectory_and_one_that_trips_before_sends_nothing() {
    let (arm, mut robot) = ready();
    let is_low = |packet: &RobotStatus| packet.joint_actual_position.is_some_and(|joints| joints.0[5] < START[5] - 5.0);
    let guard = Guard::when("joint 6 is low", is_low);
    let run = robot.start_follow(&made(&to_and_fro()), &config().guard(guard.clone())).expect("it is not low yet");
    let end = run.wait();
    assert_eq!(end.cause(), Cause::Guard, "{end}");
    assert!(
        end.rest.was_seen() && !followed(&end).has_left_curve && followed(&end).reached < followed(&end).duration,
        "{end:?}"
    );
    assert!(matches!(end.error.as_ref().expect("it says which").kind(), ErrorKind::GuardTripped { .. }));
    judge(&arm, &to_and_fro(), &end);
    let before = names(&arm).len();
    arm.set_state(|state| state.joint_position.0[5] = START[5] - 6.0);
    robot.monitor().wait_until(is_low, LONG).expect("packets show it");
    let config = config().approach(20.0);
    let error = robot.start_follow(&made(&to_and_fro()), &config.clone().guard(guard)).expect_err("it is low already");
    assert!(matches!(error.kind(), ErrorKind::GuardTripped { .. }) && !error.may_have_run(), "{error:?}");
    assert_eq!(names(&arm).len(), before, "not even a query");
}

#[test]
fn a_guard_that_trips_while_the_arm_goes_on_to_the_last_set_point_is_told() {
    let far = |packet: &RobotStatus| packet.joint_actual_position.is_some_and(|joints| joints.0[0] > START[0] + 14.5);
    let lags = || lagging(Duration::from_millis(800));
    let (_arm, mut robot) = lags();
    let there = turned([15.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let curve = Curve::through(&[(0.0, START), (1.0, there)]);
    let end = robot.start_follow(&made(&curve), &patient().guard(Guard::when("joint 1 is far", far)));
    let end = end.expect("it is not far yet").wait();
    assert_eq!((end.cause(), followed(&end).reached), (Cause::Guard, followed(&end).duration), "{end:?}");
    assert!(end.rest.was_seen() && !followed(&end).has_left_curve, "{end:?}");
    assert!(matches!(end.error.as_ref().expect("it says which").kind(), ErrorKind::GuardTripped { .. }));
    // A stream likewise.
    let (arm, mut robot) = lags();
    let servo = ServoConfig::new().step_count(CYCLES).rest_timeout(LONG);
    let config = StreamConfig::new().servo(servo).max_departure(1000.0);
    let stream = robot.stream(&config.clone().guard(Guard::when("joint 1 is far", far))).expect("it is not far yet");
    stream.handle().set_joints(there).expect("within the limits");
    wait_until(&arm, || stream.handle().joints().max_distance(&JointPosition(there)) <= 0.2);
    let error = stream.land().expect_err("the guard has tripped");
    assert!(matches!(error.kind(), ErrorKind::GuardTripped { .. }), "{error:?}");
}

#[test]
fn where_packets_do_not_show_the_joints_none_begins_and_one_that_goes_on_is_braked() {
    let (arm, mut robot) = ready();
    let servo = ServoConfig::new().step_count(CYCLES).rest_timeout(Duration::from_millis(500));
    let curve = to_and_fro().slower(2.0);
    let run = robot.start_follow(&made(&curve), &config().servo(servo)).expect("the arm is at its start");
    wait_for(&arm, &run.handle(), 0.2);
    arm.set_status([("joint_actual_position".to_owned(), Value::from("x"))]);
    let end = run.wait();
    assert_eq!(end.cause(), Cause::NotShown, "{end}");
    assert!(
        !end.rest.was_seen() && !followed(&end).has_left_curve && followed(&end).reached < followed(&end).duration,
        "{end:?}"
    );
    judge(&arm, &curve, &end);
    let text = end.error.as_ref().expect("it says so").to_string();
    assert!(text.contains("it is not known whether the joints follow their set-points"), "{text}");
    let before = names(&arm).len();
    let error = robot.start_follow(&made(&curve), &config()).expect_err("they are not shown");
    assert!(matches!(error.kind(), ErrorKind::NotShown { .. }) && !error.may_have_run(), "{error:?}");
    let error = robot.stream(&StreamConfig::new()).expect_err("they are not shown");
    assert!(matches!(error.kind(), ErrorKind::NotShown { .. }), "{error:?}");
    assert!(!names(&arm)[before..].contains(&"servo_move".to_owned()));
}
