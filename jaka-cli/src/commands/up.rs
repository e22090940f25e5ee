//! `jaka up`: power on and enable.

mod progress;

use std::time::Duration;

use clap::Args;
use jaka_sync::power::{EnableRobot, PowerOn};

use self::progress::Progress;
use crate::acting::{ActArgs, intent};
use crate::failure::Failure;
use crate::output;

/// How long it may take by default.
pub(super) const PATIENCE: Duration = Duration::from_secs(60);

/// Power and enable the arm, each step when the one before is done
///
/// Power takes some 8 s, and enabling 3 to 4 s as a rule; standard error tells how far it has come. What is done already is not sent. Nothing is sent while the emergency stop is pressed. An arm that is enabled releases its brakes.
#[derive(Debug, Args)]
pub(crate) struct Up {
    #[command(flatten)]
    act: ActArgs,
}

impl Up {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let act = self.act.begin(
            "get power and be enabled: its brakes release",
            &[intent(&PowerOn::new())?, intent(&EnableRobot::new())?],
        )?;
        act.with_steps(|robot| {
            let patience = act.patience(PATIENCE);
            let progress = Progress::begin(robot, patience);
            let done = robot.power_up(patience);
            if done.is_ok() {
                progress.has_power();
            }
            progress.end();
            done
        })?;
        output::line("the arm is powered and enabled")
    }
}
