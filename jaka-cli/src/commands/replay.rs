//! `jaka replay`: a recording in place of a robot, or as text.

mod filter;
mod show;

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use clap::Args;
use jaka_sim::{Controller, Replay as Mode, ReplayTiming};

use self::filter::Filter;
use crate::arm::interrupt::on_interrupt;
use crate::choice::{Choice, one_of};
use crate::failure::Failure;
use crate::listen::ListenArgs;
use crate::recordings::recorded;
use crate::terminal::output;
use crate::text::number::count;

/// Interval of the checks for Ctrl-C.
const TICK: Duration = Duration::from_millis(100);

/// Serve a recording in place of a robot until it is interrupted, or show it.
///
/// Prints the deviations of clients from the recording; after any, the exit code is 7.
#[derive(Debug, Args)]
pub(crate) struct Replay {
    /// Recording
    file: PathBuf,
    /// Rule for the replies to requests
    #[arg(long, default_value = "strict", value_parser = one_of(&MODES))]
    mode: Mode,
    /// Send times of replies and status packets
    #[arg(long, default_value = "recorded", value_parser = one_of(&TIMINGS))]
    timing: ReplayTiming,
    #[command(flatten)]
    listen: ListenArgs,
    /// Print the recording with a summary, without serving it
    #[arg(long, conflicts_with_all = ["mode", "timing", "address", "commands", "status"])]
    show: bool,
    /// Show only the requests of this command, and their replies
    #[arg(long, value_name = "NAME", requires = "show")]
    command: Option<String>,
}

const MODES: [Choice<Mode>; 2] = [
    ("strict", "Message by message; a request that differs from the recorded one ends the connection", Mode::Strict),
    ("matching", "Each request gets the recorded reply to an equal request, in any order", Mode::Matching),
];
const TIMINGS: [Choice<ReplayTiming>; 2] = [
    ("recorded", "As long after the request as in the recording", ReplayTiming::Recorded),
    ("immediate", "Replies at once, and status packets at the usual period", ReplayTiming::Immediate),
];

impl Replay {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let recording = recorded::read(&self.file)?;
        if self.show {
            let filter = self.command.as_ref().map(|name| Filter::new(name, &recording));
            return show::print(&recording, filter.as_ref());
        }
        let ended = Arc::new(AtomicBool::new(false));
        let end = Arc::clone(&ended);
        on_interrupt(move || end.store(true, Ordering::Relaxed));
        let builder = Controller::builder().replay(recording, self.mode).replay_timing(self.timing);
        match report(&self.listen.start(builder, |_| {})?, &ended)? {
            0 => Ok(()),
            told => Err(Failure::Departs(count(told, "deviation") + " from the recording")),
        }
    }
}

/// Prints deviations as they come, and returns their number.
fn report(controller: &Controller, ended: &AtomicBool) -> Result<usize, Failure> {
    let mut told = 0;
    loop {
        // Checks once more at the end, for the last ones.
        let is_last = ended.load(Ordering::Relaxed);
        if !is_last {
            controller.wait_for_deviations(told + 1, TICK);
        }
        for deviation in controller.deviations().iter().skip(told) {
            output::line(&format!("deviation: {deviation}"))?;
            told += 1;
        }
        if is_last {
            return Ok(told);
        }
    }
}
