//! Shared parts of the examples: a controller to talk to, and a question before its arm moves.
//!
//! Messages go to standard error, so that an example's own output can be used as it is.

use std::env::args;
use std::error::Error;
use std::io::{BufRead, stdin};
use std::process::ExitCode;

use jaka_robot::{Client, Config, Monitor, Robot};
use jaka_sim::{Controller, Delays};

/// Prints an error as text, with its causes: a result that `main` returns would be printed in its `Debug` form.
pub(crate) fn end(result: Result<(), Box<dyn Error>>) -> ExitCode {
    let Err(error) = result else { return ExitCode::SUCCESS };
    eprintln!("{error}");
    let mut cause = error.source();
    while let Some(error) = cause {
        eprintln!("  because: {error}");
        cause = error.source();
    }
    ExitCode::FAILURE
}

/// The addresses of a controller, and the simulated one itself if it is one.
#[allow(dead_code, reason = "some examples use a part of it")]
pub(crate) struct Target {
    /// Address for commands.
    pub(crate) commands: String,
    /// Address for status packets.
    pub(crate) status: String,
    /// True if no robot is at the other end.
    pub(crate) is_simulated: bool,
    /// The simulated controller, for what no command can do.
    pub(crate) controller: Option<Controller>,
}

#[allow(dead_code, reason = "some examples use a part of it")]
impl Target {
    /// Connects for commands and for status.
    pub(crate) fn robot(&self) -> Result<Robot, jaka_robot::Error> {
        let config = Config::new();
        let monitor: Monitor = Monitor::connect_with(&config, &self.status)?;
        Ok(Robot::new(Client::connect_with(&config, &self.commands)?, monitor)?)
    }

    /// Asks before a robot does something; a simulated one just does it.
    pub(crate) fn ask(&self, what: &str) -> Result<(), Box<dyn Error>> {
        if self.is_simulated {
            return Ok(());
        }
        eprint!("{what} Go on? [y/N] ");
        // Without a terminal there is no consent.
        let answer = stdin().lock().lines().next().transpose()?.unwrap_or_default();
        if matches!(answer.trim(), "y" | "yes") { Ok(()) } else { Err("not confirmed: nothing was sent".into()) }
    }
}

/// After an error, stops the arm, which may still move, and passes the error on.
#[allow(dead_code, reason = "some examples move nothing")]
pub(crate) fn or_stop<T>(robot: &Robot, result: Result<T, Box<dyn Error>>) -> Result<T, Box<dyn Error>> {
    if result.is_err() {
        match robot.stop_handle().stop() {
            Ok(()) => eprintln!("Stopped after an error."),
            Err(error) => eprintln!("The arm may still move: {error}"),
        }
    }
    result
}

/// The robot at the address given on the command line, or a simulated controller if none is given.
#[allow(dead_code, reason = "one example talks to two controllers")]
pub(crate) fn target() -> Result<Target, Box<dyn Error>> {
    target_at(args().nth(1))
}

/// The robot at an address, or a simulated controller if there is none.
pub(crate) fn target_at(address: Option<String>) -> Result<Target, Box<dyn Error>> {
    if let Some(address) = address {
        eprintln!("Controller: {address}");
        return Ok(Target { commands: address.clone(), status: address, is_simulated: false, controller: None });
    }
    // A real controller takes some twelve seconds to switch power on and to enable the arm.
    let controller = Controller::builder().delays(Delays::NONE).start()?;
    let (commands, status) = (controller.command_addr().to_string(), controller.status_addr().to_string());
    eprintln!("Controller: simulated, commands at {commands}, status at {status}");
    eprintln!("(Give the address of a robot to use that instead.)");
    Ok(Target { commands, status, is_simulated: true, controller: Some(controller) })
}
