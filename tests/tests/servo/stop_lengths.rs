//! Time and angle of stops with default limits, as the pages state them: read from the requests that the controller
//! receives.

use std::time::Duration;

use jaka_robot::jaka_motion::{Trajectory, Via};
use jaka_robot::{FollowConfig, Robot, RobotConfig, StreamConfig};
use jaka_tests::Arm;
use jaka_tests::Configured as _;
use jaka_tests::simulated::until;

use crate::received::positions;
use crate::stream::limits;

const PAGES: [&str; 2] = [include_str!("../../../docs/safety.md"), include_str!("../../../docs/streams.md")];
const PERIOD: Duration = Duration::from_millis(8);
const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, -300.0];

fn ready() -> (Arm, Robot) {
    let (arm, robot) = Arm::simulated().at(START).status_period(Duration::from_millis(10)).with_robot();
    (arm, robot.configured(&RobotConfig::new().limits(limits())).expect("it is this arm"))
}

/// Asserts that the pages have this sentence, whatever their lines are.
fn assert_stated(sentence: &str) {
    for page in PAGES {
        let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(page.contains(sentence), "{sentence}");
    }
}

#[test]
fn a_stop_of_a_fast_stream_is_as_long_as_the_pages_say() {
    let (arm, mut robot) = ready();
    let stop = robot.stop_handle();
    let stream = robot.stream(&StreamConfig::new()).expect("the arm is ready");
    let turn = || stream.handle().set_joint_velocity([0.0, 0.0, 0.0, 0.0, 0.0, 150.0], Duration::from_millis(500));
    for _ in 0..30 {
        turn().expect("within its speed");
        arm.clock().sleep(Duration::from_millis(100));
    }
    let (set_points, _) = positions(&arm, 1);
    let [.., before, last] = &set_points[..] else { panic!("set-points came") };
    assert!((last[5] - before[5] - 150.0 * PERIOD.as_secs_f64()).abs() < 1e-3, "it turns at 150 deg/s");
    let (began, from) = (arm.clock().elapsed(), last[5]);
    stop.stop().expect("the controller takes it");
    let took = arm.clock().elapsed().saturating_sub(began).as_secs_f64();
    let (set_points, after) = positions(&arm, 1);
    assert_eq!(after[0], "stop_program");
    let turned = set_points[set_points.len() - 1][5] - from;
    drop(stream);
    println!("{took:.3} s, {turned:.2} deg");
    assert_stated(&format!("at 150 deg/s it takes {took:.2} s and {turned:.0} deg"));
}

#[test]
fn a_pause_of_a_fast_trajectory_is_as_long_as_the_pages_say() {
    let (arm, mut robot) = ready();
    let mut end = START;
    end[5] += 400.0;
    let points = [Via::Joints(START.into()), Via::Joints(end.into())];
    let trajectory = Trajectory::through(points).joint_speeds([100.0; 6]).build(robot.limits().expect("it has some"));
    let run = robot.start_follow(&trajectory.expect("within the limits"), &FollowConfig::new()).expect("it starts");
    let half = run.handle().progress().duration / 2;
    until(arm.clock(), || run.handle().progress().time >= half);
    let from = positions(&arm, 1).0;
    let speed = (from[from.len() - 1][5] - from[from.len() - 2][5]) / PERIOD.as_secs_f64();
    assert!((speed - 100.0).abs() < 0.1, "it turns at 100 deg/s: {speed}");
    run.handle().pause().expect("it runs");
    let paused = arm.clock().elapsed();
    until(arm.clock(), || run.handle().progress().rate == 0.0);
    let took = arm.clock().elapsed().saturating_sub(paused).as_secs_f64();
    let (set_points, _) = positions(&arm, 1);
    let turned = set_points[set_points.len() - 1][5] - from[from.len() - 1][5];
    println!("{took:.3} s, {turned:.2} deg");
    assert_stated(&format!("at 100 deg/s takes {took:.2} s and {turned:.0} deg"));
    run.handle().resume().expect("it is paused");
    assert!(run.wait().reached().is_ok());
}
