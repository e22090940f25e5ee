//! Motions compared with limits before they are sent: one is within them, three are not and are refused.
//!
//! `cargo run --example limits` runs against a simulated controller; with an address, against a robot, which should be
//! a Zu 5. There it powers and enables the arm, which stays so, and turns joint 6 by 5 degrees; it asks before. The
//! other motions are never sent. Limits are not a safety function: keep the emergency stop within reach.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::time::Duration;

use jaka_robot::RobotConfig;
use jaka_robot::jaka_motion::Limits;
use jaka_robot::motion::{JointMove, MoveL};

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm will be powered and joint 6 will turn by 5 deg. Clear the area.")?;
    let limits = Limits::from_toml(include_str!("limits.toml"), "limits.toml")?;
    let mut robot = target.robot()?;
    robot.configure(&RobotConfig::new().limits(limits))?;
    robot.power_up(Duration::from_secs(60))?;

    let turn = |by: f64, speed: f64| JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, by], speed).acceleration(60.0);
    println!("{}", robot.run(&turn(5.0, 20.0), Duration::from_secs(30))?);
    let down = MoveL::relative([0.0, 0.0, -500.0, 0.0, 0.0, 0.0], 100.0);
    for refused in [robot.start(&turn(5.0, 90.0)), robot.start(&turn(500.0, 20.0)), robot.start(&down)] {
        println!("{}", refused.err().ok_or("a motion beyond a limit was sent")?);
    }
    Ok(())
}
