//! Results on standard output, and warnings on standard error.
//!
//! What controllers, recordings and packs say may contain what a terminal obeys: see `jaka_sync::proto::text`. Code that puts such text
//! into a table or a sentence makes it visible there, so that a line end in it does not begin a line. What is written through here is made
//! visible once more; only [`write()`] passes on bytes as they are, for which its caller is responsible.

use std::borrow::Cow;
use std::io::{Write, stderr, stdout};

use jaka_sync::proto::text::{visible, visible_json, visible_lines};

use crate::failure::Failure;

/// What people read in place of a value that a packet does not have.
pub(crate) const ABSENT: &str = "–";

/// Writes bytes as they are and immediately, so that a reader at the other end of a pipe sees each result as soon as there is one.
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

/// Writes JSON, the same JSON in characters that can be seen.
pub(crate) fn json(text: &str) -> Result<(), Failure> {
    write(visible_json(text).as_bytes())
}

/// Writes a line to standard error.
pub(crate) fn tell(text: &str) {
    // The reader may be gone.
    writeln!(stderr(), "jaka: {}", visible_lines(text)).ok();
}

/// A text of others for a cell of a table, in quotes where it is empty or has what cannot be seen.
pub(crate) fn cell(text: &str) -> Cow<'_, str> {
    match visible(text) {
        Cow::Borrowed("") => "\"\"".into(),
        Cow::Borrowed(text) => text.into(),
        Cow::Owned(text) => format!("\"{}\"", text.replace('"', "\\\"")).into(),
    }
}
