//! Ctrl-C, and the wish of the system that the program end.

use std::io;

use crate::failure::Failure;

/// Calls `call` on Ctrl-C, and on the signals by which a system ends programs, instead of ending at once.
pub(crate) fn on_interrupt(call: impl FnMut() + Send + 'static) -> Result<(), Failure> {
    ctrlc::set_handler(call).map_err(|error| Failure::local("cannot catch Ctrl-C", io::Error::other(error)))
}
