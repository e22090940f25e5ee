//! Stops the arm on Ctrl-C.
//!
//! `cargo run --example stop_on_ctrl_c` runs against a simulated controller; with an address, against a robot. There
//! joint 1 goes 10 degrees away and back, slowly, until Ctrl-C; it asks before. The arm stays enabled. This is not an
//! emergency stop: keep the button within reach.

mod common;

use std::error::Error;
use std::io::{IsTerminal, stdin};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use jaka_robot::motion::JointMove;
use jaka_robot::{Cause, Robot, RobotStop};

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    let target = common::target()?;
    target.ask("The arm will be powered and joint 1 will move by 10 deg and back, until Ctrl-C. Clear the area.")?;
    let mut robot = target.robot()?;
    robot.power_up(Duration::from_secs(60))?;

    let stop = Stop { asked: Arc::default(), handle: robot.stop_handle() };
    let on_ctrl_c = stop.clone();
    // `ctrlc` calls this in a thread of its own, where it may wait for the controller's reply.
    ctrlc::set_handler(move || on_ctrl_c.stop("Ctrl-C"))?;
    if target.is_simulated {
        let on_timer = stop.clone();
        // With a terminal there is time to press Ctrl-C.
        let time = Duration::from_secs(if stdin().is_terminal() { 10 } else { 1 });
        thread::spawn(move || {
            thread::sleep(time);
            on_timer.stop("a timer, in place of Ctrl-C");
        });
    }

    println!("Moving. Ctrl-C stops the arm.");
    let result = swing(&mut robot, &stop);
    common::or_stop(&robot, result)?;
    println!("Done.");
    Ok(())
}

/// Flag and stop handle that Ctrl-C uses.
#[derive(Clone)]
struct Stop {
    /// The handle stops the motion that runs; this keeps the next one from being sent.
    asked: Arc<AtomicBool>,
    handle: RobotStop,
}

impl Stop {
    fn stop(&self, why: &str) {
        self.asked.store(true, Ordering::SeqCst);
        match self.handle.stop() {
            Ok(()) => println!("  stopped by {why}"),
            Err(error) => eprintln!("  the arm may still move, use the emergency stop: {error}"),
        }
    }

    fn is_asked(&self) -> bool {
        self.asked.load(Ordering::SeqCst)
    }
}

/// Moves joint 1 away and back until it is stopped.
fn swing(robot: &mut Robot, stop: &Stop) -> Result<(), Box<dyn Error>> {
    let start = robot.client().get_joint_pos()?.joint_position;
    let mut away = start;
    away.0[0] += 10.0;
    for joint_position in [away, start].into_iter().cycle() {
        if stop.is_asked() {
            break;
        }
        let motion = JointMove::absolute(joint_position, 5.0).acceleration(20.0);
        robot.start(&motion)?;
        if stop.is_asked() {
            // The stop came while the motion was being sent, and may have reached the controller before it.
            robot.client().stop_program()?;
        }
        let end = robot.wait(Duration::from_secs(15));
        println!("  {end} ({:.1?})", end.report.waited);
        match end.cause() {
            Cause::Reached => {}
            Cause::Stopped => break,
            // Also after the deadline, when the arm may still move: `main` stops it.
            _ => return Ok(end.reached()?),
        }
    }
    println!("  joint 1 is at {:.2} deg, between {:.2} and {:.2}", joint_1(robot)?, start.0[0], away.0[0]);
    Ok(())
}

/// Waits until joint 1 rests, because a stop takes its time, and returns its position in degrees.
fn joint_1(robot: &mut Robot) -> Result<f64, jaka_robot::Error> {
    robot.monitor().next_packet()?;
    robot.monitor().wait_until(|status| status.in_position == Some(true), Duration::from_secs(5))?;
    Ok(robot.client().get_joint_pos()?.joint_position.0[0])
}
