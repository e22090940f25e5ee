//! `jaka check`: checks of a robot before its use.

use std::path::PathBuf;

use clap::Args;
use jaka_motion::{Limits, Model};
use jaka_robot::preflight::{Preflight, Verdict};
use serde::Serialize;

use crate::arm::limits;
use crate::failure::Failure;
use crate::packets::packed_status::PackedStatus;
use crate::target::packs::SpecArgs;
use crate::target::seat;
use crate::target::{RobotArgs, model};
use crate::terminal::{exit, output};

const EXAMPLES: &str = "\
Examples:
  jaka check -r 10.5.5.100
  jaka check -r cell1 --model zu5 --yes --json > check.json
  jaka check -r cell1 --limits limits.toml
  jaka check -r cell1 --pack newer.toml
  jaka check --sim --sim-powered

The exit code is 0 if nothing was found, 8 if there is something to look at, and 9 if something is wrong. \"Nothing found\" \
is not \"safe\".";

/// Check a robot before its use: ports, power, stops, payload, rates, model; changes nothing
///
/// Each item is `nothing found`, `look`, `wrong` or `not checked`, with the observation and a remedy. This command only
/// reads: it sends queries, and reads status packets for a second. The command port serves one client: another program
/// that is connected there may be disconnected, so this command asks first.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Check {
    /// Print one JSON object: `robot`, `verdict`, `findings`, `at_the_pendant` and `note`
    #[arg(long)]
    json: bool,
    /// Model of the arm, such as zu5 [default: the published one that agrees with the controller]
    #[arg(long, value_name = "NAME", value_parser = model)]
    model: Option<&'static Model>,
    /// TOML file with the limits of the arm and its model
    #[arg(long, value_name = "FILE", conflicts_with = "model")]
    limits: Option<PathBuf>,
    /// Connect to the command port without asking
    #[arg(long, short)]
    yes: bool,
    #[command(flatten)]
    spec: SpecArgs,
    #[command(flatten)]
    robot: RobotArgs,
}

/// The shape that the README describes.
#[derive(Serialize)]
struct Report<'r> {
    robot: &'r str,
    jaka: &'static str,
    #[serde(flatten)]
    preflight: &'r Preflight,
}

impl Check {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let limits = match &self.limits {
            Some(path) => Some(limits::read(path)?),
            None => self.model.map(Limits::of),
        };
        let protocol = self.spec.load(self.robot.lookup())?;
        protocol.read_status();
        let target = self.robot.target(&protocol.packs)?;
        if !self.yes && !self.robot.is_simulated() {
            seat::obtain(target.title(), "nothing was checked")?;
        }
        let preflight = target.preflight::<PackedStatus>(limits.as_ref());
        if self.json {
            let (robot, jaka) = (target.title(), env!("CARGO_PKG_VERSION"));
            output::json_lines(&Report { robot, jaka, preflight: &preflight })?;
        } else {
            output::lines(&format!("{preflight}\n"))?;
        }
        match preflight.verdict() {
            Verdict::NothingFound => Ok(()),
            Verdict::Wrong => Err(Failure::Printed(exit::WRONG)),
            _ => Err(Failure::Printed(exit::LOOK)),
        }
    }
}
