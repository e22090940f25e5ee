//! The controller's time.

use std::time::{Duration, Instant};

/// Length of a controller cycle (4.15).
pub(crate) const CYCLE: Duration = Duration::from_millis(8);

/// How a controller's time goes on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Clock {
    /// With real time, since this moment, so many times as fast.
    Real(Instant, f64),
    /// Only by [`Controller::advance`](crate::Controller::advance).
    Stepped,
}

impl Clock {
    /// The controller's time, if it goes by itself.
    pub(crate) fn now(self) -> Option<Duration> {
        match self {
            Self::Real(start, scale) => Some(scaled(start.elapsed(), scale)),
            Self::Stepped => None,
        }
    }
}

/// A time that is so many times as long, [`Duration::MAX`] where it is longer.
pub(crate) fn scaled(time: Duration, factor: f64) -> Duration {
    Duration::try_from_secs_f64(time.as_secs_f64() * factor).unwrap_or(Duration::MAX)
}
