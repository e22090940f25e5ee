//! Moves the tool down until it touches something, tells where that is, and moves it up again.
//!
//! `cargo run --example move_until_contact` runs against a simulated controller, with a table 6 mm below the tool; with
//! an address, against a robot. There the arm is powered, and the tool moves **straight down by up to 40 mm**, with 4
//! mm/s, along the z axis of the selected user frame, until the torque sensor reads 10 N more or less than at the
//! start; it goes on for up to 1 mm then. The arm needs a torque sensor that works and is initialised: push against the
//! tool and look at `jaka status` first. What is below must bear that, and nobody's hand may be there: a guard is not a
//! safety function. It asks before. The arm stays enabled.

mod common;

use std::error::Error;
use std::process::ExitCode;
use std::time::Duration;

use jaka_robot::motion::MoveL;
use jaka_robot::{ForceComponent, ForceLimit, MotionExt as _, Robot};
use jaka_sim::Contact;

/// Timeout for a motion.
const MOTION: Duration = Duration::from_secs(20);

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target
        .ask("The arm will be powered, and the tool moved straight down by up to 40 mm until it touches something.")?;
    let mut robot = target.robot()?;
    robot.power_up(Duration::from_secs(60))?;
    if let Some(controller) = &target.controller {
        controller.set_state(|state| state.torque_sensor.working = true);
        let tool = controller.state().tcp_pose;
        controller.set_contact(Some(Contact::plane([tool.x, tool.y, tool.z - 6.0], [0.0, 0.0, 1.0], 50.0)))?;
    }
    let result = touch(&mut robot);
    common::or_stop(&robot, result)
}

fn touch(robot: &mut Robot) -> Result<(), Box<dyn Error>> {
    let down = MoveL::relative([0.0, 0.0, -40.0, 0.0, 0.0, 0.0], 4.0).acceleration(500.0);
    let contact = ForceLimit::new(ForceComponent::Force, 10.0);
    // Fails if the arm has come to the end without a contact, too.
    let trip = robot.run(&down.guard(contact), MOTION)?.guarded()?;
    let at = robot.client().get_tcp_pos()?.pose;
    println!(
        "Contact at [{:.1}, {:.1}, {:.1}] mm; the stop was written {:.0?} after the packet.",
        at.x,
        at.y,
        at.z,
        trip.reaction.unwrap_or_default()
    );
    let up = MoveL::relative([0.0, 0.0, 10.0, 0.0, 0.0, 0.0], 20.0).acceleration(200.0);
    Ok(robot.run(&up, MOTION)?.reached()?)
}
