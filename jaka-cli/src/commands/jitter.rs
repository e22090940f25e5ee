//! `jaka jitter`: lateness of this machine's cycles of set-points, reply times, and advice on changes.

mod advice;
mod measured;
mod report;

use std::io::{IsTerminal, stderr};
use std::time::Duration;

use clap::Args;

use self::measured::{Lateness, Measured, RoundTrip};
use crate::failure::Failure;
use crate::target::AddressArgs;
use crate::target::seat;
use crate::terminal::output;
use crate::text::seconds;

const EXAMPLES: &str = "\
Examples:
  jaka jitter
  jaka jitter --seconds 600 -r 10.5.5.100
  jaka jitter --sim --json > jitter.json

Measure while the machine does what it will do while the arm moves: on an idle one most figures are good.";

/// Measure the lateness of this machine's set-point cycles, and the reply times of a robot; moves nothing
///
/// The program waits for cycles of 8 ms as a servo session does: asleep, and spinning for the last 200 µs, each with
/// the usual priority of the thread and with a real-time one, in turns. Advice on changes follows from the figures.
/// With --robot or --sim, it sends queries first, one every 8 ms; it does not contact a robot that only the environment
/// or the config file names. The command port serves one client: another program that is connected there may be
/// disconnected, so this command asks first.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Jitter {
    /// Duration of the whole measurement [default: 60]
    #[arg(long, value_name = "SECONDS", default_value = "60", hide_default_value = true, value_parser = seconds::some_seconds)]
    seconds: Duration,
    /// Print one JSON object: `jaka`, `period_us`, `lateness`, `round_trip` and `advice`
    #[arg(long)]
    json: bool,
    /// Connect to the command port without asking
    #[arg(long, short)]
    yes: bool,
    #[command(flatten)]
    robot: AddressArgs,
}

impl Jitter {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let round_trip = if self.robot.is_given() { Some(self.round_trip(self.seconds / 5)?) } else { None };
        if stderr().is_terminal() {
            output::note(&format!("this takes {:?}; it moves nothing", self.seconds));
        }
        let left = if round_trip.is_some() { self.seconds * 4 / 5 } else { self.seconds };
        let measured = Measured { lateness: Lateness::measure(left)?, round_trip };
        if self.json {
            output::json(&format!("{:#}\n", report::json(&measured)))
        } else {
            output::lines(&report::text(&measured))
        }
    }

    fn round_trip(&self, time: Duration) -> Result<RoundTrip, Failure> {
        let target = self.robot.target(&[])?;
        if !self.yes && !self.robot.is_simulated() {
            seat::obtain(target.title(), "nothing was measured")?;
        }
        RoundTrip::measure(&target, time)
    }
}
