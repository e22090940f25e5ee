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
        let mut progress = StepProgress::default();
        act.with_steps(|robot| robot.power_up_with(act.patience(PATIENCE), |step| progress.note(step)))?;
        output::line("the arm is powered and enabled")
    }
}

/// Printer of notes on the steps, from the controller's answers.
#[derive(Debug, Default)]
struct StepProgress {
    /// Duration of switching the power on, if that was a step.
    powered_after: Option<Duration>,
}

impl StepProgress {
    fn note(&mut self, step: PowerStep) {
        match (step.command, step.took) {
            (command, Some(took)) if command == PowerOn::INFO.name => self.powered_after = Some(took),
            (command, None) if command == PowerOn::INFO.name => output::note("switching the power on"),
            (_, None) => output::note(&self.powered_after.map_or_else(
                || "enabling the arm, which has power".to_owned(),
                |took| format!("the arm has power, after {:.1} s; enabling it", took.as_secs_f64()),
            )),
            (_, Some(_)) => {}
        }
    }
}
