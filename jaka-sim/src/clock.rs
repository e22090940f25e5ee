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
        self.now().map_or(Duration::MAX, |now| self.until(now + Duration::from_nanos(1)))
    }

    /// How long the first cycle is away that is not before this time, in the time that passes; for ever where it does not come by
    /// itself.
    pub(crate) fn until(&self, due: Duration) -> Duration {
        let (Self::Running { scale, .. }, Some(now)) = (self, self.now()) else { return Duration::MAX };
        let cycles = u32::try_from(due.as_nanos().div_ceil(CYCLE.as_nanos())).unwrap_or(u32::MAX);
        scaled((CYCLE * cycles).saturating_sub(now), scale.recip()).max(SHORTEST)
    }
}

/// The shortest wait for the next cycle, so that rounding does not make it none.
const SHORTEST: Duration = Duration::from_micros(100);

/// A time that is so many times as long, [`Duration::MAX`] where it is longer.
pub(crate) fn scaled(time: Duration, factor: f64) -> Duration {
    Duration::try_from_secs_f64(time.as_secs_f64() * factor).unwrap_or(Duration::MAX)
}
