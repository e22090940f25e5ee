//! Results on standard output, and warnings on standard error.
//!
//! Text of controllers, recordings and packs may contain characters that a terminal obeys: see
//! `jaka_sync::proto::text`. Code that puts such text into a table or a sentence makes it visible there, so that a line
//! end in it does not begin a line. Text that is written through here is made visible once more; only [`write()`]
//! passes on bytes as they are, for which its caller is responsible.

use std::borrow::Cow;
use std::io::Write;
#[cfg(not(test))]
use std::io::stdout;
use std::sync::atomic::{AtomicBool, Ordering};

#[cfg(not(test))]
use anstream::stderr;
use clap::builder::styling::{AnsiColor, Style};
use itertools::Itertools as _;
use jaka_sync::proto::text::{visible, visible_json, visible_lines};
use serde::Serialize;

use crate::failure::Failure;
use crate::terminal::raw::with_returns;
#[cfg(test)]
use crate::tests::{stderr, stdout};

/// Text for people in place of a value that a packet does not have.
pub(crate) const ABSENT: &str = "–";

/// Writes bytes as they are and immediately, so that a reader at the other end of a pipe sees each result as soon as
/// there is one.
pub(crate) fn write(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = stdout().lock();
    out.write_all(&with_returns(bytes)).and_then(|()| out.flush()).map_err(Failure::output)
}

/// Writes a line.
pub(crate) fn line(text: &str) -> Result<(), Failure> {
    write(format!("{}\n", visible(text)).as_bytes())
}

/// Writes text of several lines.
pub(crate) fn lines(text: &str) -> Result<(), Failure> {
    write(visible_lines(text).as_bytes())
}

/// Writes JSON, the same JSON in characters that can be seen.
pub(crate) fn json(text: &str) -> Result<(), Failure> {
    write(visible_json(text).as_bytes())
}

/// Writes a value as JSON on one line.
pub(crate) fn json_line(value: &impl Serialize) -> Result<(), Failure> {
    json(&(as_json(serde_json::to_string(value))? + "\n"))
}

/// Writes a value as JSON that people can read, too.
pub(crate) fn json_lines(value: &impl Serialize) -> Result<(), Failure> {
    json(&(as_json(serde_json::to_string_pretty(value))? + "\n"))
}

/// JSON that was made of a value.
pub(crate) fn as_json<T>(made: serde_json::Result<T>) -> Result<T, Failure> {
    made.map_err(|error| Failure::output(error.into()))
}

/// True if notes and warnings are left out.
static IS_QUIET: AtomicBool = AtomicBool::new(false);

/// From now on, notes and warnings are left out.
pub(crate) fn be_quiet() {
    // Tests run several commands in one process.
    IS_QUIET.store(!cfg!(test), Ordering::Relaxed);
}

/// True if notes and warnings are left out.
pub(crate) fn is_quiet() -> bool {
    IS_QUIET.load(Ordering::Relaxed)
}

/// Writes to standard error why something failed.
pub(crate) fn error(text: &str) {
    tell(AnsiColor::Red.on_default().bold(), "error", text);
}

/// Writes a warning to standard error, unless that is to be quiet.
pub(crate) fn warning(text: &str) {
    if !is_quiet() {
        urgent_warning(text);
    }
}

/// Writes a warning to standard error that must be seen: it is about an arm that may move.
pub(crate) fn urgent_warning(text: &str) {
    tell(AnsiColor::Yellow.on_default().bold(), "warning", text);
}

/// Writes a note to standard error, unless that is to be quiet.
pub(crate) fn note(text: &str) {
    if !is_quiet() {
        urgent_note(text);
    }
}

/// Writes a note to standard error that must be seen: it is about an arm that may move.
pub(crate) fn urgent_note(text: &str) {
    tell(Style::new().bold(), "note", text);
}

/// Writes to standard error, with colours where they are used. The reader may be gone.
fn tell(style: Style, kind: &str, text: &str) {
    let text = format!("{style}{kind}:{style:#} {}\n", visible_lines(text));
    stderr().lock().write_all(&with_returns(text.as_bytes())).ok();
}

/// Rows of two columns, the second of which begins at the same place in all of them.
pub(crate) fn aligned(rows: &[(impl AsRef<str>, impl AsRef<str>)]) -> String {
    let width = rows.iter().map(|(name, _)| name.as_ref().chars().count()).max().unwrap_or_default();
    rows.iter().map(|(name, text)| format!("{:width$}  {}\n", name.as_ref(), text.as_ref())).join("")
}

/// A text of others for a cell of a table, in quotes where it is empty or has what cannot be seen.
pub(crate) fn cell(text: &str) -> Cow<'_, str> {
    match visible(text) {
        Cow::Borrowed("") => "\"\"".into(),
        Cow::Borrowed(text) => text.into(),
        Cow::Owned(text) => format!("\"{}\"", text.replace('"', "\\\"")).into(),
    }
}
