//! Delays of the controller, other than for motion.

use std::time::Duration;

/// Durations of changes of state, other than motion.
///
/// A command that starts such a change is answered at once, and the state follows;
/// [`Habit::LatePower`](crate::Habit::LatePower) has `power_on` and `enable_robot` answered when it is there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Delays {
    /// From `power_on` to power.
    pub power_on: Duration,
    /// From `enable_robot` to enabled.
    pub enable: Duration,
    /// From `servo_move` to servo mode.
    pub servo_mode: Duration,
    /// From the start of a motion to the moment when the robot is no longer in position. A motion that ends before
    /// never shows.
    pub in_position: Duration,
}

impl Delays {
    /// As field notes have them: 8 s for power, 3.5 s for enabling, 100 ms for being in position. Servo mode is entered
    /// at once, within 9 ms of firmware 1.5.14 (a timed log).
    pub const REAL: Self = Self {
        power_on: Duration::from_secs(8),
        enable: Duration::from_millis(3500),
        servo_mode: Duration::ZERO,
        in_position: Duration::from_millis(100),
    };

    /// None at all: each change is made at once.
    pub const NONE: Self = Self {
        power_on: Duration::ZERO,
        enable: Duration::ZERO,
        servo_mode: Duration::ZERO,
        in_position: Duration::ZERO,
    };
}
