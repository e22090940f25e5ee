//! `jaka up`: power on and enable.

use std::time::Duration;

use clap::Args;
use jaka_sync::power::{EnableRobot, PowerOn};

use crate::acting::{ActArgs, intent};
use crate::failure::Failure;
use crate::output;

/// How long it may take by default.
pub(super) const PATIENCE: Duration = Duration::from_secs(60);

/// Power and enable the arm, each step when the one before is done
///
/// What is done already is not sent. Nothing is sent while the emergency stop is pressed. An arm that is enabled releases its brakes.
#[derive(Debug, Args)]
pub(crate) struct Up {
    #[command(flatten)]
    act: ActArgs,
}

impl Up {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let act = self.act.begin(&[intent(&PowerOn::new())?, intent(&EnableRobot::new())?])?;
        act.with_robot("`power_on` or `enable_robot`", |robot| robot.power_up(act.patience(PATIENCE)))?;
        output::line("the arm is powered and enabled")
    }
}
