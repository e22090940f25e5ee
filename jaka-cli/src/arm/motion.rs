//! Motions with a wait: their stop by Ctrl-C, and their ends, for people and for programs.

use std::time::Duration;

use jaka_robot::{Cause, End, Error, Rest};
use jaka_spec::Spec;
use serde::Serialize;

use crate::arm::interrupt::{Stage, UnderWay};
use crate::arm::rest;
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

/// End of a motion, and the rest of the arm after Ctrl-C.
#[derive(Debug)]
pub(crate) struct Ended {
    pub(crate) end: End,
    /// Result of the wait for rest, if Ctrl-C has stopped the arm.
    rest: Option<Result<(), Failure>>,
}

impl Ended {
    /// Returns an error if the arm is not at its target, or still moves after Ctrl-C.
    pub(crate) fn reached(self) -> Result<(), Failure> {
        rest::required(self.end.reached().map_err(Failure::from), self.rest)
    }
}

/// End of a motion, for programs.
#[derive(Serialize)]
struct NamedEnd<'e> {
    command: &'e str,
    end: &'e End,
}

/// Runs a motion. After Ctrl-C, waits until the arm is at rest.
///
/// # Errors
/// The controller did not accept the motion.
pub(crate) fn end(
    robot: &mut PackedRobot,
    motion: impl FnOnce(&mut PackedRobot) -> Result<End, Error>,
    spec: &Spec,
    under_way: &UnderWay,
) -> Result<Ended, Failure> {
    under_way.set(Stage::Moving(robot.stop_handle()));
    let ended = motion(robot);
    at_rest(robot, ended, spec, under_way)
}

/// Waits until the arm is at rest, if Ctrl-C has stopped it.
///
/// # Errors
/// The motion could not be sent, or failed.
pub(crate) fn at_rest(
    robot: &mut PackedRobot,
    mut ended: Result<End, Error>,
    spec: &Spec,
    under_way: &UnderWay,
) -> Result<Ended, Failure> {
    if let Ok(end) = &mut ended
        && is_claimed(end)
        && !under_way.is_stopped()
    {
        end.rest = seen(robot.wait_for_rest(rest::SOON).is_ok());
    }
    let rest = rest::after_interrupt(under_way, spec, robot);
    let says_so = ended.as_ref().is_ok_and(says_rest);
    if !says_so {
        rest::say(rest.as_ref());
    }
    match (ended, rest) {
        (Ok(mut end), rest) => {
            end.rest = rest.as_ref().map_or(end.rest, |rest| seen(rest.is_ok()));
            Ok(Ended { end, rest })
        }
        (Err(error), rest) => rest::required(Err(Failure::explained(spec, error)), rest),
    }
}

/// True if the end of a trajectory says that the arm is at rest, by packets alone, which may be old.
fn is_claimed(end: &End) -> bool {
    says_rest(end) && end.rest == Rest::Packets
}

/// True if the text of an end says whether the arm is at rest.
fn says_rest(end: &End) -> bool {
    end.report.trajectory.is_some() && end.cause() != Cause::Reached
}

fn seen(is_at_rest: bool) -> Rest {
    if is_at_rest { Rest::Answers } else { Rest::NotSeen }
}

/// Prints the end of a motion, as text or JSON; JSON for any end.
///
/// # Errors
/// The motion did not end at its target, or the arm still moves after Ctrl-C.
pub(crate) fn print(command: &str, ended: Ended, form: Form) -> Result<(), Failure> {
    let end = &ended.end;
    match form {
        Form::Json => output::json_line(&NamedEnd { command, end })?,
        Form::Text if end.cause() == Cause::Reached => {
            output::line(&format!("{end}, after {:.1} s", end.report.waited.as_secs_f64()))?;
        }
        Form::Text => {}
    }
    ended.reached()
}
