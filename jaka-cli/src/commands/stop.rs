//! `jaka stop`: stop of the running motion or program.

mod line;

use std::path::PathBuf;

use clap::Args;
use jaka_spec::Spec;

use crate::arm::acting::Act;
use crate::builtin;
use crate::failure::{Failure, chain};
use crate::target::RobotArgs;
use crate::target::packs::SpecArgs;
use crate::terminal::output;

pub(crate) use self::line::StopLine;

/// Stop the running motion or program, and wait until the arm is at rest; sent without a question
///
/// This is not an emergency stop: it travels over the network, and the controller must accept it. The command port
/// serves one client: another program that is connected there may be disconnected. No source says whether it ends
/// `movc`, a jog, or servo motion. So the command asks for the joints after the stop, and says whether the arm is at
/// rest; the exit code is 29 if the arm still moves after 6 s, or if its joints cannot be read.
///
/// Options of the other commands for robots are ignored, with their values. Other unknown options and words are
/// ignored only if --robot names the robot.
#[derive(Debug, Args)]
pub(crate) struct Stop {
    /// Words of the line that do not concern the command.
    #[arg(skip)]
    pub(crate) ignored: Vec<String>,
    /// Packs of the line, by which only the rest is read.
    #[arg(skip)]
    pub(crate) packs: Vec<PathBuf>,
    #[command(flatten)]
    robot: RobotArgs,
}

impl Stop {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let stopped = self.stop();
        // A terminal that takes no text must not delay the stop.
        for word in &self.ignored {
            output::note(&format!("`{word}` means nothing to `jaka stop`, and was ignored"));
        }
        stopped
    }

    fn stop(&self) -> Result<(), Failure> {
        let (act, unrecorded) = Act::at_once(&self.robot)?;
        let stopped = act.stop(|| self.spec());
        if let Some(failure) = unrecorded {
            output::warning(&format!("the stop was not recorded: {}", chain(&failure)));
        }
        stopped
    }

    /// Loads the spec with the packs of the robot, without those that cannot be read.
    fn spec(&self) -> Spec {
        let loaded = SpecArgs::of(self.packs.clone()).load(self.robot.lookup());
        loaded.map_or_else(
            |failure| {
                output::warning(&format!("the rest of the arm is read without packs: {}", chain(&failure)));
                builtin::spec().clone()
            },
            |protocol| protocol.spec,
        )
    }
}
