//! A program with a robot of an invented firmware, whose commands come from a pack alone: a motion that is waited for, a
//! stop, and a setting. Takes the two ports of the controller on loopback.

use std::error::Error;
use std::time::Duration;

use jaka_robot::{Cause, Client, Config, Monitor, Robot};

jaka_robot::pack!("../invented_firmware/invented.toml");

use invented::InventedCommands as _;

fn main() -> Result<(), Box<dyn Error>> {
    let ports: Vec<u16> = std::env::args().skip(1).map(|port| port.parse()).collect::<Result<_, _>>()?;
    let [commands, status] = ports[..] else {
        return Err("give the port of commands and that of status packets".into());
    };
    let [commands, status] = [commands, status].map(|port| format!("127.0.0.1:{port}"));
    let config = Config::new();
    let monitor = Monitor::<invented::RobotStatus>::connect_with(&config, status)?;
    let mut robot = Robot::with_monitor(Client::connect_with(&config, commands)?, monitor);
    let far = invented::DemoGlide::new([40.0, 90.0, 90.0, 90.0, -90.0, 0.0], 30.0);
    robot.run(&far, Duration::from_secs(10))?.reached()?;
    println!("the arm is there");

    let plan = robot.client().demo_glide(&invented::DemoGlide::new([0.0, 90.0, 90.0, 90.0, -90.0, 0.0], 30.0))?.plan;
    println!("it goes back in {:.1} s", plan.seconds);
    robot.client().demo_halt()?;

    robot.start(&far)?;
    robot.stop_handle().stop()?;
    let end = robot.wait(Duration::from_secs(10));
    if end.cause() != Cause::Stopped {
        return Err(format!("it was stopped: {end}").into());
    }
    println!("{end}");
    Ok(())
}
