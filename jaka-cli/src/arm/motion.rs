//! Motions with a wait: their stop by Ctrl-C, and their ends, for people and for programs.

use std::time::Duration;

use jaka_robot::{Cause, End, Error};
use jaka_spec::Spec;
use serde::Serialize;

use crate::arm::interrupt::{Stage, UnderWay};
use crate::failure::Failure;
use crate::packets::packed_status::PackedRobot;
use crate::terminal::output;

/// Default timeout for the end of a motion.
pub(crate) const PATIENCE: Duration = Duration::from_secs(300);

/// Output form of the end of a motion.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Form {
    Text,
    Json,
}

impl Form {
    /// Returns the form selected by an option.
    pub(crate) fn of(as_json: bool) -> Self {
        if as_json { Self::Json } else { Self::Text }
    }
}

/// End of a motion, for programs.
#[derive(Serialize)]
struct Ended<'e> {
    command: &'e str,
    end: &'e End,
}

/// Runs a motion.
///
/// # Errors
/// The controller did not accept it.
pub(crate) fn end(
    robot: &mut PackedRobot,
    motion: impl FnOnce(&mut PackedRobot) -> Result<End, Error>,
    spec: &Spec,
    under_way: &UnderWay,
) -> Result<End, Failure> {
    under_way.set(Stage::Moving(robot.stop_handle()));
    let ended = motion(robot);
    under_way.set(Stage::Answered);
    ended.map_err(|error| Failure::explained(spec, error))
}

/// Prints the end of a motion, as text or JSON; JSON for any end.
///
/// # Errors
/// The motion did not end at its target.
pub(crate) fn print(command: &str, end: End, form: Form) -> Result<(), Failure> {
    match form {
        Form::Json => output::json_line(&Ended { command, end: &end })?,
        Form::Text if end.cause() == Cause::Reached => {
            output::line(&format!("{end}, after {:.1} s", end.report.waited.as_secs_f64()))?;
        }
        Form::Text => {}
    }
    Ok(end.reached()?)
}
