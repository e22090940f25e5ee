//! Motions that are waited for: stopped by Ctrl-C, and how they end, for people and for programs.

use std::time::Duration;

use jaka_spec::Spec;
use jaka_sync::{Error, MotionEnd, Outcome, Robot};
use serde_json::json;

use crate::failure::Failure;
use crate::interrupt::UnderWay;
use crate::output;

/// How long the end of a motion is waited for, unless the command line says otherwise.
pub(crate) const PATIENCE: Duration = Duration::from_secs(300);

/// Runs a motion, and prints how it ended.
///
/// # Errors
/// It was not accepted, or did not end at its target.
pub(crate) fn run(
    robot: &mut Robot,
    motion: impl FnOnce(&mut Robot) -> Result<MotionEnd, Error>,
    spec: &Spec,
    under_way: &UnderWay,
    as_json: bool,
) -> Result<(), Failure> {
    under_way.moves(robot.stop_handle());
    let ended = motion(robot);
    under_way.answered();
    print(ended.map_err(|error| Failure::explained(spec, error))?, as_json)
}

/// Prints how a motion ended, as JSON whatever the end is.
fn print(end: MotionEnd, as_json: bool) -> Result<(), Failure> {
    let waited = end.waited.as_secs_f64();
    if as_json {
        let (outcome, text) = (word(&end.outcome), end.outcome.to_string());
        output::json(&format!("{}\n", json!({"outcome": outcome, "text": text, "waited_s": waited})))?;
    } else if end.outcome.is_reached() {
        output::line(&format!("{}, after {waited:.1} s", end.outcome))?;
    }
    end.reached().map_err(Failure::NotReached)
}

/// An outcome as one word, which does not change.
fn word(outcome: &Outcome) -> &'static str {
    match outcome {
        Outcome::Reached => "reached",
        Outcome::AtRest => "at_rest",
        Outcome::Stopped => "stopped",
        Outcome::ProtectiveStop => "protective_stop",
        Outcome::EmergencyStop => "emergency_stop",
        Outcome::Disabled => "disabled",
        Outcome::ControllerError { .. } => "controller_error",
        Outcome::Deadline => "deadline",
        Outcome::StatusLost { .. } => "status_lost",
        _ => "other",
    }
}
