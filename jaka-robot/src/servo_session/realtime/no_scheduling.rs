//! Where real-time priorities are not supported.

use std::io;

/// There is none.
#[derive(Debug)]
pub(super) enum Scheduling {}

impl Scheduling {
    pub(super) fn of_this_thread() -> io::Result<Self> {
        Err(io::Error::new(io::ErrorKind::Unsupported, "only supported on Linux"))
    }

    pub(super) fn set_realtime(_priority: u8) -> io::Result<()> {
        Self::of_this_thread().map(drop)
    }

    pub(super) fn set(&self) -> io::Result<()> {
        match *self {}
    }
}
