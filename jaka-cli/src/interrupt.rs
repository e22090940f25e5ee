//! Ctrl-C, and the wish of the system that the program end.

use std::io::{self, stdout};
use std::time::Duration;
use std::{process, thread};

use crate::failure::Failure;

/// How long what is being written may take to be whole.
const PATIENCE: Duration = Duration::from_secs(1);

/// Calls `call` on Ctrl-C, and on the signals by which a system ends programs, instead of ending at once.
pub(crate) fn on_interrupt(call: impl FnMut() + Send + 'static) -> Result<(), Failure> {
    ctrlc::set_handler(call).map_err(|error| Failure::local("cannot catch Ctrl-C", io::Error::other(error)))
}

/// Ends the program with success on Ctrl-C, but not in the middle of what it writes.
pub(crate) fn end_on_interrupt() -> Result<(), Failure> {
    on_interrupt(|| {
        thread::spawn(|| {
            let _whole = stdout().lock();
            process::exit(0);
        });
        // Who reads the output may never read on.
        thread::sleep(PATIENCE);
        process::exit(0);
    })
}
