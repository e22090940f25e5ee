//! Trajectories on an arm that lags behind its set-points, by each filter of 4.60 or none.

use jaka_robot::servo::SetServoMoveFilter;
use jaka_robot::{Cause, Numbering};
use jaka_sim::{Happening, Level};

use super::*;
use crate::stream::filters;

const INPUT: Numbering = Numbering::FromZero;

fn filtered(filter: &SetServoMoveFilter, lag_ms: u64) -> (Arm, Robot, FollowConfig) {
    let (arm, robot) = lagging(Duration::from_millis(lag_ms));
    let servo = ServoConfig::new().step_count(CYCLES).filter(*filter);
    (arm, robot, FollowConfig::new().servo(servo))
}

#[test]
fn a_trajectory_is_completed_where_the_arm_is_at_its_end_whatever_the_filter() {
    for filter in filters() {
        let (arm, mut robot, config) = filtered(&filter, 80);
        let end = robot.start_follow(&made(&to_and_fro()), &config).expect("the arm is at its start").wait();
        judge(&arm, &to_and_fro(), &end);
        assert_eq!((end.cause(), end.rest.was_seen()), (Cause::Reached, true), "{filter:?}: {end}");
        let (state, there) = (arm.state(), JointPosition(to_and_fro().at(3.0)));
        let off = state.joint_position.max_distance(&there);
        assert!(!state.servo_mode && off < 0.1, "{filter:?}: {off}");
        let lag = followed(&end).lag.expect("the arm has moved");
        assert!(lag.delay >= Duration::from_millis(60), "{filter:?}: {lag:?}");
    }
}

#[test]
fn a_guard_stops_it_on_its_curve_whatever_the_filter() {
    for filter in filters() {
        let (arm, mut robot, config) = filtered(&filter, 80);
        let run = robot.start_follow(&made(&to_and_fro()), &config.clone().guard(INPUT.cabinet(3).is_high()));
        let run = run.expect("the input is low");
        let rises = arm.elapsed() + Duration::from_secs(1);
        arm.at(rises, Happening::Input(3, Level::High)).expect("there is such an input");
        let end = run.wait();
        judge(&arm, &to_and_fro(), &end);
        assert_eq!((end.cause(), end.rest.was_seen()), (Cause::Guard, true), "{filter:?}: {end}");
        assert!(
            !followed(&end).has_left_curve && followed(&end).reached < Duration::from_millis(1500),
            "{filter:?}: {end:?}"
        );
        let there = JointPosition(to_and_fro().at(followed(&end).reached.as_secs_f64()));
        let off = arm.state().joint_position.max_distance(&there);
        assert!(off < 0.1, "{filter:?}: {off}");
    }
}

#[test]
fn an_arm_departs_where_it_does_not_follow_and_only_then_whatever_the_filter() {
    for filter in filters() {
        for (lag_ms, departs) in [(80, false), (2000, true)] {
            let (arm, mut robot, config) = filtered(&filter, lag_ms);
            let end = robot.start_follow(&made(&to_and_fro()), &config.max_departure(3.0));
            let end = end.expect("the arm is at its start").wait();
            judge(&arm, &to_and_fro(), &end);
            let cause = if departs { Cause::Departed } else { Cause::Reached };
            assert_eq!(end.cause(), cause, "{filter:?}, {lag_ms} ms: {end}");
        }
    }
}
