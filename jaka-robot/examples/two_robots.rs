//! Two robots from two threads; if one fails, both are stopped.
//!
//! `cargo run --example two_robots` runs against two simulated controllers,
//! `cargo run --example two_robots 10.5.5.100 10.5.5.101` against two robots. There joint 1 of each moves by five
//! degrees and back, twice; it asks before. The arms stay enabled.

mod common;

use std::env::args;
use std::error::Error;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

use jaka_robot::motion::JointMove;
use jaka_robot::types::JointPosition;
use jaka_robot::{Cause, Robot, RobotStop};

/// An error that can leave its thread.
type Failure = Box<dyn Error + Send + Sync>;

fn main() -> ExitCode {
    common::end(run())
}

fn run() -> Result<(), Box<dyn Error>> {
    if args().len() == 2 {
        return Err("give the addresses of two robots, or none".into());
    }
    let targets = [common::target_at(args().nth(1))?, common::target_at(args().nth(2))?];
    targets[0].ask("Both arms will be powered and joint 1 of each will move by 5 deg. Clear the area.")?;
    let (left, right) = (targets[0].robot()?, targets[1].robot()?);
    let cell = Cell { failed: AtomicBool::new(false), stops: [left.stop_handle(), right.stop_handle()] };

    // Each thread owns its robot; what they share is how to stop both.
    let results = thread::scope(|scope| {
        let left = scope.spawn(|| cell.work("left", left));
        let right = scope.spawn(|| cell.work("right", right));
        [left.join(), right.join()]
    });
    for result in results {
        result.map_err(|_| "a thread panicked")?.map_err(|failure| -> Box<dyn Error> { failure })?;
    }
    println!("Done.");
    Ok(())
}

/// State that the threads share.
struct Cell {
    failed: AtomicBool,
    stops: [RobotStop; 2],
}

impl Cell {
    /// Drives one robot, and stops both if that fails.
    fn work(&self, name: &str, mut robot: Robot) -> Result<(), Failure> {
        let result = self.swing(name, &mut robot);
        if let Err(error) = &result {
            eprintln!("{name}: {error}");
            self.stop_all();
        }
        result
    }

    fn stop_all(&self) {
        self.failed.store(true, Ordering::SeqCst);
        for stop in &self.stops {
            if let Err(error) = stop.stop() {
                eprintln!("an arm may still move: {error}");
            }
        }
    }

    fn swing(&self, name: &str, robot: &mut Robot) -> Result<(), Failure> {
        robot.power_up(Duration::from_secs(60))?;
        println!("{name}: powered and enabled");
        let start = robot.client().get_joint_pos()?.joint_position;
        let mut away = start;
        away.0[0] += 5.0;
        for joint_position in [away, start, away, start] {
            self.go(name, robot, joint_position)?;
        }
        Ok(())
    }

    fn go(&self, name: &str, robot: &mut Robot, joint_position: JointPosition) -> Result<(), Failure> {
        self.check()?;
        let motion = JointMove::absolute(joint_position, 10.0).acceleration(40.0);
        robot.start(&motion)?;
        // The other's stop may have come just before the motion was accepted: this ends in a stop of both once more.
        self.check()?;
        let end = robot.wait(Duration::from_secs(15));
        println!("{name}: joint 1 to {:.1} deg: {end} ({:.1?})", joint_position.0[0], end.report.waited);
        match end.cause() {
            Cause::Stopped => Err("was stopped".into()),
            // Also after the deadline: `work` then stops both.
            _ => end.reached().map_err(Into::into),
        }
    }

    fn check(&self) -> Result<(), Failure> {
        if self.failed.load(Ordering::SeqCst) { Err("the other robot has failed".into()) } else { Ok(()) }
    }
}
