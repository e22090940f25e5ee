//! The controller's time.

use std::time::{Duration, Instant};

/// Length of a controller cycle (4.15).
pub(crate) const CYCLE: Duration = Duration::from_millis(8);

/// How a controller's time goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Clock {
    /// With real time, since this moment.
    Real(Instant),
    /// Only by [`Controller::advance`](crate::Controller::advance).
    Stepped,
}

impl Clock {
    /// The controller's time, if it goes by itself.
    pub(crate) fn now(self) -> Option<Duration> {
        match self {
            Self::Real(start) => Some(start.elapsed()),
            Self::Stepped => None,
        }
    }
}
