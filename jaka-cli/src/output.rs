//! Results on standard output, and warnings on standard error.
//!
//! What controllers, recordings and packs say may hold what a terminal obeys: see `jaka_sync::proto::text`. Whoever puts such text
//! into a table or a sentence makes it visible there, so that a line end in it makes no line. What is written through here is made
//! visible once more; only [`write()`] passes on what its caller answers for.

use std::borrow::Cow;
use std::io::{Write, stderr, stdout};

use jaka_sync::proto::text::{visible, visible_json, visible_lines};

use crate::failure::Failure;

/// What stands for a value that a packet does not have, where people read it.
pub(crate) const ABSENT: &str = "–";

/// Writes bytes as they are and at once, so that a reader at the other end of a pipe sees each result when it is there.
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
    // Nobody may be reading.
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
