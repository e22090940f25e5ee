//! `jaka report`: a recording as a page with pictures.

use clap::Args;

use crate::failure::Failure;
use crate::packs::SpecArgs;
use crate::recorded::{self, RecordedArgs};
use crate::report;
use crate::target::Lookup;

const EXAMPLES: &str = "\
Examples:
  jaka report session.jsonl -o report.html";

/// Make a page with pictures of a recording: an HTML file, for browsers and for print
///
/// Talks to no robot. The page has the joints, speeds, the path of the tool centre point from two sides, inputs and outputs, calls with the times of their replies, refusals and
/// events on one time axis, how regularly set-points were sent, and what went wrong, with the messages before it. It is one file without scripts, which refers to nothing
/// outside of itself.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Report {
    #[command(flatten)]
    recorded: RecordedArgs,
    #[command(flatten)]
    spec: SpecArgs,
}

impl Report {
    pub(crate) fn run(self) -> Result<(), Failure> {
        self.spec.load(Lookup::default())?.read_status();
        let recording = recorded::read(&self.recorded.file)?;
        let name = self.recorded.file.file_name().unwrap_or_default().to_string_lossy();
        let page = report::page(&name, &recording)?;
        let mut out = self.recorded.create()?;
        out.write(&page)?;
        out.finish()
    }
}
