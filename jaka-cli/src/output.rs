//! Results on standard output.

use std::io::{Write, stdout};

use crate::failure::Failure;

/// What stands for a value that a packet does not have, where people read it.
pub(crate) const ABSENT: &str = "–";

/// Writes bytes at once, so that a reader at the other end of a pipe sees each result when it is there.
pub(crate) fn write(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = stdout().lock();
    out.write_all(bytes).and_then(|()| out.flush()).map_err(Failure::output)
}

/// Writes a line.
pub(crate) fn line(text: &str) -> Result<(), Failure> {
    write(format!("{text}\n").as_bytes())
}
