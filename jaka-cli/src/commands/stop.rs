//! `jaka stop`: stop of the running motion or program.

use clap::Args;
use jaka_sync::program::StopProgram;

use crate::arm::acting::Act;
use crate::failure::Failure;
use crate::target::{RobotArgs, Target};
use crate::terminal::output;

/// Stop the running motion or program; sent without a question
///
/// This is not an emergency stop: it travels over the network, and the controller must accept it. The command port
/// serves one client: another program that is connected there may be disconnected. No source says whether it ends
/// `movc`, a jog, or servo motion.
#[derive(Debug, Args)]
pub(crate) struct Stop {
    #[command(flatten)]
    robot: RobotArgs,
}

impl Stop {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let act = Act::at_once(&self.robot)?;
        let stopped = act.with(Target::client, "`stop_program`", |client| client.call(&StopProgram::new()));
        stopped.map_err(|failure| Failure::NotStopped(Box::new(failure)))?;
        output::line("the controller accepted the stop (`stop_program`)")
    }
}
