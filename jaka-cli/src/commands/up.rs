//! `jaka up`: power on and enable.

use std::time::Duration;

use clap::Args;
use jaka_robot::PowerStep;
use jaka_robot::power::{EnableRobot, PowerOn};
use jaka_robot::proto::Command;

use crate::arm::acting::{ActArgs, intent};
use crate::failure::Failure;
use crate::terminal::output;

/// Default timeout of `jaka up` and `jaka down`.
pub(super) const PATIENCE: Duration = Duration::from_secs(60);

/// Power and enable the arm, each step after the previous one is done
///
/// Power takes some 8 s, and enabling 3 to 4 s as a rule; standard error shows the progress. Steps already done are not
/// sent. Nothing is sent while the emergency stop is pressed. An enabled arm releases its brakes.
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
        let mut powered_after = None;
        let tell = |step| note(step, &mut powered_after);
        act.with_steps(|robot| robot.power_up_with(act.patience(PATIENCE), tell))?;
        output::line("the arm is powered and enabled")
    }
}

/// Prints a note on a step, and keeps the duration of switching the power on, if that was a step.
fn note(step: PowerStep, powered_after: &mut Option<Duration>) {
    match (step.command, step.took) {
        (command, Some(took)) if command == PowerOn::INFO.name => *powered_after = Some(took),
        (command, None) if command == PowerOn::INFO.name => output::note("switching the power on"),
        (_, None) => output::note(&powered_after.map_or_else(
            || "enabling the arm, which has power".to_owned(),
            |took| format!("the arm has power, after {:.1} s; enabling it", took.as_secs_f64()),
        )),
        (_, Some(_)) => {}
    }
}
