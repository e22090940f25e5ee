//! Servo mode: set-points at the controller's own pace.

mod enter;
mod leave;
mod pace;
mod report;
mod session;

use std::time::Duration;

use jaka_proto::messages::servo::SetServoMoveFilter;

pub use self::report::ServoReport;
pub use self::session::ServoSession;

/// How a [`ServoSession`] runs.
#[derive(Debug, Clone, PartialEq)]
#[must_use = "a configuration does nothing until servo mode is entered with it"]
pub struct ServoConfig {
    pub(crate) step_count: u32,
    pub(crate) filter: Option<SetServoMoveFilter>,
    pub(crate) enter_timeout: Duration,
    pub(crate) busy_wait: Duration,
    pub(crate) max_unanswered: Duration,
}

/// The longest servo period, in controller cycles.
const MOST_STEPS: u32 = 12;

/// This many set-points may be unanswered, however long their period is: replies take their time.
const FEWEST_UNANSWERED: usize = 3;

impl Default for ServoConfig {
    fn default() -> Self {
        Self {
            step_count: 1,
            filter: None,
            enter_timeout: Duration::from_secs(5),
            busy_wait: Duration::ZERO,
            max_unanswered: Duration::from_millis(100),
        }
    }
}

impl ServoConfig {
    /// The defaults: a set-point each 8 ms, and the filter stays as it is.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the servo period, in controller cycles of 8 ms: 1 by default and at least, 12 at most, which [`Robot::enter_servo_mode`]
    /// checks.
    ///
    /// [`Robot::enter_servo_mode`]: crate::Robot::enter_servo_mode
    pub fn step_count(mut self, cycles: u32) -> Self {
        self.step_count = cycles.max(1);
        self
    }

    /// Sets the filter that smooths the set-points, before servo mode is entered. By default it stays as it is.
    pub fn filter(mut self, filter: SetServoMoveFilter) -> Self {
        self.filter = Some(filter);
        self
    }

    /// Sets how long the controller may take to enter servo mode. 5 s by default.
    pub fn enter_timeout(mut self, timeout: Duration) -> Self {
        self.enter_timeout = timeout;
        self
    }

    /// Sets how long before each set-point the thread spins instead of sleeping, which is more exact and takes CPU time. Zero by
    /// default; 200 µs suit a usual Linux system.
    pub fn busy_wait(mut self, time: Duration) -> Self {
        self.busy_wait = time;
        self
    }

    /// Sets how many set-points may be unanswered, as the time that they take: 100 ms by default, and at least three set-points.
    ///
    /// With more, the session ends. It is also how far the arm may still move if the link stalls.
    pub fn max_unanswered(mut self, time: Duration) -> Self {
        self.max_unanswered = time;
        self
    }

    /// How many set-points may be unanswered.
    pub(crate) fn most_unanswered(&self) -> usize {
        let count = self.max_unanswered.as_nanos() / self.period().as_nanos();
        usize::try_from(count).unwrap_or(usize::MAX).max(FEWEST_UNANSWERED)
    }

    /// The time between two set-points.
    pub fn period(&self) -> Duration {
        pace::CYCLE * self.step_count
    }
}
