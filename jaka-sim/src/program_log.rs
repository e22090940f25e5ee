//! Prints what the controller logs.

use jaka_proto::text::visible;
use log::{LevelFilter, Log, Metadata, Record};

struct Printer;

impl Log for Printer {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.target().starts_with("jaka_sim")
    }

    fn log(&self, record: &Record<'_>) {
        if self.enabled(record.metadata()) {
            // A request may have anything in it that a terminal obeys.
            println!("{}", visible(&record.args().to_string()));
        }
    }

    fn flush(&self) {}
}

/// Prints each message from now on.
pub(crate) fn print_all() {
    // A second call changes nothing: the first logger stays.
    if log::set_logger(&Printer).is_ok() {
        log::set_max_level(LevelFilter::Trace);
    }
}
