//! Ctrl-C, and the wish of the system that the program end.

use std::io::{self, stdout};
use std::process;

use crate::failure::Failure;

/// Calls `call` on Ctrl-C, and on the signals by which a system ends programs, instead of ending at once.
pub(crate) fn on_interrupt(call: impl FnMut() + Send + 'static) -> Result<(), Failure> {
    ctrlc::set_handler(call).map_err(|error| Failure::local("cannot catch Ctrl-C", io::Error::other(error)))
}

/// Ends the program with success on Ctrl-C, but not in the middle of what it writes.
pub(crate) fn end_on_interrupt() -> Result<(), Failure> {
    on_interrupt(|| {
        let _whole = stdout().lock();
        process::exit(0);
    })
}
