//! `jaka status`: what the status packets of port 10000 say.

use clap::Args;
use jaka_sync::{Monitor, Reconnect};

use crate::failure::Failure;
use crate::output;
use crate::target::RobotArgs;

/// Print the robot's state.
#[derive(Debug, Args)]
pub(crate) struct Status {
    #[command(flatten)]
    robot: RobotArgs,
}

impl Status {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let target = self.robot.target()?;
        let monitor: Monitor = target.monitor(Reconnect::Never)?;
        output::line(&format!("{}: {:?}", target.title(), monitor.next()?.status))
    }
}
