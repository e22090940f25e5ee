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

/// Prints what is logged, as far as it is asked for.
#[derive(Debug)]
struct Logger;

/// The beginning of the targets that are printed on standard output.
static PRINTED: OnceLock<&str> = OnceLock::new();
/// Number of `-v` options.
static VERBOSE: AtomicU8 = AtomicU8::new(0);
/// Time at which the program began.
static BEGIN: OnceLock<Instant> = OnceLock::new();

/// Begins to print warnings, which are about arms that may move.
pub(crate) fn begin() {
    BEGIN.get_or_init(Instant::now);
    // There is no other logger.
    if log::set_logger(&Logger).is_ok() {
        log::set_max_level(LevelFilter::Warn);
    }
}

/// From now on prints each message of a target that begins with this prefix, on standard output.
pub(crate) fn print(targets: &'static str) {
    PRINTED.get_or_init(|| targets);
    log::set_max_level(LevelFilter::Trace);
}

/// From now on tells connections, requests and replies on standard error, and more if `-v` is given more often; not
/// where that is to be quiet.
pub(crate) fn tell(verbose: u8) {
    if output::is_quiet() {
        return;
    }
    if VERBOSE.fetch_max(verbose, Ordering::Relaxed) == 0 {
        backlog::begin();
        log::set_max_level(LevelFilter::Trace);
    }
}

/// True if `-v` is given.
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
            // The reader is gone, which is not a reason to end.
            let _: Result<(), Failure> = output::line(&text.to_string());
        }
    }

    fn flush(&self) {}
}
