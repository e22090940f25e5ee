//! A real-time priority for the thread that sends set-points.

#[cfg(target_os = "linux")]
mod scheduling;
#[cfg(not(target_os = "linux"))]
#[path = "realtime/no_scheduling.rs"]
mod scheduling;

use std::thread::{self, ThreadId};

use self::scheduling::Scheduling;
use super::ServoConfig;
use crate::{Error, ErrorKind};

/// The real-time priority of this thread, which has its own again when this is dropped.
#[derive(Debug)]
pub(super) struct RealtimePriority {
    thread: ThreadId,
    own: Scheduling,
}

impl ServoConfig {
    /// The real-time priority for this thread, where one is asked for.
    pub(super) fn take_priority(&self) -> Result<Option<RealtimePriority>, Error> {
        self.realtime_priority.map(RealtimePriority::take).transpose()
    }
}

impl RealtimePriority {
    fn take(priority: u8) -> Result<Self, Error> {
        if !(1..=99).contains(&priority) {
            return Err(ServoConfig::option("realtime_priority").refuse(priority, "1 to 99"));
        }
        let taken = Scheduling::of_this_thread().and_then(|own| Scheduling::set_realtime(priority).map(|()| own));
        match taken {
            Ok(own) => Ok(Self { thread: thread::current().id(), own }),
            Err(source) => Err(ErrorKind::RealtimePriority { priority, source }.into()),
        }
    }
}

impl Drop for RealtimePriority {
    fn drop(&mut self) {
        if thread::current().id() != self.thread {
            log::warn!(target: "jaka_robot", "a servo session has ended in another thread than the one that entered it, which keeps its real-time priority");
        } else if let Err(error) = self.own.set() {
            log::warn!(target: "jaka_robot", "the thread keeps the real-time priority of its servo session: {error}");
        }
    }
}
