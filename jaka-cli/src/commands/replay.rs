//! `jaka replay`: a recording in place of a robot, or as text.

mod filter;
mod show;

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use clap::{Args, ValueEnum};
use jaka_sim::{Controller, Replay as Mode, ReplayTiming};

use self::filter::FilterArgs;
use crate::failure::Failure;
use crate::interrupt::on_interrupt;
use crate::listen::ListenArgs;
use crate::number::count;
use crate::{output, recorded};

/// The interval at which Ctrl-C is checked.
const TICK: Duration = Duration::from_millis(100);

/// Serve a recording in place of a robot until it is interrupted, or show it.
///
/// Prints where clients deviate from the recording, and then ends with exit code 7.
#[derive(Debug, Args)]
pub(crate) struct Replay {
    /// The recording
    file: PathBuf,
    /// Which requests get which replies
    #[arg(long, value_enum, default_value_t)]
    mode: ModeName,
    /// When replies and status packets are sent
    #[arg(long, value_enum, default_value_t)]
    timing: TimingName,
    #[command(flatten)]
    listen: ListenArgs,
    /// Print the recording, with a summary, and serve nothing
    #[arg(long, conflicts_with_all = ["mode", "timing", "address", "commands", "status"])]
    show: bool,
    #[command(flatten)]
    filter: FilterArgs,
}

/// Which requests get which replies.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
enum ModeName {
    /// Message by message; a request that differs from the recorded one ends the connection
    #[default]
    Strict,
    /// Each request gets the recorded reply to an equal request, in any order
    Matching,
}

/// When replies and status packets are sent.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
enum TimingName {
    /// As long after the request as in the recording
    #[default]
    Recorded,
    /// Replies at once, and status packets at the usual period
    Immediate,
}

impl Replay {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let recording = recorded::read(&self.file)?;
        if self.show {
            return show::print(&recording, &self.filter.filter(&recording));
        }
        let ended = Arc::new(AtomicBool::new(false));
        let end = Arc::clone(&ended);
        on_interrupt(move || end.store(true, Ordering::Relaxed))?;
        let mode = match self.mode {
            ModeName::Strict => Mode::Strict,
            ModeName::Matching => Mode::Matching,
        };
        let timing = match self.timing {
            TimingName::Recorded => ReplayTiming::Recorded,
            TimingName::Immediate => ReplayTiming::Immediate,
        };
        let builder = Controller::builder().replay(recording, mode).replay_timing(timing);
        match report(&self.listen.start(builder, |_| {})?, &ended)? {
            0 => Ok(()),
            told => Err(Failure::Departs(count(told, "deviation") + " from the recording")),
        }
    }
}

/// Prints deviations as they come, and returns how many there were.
fn report(controller: &Controller, ended: &AtomicBool) -> Result<usize, Failure> {
    let mut told = 0;
    loop {
        // Checked once more at the end, for the last ones.
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
