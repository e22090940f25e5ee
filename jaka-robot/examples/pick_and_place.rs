//! Waits for a part, picks it up and puts it down 60 mm to the side, with a gripper on digital output 1 of the cabinet.
//!
//! `cargo run --example pick_and_place` runs against a simulated controller; with an address, against a robot. There
//! the arm is powered, and nothing moves until input 3 of the cabinet (the third in the list of packets) is high. Then
//! output 1 is switched, and the arm moves by a few centimetres from where it is, **down as well**: put it well above
//! everything. It asks before. The arm stays enabled; whatever goes wrong, the gripper stays as it is: a part that it
//! holds is not dropped.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::thread::sleep;
use std::time::Duration;

use jaka_robot::io::SetDigitalOutput;
use jaka_robot::motion::{EndMove, MoveL};
use jaka_robot::types::{Pose, Switch};
use jaka_robot::{Motion, Numbering, Robot};
use jaka_sim::{Happening, Level};

/// This program counts inputs from 1.
const IO: Numbering = Numbering::FromOne;
/// The number of the gripper's output in commands: from which number a controller counts them is to be tried.
const GRIPPER: i64 = 1;
/// Time that the fingers need. With a sensor in the gripper, wait for its digital input instead.
const FINGERS: Duration = Duration::from_millis(300);
/// Timeout for a motion, and for the arrival of a part.
const MOTION: Duration = Duration::from_secs(15);
const PART: Duration = Duration::from_secs(60);

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask(
        "The arm will be powered. When input 3 of the cabinet is high, digital output 1 is switched, and the tool moved 20 mm along x, 60 mm along y and 30 mm down. Clear the area.",
    )?;
    let mut robot = target.robot()?;
    robot.power_up(Duration::from_secs(60))?;
    if let Some(controller) = &target.controller {
        let in_a_second = controller.elapsed() + Duration::from_secs(1);
        controller.at(in_a_second, Happening::Input(2, Level::High))?;
    }
    let result = pick_and_place(&mut robot);
    common::or_stop(&robot, result)?;
    println!("Done.");
    Ok(())
}

fn pick_and_place(robot: &mut Robot) -> Result<(), Box<dyn Error>> {
    let start = robot.client().get_tcp_pos()?.pose;
    let part = Pose { x: start.x + 20.0, ..start };
    let place = Pose { y: part.y + 60.0, ..part };
    grip(robot, Switch::Off)?;
    robot.wait_for_input(IO.cabinet(3).is_high(), PART)?;
    for (above, gripper) in [(part, Switch::On), (place, Switch::Off)] {
        // Through free space the joints take the shortest way; near the part the tool keeps to a straight line.
        go(robot, "above", &EndMove::new(above, 15.0).acceleration(60.0))?;
        go(robot, "down", &line(Pose { z: above.z - 30.0, ..above }))?;
        grip(robot, gripper)?;
        go(robot, "up", &line(above))?;
    }
    go(robot, "back", &EndMove::new(start, 15.0).acceleration(60.0))
}

fn line(pose: Pose) -> MoveL {
    MoveL::absolute(pose, 50.0).acceleration(200.0)
}

fn go(robot: &mut Robot, what: &str, motion: &impl Motion) -> Result<(), Box<dyn Error>> {
    robot.run(motion, MOTION)?.reached()?;
    println!("  {what}");
    Ok(())
}

fn grip(robot: &mut Robot, value: Switch) -> Result<(), Box<dyn Error>> {
    robot.client().set_digital_output(&SetDigitalOutput::cabinet(GRIPPER, value))?;
    sleep(FINGERS);
    println!("  gripper {}", if value == Switch::On { "closed" } else { "open" });
    Ok(())
}
