//! What the examples share: a controller to talk to.

use std::env::args;
use std::error::Error;

use jaka_sim::{Controller, Delays};

/// The addresses of a controller, and the simulated one itself if it is one.
#[allow(dead_code, reason = "some examples use a part of it")]
pub(crate) struct Target {
    /// Address for commands.
    pub(crate) commands: String,
    /// Address for status packets.
    pub(crate) status: String,
    /// True if no robot is at the other end.
    pub(crate) is_simulated: bool,
    _controller: Option<Controller>,
}

/// The robot at the address given on the command line, or a simulated controller if none is given.
pub(crate) fn target() -> Result<Target, Box<dyn Error>> {
    if let Some(address) = args().nth(1) {
        println!("Controller: {address}");
        return Ok(Target { commands: address.clone(), status: address, is_simulated: false, _controller: None });
    }
    // A real controller takes some twelve seconds to switch power on and to enable the arm.
    let controller = Controller::builder().delays(Delays::NONE).start()?;
    let (commands, status) = (controller.command_addr().to_string(), controller.status_addr().to_string());
    println!("Controller: simulated, commands at {commands}, status at {status}");
    println!("(Give the address of a robot to use that instead.)");
    Ok(Target { commands, status, is_simulated: true, _controller: Some(controller) })
}
