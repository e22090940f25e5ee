//! When the client has dropped a late reply, as its log tells: nothing else does.

use std::sync::{Condvar, Mutex, MutexGuard, Once, PoisonError};
use std::time::Duration;

use log::{LevelFilter, Log, Metadata, Record};

static DROPPED: Mutex<u32> = Mutex::new(0);
static CHANGED: Condvar = Condvar::new();

fn dropped() -> MutexGuard<'static, u32> {
    DROPPED.lock().unwrap_or_else(PoisonError::into_inner)
}

struct Logger;

impl Log for Logger {
    fn enabled(&self, _: &Metadata<'_>) -> bool {
        true
    }

    fn log(&self, record: &Record<'_>) {
        if record.target() == "jaka_sync::wire" && record.args().to_string().starts_with("late reply") {
            *dropped() += 1;
            CHANGED.notify_all();
        }
    }

    fn flush(&self) {}
}

/// The late replies that have been dropped since some moment.
#[derive(Debug)]
pub(crate) struct Drops {
    before: u32,
}

impl Drops {
    pub(crate) fn from_now() -> Self {
        static ONCE: Once = Once::new();
        ONCE.call_once(|| {
            log::set_logger(&Logger).expect("this is the only logger");
            log::set_max_level(LevelFilter::Debug);
        });
        Self { before: *dropped() }
    }

    /// Waits until there are this many; false if there are fewer after some time.
    pub(crate) fn wait_for(&self, count: u32, patience: Duration) -> bool {
        let waits = |dropped: &mut u32| *dropped - self.before < count;
        let waited = CHANGED.wait_timeout_while(dropped(), patience, waits);
        !waited.unwrap_or_else(PoisonError::into_inner).1.timed_out()
    }
}
