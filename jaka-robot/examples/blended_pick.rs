//! Pick and place along lines with rounded corners. It moves the tool by 60 mm along y and 30 mm down, and asks before.
mod common;

use std::{error::Error, process::ExitCode, thread::sleep, time::Duration};

use jaka_robot::io::SetDigitalOutput;
use jaka_robot::jaka_motion::{Limits, Model, Trajectory, Via};
use jaka_robot::payload::SetPayload;
use jaka_robot::types::{Pose, Switch};
use jaka_robot::{Robot, RobotConfig};

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm moves, and digital output 1 and the payload are set. Clear the area.")?;
    let mut robot = target.robot()?;
    robot.configure(&RobotConfig::new().limits(Limits::of(Model::named("Zu 5").ok_or("an arm")?)))?;
    robot.power_up(Duration::from_secs(60))?;
    let above = robot.client().get_tcp_pos()?.pose;
    let part = Pose { z: above.z - 30.0, ..above };
    go(&mut robot, &[part])?;
    grip(&mut robot, Switch::On, 0.8)?;
    go(&mut robot, &[above, Pose { y: above.y + 60.0, ..above }, Pose { y: part.y + 60.0, ..part }])?;
    grip(&mut robot, Switch::Off, 0.0)?;
    go(&mut robot, &[Pose { y: above.y + 60.0, ..above }, above])
}

/// Along lines from where the arm is, with corners rounded by 10 mm, and slowly on the last one.
fn go(robot: &mut Robot, poses: &[Pose]) -> Result<(), Box<dyn Error>> {
    let mut points = vec![Via::joints(robot.client().get_joint_pos()?.joint_position)];
    points.extend(poses.iter().map(|pose| Via::line(*pose)));
    points.last_mut().into_iter().for_each(|last| *last = last.with_tcp_speed(25.0));
    let way = Trajectory::through(points).corner_mm(10.0).tcp_speed(100.0).build(robot.limits().ok_or("limits")?)?;
    Ok(robot.follow(&way, Duration::from_secs(60))?.reached()?)
}

/// The payload changes while the arm rests: the controller's model of its forces would jump under way.
fn grip(robot: &mut Robot, value: Switch, mass_kg: f64) -> Result<(), Box<dyn Error>> {
    robot.client().set_digital_output(&SetDigitalOutput::cabinet(1, value))?;
    sleep(Duration::from_millis(300));
    Ok(robot.client().set_payload(&SetPayload::new(mass_kg, [0.0, 0.0, 50.0])).map(drop)?)
}
