//! Results on standard output, and warnings on standard error.
//!
//! Text of controllers, recordings and packs may contain control characters for a terminal: see
//! `jaka_sync::proto::text`. Code that puts such text into a table or a sentence makes them visible, so that a line end
//! in the text does not start a line. The functions of this module make all text visible once more; only [`write()`]
//! passes on unchanged bytes, for which its caller is responsible.

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
#[cfg(test)]
use crate::tests::{stderr, stdout};

/// Text for people in place of a missing value of a packet.
pub(crate) const ABSENT: &str = "–";

/// Writes unchanged bytes immediately, so that a reader of a pipe sees each result at once.
pub(crate) fn write(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = stdout().lock();
    out.write_all(bytes).and_then(|()| out.flush()).map_err(Failure::output)
}

/// Writes a line.
pub(crate) fn line(text: &str) -> Result<(), Failure> {
    write(format!("{}\n", visible(text)).as_bytes())
}

/// Writes text of several lines.
pub(crate) fn lines(text: &str) -> Result<(), Failure> {
    write(visible_lines(text).as_bytes())
}

/// Writes JSON, with invisible characters escaped.
pub(crate) fn json(text: &str) -> Result<(), Failure> {
    write(visible_json(text).as_bytes())
}

/// Writes a value as JSON on one line.
pub(crate) fn json_line(value: &impl Serialize) -> Result<(), Failure> {
    json(&(as_json(serde_json::to_string(value))? + "\n"))
}

/// Writes a value as indented JSON.
pub(crate) fn json_lines(value: &impl Serialize) -> Result<(), Failure> {
    json(&(as_json(serde_json::to_string_pretty(value))? + "\n"))
}

/// Returns the JSON of a value, or the failure of the command.
pub(crate) fn as_json<T>(made: serde_json::Result<T>) -> Result<T, Failure> {
    made.map_err(|error| Failure::output(error.into()))
}

/// True if notes and warnings are omitted.
static IS_QUIET: AtomicBool = AtomicBool::new(false);

/// Omits notes and warnings from now on.
pub(crate) fn be_quiet() {
    // Tests run several commands in one process.
    IS_QUIET.store(!cfg!(test), Ordering::Relaxed);
}

/// Whether notes and warnings are omitted.
pub(crate) fn is_quiet() -> bool {
    IS_QUIET.load(Ordering::Relaxed)
}

/// Writes the cause of a failure to standard error.
pub(crate) fn error(text: &str) {
    tell(AnsiColor::Red.on_default().bold(), "error", text);
}

/// Writes a warning to standard error, unless `--quiet` omits it.
pub(crate) fn warning(text: &str) {
    if !is_quiet() {
        urgent_warning(text);
    }
}

/// Writes an essential warning to standard error: it is about an arm that may move.
pub(crate) fn urgent_warning(text: &str) {
    tell(AnsiColor::Yellow.on_default().bold(), "warning", text);
}

/// Writes a note to standard error, unless `--quiet` omits it.
pub(crate) fn note(text: &str) {
    if !is_quiet() {
        urgent_note(text);
    }
}

/// Writes an essential note to standard error: it is about an arm that may move.
pub(crate) fn urgent_note(text: &str) {
    tell(Style::new().bold(), "note", text);
}

/// Writes to standard error, with colours if enabled. The reader may be gone.
fn tell(style: Style, kind: &str, text: &str) {
    let text = format!("{style}{kind}:{style:#} {}\n", visible_lines(text));
    stderr().lock().write_all(text.as_bytes()).ok();
}

/// Returns rows of two aligned columns.
pub(crate) fn aligned(rows: &[(impl AsRef<str>, impl AsRef<str>)]) -> String {
    let width = rows.iter().map(|(name, _)| name.as_ref().chars().count()).max().unwrap_or_default();
    rows.iter().map(|(name, text)| format!("{:width$}  {}\n", name.as_ref(), text.as_ref())).join("")
}

/// Returns foreign text for a table cell, in quotes if it is empty or has invisible characters.
pub(crate) fn cell(text: &str) -> Cow<'_, str> {
    match visible(text) {
        Cow::Borrowed("") => "\"\"".into(),
        Cow::Borrowed(text) => text.into(),
        Cow::Owned(text) => format!("\"{}\"", text.replace('"', "\\\"")).into(),
    }
}
