//! Lengths of stops with default limits, as the page states them: set-points are read from the requests that the
//! controller receives, and put through the tests' own model of the arm.

use std::time::Duration;

use jaka_robot::jaka_motion::{Limits, TcpVelocity, Trajectory, VelocityFrame, Via};
use jaka_robot::{FollowConfig, FollowHandle, Robot, RobotConfig, ServoConfig, StreamConfig, StreamHandle};
use jaka_tests::simulated::until;
use jaka_tests::witness::Witness;
use jaka_tests::{Arm, Configured as _};

use crate::received::positions;
use crate::stream::limits;

const PAGE: &str = include_str!("../../../docs/safety.md");
const PERIOD_S: f64 = 0.008;
const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, -300.0];
/// Level with the shoulder.
const STRETCHED: [f64; 6] = [-100.0, 180.0, 0.0, 50.0, -90.0, -300.0];

fn ready(start: [f64; 6], limits: Limits) -> (Arm, Robot) {
    let (arm, robot) = Arm::simulated().at(start).status_period(Duration::from_millis(10)).with_robot();
    (arm, robot.configured(&RobotConfig::new().limits(limits)).expect("it is this arm"))
}

/// Set-points of a stop.
struct Stop {
    before: Vec<[f64; 6]>,
    /// The first one is the last before it.
    set_points: Vec<[f64; 6]>,
}

impl Stop {
    /// A stop that ends at the last set-point and begins where the joints, or the tool, were the fastest, but for a
    /// share.
    fn of(arm: &Arm, steps: impl Fn(&[[f64; 6]]) -> Vec<f64>, uneven: f64) -> Self {
        let mut before = positions(arm, 1).0;
        let steps = steps(&before);
        let fastest = steps.iter().copied().fold(0.0, f64::max);
        let begun = steps.iter().rposition(|step| *step > (1.0 - uneven) * fastest).expect("it moved") + 1;
        // The arm is held at the last one.
        let rests = steps.iter().rposition(|step| *step > 0.0).expect("it moved") + 1;
        let set_points = before[begun..=rests].to_vec();
        before.truncate(begun + 1);
        Self { before, set_points }
    }

    fn seconds(&self) -> f64 {
        f64::from(u32::try_from(self.set_points.len() - 1).expect("some")) * PERIOD_S
    }

    fn degrees(&self) -> f64 {
        let [first, last] = [self.set_points[0], self.set_points[self.set_points.len() - 1]];
        (0..6).map(|joint| (last[joint] - first[joint]).abs()).fold(0.0, f64::max)
    }

    fn millimetres(&self) -> f64 {
        tool_steps(&self.set_points).iter().sum()
    }

    /// Speed of the fastest joint before, in deg/s.
    fn speed(&self) -> f64 {
        joint_steps(&self.before).last().expect("it moved") / PERIOD_S
    }

    /// Greatest deceleration of the tool, in mm/s².
    fn tool_deceleration(&self) -> f64 {
        let mut all = self.before[self.before.len() - 2..].to_vec();
        all.extend(&self.set_points[1..]);
        let steps = tool_steps(&all);
        steps.windows(2).map(|two| two[0] - two[1]).fold(0.0, f64::max) / PERIOD_S / PERIOD_S
    }

    /// Row of the page.
    fn row(&self, what: &str) -> String {
        let [degrees, millimetres] = [self.degrees(), self.millimetres()];
        format!("| {what} | {:.2} s | {degrees:.0} deg | {millimetres:.0} mm |", self.seconds())
    }
}

/// Travel of the furthest-moving joint with each set-point, in degrees.
fn joint_steps(set_points: &[[f64; 6]]) -> Vec<f64> {
    let step = |two: &[[f64; 6]]| (0..6).map(|joint| (two[1][joint] - two[0][joint]).abs()).fold(0.0, f64::max);
    set_points.windows(2).map(step).collect()
}

/// Travel of the flange with each set-point, in mm.
fn tool_steps(set_points: &[[f64; 6]]) -> Vec<f64> {
    let arm = Witness::published("Zu 5");
    let places: Vec<_> = set_points.iter().map(|joints| arm.flange(*joints).map(|row| row[3])).collect();
    let apart = |two: &[[f64; 3]]| (0..3).map(|axis| (two[1][axis] - two[0][axis]).powi(2)).sum::<f64>().sqrt();
    places.windows(2).map(apart).collect()
}

/// An arm after a stop of the robot that came after so many periods of 0.1 s of a velocity.
fn stopped_stream((start, limits, periods): ([f64; 6], Limits, u32), give: impl Fn(&StreamHandle, Duration)) -> Arm {
    let (arm, mut robot) = ready(start, limits);
    let stop = robot.stop_handle();
    let stream = robot.stream(&StreamConfig::new()).expect("the arm is ready");
    for _ in 0..periods {
        give(&stream.handle(), Duration::from_millis(500));
        arm.clock().sleep(Duration::from_millis(100));
    }
    stop.stop().expect("the controller takes it");
    assert_eq!(positions(&arm, 1).1[0], "stop_program");
    drop(stream);
    arm
}

fn stop_of_stream(from: ([f64; 6], Limits, u32), give: impl Fn(&StreamHandle, Duration)) -> Stop {
    Stop::of(&stopped_stream(from, give), joint_steps, 1e-5)
}

fn turn(joint: usize, deg_s: f64) -> impl Fn(&StreamHandle, Duration) {
    move |stream, time| {
        let mut speeds = [0.0; 6];
        speeds[joint - 1] = deg_s;
        stream.set_joint_velocity(speeds, time).expect("within its speed");
    }
}

fn lead(stream: &StreamHandle, time: Duration) {
    let velocity = TcpVelocity::new(VelocityFrame::ArmBase).with_linear([0.0, 0.0, -250.0]);
    stream.set_tcp_velocity(velocity, time).expect("within its speed");
}

/// Stop by a handle of a trajectory of joint 6 at 100 deg/s.
fn stop_of_trajectory(stop: impl Fn(&FollowHandle)) -> Stop {
    let (arm, mut robot) = ready(START, limits());
    let mut end = START;
    end[5] += 400.0;
    let points = [Via::joints(START), Via::joints(end)];
    let trajectory = Trajectory::through(points).joint_speeds([100.0; 6]).build(robot.limits().expect("it has some"));
    let run = robot.start_follow(&trajectory.expect("within the limits"), &FollowConfig::new()).expect("it starts");
    let half = run.handle().progress().duration / 2;
    until(arm.clock(), || run.handle().progress().time >= half);
    stop(&run.handle());
    until(arm.clock(), || run.handle().progress().rate == 0.0);
    let stop = Stop::of(&arm, joint_steps, 1.5e-3);
    if run.handle().resume().is_ok() {
        let _ = run.wait();
    }
    stop
}

fn assert_stated(rows: &[String]) {
    for row in rows {
        assert!(PAGE.contains(row.as_str()), "docs/safety.md lacks one of these rows: {row}\n{}", rows.join("\n"));
    }
}

#[test]
fn stops_of_streams_are_as_long_as_the_page_says() {
    let cruise = stop_of_stream((START, limits(), 30), turn(6, 150.0));
    assert!((cruise.speed() - 150.0).abs() < 0.1, "{}", cruise.speed());
    let gains = stop_of_stream((START, limits(), 11), turn(6, 150.0));
    let speeds: Vec<f64> = gains.before.windows(2).map(|two| (two[1][5] - two[0][5]) / PERIOD_S).collect();
    // In the last two periods the acceleration goes to zero.
    let gained = speeds[speeds.len() - 3] - speeds[speeds.len() - 4];
    assert!((gained - 72.0 * PERIOD_S).abs() < 1e-3, "it gains speed: {gained}");
    let stretched = stop_of_stream((STRETCHED, limits(), 30), turn(1, 150.0));
    let deceleration = stretched.tool_deceleration();
    assert!((7500.0..8000.0).contains(&deceleration), "{deceleration} mm/s²");
    let unbound = limits().without_stop_tcp_acceleration();
    let unbound = stop_of_stream((STRETCHED, unbound, 30), turn(1, 150.0));
    let deceleration = unbound.tool_deceleration();
    assert!((9000.0..9600.0).contains(&deceleration), "570 deg/s² at 0.96 m: {deceleration} mm/s²");
    let slow = stop_of_stream((STRETCHED, limits(), 30), turn(1, 30.0));
    let line = Stop::of(&stopped_stream((START, limits(), 10), lead), tool_steps, 1.5e-3);
    assert!((tool_steps(&line.before).last().expect("some") / PERIOD_S - 250.0).abs() < 1.0);
    assert_stated(&[
        cruise.row("a stream, or a session of set-points, turns joint 6 at 150 deg/s"),
        gains.row(&format!("the same while it gains speed by 72 deg/s², at {:.0} deg/s", gains.speed())),
        stretched.row("a stream turns joint 1 at 150 deg/s, the arm stretched to 0.96 m"),
        unbound.row("the same without the bound of the tool"),
        slow.row("the same at 30 deg/s"),
        line.row("a stream leads the tool at 250 mm/s, the arm half stretched"),
    ]);
}

/// Set-points of a program of its own, which gains 72 deg/s² of speed up to 150 deg/s, and lands.
#[test]
fn a_session_with_limits_lands_by_a_stop_as_long_as_the_page_says() {
    let (arm, mut robot) = ready(START, limits());
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is ready");
    let (mut joints, mut speed) = (START, 0.0);
    while speed < 150.0 {
        speed = f64::min(speed + 71.9 * PERIOD_S, 150.0);
        joints[5] += speed * PERIOD_S;
        session.send_joints(joints).expect("within the limits");
    }
    for _ in 0..10 {
        joints[5] += speed * PERIOD_S;
        session.send_joints(joints).expect("within the limits");
    }
    let end = session.land().expect("it comes to rest");
    assert!(end.rest.was_seen(), "{end:?}");
    let stop = Stop::of(&arm, joint_steps, 1e-5);
    let all = [&stop.before[stop.before.len() - 2..], &stop.set_points[1..]].concat();
    let steps: Vec<f64> = joint_steps(&all).iter().map(|step| step / PERIOD_S).collect();
    let changes: Vec<f64> = steps.windows(2).map(|two| (two[0] - two[1]) / PERIOD_S).collect();
    assert!(changes.iter().all(|change| (0.0..=570.0 + 1e-3).contains(change)), "{changes:?}");
    let jerks = changes.windows(2).map(|two| ((two[1] - two[0]) / PERIOD_S).abs());
    assert!(jerks.fold(0.0, f64::max) <= 5700.0 + 1e-2, "{changes:?}");
    assert_stated(&[stop.row("a stream, or a session of set-points, turns joint 6 at 150 deg/s")]);
}

/// Up to 60 deg/s by what motions have, and down by more.
#[test]
fn a_program_may_brake_its_set_points_by_the_acceleration_of_stops() {
    for (braking, is_sent) in [(569.0, true), (571.0, false)] {
        let (_arm, mut robot) = ready(START, limits());
        let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is ready");
        let (mut joints, mut speed) = (START, 0.0);
        while speed < 60.0 {
            speed += 71.9 * PERIOD_S;
            joints[5] += speed * PERIOD_S;
            session.send_joints(joints).expect("within the limits");
        }
        let sent = (0..5).try_for_each(|_| {
            speed -= braking * PERIOD_S;
            joints[5] += speed * PERIOD_S;
            session.send_joints(joints)
        });
        assert_eq!(sent.is_ok(), is_sent, "{braking} deg/s²: {sent:?}");
        let landed = session.land();
        assert_eq!(landed.is_ok(), is_sent, "{landed:?}");
    }
}

#[test]
fn stops_and_pauses_of_trajectories_are_as_long_as_the_page_says() {
    let stop = stop_of_trajectory(|run| run.stop().expect("it runs"));
    let quick = stop_of_trajectory(|run| run.pause_by_stop().expect("it runs"));
    let pause = stop_of_trajectory(|run| run.pause().expect("it runs"));
    for stop in [&stop, &quick, &pause] {
        assert!((stop.speed() - 100.0).abs() < 0.1, "{}", stop.speed());
    }
    assert_eq!(stop.set_points.len(), quick.set_points.len());
    assert_stated(&[
        stop.row("a trajectory turns joint 6 at 100 deg/s: `FollowHandle::stop`, `pause_by_stop`"),
        pause.row("the same: `FollowHandle::pause`"),
    ]);
}
