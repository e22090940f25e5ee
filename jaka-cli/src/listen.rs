//! The addresses at which a controller of this program listens.

use std::net::{IpAddr, SocketAddr};

use clap::Args;
use jaka_sim::{Builder, Controller};

use crate::failure::Failure;
use crate::output;

/// The options that give the addresses.
#[derive(Debug, Args)]
pub(crate) struct ListenArgs {
    /// Address to listen at
    #[arg(long, default_value = "127.0.0.1")]
    address: IpAddr,
    /// Port for commands, 0 for a free one
    #[arg(long, value_name = "PORT", default_value_t = jaka_sync::COMMAND_PORT)]
    commands: u16,
    /// Port for status packets, 0 for a free one
    #[arg(long, value_name = "PORT", default_value_t = jaka_sync::STATUS_PORT)]
    status: u16,
}

impl ListenArgs {
    /// Starts a controller at these addresses, and prints them.
    pub(crate) fn start(&self, builder: Builder) -> Result<Controller, Failure> {
        let started = builder.address(self.address).ports(self.commands, self.status).start();
        let controller = started.map_err(|error| Failure::local("cannot start the simulated controller", error))?;
        print(controller.command_addr(), controller.status_addr())?;
        Ok(controller)
    }
}

/// Prints the addresses of the command port and of the status port.
pub(crate) fn print(commands: SocketAddr, status: SocketAddr) -> Result<(), Failure> {
    output::line(&format!("commands at {commands}, status at {status}"))
}
