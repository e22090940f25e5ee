//! Ctrl-C, and the signals by which a system ends programs.

use std::io::{self, stdout};
use std::time::Duration;
use std::{process, thread};

use crate::failure::Failure;
use crate::{exit, record};

/// How long the program may take to end by itself.
const PATIENCE: Duration = Duration::from_secs(1);

/// Calls `call` on Ctrl-C, and on the signals by which a system ends programs. It should make the program end soon; otherwise
/// the program is ended with success.
pub(crate) fn on_interrupt(mut call: impl FnMut() + Send + 'static) -> Result<(), Failure> {
    let handler = move || {
        call();
        thread::sleep(PATIENCE);
        end();
    };
    ctrlc::set_handler(handler).map_err(|error| Failure::local("cannot catch Ctrl-C", io::Error::other(error)))
}

/// Ends the program with success on Ctrl-C, but not in the middle of what it writes.
pub(crate) fn end_on_interrupt() -> Result<(), Failure> {
    on_interrupt(|| {
        // Not here, since the reader of the output may never continue.
        thread::spawn(|| {
            let _whole = stdout().lock();
            end();
        });
    })
}

/// Ends the program with success, unless what it recorded cannot be written.
fn end() -> ! {
    if let Err(failure) = record::finish() {
        exit::report(&failure);
        process::exit(exit::LOCAL.into());
    }
    process::exit(0)
}
