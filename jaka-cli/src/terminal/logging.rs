//! Log messages of libraries: for `-v`, and for `jaka sim --log`.

mod backlog;

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU8, Ordering};
use std::time::Instant;

use jaka_sync::proto::text::visible;
use log::{Level, LevelFilter, Log, Metadata, Record};

use crate::failure::Failure;
use crate::terminal::output;

pub(crate) use self::backlog::finish;

/// Logger that prints the requested messages.
#[derive(Debug)]
struct Logger;

/// Prefix of the targets with messages on standard output.
static PRINTED: OnceLock<&str> = OnceLock::new();
/// Number of `-v` options.
static VERBOSE: AtomicU8 = AtomicU8::new(0);
/// Start time of the program.
static BEGIN: OnceLock<Instant> = OnceLock::new();

/// Starts printing warnings, which are about arms that may move.
pub(crate) fn begin() {
    BEGIN.get_or_init(Instant::now);
    // The program sets no other logger.
    if log::set_logger(&Logger).is_ok() {
        log::set_max_level(LevelFilter::Warn);
    }
}

/// Prints all later messages of targets with this prefix on standard output.
pub(crate) fn print(targets: &'static str) {
    PRINTED.get_or_init(|| targets);
    log::set_max_level(LevelFilter::Trace);
}

/// Prints connections, requests and replies on standard error from now on, and more if `-v` is repeated. Has no effect
/// with `--quiet`.
pub(crate) fn tell(verbose: u8) {
    if output::is_quiet() {
        return;
    }
    if VERBOSE.fetch_max(verbose, Ordering::Relaxed) == 0 {
        backlog::begin();
        log::set_max_level(LevelFilter::Trace);
    }
}

/// Whether `-v` is given.
pub(crate) fn is_told() -> bool {
    VERBOSE.load(Ordering::Relaxed) > 0
}

impl Logger {
    fn prints(metadata: &Metadata<'_>) -> bool {
        PRINTED.get().is_some_and(|targets| metadata.target().starts_with(targets))
    }

    fn tells(metadata: &Metadata<'_>) -> bool {
        let targets: &[&str] = match VERBOSE.load(Ordering::Relaxed) {
            0 => &[],
            1 => &["jaka_sync", "jaka_robot"],
            _ => &["jaka"],
        };
        targets.iter().any(|target| metadata.target().starts_with(target))
    }
}

impl Log for Logger {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        metadata.level() <= Level::Warn || Self::prints(metadata) || Self::tells(metadata)
    }

    fn log(&self, record: &Record<'_>) {
        let (metadata, text) = (record.metadata(), record.args());
        if metadata.level() <= Level::Warn && metadata.target().starts_with("jaka") {
            output::urgent_warning(&text.to_string());
        } else if Self::tells(metadata) {
            let seconds = BEGIN.get_or_init(Instant::now).elapsed().as_secs_f64();
            backlog::add(format!("[{seconds:8.3} s] {}\n", visible(&text.to_string())));
        }
        if Self::prints(metadata) {
            // The program continues without a reader.
            let _: Result<(), Failure> = output::line(&text.to_string());
        }
    }

    fn flush(&self) {}
}
