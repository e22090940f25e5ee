//! `jaka probe`: departures of a controller from the spec.

mod draft;
mod finding;
mod progress;
mod queries;
mod report;
mod status;

use std::fs::File;
use std::io::{ErrorKind, Write};
use std::num::NonZeroU32;
use std::path::{Path, PathBuf};

use clap::Args;
use jaka_spec::Spec;

use self::finding::Findings;
use self::progress::ProbeProgress;
use crate::failure::Failure;
use crate::target::RobotArgs;
use crate::target::packs::SpecArgs;
use crate::target::seat;
use crate::terminal::output;

/// Send a controller every query of the protocol, and report the departures of its answers from the spec.
///
/// This command only reads: it sends the queries that need no argument, and reads a status packet. The command port
/// serves one client: another program that is connected there may be disconnected, so this command asks first. The
/// report can be pasted into a bug report. On Ctrl-C it has the findings so far.
#[derive(Debug, Args)]
pub(crate) struct Probe {
    /// Read this many status packets
    #[arg(long, value_name = "N", default_value = "1")]
    packets: NonZeroU32,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
    /// Write a draft of a command pack with the unknown keys, and with types for unreadable values
    ///
    /// Each key is optional, with a type guessed from its values, and without documentation. A field that cannot be
    /// read gets the apparent type of its value. A key that seems to be the new name of a missing one is proposed as
    /// such. An existing file is not overwritten.
    #[arg(long, value_name = "FILE")]
    draft: Option<PathBuf>,
    /// Connect to the command port without asking
    #[arg(long, short)]
    yes: bool,
    #[command(flatten)]
    spec: SpecArgs,
    #[command(flatten)]
    robot: RobotArgs,
}

impl Probe {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let protocol = self.spec.load(self.robot.lookup())?;
        let target = self.robot.target(&protocol.packs)?;
        if !self.yes && !self.robot.is_simulated() {
            seat::obtain(target.title(), "nothing was probed")?;
        }
        let progress = ProbeProgress::begin();
        let commands = queries::ask_all(&protocol.spec, &target, &progress)?;
        let status = status::take(&protocol.spec, &target, self.packets.get(), &progress);
        let findings = Findings::new(commands, status, &protocol.packs);
        let text = if self.json { report::json(&findings) } else { report::text(&findings) };
        if self.json { output::json(&text) } else { output::lines(&text) }?;
        if let Some(path) = &self.draft {
            write_draft(path, &protocol.spec, &findings)?;
        }
        if progress.is_interrupted() {
            return Err(Failure::Interrupted);
        }
        match findings.departing() {
            0 => Ok(()),
            count => Err(Failure::Departs(format!("{count} of {} depart from the spec", findings.asked()))),
        }
    }
}

fn write_draft(path: &Path, spec: &Spec, findings: &Findings) -> Result<(), Failure> {
    let Some(draft) = draft::text(spec, findings) else {
        output::note(
            "no draft is written: no message has a key that is not in the spec, or a value that cannot be read",
        );
        return Ok(());
    };
    let failed = |error| Failure::unwritten(path, error);
    let mut file = File::create_new(path).map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => {
            Failure::Usage(format!("{} exists already, and packs are not overwritten", path.display()))
        }
        _ => failed(error),
    })?;
    file.write_all(draft.as_bytes()).map_err(failed)
}
