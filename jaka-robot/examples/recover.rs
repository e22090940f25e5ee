//! Recovers from a protective stop in the middle of a motion.
//!
//! `cargo run --example recover` runs against a simulated controller, whose arm runs into something. With an address,
//! it runs against a robot: joint 1 moves by 10 degrees and back, slowly, and a protective stop is recovered from if
//! one comes. Do not cause one with your body. It asks before each motion. The arm stays enabled.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::time::Duration;

use common::Target;
use jaka_robot::motion::JointMove;
use jaka_robot::types::JointPosition;
use jaka_robot::{Cause, End, Robot};

const MOTION: Duration = Duration::from_secs(20);

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm will be powered and joint 1 will move by 10 deg. Clear the area.")?;
    let mut robot = target.robot()?;
    robot.power_up(Duration::from_secs(60))?;
    let result = there_and_back(&mut robot, &target);
    common::or_stop(&robot, result)?;
    println!("Done.");
    Ok(())
}

fn there_and_back(robot: &mut Robot, target: &Target) -> Result<(), Box<dyn Error>> {
    let start = robot.client().get_joint_pos()?.joint_position;
    let mut away = start;
    away.0[0] += 10.0;
    println!("Joint 1 moves by 10 deg");
    let end = run_into_something(robot, target, start, away)?;
    report(&end);
    if end.cause() == Cause::ProtectiveStop {
        refused(robot, away);
        recover(robot, target)?;
        println!("On to the target: nothing is sent again on its own");
        go(robot, away)?;
    } else {
        end.reached()?;
    }

    target.ask("Joint 1 will move back.")?;
    println!("And back");
    go(robot, start)
}

fn to(joint_position: JointPosition) -> JointMove {
    JointMove::absolute(joint_position, 5.0).acceleration(20.0)
}

/// Runs a motion; a simulated arm collides once it has moved by three degrees.
fn run_into_something(
    robot: &mut Robot,
    target: &Target,
    start: JointPosition,
    away: JointPosition,
) -> Result<End, Box<dyn Error>> {
    if let Some(controller) = &target.controller {
        let far = start.0[0] + 3.0;
        controller.when(move |state| state.joint_position.0[0] > far, jaka_sim::Controller::collide)?;
    }
    Ok(robot.run(&to(away), MOTION)?)
}

/// Prints the end of a motion, and the last packet before it.
fn report(end: &End) {
    println!("  after {:.1?}: {end}", end.report.waited);
    let Some(last) = end.packets.last() else { return };
    let joint_1 = last.status.joint_actual_position.map_or(f64::NAN, |joints| joints.0[0]);
    let code = last.status.error_code.as_deref().unwrap_or("none");
    println!("  the last of {} packets: joint 1 at {joint_1:.2} deg, error code {code}", end.packets.len());
}

/// Until somebody has acknowledged the stop, motions are not even sent.
fn refused(robot: &mut Robot, away: JointPosition) {
    println!("Another motion before the stop is acknowledged");
    match robot.start(&to(away)) {
        Ok(()) => println!("  was accepted"),
        Err(error) => println!("  {error}"),
    }
}

fn recover(robot: &mut Robot, target: &Target) -> Result<(), Box<dyn Error>> {
    target.ask("Look at the arm: is anybody or anything in contact with it? If not, it will go on.")?;
    println!("clear_error leaves the protective stop");
    robot.client().clear_error()?;
    // Only the status proves it, not the reply. An acknowledgement before the status shows it would have no effect.
    robot.monitor().wait_until(|status| status.protective_stop == Some(false), Duration::from_secs(15))?;
    // Whether the arm is still enabled is up to the controller.
    robot.power_up(Duration::from_secs(60))?;
    robot.acknowledge();
    println!("  acknowledged; what still holds motions back: {:?}", robot.unacknowledged());
    Ok(())
}

fn go(robot: &mut Robot, joint_position: JointPosition) -> Result<(), Box<dyn Error>> {
    let end = robot.run(&to(joint_position), MOTION)?;
    report(&end);
    Ok(end.reached()?)
}
