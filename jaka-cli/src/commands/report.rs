//! `jaka report`: a recording as a page with pictures. `session` reads it, `pictures` draws, `page` writes HTML.

mod page;
mod pictures;
mod session;

use clap::Args;
use jaka_sync::recording::Recording;

use self::page::HtmlPage;
use self::session::Session;
use crate::failure::Failure;
use crate::recordings::recorded;
use crate::recordings::recorded::RecordedArgs;
use crate::target::Lookup;
use crate::target::packs::SpecArgs;
use crate::text::number::count;

const EXAMPLES: &str = "\
Examples:
  jaka report session.jsonl -o report.html";

/// Write a page with pictures of a recording: an HTML file, for browsers and for print
///
/// Does not connect to a robot. On one time axis, the page has the joints, speeds, inputs and outputs, calls with their
/// reply times, refusals and events. It also has the path of the tool centre point from two sides, the regularity of
/// set-points, and problems with the messages before them. It is one file without scripts or external references.
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
        let page = page_of(&name, &recording)?;
        let mut out = self.recorded.create()?;
        out.write(&page)?;
        out.finish()
    }
}

/// Returns the page of a recording of this name: HTML without scripts or external references.
fn page_of(name: &str, recording: &Recording) -> Result<String, Failure> {
    let session = Session::read(recording);
    let mut page = HtmlPage::new(name);
    page.section("summary", "Summary", &page::facts(&session));
    page.section("problems", "Problems", &page::problems(&session));
    for (id, title, html) in pictures::sections(&session)? {
        page.section(id, title, &html);
    }
    page.section("commands", "Commands", &page::commands(&session));
    page.section("list", "List of events", &page::events(&session));
    Ok(page.end())
}

/// Returns the number of shown items and of all, if some are not shown.
fn more(all: usize, shown: usize, noun: &str) -> Option<String> {
    (all > shown).then(|| format!("{} of {} are shown.", shown, count(all, noun)))
}
