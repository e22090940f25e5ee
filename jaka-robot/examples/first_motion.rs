//! A first program: the last joint turns by 5 degrees from where it is, slowly, and Ctrl-C stops it.
//!
//! `cargo run --example first_motion` runs against a simulated controller; with an address, against a robot. There it
//! powers and enables the arm, which stays so; it asks before. This is not an emergency stop: keep the button within
//! reach.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::time::Duration;

use jaka_robot::motion::JointMove;

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm will be powered and joint 6 will turn by 5 deg. Clear the area.")?;
    let mut robot = target.robot()?;
    let stop = robot.stop_handle();
    // From now on. A stop that comes before the motion keeps it from being sent.
    ctrlc::set_handler(move || match stop.stop() {
        Ok(()) => eprintln!("stopped"),
        Err(error) => eprintln!("the arm may still move, use the emergency stop: {error}"),
    })?;
    robot.power_up(Duration::from_secs(60))?;
    let before = robot.client().get_joint_pos()?.joint_position.0;
    // By 5 deg from where it is, at 5 deg/s and 20 deg/s².
    let turn = JointMove::relative([0.0, 0.0, 0.0, 0.0, 0.0, 5.0], 5.0).acceleration(20.0);
    let end = robot.run(&turn, Duration::from_secs(30))?;
    println!("{end} ({:.1?})", end.report.waited);
    let after = robot.client().get_joint_pos()?.joint_position.0;
    println!("joint 6 was at {:.2} deg and is at {:.2}", before[5], after[5]);
    Ok(end.reached()?)
}
