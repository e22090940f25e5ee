//! `jaka down`: disable and power off.

use clap::Args;
use jaka_robot::RobotConfig;
use jaka_sync::power::{DisableRobot, PowerOff};

use super::up::PATIENCE;
use crate::arm::acting::{ActArgs, intent};
use crate::failure::Failure;
use crate::terminal::output;

/// Disable the arm and switch its power off, each step after the previous one is done
///
/// Steps already done are not sent. Nothing is sent while the arm moves, by three answers of the controller: use
/// `jaka stop` first. The controller does not disable an arm that runs a program.
#[derive(Debug, Args)]
pub(crate) struct Down {
    /// Power down also if the controller does not report the joints, so that it is not known whether the arm moves
    #[arg(long)]
    without_joints: bool,
    #[command(flatten)]
    act: ActArgs,
}

impl Down {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let act = self
            .act
            .begin("be disabled and lose its power", &[intent(&DisableRobot::new())?, intent(&PowerOff::new())?])?;
        let config = RobotConfig::new();
        let config = if self.without_joints { config.allow_power_down_without_joints() } else { config };
        act.with_steps(|robot| {
            robot.configure(&config)?;
            robot.power_down(act.patience(PATIENCE))
        })?;
        output::line("the arm has no power")
    }
}
