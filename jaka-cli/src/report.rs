//! A recording as a page with pictures: `session` reads it, `pictures` draws, `page` writes HTML.

mod page;
mod pictures;
mod session;

use jaka_sync::recording::Recording;

use self::page::Page;
use self::session::Session;
use crate::failure::Failure;
use crate::number::count;

/// The page of a recording of this name: HTML without scripts, which refers to nothing outside of itself.
pub(crate) fn page(name: &str, recording: &Recording) -> Result<String, Failure> {
    let session = Session::read(recording);
    let mut page = Page::new(name);
    page.section("summary", "Summary", &page::facts(&session));
    page.section("problems", "What went wrong", &page::problems(&session));
    for (id, title, html) in pictures::sections(&session)? {
        page.section(id, title, &html);
    }
    page.section("commands", "Commands", &page::commands(&session));
    page.section("list", "List of events", &page::events(&session));
    Ok(page.end())
}

/// So many, and how many more there are than are shown.
fn more(all: usize, shown: usize, noun: &str) -> Option<String> {
    (all > shown).then(|| format!("{} of {} are shown.", shown, count(all, noun)))
}
