//! Targets 20 times a second, with delays, as a person's hand or a camera gives them: the arm follows smoothly.
//!
//! `cargo run --example teleop` runs against a simulated controller; with an address, against a robot, which should be
//! a Zu 5. There it powers and enables the arm, which stays so, and turns joint 6 to and fro by at most 10 degrees for
//! 5 s; it asks before.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::thread::sleep;
use std::time::Duration;

use jaka_robot::jaka_motion::{Limits, Model};
use jaka_robot::{RobotConfig, ServoConfig, StreamConfig};

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm will be powered and joint 6 will turn by up to 10 deg for 5 s. Clear the area.")?;
    let arm = Model::named("Zu 5").ok_or("a published arm")?;
    let mut robot = target.robot()?;
    robot.configure(&RobotConfig::new().limits(Limits::of(arm)))?;
    robot.power_up(Duration::from_secs(60))?;

    // A set-point each 32 ms: an ordinary system holds a thread up for three of them far less often than for 24 ms.
    let servo = ServoConfig::new().step_count(4);
    let stream = robot.stream(&StreamConfig::new().servo(servo))?;
    let mut target = stream.handle().joints();
    let middle = target[5];
    for n in 0..100_u32 {
        target[5] = middle + 10.0 * (f64::from(n) * 0.1).sin();
        stream.handle().set_joints(target)?;
        sleep(Duration::from_millis(50 + u64::from(n * 37 % 60)));
    }
    let report = stream.land()?.report;
    println!("{} set-points, {} late by half a period", report.cycles, report.late_cycles);
    Ok(())
}
