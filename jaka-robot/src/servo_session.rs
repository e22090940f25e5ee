//! Servo mode: set-points at the controller's own pace.

mod braking;
pub(crate) mod course;
mod departure;
mod enter;
mod generated;
mod lag;
mod land;
mod leave;
mod pace;
mod rates;
mod realtime;
mod session;
mod session_config;
mod set_point;

use std::time::Duration;

use jaka_clock::Clock;
use jaka_proto::messages::servo::SetServoMoveFilter;

pub(crate) use self::departure::MOST_DEG;
pub(crate) use self::generated::{SetPoints, Supervision, beyond_limit, check_shows_joints, no_limits};
pub(crate) use self::lag::LagFit;
use self::pace::Pace;
use self::realtime::RealtimePriority;
pub use self::session::ServoSession;
pub use self::session_config::SessionConfig;
pub(crate) use self::set_point::SetPoint;
use crate::Error;
use crate::arm::Arm;
use crate::error::OptionName;
use crate::limits::LimitChecks;

/// Options for the set-points of a [`ServoSession`], a stream or a trajectory.
#[derive(Debug, Clone, PartialEq)]
#[must_use = "a configuration does nothing until servo mode is entered with it"]
pub struct ServoConfig {
    pub(crate) step_count: u32,
    pub(crate) filter: Option<SetServoMoveFilter>,
    pub(crate) enter_timeout: Duration,
    pub(crate) busy_wait: Duration,
    pub(crate) max_unanswered: Duration,
    rest_timeout: Duration,
    realtime_priority: Option<u8>,
}

/// Arm of a session, and the limits that check its set-points.
#[derive(Debug)]
pub(crate) struct LedArm<'r> {
    pub(crate) arm: &'r mut Arm,
    pub(crate) limits: &'r mut LimitChecks,
    /// True if motions were started that have not been waited for.
    pub(crate) has_motions: bool,
    /// Time for which the arm must rest.
    pub(crate) settling: Duration,
}

/// Arm of a session in a separate thread.
#[derive(Debug)]
pub(crate) struct LentArm {
    pub(crate) arm: Arm,
    limits: LimitChecks,
    has_motions: bool,
    settling: Duration,
}

impl LedArm<'_> {
    /// Returns the arm for another thread, which ends before the borrowed arm is dropped.
    pub(crate) fn lent(self) -> LentArm {
        let Self { arm, limits, has_motions, settling } = self;
        LentArm { arm: arm.lent(), limits: limits.lent(), has_motions, settling }
    }
}

impl LentArm {
    pub(crate) fn led(&mut self) -> LedArm<'_> {
        let Self { arm, limits, has_motions, settling } = self;
        LedArm { arm, limits, has_motions: *has_motions, settling: *settling }
    }
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
            rest_timeout: Duration::from_secs(1),
            realtime_priority: None,
        }
    }
}

impl ServoConfig {
    /// The defaults: a set-point each 8 ms, and the filter stays as it is.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the servo period, in controller cycles of 8 ms: 1 by default and at least, 12 at most. With more, entering
    /// servo mode fails with [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption).
    pub fn step_count(mut self, cycles: u32) -> Self {
        self.step_count = cycles.max(1);
        self
    }

    /// Sets the filter that smooths the set-points, before servo mode is entered. By default it stays as it is.
    pub fn filter(mut self, filter: SetServoMoveFilter) -> Self {
        self.filter = Some(filter);
        self
    }

    /// Sets the longest time until the controller enters servo mode. 5 s by default.
    pub fn enter_timeout(mut self, timeout: Duration) -> Self {
        self.enter_timeout = timeout;
        self
    }

    /// Sets the time before each set-point in which the thread spins instead of sleeping, which is more exact and takes
    /// CPU time. Zero by default; 200 µs suit a usual Linux system.
    pub fn busy_wait(mut self, time: Duration) -> Self {
        self.busy_wait = time;
        self
    }

    /// Gives the thread that enters servo mode a real-time priority (`SCHED_FIFO`) until the session ends, from 1 to
    /// 99; another is an [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption). By default it keeps its own.
    /// Needs the feature `realtime`, and Linux.
    ///
    /// Then only the system and threads of this or a higher real-time priority can take its core. 20 suits a machine
    /// without others: from 50 on it would precede the work of a real-time kernel (`PREEMPT_RT`) for the network. A
    /// [`ServoSession`] has the caller's thread, which also computes the set-points and holds its core meanwhile; a
    /// `Stream` has its own. Other threads keep their priority, but threads started by this one meanwhile inherit it.
    ///
    /// The session must stay in the thread that has entered it: if it ends in another, the first one keeps the
    /// priority. If the system does not allow the priority, entering fails with
    /// [`ErrorKind::RealtimePriority`](crate::ErrorKind::RealtimePriority), and nothing is sent.
    #[cfg(feature = "realtime")]
    pub fn realtime_priority(mut self, priority: u8) -> Self {
        self.realtime_priority = Some(priority);
        self
    }

    /// Sets the greatest number of unanswered set-points, as the time of their periods: 100 ms by default, and at least
    /// three set-points.
    ///
    /// With more, the session ends. The arm may still move for this time if the link stalls.
    pub fn max_unanswered(mut self, time: Duration) -> Self {
        self.max_unanswered = time;
        self
    }

    /// Sets the time for which the session holds the last set-point at its end, if no status packet shows the arm at
    /// rest there: 1 s by default.
    pub fn rest_timeout(mut self, timeout: Duration) -> Self {
        self.rest_timeout = timeout;
        self
    }

    /// Least lateness of a set-point that follows a gap: the controller had none for so long. No source says how long
    /// it bears that; three periods are ours.
    fn gap(&self) -> Duration {
        self.period() * 3
    }

    /// Greatest number of set-points that may be unanswered.
    pub(crate) fn most_unanswered(&self) -> usize {
        let count = self.max_unanswered.as_nanos() / self.period().as_nanos();
        usize::try_from(count).unwrap_or(usize::MAX).max(FEWEST_UNANSWERED)
    }

    /// Name of one of its options.
    const fn option(name: &'static str) -> OptionName {
        OptionName::new("ServoConfig", name)
    }

    /// The time between two set-points.
    pub fn period(&self) -> Duration {
        pace::CYCLE * self.step_count
    }

    /// Takes the real-time priority for this thread, where one is asked for.
    fn take_priority(&self) -> Result<Option<RealtimePriority>, Error> {
        self.realtime_priority.map(RealtimePriority::take).transpose()
    }

    /// Waits for cycles as a [`ServoSession`](super::ServoSession) does, for this time, and returns the lateness of
    /// each. Sends nothing: it measures this machine alone.
    ///
    /// At least one cycle, in the calling thread, with the period, the [`busy_wait`](Self::busy_wait) and the real-time
    /// priority of this configuration. `jaka jitter` prints it.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption), and `ErrorKind::RealtimePriority` if the system
    /// does not allow the priority.
    pub fn measure_lateness(&self, time: Duration) -> Result<Vec<Duration>, Error> {
        self.check_step_count()?;
        let _priority = self.take_priority()?;
        let clock = Clock::default();
        let mut pace = Pace::new(&clock, self.period(), self.busy_wait);
        // The first one is due at once.
        pace.wait();
        let (since, mut lateness) = (clock.stopwatch(), Vec::new());
        loop {
            lateness.push(pace.wait().late);
            if since.passed() >= time {
                return Ok(lateness);
            }
        }
    }

    /// Fails for a period so long that one set-point would move the arm far.
    fn check_step_count(&self) -> Result<(), Error> {
        if self.step_count <= MOST_STEPS {
            return Ok(());
        }
        let expected = format!("1 to {MOST_STEPS}: a period of at most {:?}", pace::CYCLE * MOST_STEPS);
        Err(Self::option("step_count").refuse(self.step_count, expected))
    }
}
