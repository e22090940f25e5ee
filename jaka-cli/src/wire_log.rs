//! Messages of the wire, as a library logs them.

use std::sync::OnceLock;

use log::{LevelFilter, Log, Metadata, Record};

use crate::output;

/// Prints what is logged under targets that begin with a prefix.
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
            // The reader is gone, which is not a reason to end.
            output::line(&record.args().to_string()).ok();
        }
    }

    fn flush(&self) {}
}

/// From now on prints each message of a target that begins with this prefix.
pub(crate) fn print_all(targets: &'static str) {
    // A second call changes nothing: the first logger stays.
    if log::set_logger(PRINTER.get_or_init(|| Printer { targets })).is_ok() {
        log::set_max_level(LevelFilter::Trace);
    }
}
