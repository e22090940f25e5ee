//! An hour of servo cycles against a simulated controller, in seconds: both have one clock, whose time goes on as soon
//! as all wait.
//!
//! `cargo run --release --example simulated_hour --features jaka-robot/simulated-clock`; a number after `--` is the
//! minutes.

mod common;

use std::error::Error;
use std::f64::consts::TAU;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use jaka_robot::{Config, Robot, ServoConfig};
use jaka_sim::{Controller, SimulatedClock};

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let minutes: u32 = std::env::args().nth(1).map_or(Ok(60), |minutes| minutes.parse())?;
    let began = Instant::now();
    let clock = SimulatedClock::new();
    let controller = Controller::builder().clock(&clock).start()?;
    let config = Config::new().clock(&clock);
    let mut robot = Robot::connect_at(&config, controller.command_addr(), controller.status_addr())?;
    robot.power_up(Duration::from_secs(60))?;
    println!("powered up after {:?}", clock.elapsed());

    let mut session = robot.enter_servo_mode(ServoConfig::new())?;
    let since = clock.elapsed();
    let start = controller.state().joint_position.0;
    for cycle in 0..minutes * 60 * 125 {
        // Joint 6 swings by 10 deg in 8 s, from rest.
        let angle = 5.0 - 5.0 * (f64::from(cycle) / 1000.0 * TAU).cos();
        session.send_joints([start[0], start[1], start[2], start[3], start[4], start[5] + angle])?;
    }
    let lasted = clock.elapsed().saturating_sub(since);
    let report = session.land()?.report;
    println!("{} set-points in {lasted:?}, {} of them late", report.cycles, report.late_cycles);
    println!(
        "status packets each {:?}, jitter {:?}",
        robot.monitor().statistics().period,
        robot.monitor().statistics().jitter
    );
    println!("{:.1?} of real time", began.elapsed());
    Ok(())
}
