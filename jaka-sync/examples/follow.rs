//! A trajectory, followed with a pause on the way: the arm stops on its curve, and goes on along it.
//!
//! `cargo run --example follow --features jaka-sync/stream` runs against a simulated controller; with an address, against a robot, which should be
//! a Zu 5. There it powers and enables the arm, which stays so, and turns joint 6 to and fro by at most 10 degrees for some 8 s; it asks before.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::thread::sleep;
use std::time::Duration;

use jaka_sync::FollowConfig;
use jaka_sync::jaka_motion::{Checker, Frames, Limits, Model, TimedPoint, Trajectory};

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm will be powered and joint 6 will turn by up to 10 deg for some 8 s. Clear the area.")?;
    let limits = Limits::of(Model::named("Zu 5").ok_or("a published arm")?);
    let mut robot = target.robot()?.with_limits(limits.clone())?;
    robot.power_up(Duration::from_secs(60))?;

    let start = robot.client().get_joint_pos()?.joint_position;
    let at = |time_s, degrees| {
        let mut joints = start;
        joints.0[5] += degrees;
        TimedPoint::new(time_s, joints)
    };
    let points = [at(0.0, 0.0), at(2.0, 10.0), at(4.0, -10.0), at(6.0, 0.0)];
    let trajectory = Trajectory::timed(&points, &Checker::new(limits, Frames::new()))?;
    let run = robot.start_follow(&trajectory, &FollowConfig::new().deadline(Duration::from_secs(30)))?;
    sleep(Duration::from_secs(2));
    run.pause()?;
    sleep(Duration::from_secs(1));
    run.resume()?;
    let end = run.wait();
    let lag = end.lag.map(|lag| lag.delay);
    println!("{} set-points, {} late by half a period, lag {lag:?}", end.report.cycles, end.report.late_cycles);
    Ok(end.completed()?)
}
