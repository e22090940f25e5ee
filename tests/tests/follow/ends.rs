//! How trajectories end before their end.

use std::panic::{AssertUnwindSafe, catch_unwind};

use jaka_sim::{Fault, Port};
use jaka_sync::jaka_motion::TimedPoint;
use jaka_sync::status::RobotStatus;
use jaka_sync::types::JointPosition;
use jaka_sync::{Guard, StreamConfig};

use super::*;

/// A run on its way, and what becomes of it.
fn ended_by(config: &FollowConfig, act: impl FnOnce(&Controller, &FollowHandle)) -> (Controller, Robot, FollowEnd) {
    let (controller, mut robot) = ready();
    let run = robot.start_follow(&made(&to_and_fro()), config).expect("the arm is at its start");
    wait_for(&controller, &run, 0.5);
    act(&controller, &run);
    let end = run.wait();
    (controller, robot, end)
}

fn assert_ended_on_the_way(end: &FollowEnd, outcome: FollowOutcome) {
    assert_eq!(end.outcome, outcome, "{end}");
    assert!(end.reached < end.duration && end.reached >= Duration::from_millis(500), "{end:?}");
}

#[test]
fn a_stop_brakes_along_the_trajectory() {
    let (controller, mut robot, end) = ended_by(&patient(), |_, run| run.stop().expect("it goes on"));
    assert_ended_on_the_way(&end, FollowOutcome::Stopped);
    assert!(end.error.is_none() && end.is_at_rest() && !end.has_left_curve, "{end:?}");
    let set_points = judge(&controller, &to_and_fro(), &end);
    let last = set_points.last().expect("there are some");
    assert!(apart(&to_and_fro().at(end.reached.as_secs_f64()), last) < 1e-6);
    assert!(!names(&controller).iter().any(|name| name == "stop_program") && !controller.state().servo_mode);
    let text = end.completed().expect_err("it was stopped").to_string();
    assert!(
        text.starts_with("the trajectory was stopped before its end (")
            && text.ends_with(" s of 3.000 s), and the arm is at rest"),
        "{text}"
    );
    // Nothing must be acknowledged.
    robot
        .start_follow(&made(&to_and_fro()), &patient().approach(60.0))
        .expect("the way is free")
        .stop()
        .expect("it runs");
}

#[test]
fn a_run_in_a_pause_can_be_stopped_and_so_can_one_on_the_way_to_its_start() {
    let (_, _, end) = ended_by(&patient(), |_, run| {
        run.pause().expect("it goes on");
        run.stop().expect("it goes on");
    });
    assert_ended_on_the_way(&end, FollowOutcome::Stopped);
    let (controller, mut robot) = ready();
    controller.set_state(|state| state.joint_position.0[0] += 60.0);
    let run = robot.start_follow(&made(&to_and_fro()), &patient().approach(20.0)).expect("the way is free");
    clock_of(&controller).sleep(Duration::from_millis(300));
    assert!(run.progress().time.is_zero() && run.progress().rate == 0.0);
    run.stop().expect("it goes on");
    let end = run.wait();
    assert_eq!((end.outcome, end.reached), (FollowOutcome::Stopped, Duration::ZERO));
    let at = controller.state().joint_position.0[0] - START[0];
    assert!((10.0..60.0).contains(&at), "{at}");
}

#[test]
fn a_deadline_stops_along_the_trajectory() {
    let (controller, mut robot) = ready();
    let config = patient().deadline(Duration::from_millis(1500));
    let end = robot.start_follow(&made(&to_and_fro().slower(3.0)), &config).expect("the arm is at its start").wait();
    assert_eq!(end.outcome, FollowOutcome::Deadline, "{end}");
    assert!(end.error.is_none() && end.reached < end.duration && end.is_at_rest(), "{end:?}");
    judge(&controller, &to_and_fro().slower(3.0), &end);
    assert!(end.to_string().starts_with("the trajectory was not done by its deadline, and was stopped ("), "{end}");
}

#[test]
fn a_stop_of_the_robot_brakes_along_the_trajectory_before_it_goes_out() {
    let (controller, mut robot) = ready();
    let stop = robot.stop_handle();
    let run = robot.start_follow(&made(&to_and_fro()), &patient()).expect("the arm is at its start");
    wait_for(&controller, &run, 0.5);
    stop.stop().expect("the controller takes it");
    let end = run.wait();
    assert_ended_on_the_way(&end, FollowOutcome::Stopped);
    assert!(
        end.is_at_rest() && matches!(end.error.as_ref().expect("it says so").kind(), ErrorKind::NotAcknowledged { .. })
    );
    judge(&controller, &to_and_fro(), &end);
    assert!(set_points(&controller).1.contains(&"stop_program".to_owned()));
    let error = robot.start_follow(&made(&to_and_fro()), &patient()).expect_err("nobody has acknowledged it");
    assert!(matches!(error.kind(), ErrorKind::NotAcknowledged { .. }), "{error:?}");
}

#[test]
fn a_protective_stop_ends_it_at_once() {
    let (controller, _robot, end) = ended_by(&patient(), |controller, _| controller.collide());
    assert_ended_on_the_way(&end, FollowOutcome::ProtectiveStop);
    assert!(!end.is_at_rest() && !end.has_left_curve && end.report.landing_cycles == 0, "{end:?}");
    to_and_fro().has(&set_points(&controller).0).expect("no set-point was sent off the curve");
    let (_, _, end) = ended_by(&patient(), |controller, _| controller.press_emergency_stop());
    assert_ended_on_the_way(&end, FollowOutcome::EmergencyStop);
}

#[test]
fn a_status_that_is_no_longer_known_brakes_it_along_the_trajectory() {
    let config = Config::new().stale_after(Duration::from_millis(500));
    let (controller, mut robot) = ready_of(Controller::builder(), config);
    let run = robot.start_follow(&made(&to_and_fro().slower(2.0)), &patient()).expect("the arm is at its start");
    controller.link(Port::Status).to_client().hold();
    let end = run.wait();
    assert_eq!(end.outcome, FollowOutcome::StatusLost, "{end}");
    assert!(!end.is_at_rest() && !end.has_left_curve && end.reached < end.duration, "{end:?}");
    judge(&controller, &to_and_fro().slower(2.0), &end);
    assert!(!controller.state().servo_mode);
}

#[test]
fn a_refused_set_point_ends_it_on_the_trajectory() {
    let refusal = br#"{"errorCode":"3","errorMsg":"no","cmdName":"servo_j"}"#.to_vec();
    let (controller, _robot, end) =
        ended_by(&patient(), |controller, _| controller.inject_for("servo_j", Fault::Instead(refusal)));
    assert_ended_on_the_way(&end, FollowOutcome::Refused);
    assert!(end.report.refused == 1 && end.error.as_ref().is_some_and(jaka_sync::Error::is_refused), "{end:?}");
    judge(&controller, &to_and_fro(), &end);
}

#[test]
fn a_set_point_that_is_too_late_is_an_underrun() {
    let config = patient().max_gap(Duration::from_nanos(1));
    let (controller, mut robot) = ready_in_real_time();
    let end = robot.start_follow(&made(&to_and_fro()), &config).expect("the arm is at its start").wait();
    assert_eq!(end.outcome, FollowOutcome::Underrun, "{end}");
    assert!(!end.has_left_curve, "{end:?}");
    if end.report.cycles > 0 {
        judge(&controller, &to_and_fro(), &end);
    }
}

#[test]
fn an_arm_that_does_not_follow_departs_and_one_that_lags_shows_by_how_much() {
    let run = |lag: Duration, config: &FollowConfig| {
        let (controller, mut robot) = ready_of(Controller::builder().lag(lag), Config::new());
        let end = robot.start_follow(&made(&to_and_fro()), config).expect("the arm is at its start").wait();
        judge(&controller, &to_and_fro(), &end);
        end
    };
    let end = run(Duration::from_millis(1500), &patient().max_departure(3.0));
    assert_ended_on_the_way(&end, FollowOutcome::Departed);
    assert!(end.is_at_rest() && !end.has_left_curve, "{end:?}");
    let [quick, slow] = [0, 150].map(|lag| run(Duration::from_millis(lag), &patient()));
    assert!(matches!((quick.outcome, slow.outcome), (FollowOutcome::Completed, FollowOutcome::Completed)));
    let [quick, slow] = [quick, slow].map(|end| end.lag.expect("the arm has moved"));
    let more = slow.delay.saturating_sub(quick.delay);
    assert!((80..=220).contains(&more.as_millis()), "{quick:?} {slow:?}");
    assert!(slow.residual_deg[5] > 0.0 && slow.worst_deg[5] >= slow.residual_deg[5], "{slow:?}");
    assert_eq!([slow.worst_deg[1], slow.worst_deg[2]].map(|degrees| degrees < 1e-3), [true; 2], "they stand: {slow:?}");
}

#[test]
fn a_link_that_is_held_or_cut_ends_it() {
    for cut in [false, true] {
        let config = patient().servo(ServoConfig::new().step_count(CYCLES));
        let (controller, mut robot) = ready();
        let run = robot.start_follow(&made(&to_and_fro().slower(3.0)), &config).expect("the arm is at its start");
        wait_for(&controller, &run, 0.2);
        if cut {
            controller.disconnect();
        } else {
            controller.links().hold();
        }
        let end = run.wait();
        assert_eq!(end.outcome, FollowOutcome::LinkLost, "{cut}: {end}");
        assert!(!end.is_at_rest() && end.error.as_ref().is_some_and(jaka_sync::Error::may_have_run), "{cut}: {end:?}");
        controller.links().release();
        to_and_fro().slower(3.0).has(&set_points(&controller).0).expect("they are on the curve");
    }
}

#[test]
fn a_run_that_is_dropped_or_unwinds_stops_along_the_trajectory() {
    for panics in [false, true] {
        let (controller, mut robot) = ready();
        let end = catch_unwind(AssertUnwindSafe(|| {
            let run = robot.start_follow(&made(&to_and_fro()), &patient()).expect("the arm is at its start");
            wait_for(&controller, &run, 0.5);
            assert!(!panics, "a bug in the user's program");
        }));
        assert_eq!(end.is_err(), panics);
        let (set_points, _) = set_points(&controller);
        to_and_fro().has(&set_points).expect("they are on the curve");
        assert!(
            set_points.len() < 90
                && JointPosition(set_points[set_points.len() - 2]) == JointPosition(set_points[set_points.len() - 1])
        );
        assert!(!controller.state().servo_mode);
        robot.client().get_version().expect("the connection works");
    }
}

/// All of joint 6's acceleration is used from the start to the end: 2 s one way, 4 s the other, 2 s to rest.
fn without_reserve() -> (Limits, [TimedPoint; 4]) {
    let limits = limits().with_joint_accelerations([25.0; 6]).expect("above 0");
    let at = |time_s: f64, joint_6: f64, speed: f64| {
        let [mut joints, mut speeds] = [START, [0.0; 6]];
        (joints[5], speeds[5]) = (joint_6, speed);
        TimedPoint::new(time_s, joints).with_velocity(speeds)
    };
    (limits, [at(0.0, 0.0, 0.0), at(1.0, -12.5, -25.0), at(3.0, -12.5, 25.0), at(4.0, 0.0, 0.0)])
}

/// How such a run ends that is stopped next to where joint 6 turns round, and where that is; none where the machine was so busy that the arm has
/// stood meanwhile: then there is room.
fn stopped_without_reserve(by_robot: bool) -> Option<(FollowEnd, f64)> {
    let (limits, points) = without_reserve();
    let (controller, robot) = plain();
    let mut robot = robot.with_limits(limits).expect("it is this arm");
    let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some")).expect("within the limits");
    let stop = robot.stop_handle();
    let run = robot.start_follow(&trajectory, &patient()).expect("the arm is at its start");
    wait_for(&controller, &run, 1.9);
    if by_robot {
        stop.stop().expect("the controller takes it");
    } else {
        run.stop().expect("it goes on");
    }
    let end = run.wait();
    let (set_points, _) = set_points(&controller);
    let second = |three: &[[f64; 6]]| (three[2][5] - 2.0 * three[1][5] + three[0][5]).abs() / PERIOD.powi(2);
    let worst = set_points.windows(3).map(second).fold(0.0, f64::max);
    let last = set_points.last()?[5];
    // It has stood where it jumps, or is late enough for that.
    (worst <= 25.0 * (1.0 + 1e-6) && end.report.gaps == 0).then_some((end, last))
}

#[test]
fn where_the_trajectory_leaves_no_room_an_error_brakes_straight_on_and_a_stop_goes_on_until_there_is() {
    let tried = |by_robot: bool| (0..20).find_map(|_| stopped_without_reserve(by_robot)).expect("one is not disturbed");
    let (end, last) = tried(true);
    assert_eq!((end.outcome, end.has_left_curve), (FollowOutcome::Stopped, true), "{end:?}");
    assert!(end.is_at_rest() && last < -20.0, "next to where it turns: {last}");
    let (end, last) = tried(false);
    // It has stopped at the end, or as good as there.
    assert!(!end.has_left_curve && end.reached > Duration::from_secs(3) && last > -1.0, "{end:?} {last}");
}

/// How a run ends that a stop of the robot finds on the way to its greatest speed: braking along the trajectory would take longer than the stop waits, and not much
/// longer than braking straight on. None where the machine was so busy that the arm has stood meanwhile.
fn stopped_at_speed() -> Option<(FollowEnd, Vec<[f64; 6]>)> {
    let limits = limits().with_joint_accelerations([70.0; 6]).expect("above 0");
    let at = |time_s: f64, joint_6: f64, speed: f64| {
        let [mut joints, mut speeds] = [START, [0.0; 6]];
        (joints[5], speeds[5]) = (joint_6, speed);
        TimedPoint::new(time_s, joints).with_velocity(speeds)
    };
    let points = [at(0.0, -220.0, 0.0), at(2.5, -1.25, 175.0), at(5.0, 217.5, 0.0)];
    let (controller, robot) = plain();
    controller.set_state(|state| state.joint_position = points[0].joints);
    let mut robot = robot.with_limits(limits).expect("it is this arm");
    let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some")).expect("within the limits");
    let stop = robot.stop_handle();
    let run = robot.start_follow(&trajectory, &patient()).expect("the arm is at its start");
    wait_for(&controller, &run, 1.6);
    stop.stop().expect("the controller takes it");
    let end = run.wait();
    (end.report.gaps == 0).then(|| (end, set_points(&controller).0))
}

#[test]
fn a_stop_of_the_robot_that_would_go_out_before_the_arm_is_braked_along_the_trajectory_brakes_it_straight_on() {
    let (end, set_points) = (0..20).find_map(|_| stopped_at_speed()).expect("one is not disturbed");
    assert_eq!((end.outcome, end.has_left_curve), (FollowOutcome::Stopped, true), "{end:?}");
    let speeds: Vec<f64> = set_points.windows(2).map(|two| (two[1][5] - two[0][5]) / PERIOD).collect();
    let (fastest, last) = (speeds.iter().copied().fold(0.0, f64::max), speeds[speeds.len() - 1]);
    assert!(end.is_at_rest() && fastest > 100.0 && last < 70.0 * PERIOD * 1.01, "from {fastest} to {last}: {end:?}");
}

#[test]
fn a_guard_stops_it_along_the_trajectory_and_one_that_trips_before_sends_nothing() {
    let (controller, mut robot) = ready();
    let is_low = |packet: &RobotStatus| packet.joint_actual_position.is_some_and(|joints| joints.0[5] < START[5] - 5.0);
    let guard = Guard::when("joint 6 is low", is_low);
    let run = robot.start_follow_until(&made(&to_and_fro()), &patient(), guard.clone()).expect("it is not low yet");
    let end = run.wait();
    assert_eq!(end.outcome, FollowOutcome::Guard, "{end}");
    assert!(end.is_at_rest() && !end.has_left_curve && end.reached < end.duration, "{end:?}");
    assert!(matches!(end.error.as_ref().expect("it says which").kind(), ErrorKind::GuardTripped { .. }));
    judge(&controller, &to_and_fro(), &end);
    let before = names(&controller).len();
    controller.set_state(|state| state.joint_position.0[5] = START[5] - 6.0);
    robot.monitor().wait_until(is_low, LONG).expect("packets show it");
    let config = patient().approach(20.0);
    let error = robot.start_follow_until(&made(&to_and_fro()), &config, guard).expect_err("it is low already");
    assert!(matches!(error.kind(), ErrorKind::GuardTripped { .. }) && !error.may_have_run(), "{error:?}");
    assert_eq!(names(&controller).len(), before, "not even a query");
}

#[test]
fn a_guard_that_trips_while_the_arm_goes_on_to_the_last_set_point_is_told() {
    let far = |packet: &RobotStatus| packet.joint_actual_position.is_some_and(|joints| joints.0[0] > START[0] + 14.5);
    let lags = || ready_of(Controller::builder().lag(Duration::from_millis(800)), Config::new());
    let (_controller, mut robot) = lags();
    let there = turned([15.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let curve = Curve::through(&[(0.0, START), (1.0, there)]);
    let end = robot.start_follow_until(&made(&curve), &patient(), Guard::when("joint 1 is far", far));
    let end = end.expect("it is not far yet").wait();
    assert_eq!((end.outcome, end.reached), (FollowOutcome::Guard, end.duration), "{end:?}");
    assert!(end.is_at_rest() && !end.has_left_curve, "{end:?}");
    assert!(matches!(end.error.as_ref().expect("it says which").kind(), ErrorKind::GuardTripped { .. }));
    // A stream likewise.
    let (controller, mut robot) = lags();
    let servo = ServoConfig::new().step_count(CYCLES).max_unanswered(LONG).rest_timeout(LONG);
    let config = StreamConfig::new().servo(servo).max_gap(LONG).max_departure(1000.0);
    let stream = robot.stream_until(&config, Guard::when("joint 1 is far", far)).expect("it is not far yet");
    stream.set_joints(there).expect("within the limits");
    wait_until(&controller, || stream.joints().max_distance(&JointPosition(there)) <= 0.2);
    let error = stream.land().expect_err("the guard has tripped");
    assert!(matches!(error.kind(), ErrorKind::GuardTripped { .. }), "{error:?}");
}

#[test]
fn where_packets_do_not_show_the_joints_none_begins_and_one_that_goes_on_is_braked() {
    let (controller, mut robot) = ready();
    let servo = ServoConfig::new().step_count(CYCLES).max_unanswered(LONG).rest_timeout(Duration::from_millis(500));
    let curve = to_and_fro().slower(2.0);
    let run = robot.start_follow(&made(&curve), &patient().servo(servo)).expect("the arm is at its start");
    wait_for(&controller, &run, 0.2);
    controller.set_status([("joint_actual_position".to_owned(), Value::from("x"))]);
    let end = run.wait();
    assert_eq!(end.outcome, FollowOutcome::StatusLost, "{end}");
    assert!(!end.is_at_rest() && !end.has_left_curve && end.reached < end.duration, "{end:?}");
    judge(&controller, &curve, &end);
    let text = end.error.as_ref().expect("it says so").to_string();
    assert!(text.contains("it is not known whether the joints follow their set-points"), "{text}");
    let before = names(&controller).len();
    let error = robot.start_follow(&made(&curve), &patient()).expect_err("they are not shown");
    assert!(matches!(error.kind(), ErrorKind::NotShown { .. }) && !error.may_have_run(), "{error:?}");
    let error = robot.stream(&StreamConfig::new()).expect_err("they are not shown");
    assert!(matches!(error.kind(), ErrorKind::NotShown { .. }), "{error:?}");
    assert!(!names(&controller)[before..].contains(&"servo_move".to_owned()));
}
