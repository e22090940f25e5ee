//! Picks a part up and puts it down 60 mm to the side, with a gripper on digital output 1 of the cabinet.
//!
//! `cargo run --example pick_and_place` runs against a simulated controller; with an address, against a robot. There the
//! arm moves by a few centimetres from where it is, down as well: put it well above everything. It asks before. The arm
//! stays enabled.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::thread::sleep;
use std::time::Duration;

use jaka_sync::io::SetDigitalOutput;
use jaka_sync::motion::{EndMove, JointMove, MoveL};
use jaka_sync::types::{Pose, Switch};
use jaka_sync::{Motion, Outcome, Robot};

/// The number of the gripper's output in commands.
const OUTPUT: i64 = 1;
/// Its place in the status, from 0. Firmware that counts outputs from 1 has it one place earlier.
const OUTPUT_IN_STATUS: usize = 1;
/// How long the fingers take. A gripper with a sensor says so itself: wait for its digital input then.
const FINGERS: Duration = Duration::from_millis(300);
/// How long a motion may take.
const MOTION: Duration = Duration::from_secs(15);

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask(
        "The arm will be powered, digital output 1 switched, and the tool moved 20 mm along x, 60 mm along y and 30 mm \
         down. Clear the area.",
    )?;
    let mut robot = target.robot()?;
    robot.power_up(Duration::from_secs(60))?;
    let result = pick_and_place(&mut robot);
    common::or_stop(&robot, result)?;
    println!("Done.");
    Ok(())
}

fn pick_and_place(robot: &mut Robot) -> Result<(), Box<dyn Error>> {
    let home = robot.client().get_joint_pos()?.joint_position;
    let start = robot.client().get_tcp_pos()?.pose;
    let above_part = Pose { x: start.x + 20.0, ..start };
    let above_place = Pose { y: above_part.y + 60.0, ..above_part };

    grip(robot, Switch::Off)?;
    go(robot, "above the part", &swing(above_part))?;
    down_and_up(robot, above_part, Switch::On)?;
    go(robot, "above the place", &swing(above_place))?;
    down_and_up(robot, above_place, Switch::Off)?;

    let back = JointMove::absolute(home, 15.0).acceleration(60.0);
    go(robot, "back", &back)
}

/// Straight down, the gripper, and straight up again.
fn down_and_up(robot: &mut Robot, above: Pose, gripper: Switch) -> Result<(), Box<dyn Error>> {
    let below = Pose { z: above.z - 30.0, ..above };
    go(robot, "down", &line(below))?;
    grip(robot, gripper)?;
    go(robot, "up", &line(above))
}

/// Through free space: the joints take the shortest way.
fn swing(pose: Pose) -> EndMove {
    EndMove::new(pose, 15.0).acceleration(60.0)
}

/// Near the part: the tool keeps to a straight line.
fn line(pose: Pose) -> MoveL {
    MoveL::absolute(pose, 50.0).acceleration(200.0)
}

/// Runs a motion to its end. Whatever goes wrong, the gripper stays as it is: a part that it holds is not dropped.
fn go(robot: &mut Robot, what: &str, motion: &impl Motion) -> Result<(), Box<dyn Error>> {
    // The error for a refusal has the reason, too.
    let end = robot.run(motion, MOTION)?;
    match &end.outcome {
        // Another program might wait again. This one has nothing to wait for: `main` stops the arm.
        Outcome::Deadline => println!("  takes too long"),
        Outcome::ProtectiveStop | Outcome::EmergencyStop => println!("  check the arm before you go on"),
        // Reached, or stopped, disabled, an error of the controller, a lost connection: the error below says it.
        _ => {}
    }
    let waited = end.waited;
    end.reached()?;
    let at = robot.client().get_tcp_pos()?.pose;
    println!("  {what}: [{:.1}, {:.1}, {:.1}] mm after {waited:.1?}", at.x, at.y, at.z);
    Ok(())
}

/// Switches the gripper, and waits until the status shows it and the fingers have had their time.
fn grip(robot: &mut Robot, value: Switch) -> Result<(), Box<dyn Error>> {
    robot.client().set_digital_output(&SetDigitalOutput::cabinet(OUTPUT, value))?;
    let is_set = |outputs: &Vec<bool>| outputs.get(OUTPUT_IN_STATUS) == Some(&(value == Switch::On));
    robot.monitor().wait_until(|status| status.digital_outputs.as_ref().is_some_and(is_set), Duration::from_secs(2))?;
    sleep(FINGERS);
    println!("  gripper {}", if value == Switch::On { "closed" } else { "open" });
    Ok(())
}
