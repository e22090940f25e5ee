//! Messages of the wire, as a library logs them.

use std::sync::OnceLock;

use log::{LevelFilter, Log, Metadata, Record};

use crate::output;

/// Prints what the libraries log whose targets begin so.
#[derive(Debug)]
struct Printer {
    targets: &'static str,
}

static PRINTER: OnceLock<Printer> = OnceLock::new();

impl Log for Printer {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.target().starts_with(self.targets)
    }

    fn log(&self, record: &Record<'_>) {
        if self.enabled(record.metadata()) {
            // Nobody reads it any more: that is no reason to end.
            output::line(&record.args().to_string()).ok();
        }
    }

    fn flush(&self) {}
}

/// Prints each message from now on that goes to a target which begins so.
pub(crate) fn print_all(targets: &'static str) {
    // A second call changes nothing: the first logger stays.
    if log::set_logger(PRINTER.get_or_init(|| Printer { targets })).is_ok() {
        log::set_max_level(LevelFilter::Trace);
    }
}
