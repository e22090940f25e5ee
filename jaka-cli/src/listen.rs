//! Listening addresses of a controller of this program.

use std::io::{self, ErrorKind};
use std::net::{IpAddr, SocketAddr, TcpListener};

use clap::Args;
use itertools::Itertools as _;
use jaka_sim::{Builder, Controller};

use crate::failure::Failure;
use crate::terminal::output;

/// Hint for ports in use.
const PORTS_IN_USE: &str =
    "end the program that uses the port; or `--commands` and `--status` set other ports, 0 a free one";

/// Options for the listening addresses.
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
    /// Starts a controller at these addresses, prepares it, and prints them.
    pub(crate) fn start(&self, builder: Builder, prepare: impl FnOnce(&Controller)) -> Result<Controller, Failure> {
        let started = builder.address(self.address).ports(self.commands, self.status).start();
        let controller = started.map_err(|error| self.failed(error))?;
        prepare(&controller);
        print(controller.command_addr(), controller.status_addr())?;
        Ok(controller)
    }

    /// Creates the failure, with the port if it is in use.
    fn failed(&self, error: io::Error) -> Failure {
        let is_in_use = |error: &io::Error| error.kind() == ErrorKind::AddrInUse;
        let is_taken =
            |port: &u16| is_in_use(&error) && TcpListener::bind((self.address, *port)).is_err_and(|e| is_in_use(&e));
        let taken: Vec<_> = [self.commands, self.status].into_iter().filter(is_taken).collect();
        let ports = match taken[..] {
            [] => String::new(),
            [port] => format!(": port {port} of {} is in use", self.address),
            _ => format!(": ports {} of {} are in use", taken.iter().join(" and "), self.address),
        };
        Failure::unopened(format!("cannot start the controller{ports}"), error, PORTS_IN_USE)
    }
}

/// Prints the addresses of the command port and of the status port.
pub(crate) fn print(commands: SocketAddr, status: SocketAddr) -> Result<(), Failure> {
    output::line(&format!("commands at {commands}, status at {status}"))
}
