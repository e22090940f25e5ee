//! `jaka down`: disable and power off.

use clap::Args;
use jaka_sync::power::{DisableRobot, PowerOff};

use super::up::PATIENCE;
use crate::arm::acting::{ActArgs, intent};
use crate::failure::Failure;
use crate::terminal::output;

/// Disable the arm and switch its power off, each step after the previous one is done
///
/// Steps already done are not sent. The controller does not disable an arm that moves or runs a program: use
/// `jaka stop` first.
#[derive(Debug, Args)]
pub(crate) struct Down {
    #[command(flatten)]
    act: ActArgs,
}

impl Down {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let act = self
            .act
            .begin("be disabled and lose its power", &[intent(&DisableRobot::new())?, intent(&PowerOff::new())?])?;
        act.with_steps(|robot| robot.power_down(act.patience(PATIENCE)))?;
        output::line("the arm has no power")
    }
}
