//! A tour of the SDK: power, two motions, an output and the status, with a stop on Ctrl-C.
//!
//! `cargo run --example tour` runs it against a simulated controller, `cargo run --example tour 10.5.5.100` against a
//! robot. On a robot it powers the arm, moves joint 1 by two degrees and back, switches digital output 1 of the cabinet
//! on and off, and powers the arm down; it asks before.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::time::Duration;

use jaka_robot::io::SetDigitalOutput;
use jaka_robot::motion::JointMove;
use jaka_robot::types::Switch;

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm will be powered and joint 1 will move by 2 deg. Clear the area.")?;
    let mut robot = target.robot()?;
    println!("firmware {}", robot.client().get_version()?.version);
    let stop = robot.stop_handle();
    ctrlc::set_handler(move || match stop.stop() {
        Ok(()) => eprintln!("stopped"),
        Err(error) => eprintln!("the arm may still move, use the emergency stop: {error}"),
    })?;

    // Seconds pass until the arm has power and is enabled: each step is reported as it comes.
    robot.power_up_with(Duration::from_secs(60), |step| println!("{step}"))?;

    for degrees in [2.0, -2.0] {
        // An offset of the joints in degrees, at 5 deg/s and 10 deg/s². The call returns when the arm is at rest.
        let turn = JointMove::relative([degrees, 0.0, 0.0, 0.0, 0.0, 0.0], 5.0).acceleration(10.0);
        let end = robot.run(&turn, Duration::from_secs(30))?;
        println!("joint 1 by {degrees:+.1} deg: {end}, after {:.1} s", end.report.waited.as_secs_f64());
        end.reached()?;
    }

    for value in [Switch::On, Switch::Off] {
        robot.client().set_digital_output(&SetDigitalOutput::cabinet(1, value))?;
        println!("digital output 1 of the cabinet: {value:?}");
    }

    let packet = robot.monitor().next_packet()?;
    if let (Some(joints), Some(pose)) = (packet.status.joint_actual_position, packet.status.actual_position) {
        println!("the arm is at {joints:.1}, its tool at {pose:.1}");
    }

    robot.power_down_with(Duration::from_secs(30), |step| println!("{step}"))?;
    Ok(())
}
