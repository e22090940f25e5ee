//! A trajectory, followed with a pause on the way: the arm stops on its curve, and goes on along it.
//!
//! `cargo run --example follow` runs against a simulated controller; with an address, against a robot, which should be
//! a Zu 5. There it powers and enables the arm, which stays so, and turns joints 5 and 6 by at most 10 degrees, and
//! back, for some 9 s; it asks before.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::thread::sleep;
use std::time::Duration;

use jaka_robot::jaka_motion::{Limits, Model, Trajectory, Via};
use jaka_robot::{FollowConfig, RobotConfig, ServoConfig};

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask(
        "The arm will be powered; joints 5 and 6 will turn by up to 10 deg and back for some 9 s. Clear the area.",
    )?;
    let arm = Model::named("Zu 5").ok_or("a published arm")?;
    let mut robot = target.robot()?;
    robot.configure(&RobotConfig::new().limits(Limits::of(arm)))?;
    robot.power_up(Duration::from_secs(60))?;

    let start = robot.client().get_joint_pos()?.joint_position;
    let turned = |joint_5, joint_6| {
        let mut joints = start;
        (joints.0[4], joints.0[5]) = (start[4] + joint_5, start[5] + joint_6);
        Via::joints(joints)
    };
    // To the second point and the third, rounding the corners by up to 2 deg of a joint, and back.
    let through = Trajectory::through([turned(0.0, 0.0), turned(0.0, 10.0), turned(10.0, 10.0), turned(0.0, 0.0)]);
    let checker = robot.limits().ok_or("it has limits")?;
    let trajectory = through.corner_deg(2.0).joint_speeds([5.0; 6]).build(checker)?;
    // A set-point each 32 ms: an ordinary system holds a thread up for three of them far less often than for 24 ms.
    let servo = ServoConfig::new().step_count(4);
    let config = FollowConfig::new().servo(servo).deadline(Duration::from_secs(30));
    let run = robot.start_follow(&trajectory, &config)?;
    sleep(Duration::from_secs(2));
    run.handle().pause()?;
    sleep(Duration::from_secs(1));
    run.handle().resume()?;
    let end = run.wait();
    let lag = end.report.trajectory.as_ref().and_then(|trajectory| trajectory.lag).map(|lag| lag.delay);
    println!("{} set-points, {} late by half a period, lag {lag:?}", end.report.cycles, end.report.late_cycles);
    Ok(end.reached()?)
}
