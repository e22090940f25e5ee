//! `jaka jog`: move one joint, or the tool centre point along one axis, by an increment.

use std::str::FromStr;

use clap::Args;

use crate::arm::going::GoArgs;
use crate::arm::planned::MoveTarget;
use crate::failure::Failure;
use crate::text::number::place;

const EXAMPLES: &str = "\
Examples:
  jaka jog 6 5 --speed 5 -r cell1
  jaka jog z -10 --speed 20 -r cell1
  jaka jog 1 1 --speed 5 --model zu5 -r cell1
  jaka jog 1 1 --speed 5 --model zu5 -r cell1 --dry-run";

/// Move one joint, or the tool centre point along one axis, by an increment, and wait; Ctrl-C stops it
///
/// This is a motion with an end (`joint_move` or `moveL` with an offset): it can be stopped, and its end is known. Only
/// `jaka call jog` starts a jog that continues until it is stopped.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Jog {
    /// Joint, 1 to 6, or axis of the selected user frame: x, y or z
    axis: Axis,
    /// Increment, in deg or mm
    #[arg(allow_negative_numbers = true, value_parser = place)]
    distance: f64,
    #[command(flatten)]
    go: GoArgs,
}

/// Axis of a jog, by its index.
#[derive(Debug, Clone, Copy)]
enum Axis {
    Joint(usize),
    Line(usize),
}

impl Jog {
    pub(crate) fn run(self) -> Result<(), Failure> {
        self.go.go(match self.axis {
            Axis::Joint(at) => MoveTarget::Joint(at, self.distance),
            Axis::Line(at) => MoveTarget::Line(at, self.distance),
        })
    }
}

impl FromStr for Axis {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if let Some(at) = ["x", "y", "z"].iter().position(|axis| *axis == text) {
            return Ok(Self::Line(at));
        }
        match text.parse() {
            Ok(joint @ 1..=6) => Ok(Self::Joint(joint - 1)),
            _ => Err("there are joints 1 to 6, and the axes x, y and z"),
        }
    }
}
