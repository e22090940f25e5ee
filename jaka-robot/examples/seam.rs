//! A seam of 200 points at 15 mm/s, with a pause on it. The tool moves by 100 mm along y and back in an arc of 10 mm.
mod common;

use std::{error::Error, process::ExitCode, thread::sleep, time::Duration};

use jaka_robot::jaka_motion::{Limits, Model, Trajectory, Via};
use jaka_robot::types::Pose;
use jaka_robot::{FollowConfig, RobotConfig};

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm will be powered, and the tool moved by 100 mm along y. Clear the area.")?;
    let mut robot = target.robot()?;
    robot.configure(&RobotConfig::new().limits(Limits::of(Model::named("Zu 5").ok_or("an arm")?)))?;
    robot.power_up(Duration::from_secs(60))?;
    let (start, joints) = (robot.client().get_tcp_pos()?.pose, robot.client().get_joint_pos()?.joint_position);
    let seam = (0..200).map(|point| f64::from(point) / 199.0).map(|share| {
        let (y, x) = (100.0 * share, 10.0 * (std::f64::consts::PI * share).sin());
        Via::line(Pose { x: start.x + x, y: start.y + y, ..start })
    });
    let curve = Trajectory::curve(seam).near(joints).within_mm(0.2).within_deg(0.5).tcp_speed(15.0);
    let trajectory = curve.build(robot.limits().ok_or("limits")?)?;
    for slow in trajectory.slow_places() {
        println!("at {:.1} s {:.0} % of the speed: {}", slow.time_s, 100.0 * slow.share, slow.by);
    }
    let run = robot.start_follow(&trajectory, &FollowConfig::new().deadline(Duration::from_secs(60)))?;
    sleep(Duration::from_secs(2));
    run.handle().pause()?;
    sleep(Duration::from_secs(1));
    run.handle().resume()?;
    let end = run.wait();
    println!("{} set-points for {:.1?} of the seam", end.report.cycles, trajectory.duration());
    Ok(end.reached()?)
}
