//! A robot, its monitor and the simulator by one simulated clock: long times in short ones, and each time exact.

use std::time::{Duration, Instant};

use jaka_robot::jaka_motion::{Limits, Model, TimedPoint, Trajectory};
use jaka_robot::motion::JointMove;
use jaka_robot::types::JointPosition;
use jaka_robot::{Cause, Client, Evidence, FollowConfig, Robot, RobotConfig, ServoConfig, StreamConfig};
use jaka_sim::{Controller, Port, StatusFault};
use jaka_tests::simulated::{SetPoints, beside};
use jaka_tests::{Arm, ArmBuilder, CYCLE, Configured as _, LONG};

const START: [f64; 6] = [10.0, 100.0, 80.0, 90.0, -90.0, 0.0];

/// Length of sessions in minutes: `JAKA_SIMULATED_MINUTES`, one if it is not set.
fn minutes() -> u64 {
    std::env::var("JAKA_SIMULATED_MINUTES").ok().and_then(|minutes| minutes.parse().ok()).unwrap_or(1)
}

fn arm(status_period: Duration) -> ArmBuilder {
    Arm::simulated().at(START).status_period(status_period)
}

/// A robot that is connected through a witness of its set-points.
fn watched(arm: &Arm, wire: &SetPoints) -> Robot {
    let client = Client::connect_with(&arm.config(), wire.address()).expect("the proxy listens");
    Robot::new(client, arm.monitor()).expect("it is the only robot")
}

fn to(angle: f64, speed: f64) -> JointMove {
    JointMove::absolute([angle, START[1], START[2], START[3], START[4], START[5]], speed).acceleration(400.0)
}

/// Resident memory of this process in KiB, if the system reports it.
fn memory_kib() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.trim().trim_end_matches(" kB").parse().ok()
}

/// Joint 6 at a cycle: it swings by 10 deg each 8 s, from rest to rest.
fn swing(cycle: u64) -> f64 {
    let phase = f64::from(u32::try_from(cycle % 1000).unwrap_or_default()) / 1000.0 * std::f64::consts::TAU;
    5.0 - 5.0 * phase.cos()
}

#[test]
fn no_cycle_of_a_long_session_is_late_or_missing() {
    let (began, cycles) = (Instant::now(), minutes() * 60 * 125);
    let arm = arm(Duration::from_millis(30)).start();
    // Those of the landing brake the arm, which hardly moves, and hold it.
    let tolerance = move |cycle| if cycle < cycles { 1e-5 } else { 0.01 };
    let expected =
        move |cycle: u64, joints: [f64; 6]| (joints[5] - swing(cycle.min(cycles - 1))).abs() < tolerance(cycle);
    let wire = SetPoints::watch(arm.clock(), arm.command_addr(), expected);
    let mut robot = watched(&arm, &wire);
    let mut session = robot.enter_servo_mode(ServoConfig::new()).expect("the arm is at rest");
    let mut memory = None;
    for cycle in 0..cycles {
        session.send_joints([START[0], START[1], START[2], START[3], START[4], swing(cycle)]).expect("answers come");
        if cycle == cycles / 10 {
            memory = memory_kib();
        }
    }
    let grown = memory.zip(memory_kib());
    let report = session.land().expect("the arm comes to rest").report;
    let seen = wire.seen();
    println!("{} set-points in {:?} of real time, memory {grown:?} KiB, {report:?}", seen.count, began.elapsed());
    assert_eq!((report.cycles, report.late_cycles, report.gaps, report.lateness(1.0)), (cycles, 0, 0, Duration::ZERO));
    assert_eq!((report.refused, report.unanswered), (0, 0));
    assert_eq!(report.accepted, seen.count);
    assert_eq!(seen.count, report.cycles + report.landing_cycles);
    assert_eq!((seen.shortest, seen.longest, seen.unexpected), (Some(CYCLE), Some(CYCLE), 0));
    let packets = robot.monitor().statistics();
    assert_eq!((packets.skipped, packets.unfit, packets.jitter), (0, 0, Duration::ZERO));
    assert_eq!((packets.period, packets.longest_gap), (Some(Duration::from_millis(30)), Duration::from_millis(30)));
}

#[test]
fn no_cycle_of_a_long_stream_is_late_or_missing() {
    let began = Instant::now();
    let arm = arm(Duration::from_millis(30)).start();
    let clock = arm.clock();
    let wire = SetPoints::watch(clock, arm.command_addr(), |_, _| true);
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    let mut robot = watched(&arm, &wire).configured(&RobotConfig::new().limits(limits)).expect("it is this arm");
    let stream = robot.stream(&StreamConfig::new()).expect("the arm is at rest");
    let since = clock.elapsed();
    for target in 0..minutes() * 60 * 20 {
        let angle = f64::from(u32::try_from(target * 7919 % 40).unwrap_or_default());
        stream
            .handle()
            .set_joints([angle - 10.0, START[1], START[2], START[3], START[4], angle])
            .expect("it is within limits");
        clock.sleep(Duration::from_millis(50));
    }
    let lasted = clock.elapsed().saturating_sub(since);
    let report = stream.land().expect("the arm comes to rest").report;
    let seen = wire.seen();
    println!("{} set-points in {:?} of real time, {report:?}", seen.count, began.elapsed());
    assert_eq!(lasted, LONG * u32::try_from(minutes()).expect("few"));
    assert_eq!((report.late_cycles, report.gaps, report.unanswered), (0, 0, 0));
    assert_eq!(seen.count, report.cycles + report.landing_cycles);
    assert_eq!((seen.shortest, seen.longest), (Some(CYCLE), Some(CYCLE)));
    // From the first target to the last, none is missing.
    assert!(u128::from(report.cycles).abs_diff(lasted.as_nanos() / CYCLE.as_nanos()) <= 1, "{report:?}");
}

/// Packets come each 2 s.
fn slow_status() -> (Arm, Robot) {
    arm(Duration::from_secs(2)).config(|config| config.stale_after(Duration::from_secs(3))).with_robot()
}

#[test]
fn a_slow_status_is_lost_at_the_end_of_the_silence_that_is_allowed() {
    let (arm, robot) = slow_status();
    let (clock, mut robot) = (
        arm.clock(),
        robot.configured(&RobotConfig::new().status_silence(Duration::from_secs(4))).expect("it has no limits"),
    );
    let silent = || {
        clock.sleep(Duration::from_secs(7));
        arm.status_fault(StatusFault::Silent);
    };
    let end = beside(clock, silent, || robot.run(&to(40.0, 1.0), LONG)).expect("it is reachable");
    assert!(matches!(end.evidence(), Evidence::Status { cause: None, .. }), "{:?}", end.cause());
    let last = robot.monitor().last_known_packet().expect("packets came");
    assert_eq!(clock.now(), last.received + Duration::from_secs(4));
    assert_eq!(robot.monitor().statistics().period, Some(Duration::from_secs(2)));
}

#[test]
fn a_slow_status_that_falls_silent_for_a_while_ends_no_motion() {
    let (arm, robot) = slow_status();
    let (clock, mut robot) = (
        arm.clock(),
        robot.configured(&RobotConfig::new().status_silence(Duration::from_secs(8))).expect("it has no limits"),
    );
    let silent = || {
        clock.sleep(Duration::from_secs(7));
        arm.status_fault(StatusFault::Silent);
        clock.sleep(Duration::from_secs(5));
        arm.status_fault(StatusFault::None);
    };
    let end = beside(clock, silent, || robot.run(&to(30.0, 1.0), LONG)).expect("it is reachable");
    assert!(end.cause() == Cause::Reached && arm.state().at_rest, "{:?}", end.cause());
    let gap = robot.monitor().statistics().longest_gap;
    assert!((Duration::from_secs(5)..Duration::from_secs(8)).contains(&gap), "{gap:?}");
}

#[test]
fn a_collision_on_the_way_is_told_with_the_next_packet() {
    let period = Duration::from_millis(30);
    let (arm, mut robot) = arm(period).with_robot();
    let clock = arm.clock();
    let collide = arm.when(|state| state.joint_position.0[0] > 20.0, Controller::collide);
    let end = robot.run(&to(40.0, 10.0), LONG).expect("it is reachable");
    assert!(end.cause() == Cause::ProtectiveStop, "{:?}", end.cause());
    let collided = collide.expect("a thread starts").fired_at().expect("the arm was there");
    let told = clock.elapsed().saturating_sub(collided);
    let joint = arm.state().joint_position.0[0];
    // It stands where it was in that cycle, at 10 deg/s.
    assert!(told <= period && joint > 20.0 && joint <= 20.0 + 0.08 + 1e-9, "after {told:?}, at {joint} deg");
}

#[test]
fn time_goes_on_after_the_end_of_a_stream_and_of_a_trajectory_for_which_nobody_waits() {
    let (arm, robot) = arm(Duration::from_millis(30)).with_robot();
    let clock = arm.clock();
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    let mut robot = robot.configured(&RobotConfig::new().limits(limits)).expect("it is this arm");
    let at = arm.state().joint_position;
    let there = JointPosition(std::array::from_fn(|joint| at.0[joint] + if joint == 5 { 5.0 } else { 0.0 }));
    let points = [TimedPoint::new(0.0, at), TimedPoint::new(2.0, there)];
    let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some")).expect("it is slow");
    let run = robot.start_follow(&trajectory, &FollowConfig::new()).expect("it is where it starts");
    clock.sleep(Duration::from_secs(10));
    let since = clock.elapsed();
    run.wait().reached().expect("nothing is in its way");
    assert_eq!(clock.elapsed(), since, "it had ended");

    let stream = robot.stream(&StreamConfig::new()).expect("it is at rest");
    arm.link(Port::Command).cut();
    clock.sleep(Duration::from_secs(10));
    let since = clock.elapsed();
    stream.land().expect_err("its connection was cut");
    assert_eq!(clock.elapsed(), since, "it had ended");
}
