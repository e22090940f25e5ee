//! Smooth motions to targets and velocities that any thread gives at any time.

mod cycle;
mod handle;
mod target;

use std::marker::PhantomData;
use std::sync::Arc;
use std::time::Duration;

use jaka_motion::Dynamics;

pub use self::handle::StreamHandle;
#[cfg(doc)]
use crate::ErrorKind;
use crate::error::OptionName;
use crate::guard::SetPointGuard;
use crate::servo_session::{LedArm, LentArm, MOST_DEG};
use crate::servo_thread::ServoThread;
use crate::{End, Error, Guard, ServoConfig};

/// Options of a [`Stream`].
#[derive(Debug, Clone)]
#[must_use = "a configuration does nothing until a stream is begun with it"]
pub struct StreamConfig {
    servo: ServoConfig,
    dynamics: Option<Dynamics>,
    max_departure_deg: f64,
    max_gap: Duration,
    guard: Option<Guard>,
}

impl Default for StreamConfig {
    fn default() -> Self {
        Self {
            servo: ServoConfig::new(),
            dynamics: None,
            max_departure_deg: MOST_DEG,
            max_gap: Duration::from_millis(100),
            guard: None,
        }
    }
}

impl StreamConfig {
    /// The defaults: a set-point each 8 ms, and the speeds and accelerations of the robot's limits.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the options of set-points: period, filter, timeout of servo mode and more.
    pub fn servo(mut self, servo: ServoConfig) -> Self {
        self.servo = servo;
        self
    }

    /// Sets the dynamics of the joints: by default the speeds and accelerations of the robot's limits, and jerks with
    /// which a joint reaches its acceleration in 0.1 s, which is ours ([`Dynamics::of`]). Dynamics beyond the limits
    /// are an [`ErrorKind::InvalidOption`].
    pub fn dynamics(mut self, dynamics: Dynamics) -> Self {
        self.dynamics = Some(dynamics);
        self
    }

    /// Sets the greatest distance of a joint from all its set-points of the last half second, in degrees, by status
    /// packets: 5 by default. Beyond it the stream lands, and ends with [`ErrorKind::Departed`]. Less than 0.001, or no
    /// number, is an [`ErrorKind::InvalidOption`].
    pub fn max_departure(mut self, degrees: f64) -> Self {
        self.max_departure_deg = degrees;
        self
    }

    /// Sets the greatest lateness of a set-point of a slow arm: 100 ms by default. Beyond it the stream ends with
    /// [`ErrorKind::SetPointLate`]. At speed it ends so after three periods ([`ServoSession`](crate::ServoSession) has
    /// details at "Late set-points"); a slow arm continues from standstill.
    pub fn max_gap(mut self, time: Duration) -> Self {
        self.max_gap = time;
        self
    }

    /// Puts the stream under a guard: when it trips, the stream lands, and ends with [`ErrorKind::GuardTripped`]. The
    /// first set-point that brakes goes out in the next servo period after the packet. [`Guard`] describes its reach
    /// and its limits: it is **not a safety function**.
    ///
    /// Nothing that moves the arm was sent after [`ErrorKind::GuardTripped`] (the guard trips by the newest packet
    /// already), [`ErrorKind::NotShown`] (packets lack its values), [`ErrorKind::StatusUnknown`], and
    /// [`ErrorKind::NotGuarded`] (the period of packets is not known yet).
    ///
    /// # A limit of force
    /// Under a [`ForceLimit`](crate::ForceLimit) the stream is slow. The speed of the tool never uses more than the
    /// overtravel in the time without braking and 0.05 s (ours), and from each set-point on the tool lands within the
    /// rest of the overtravel. This holds for any target; a faster velocity of the tool is refused, with that speed as
    /// the limit ([`Generator::with_tool_stop`](jaka_motion::Generator::with_tool_stop)). The stream also lands if
    /// packets stay away for three of their periods, 100 ms at least.
    pub fn guard(mut self, guard: impl Into<Guard>) -> Self {
        self.guard = Some(guard.into());
        self
    }

    /// Name of one of its options.
    const fn option(name: &'static str) -> OptionName {
        OptionName::new("StreamConfig", name)
    }

    fn check(&self) -> Result<(), Error> {
        Self::option("max_departure").check_at_least(self.max_departure_deg, "deg")
    }
}

/// A robot that moves to targets and velocities of its [handles](StreamHandle), from
/// [`Robot::stream`](crate::Robot::stream).
///
/// A separate thread generates a set-point in each servo period, within the speeds, accelerations and jerks of
/// [`StreamConfig::dynamics`] and the robot's limits, for any targets at any rate, and sends it as `servo_j` (4.15).
/// [`Generator`](jaka_motion::Generator) states its guarantees for the set-points.
///
/// A stream ends by a landing: [`land`](Self::land), a drop, also in a panic, a [`RobotStop`](crate::RobotStop), an
/// unknown status, joints that do not follow their set-points. After a set-point that is three periods late at speed
/// nothing brakes. The section "Landing" of [`ServoSession`](crate::ServoSession) applies, but a stream brakes the arm
/// by a stop within its jerks, too. If the program's thread is held up, the stream continues: a velocity ends after its
/// given time.
///
/// ```no_run
/// use std::time::Duration;
/// use jaka_robot::jaka_motion::{Limits, Model};
/// use jaka_robot::{Robot, RobotConfig, StreamConfig};
///
/// let arm = Model::named("Zu 5").expect("a published arm");
/// let mut robot = Robot::connect("10.5.5.100")?;
/// robot.configure(&RobotConfig::new().limits(Limits::of(arm)))?;
/// let stream = robot.stream(&StreamConfig::new())?;
/// let handle = stream.handle();
/// let start = handle.joints();
/// handle.set_joints([start[0] + 5.0, start[1], start[2], start[3], start[4], start[5]])?;
/// handle.wait_for_rest(Duration::from_secs(10))?;
/// handle.set_joint_velocity([0.0, 0.0, 0.0, 0.0, 0.0, 10.0], Duration::from_millis(500))?;
/// let end = stream.land()?;
/// println!("{} set-points", end.report.cycles);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use = "dropping a stream ends it; `land` does so, too, and reports"]
#[derive(Debug)]
pub struct Stream<'r> {
    handle: StreamHandle,
    thread: ServoThread<Result<End, Error>>,
    robot: PhantomData<&'r mut ()>,
}

impl<'r> Stream<'r> {
    /// Begins a stream in a separate thread.
    pub(crate) fn begin(led: LedArm<'r>, config: &StreamConfig) -> Result<Self, Error> {
        let guard = SetPointGuard::arm(led.arm, config.guard.as_ref())?;
        config.check()?;
        let config = config.clone();
        let work = move |lent: &mut LentArm, begun: &_| cycle::run(lent, &config, guard.as_ref(), begun);
        let (thread, (targets, generator)) = ServoThread::start("jaka stream", led.lent(), work)?;
        let handle = StreamHandle { targets, desk: Arc::new(generator) };
        Ok(Self { handle, thread, robot: PhantomData })
    }
}

impl Stream<'_> {
    /// Handle that gives targets, in this thread or another.
    pub fn handle(&self) -> StreamHandle {
        self.handle.clone()
    }

    /// Brakes the arm, holds it until the status shows it at rest, and leaves servo mode.
    ///
    /// # Errors
    /// As [`ServoSession::land`](crate::ServoSession::land); or the error with which the stream has ended before.
    pub fn land(mut self) -> Result<End, Error> {
        self.handle.targets.land();
        self.thread.join()?
    }
}

impl Drop for Stream<'_> {
    fn drop(&mut self) {
        if self.thread.was_awaited {
            return;
        }
        self.handle.targets.land();
        if let Err(error) = self.thread.join().and_then(|ended| ended) {
            log::warn!(target: "jaka_robot", "the stream that was dropped did not end at rest: {error}");
        }
    }
}
