//! Delays of the controller, other than motions.

use std::time::Duration;

/// Durations of state changes, other than motions.
///
/// The controller answers a command for such a change at once, and the state follows. With
/// [`Habit::LatePower`](crate::Habit::LatePower), it answers `power_on` and `enable_robot` after the change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Delays {
    /// Time from `power_on` to power.
    pub power_on: Duration,
    /// Time from `enable_robot` to enabled.
    pub enable: Duration,
    /// Time from `servo_move` to servo mode.
    pub servo_mode: Duration,
    /// Time from the start of a motion until the robot stops reporting that it is in position. A shorter motion never
    /// shows.
    pub in_position: Duration,
}

impl Delays {
    /// Delays from field notes: 8 s for power, 3.5 s for enabling, 100 ms for being in position. The controller enters
    /// servo mode at once; firmware 1.5.14 takes at most 9 ms (a timed log).
    pub const REAL: Self = Self {
        power_on: Duration::from_secs(8),
        enable: Duration::from_millis(3500),
        servo_mode: Duration::ZERO,
        in_position: Duration::from_millis(100),
    };

    /// No delays: the controller makes each change at once.
    pub const NONE: Self = Self {
        power_on: Duration::ZERO,
        enable: Duration::ZERO,
        servo_mode: Duration::ZERO,
        in_position: Duration::ZERO,
    };
}
