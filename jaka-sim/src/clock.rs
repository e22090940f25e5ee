//! The controller's time.

use std::time::{Duration, Instant};

use crate::time::Time;

/// Length of a controller cycle (4.15).
pub(crate) const CYCLE: Duration = Duration::from_millis(8);

/// How a controller's time goes on.
#[derive(Debug)]
pub(crate) enum Clock {
    /// With this time, since this moment, so many times as fast.
    Running { time: Time, start: Instant, scale: f64 },
    /// Only by [`Controller::advance`](crate::Controller::advance).
    Stepped,
}

impl Clock {
    /// One that goes with this time from now on.
    pub(crate) fn of(time: &Time, scale: f64) -> Self {
        Self::Running { time: time.clone(), start: time.now(), scale }
    }

    /// The controller's time, if it goes by itself.
    pub(crate) fn now(&self) -> Option<Duration> {
        match self {
            Self::Running { time, start, scale } => Some(scaled(time.since(*start), *scale)),
            Self::Stepped => None,
        }
    }

    /// How long the next cycle is away, in the time that passes; for ever where it does not come by itself.
    pub(crate) fn until_next_cycle(&self) -> Duration {
        let Self::Running { time, start, scale } = self else { return Duration::MAX };
        let passed = scaled(time.since(*start), *scale).as_nanos() % CYCLE.as_nanos();
        let left = CYCLE.saturating_sub(Duration::from_nanos(u64::try_from(passed).unwrap_or_default()));
        scaled(left, scale.recip()).max(SHORTEST)
    }
}

/// The shortest wait for the next cycle, so that rounding does not make it none.
const SHORTEST: Duration = Duration::from_micros(100);

/// A time that is so many times as long, [`Duration::MAX`] where it is longer.
pub(crate) fn scaled(time: Duration, factor: f64) -> Duration {
    Duration::try_from_secs_f64(time.as_secs_f64() * factor).unwrap_or(Duration::MAX)
}
