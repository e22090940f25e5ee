//! A real-time priority for the thread that sends set-points.

#[cfg(all(feature = "realtime", target_os = "linux"))]
mod scheduling;

use std::thread::{self, ThreadId};
use std::{fmt, io};

use super::ServoConfig;
use crate::{Error, ErrorKind};

/// Real-time priority of this thread, which has its own again when this is dropped.
pub(super) struct RealtimePriority {
    thread: ThreadId,
    restore: Restore,
}

/// Gives the thread that calls it the scheduling that it had before.
type Restore = Box<dyn Fn() -> io::Result<()> + Send + Sync>;

impl RealtimePriority {
    pub(super) fn take(priority: u8) -> Result<Self, Error> {
        if !(1..=99).contains(&priority) {
            return Err(ServoConfig::option("realtime_priority").refuse(priority, "1 to 99"));
        }
        #[cfg(all(feature = "realtime", target_os = "linux"))]
        let set = scheduling::set_realtime(priority);
        #[cfg(not(all(feature = "realtime", target_os = "linux")))]
        let set: io::Result<Restore> = Err(io::Error::new(io::ErrorKind::Unsupported, "only supported on Linux"));
        match set {
            Ok(restore) => Ok(Self { thread: thread::current().id(), restore }),
            Err(source) => Err(ErrorKind::RealtimePriority { priority, source }.into()),
        }
    }
}

impl fmt::Debug for RealtimePriority {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RealtimePriority").field("thread", &self.thread).finish_non_exhaustive()
    }
}

impl Drop for RealtimePriority {
    fn drop(&mut self) {
        if thread::current().id() != self.thread {
            log::warn!(target: "jaka_robot", "a servo session ended in another thread than it began; the first thread keeps its real-time priority");
        } else if let Err(error) = (self.restore)() {
            log::warn!(target: "jaka_robot", "the thread keeps the real-time priority of its servo session: {error}");
        }
    }
}
