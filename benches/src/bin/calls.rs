//! Does one thing a number of times and nothing else, for tools that count: `calls WHAT COMMANDS STATUS COUNT`, where
//! WHAT is `call` for calls with their replies, or `servo` for set-points of a session.

use std::error::Error;
use std::time::Duration;

use jaka_robot::{Client, Config, Monitor, Robot, RobotConfig, ServoConfig};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let [what, commands, status, count] = &*arguments else {
        return Err("calls WHAT COMMANDS STATUS COUNT".into());
    };
    let count = count.parse()?;
    match &**what {
        "call" => call(commands, count),
        "servo" => servo(commands, status, count),
        other => Err(format!("`{other}` is not known").into()),
    }
}

fn call(commands: &str, count: u32) -> Result<(), Box<dyn Error>> {
    let mut client = Client::connect(commands)?;
    for _ in 0..count {
        std::hint::black_box(client.get_joint_pos()?.joint_position);
    }
    Ok(())
}

fn servo(commands: &str, status: &str, count: u32) -> Result<(), Box<dyn Error>> {
    let monitor: Monitor = Monitor::connect_with(&Config::new(), status)?;
    let mut robot = Robot::new(Client::connect(commands)?, monitor)?;
    robot.configure(&RobotConfig::new().allow_motion_without_status())?;
    // It spins, so that it is not asleep when the cycle is due; and the arm is not held at the end, so that all
    // set-points are counted.
    let config = ServoConfig::new().max_unanswered(Duration::from_secs(30)).busy_wait(Duration::from_millis(8));
    let config = config.rest_timeout(Duration::ZERO);
    let mut session = robot.enter_servo_mode(&config)?;
    for _ in 0..count {
        session.send_joint_offset([0.0; 6])?;
    }
    // No packets come that could show rest.
    let _end = session.land()?;
    Ok(())
}
