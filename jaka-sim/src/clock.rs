//! Time and threads of the controller.

use std::io;
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use jaka_clock::Clock;

/// Length of a controller cycle (4.15).
pub(crate) const CYCLE: Duration = Duration::from_millis(8);

/// Passage of a controller's time.
#[derive(Debug)]
pub(crate) enum ControllerClock {
    /// The controller's time follows this clock since a moment, scaled by a factor.
    Running { time: Clock, start: Instant, scale: f64 },
    /// Only [`Controller::advance`](crate::Controller::advance) advances the controller's time.
    Stepped,
}

impl ControllerClock {
    /// Creates a clock that follows this time from now on.
    pub(crate) fn of(time: &Clock, scale: f64) -> Self {
        Self::Running { time: time.clone(), start: time.now(), scale }
    }

    /// Returns the controller's time; `None` for a stepped clock.
    pub(crate) fn now(&self) -> Option<Duration> {
        match self {
            Self::Running { time, start, scale } => Some(scaled(time.elapsed(*start), *scale)),
            Self::Stepped => None,
        }
    }

    /// Returns the time to the next cycle, by the underlying clock; [`Duration::MAX`] for a stepped clock.
    pub(crate) fn until_next_cycle(&self) -> Duration {
        self.now().map_or(Duration::MAX, |now| self.until(now + Duration::from_nanos(1)))
    }

    /// Returns the time to the first cycle that is not before this time, by the underlying clock; [`Duration::MAX`] for
    /// a stepped clock.
    pub(crate) fn until(&self, due: Duration) -> Duration {
        let (Self::Running { scale, .. }, Some(now)) = (self, self.now()) else { return Duration::MAX };
        let cycles = u32::try_from(due.as_nanos().div_ceil(CYCLE.as_nanos())).unwrap_or(u32::MAX);
        scaled((CYCLE * cycles).saturating_sub(now), scale.recip()).max(SHORTEST)
    }
}

/// Shortest wait for the next cycle, so that rounding does not make it zero.
const SHORTEST: Duration = Duration::from_micros(100);

/// Multiplies a time by a factor, to at most [`Duration::MAX`].
pub(crate) fn scaled(time: Duration, factor: f64) -> Duration {
    Duration::try_from_secs_f64(time.as_secs_f64() * factor).unwrap_or(Duration::MAX)
}

/// Starts a serving thread of the controller.
pub(crate) fn spawn(time: &Clock, name: &str, work: impl FnOnce() + Send + 'static) -> io::Result<JoinHandle<()>> {
    thread::Builder::new().name(format!("jaka-sim {name}")).spawn(time.serving(work))
}
