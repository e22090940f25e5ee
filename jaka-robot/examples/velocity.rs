//! A velocity of the tool that is given again and again, and ends by itself when it is not.
//!
//! `cargo run --example velocity` runs against a simulated controller; with an address, against a robot, which should
//! be a Zu 5. There it powers and enables the arm, which stays so, and moves the tool centre point up by some 20 mm,
//! and down again; it asks before.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::thread::sleep;
use std::time::Duration;

use jaka_robot::jaka_motion::{Limits, Model, TcpVelocity, VelocityFrame};
use jaka_robot::{RobotConfig, ServoConfig, StreamConfig};

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm will be powered, and its tool will move up and down by some 20 mm. Clear the area.")?;
    let arm = Model::named("Zu 5").ok_or("a published arm")?;
    let mut robot = target.robot()?;
    robot.configure(&RobotConfig::new().limits(Limits::of(arm)))?;
    robot.power_up(Duration::from_secs(60))?;

    // A set-point each 32 ms: an ordinary system holds a thread up for three of them far less often than for 24 ms.
    let servo = ServoConfig::new().step_count(4);
    let stream = robot.stream(&StreamConfig::new().servo(servo))?;
    for mm_s in [20.0, -20.0] {
        let up = TcpVelocity::new(VelocityFrame::User).with_linear([0.0, 0.0, mm_s]);
        for _ in 0..10 {
            stream.handle().set_tcp_velocity(up, Duration::from_millis(200))?;
            sleep(Duration::from_millis(100));
        }
        // Not given again, it ends.
        stream.handle().wait_for_rest(Duration::from_secs(5))?;
    }
    println!("{} set-points", stream.land()?.report.cycles);
    Ok(())
}
