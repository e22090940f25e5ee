//! Trajectories, followed along their curve at any rate.

mod approach;
mod config;
mod cycle;
mod handle;
mod orders;
mod start;

use std::marker::PhantomData;
use std::sync::Arc;
use std::time::Duration;

use jaka_motion::Trajectory;
use jaka_proto::messages::status::RobotStatus;

pub use self::config::FollowConfig;
pub use self::handle::{FollowHandle, FollowProgress};
use self::orders::Orders;
#[cfg(doc)]
use crate::ErrorKind;
use crate::robot::SetPointGuard;
use crate::servo_thread::ServoThread;
use crate::{End, Error, Guard, MotionStatus, Robot};

/// A robot that follows a [`Trajectory`], from [`Robot::start_follow`].
///
/// A thread of its own sends a set-point in each servo period, as `servo_j` (4.15). Each is where the trajectory is at some time of it:
/// [`Follower`](jaka_motion::Follower) tells how that time passes and what is promised of the set-points. A pause, another speed and a stop, by [handles](FollowHandle),
/// change how fast it passes, smoothly; the arm is not led off the curve.
///
/// # How it ends
/// - At the end of the trajectory, or where it was stopped, the last set-point is held until status packets show the arm at rest there, and servo mode is left.
/// - After a [`RobotStop`](crate::RobotStop), a [`Guard`] that trips, a status that is no longer known or does not show the joints for half a second, a set-point that the controller refuses, or joints that do not follow,
///   the arm is braked along the curve first. Where that would take more than twice as long as braking straight on in joint space, and half a second more, because
///   the trajectory leaves no acceleration for it, or longer than a [`RobotStop`](crate::RobotStop) waits, it is braked straight on: [`TrajectoryReport::has_left_curve`](crate::TrajectoryReport::has_left_curve).
/// - A protective stop, an emergency stop, and a lost or stalled connection end it at once. What an arm does then that is at speed is not known from any source.
///
/// After a late set-point nothing is skipped. After one that is late by three periods or more, an arm that was slow
/// goes on from standstill; one at speed ends the run ([`ServoSession`](crate::ServoSession) says more, at "Late
/// set-points").
///
/// ```no_run
/// use std::time::Duration;
/// use jaka_robot::jaka_motion::{Limits, Model, TimedPoint, Trajectory};
/// use jaka_robot::{FollowConfig, Robot};
///
/// let arm = Model::named("Zu 5").expect("a published arm");
/// let mut robot = Robot::connect("10.5.5.100")?.with_limits(Limits::of(arm))?;
/// let points = [
///     TimedPoint::new(0.0, [0.0, 60.0, -80.0, 190.0, -90.0, 0.0]),
///     TimedPoint::new(4.0, [10.0, 60.0, -80.0, 190.0, -90.0, 20.0]),
/// ];
/// let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some"))?;
/// let run = robot.start_follow(&trajectory, &FollowConfig::new().approach(5.0))?;
/// run.set_speed_scale(0.5)?;
/// run.pause()?;
/// run.resume()?;
/// run.wait().reached()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use = "dropping a run stops it; `wait` waits for its end"]
#[derive(Debug)]
pub struct FollowRun<'r, S: MotionStatus = RobotStatus> {
    handle: FollowHandle,
    thread: ServoThread<End>,
    robot: PhantomData<&'r mut Robot<S>>,
}

/// Following trajectories needs the feature `stream`.
impl<S: MotionStatus> Robot<S> {
    /// Follows a trajectory, and returns when the arm is at rest at its end, or why it is not. It stops along the trajectory where it is not done
    /// by the deadline.
    ///
    /// The arm must be where the trajectory starts: see [`FollowConfig::approach`].
    ///
    /// # Errors
    /// As [`start_follow`](Self::start_follow). All that happens after the first set-point is told by the [`End`].
    pub fn follow(&mut self, trajectory: &Trajectory, deadline: Duration) -> Result<End, Error> {
        Ok(self.start_follow(trajectory, &FollowConfig::new().deadline(deadline))?.wait())
    }

    /// Begins to follow a trajectory.
    ///
    /// All of it is compared with the robot's limits before the first set-point, with the tool and the frames that the controller has now, whatever it was
    /// compared with before; also where the limits' policy is only to warn.
    ///
    /// # Errors
    /// Nothing moves the arm then. As [`ServoSession`](crate::ServoSession) says at "Entering"; [`ErrorKind::NotChecked`] if the robot has no limits,
    /// [`ErrorKind::NotShown`] if packets do not show the joints, [`ErrorKind::Trajectory`] if the trajectory is beyond one, [`ErrorKind::NotAtStart`] if it starts elsewhere than where the controller's own answer says that the
    /// joints are to be, [`ErrorKind::BeyondLimit`] if the straight way in joint space to its start is beyond a limit,
    /// [`ErrorKind::InvalidOption`] if the configuration has a value that it does not take.
    pub fn start_follow(&mut self, trajectory: &Trajectory, config: &FollowConfig) -> Result<FollowRun<'_, S>, Error> {
        self.begin_follow(trajectory, config, None)
    }

    /// The same under a guard: when it trips, the arm is braked along the trajectory, and the run ends with [`Cause::Guard`](crate::Cause::Guard). The first set-point that brakes
    /// goes out in the next servo period after the packet.
    ///
    /// [`Guard`] tells what can be expected of that, and what not: it is **not a safety function**.
    ///
    /// # A limit of force
    /// Under a [`ForceLimit`](crate::ForceLimit) the arm is braked as soon as the joints' accelerations allow, also where packets stay away for three of their periods, 100 ms at least. All of
    /// the trajectory is looked at, at its own speed, which is the most that a handle can ask for: wherever something were touched, the tool must rest within the overtravel,
    /// [computed](jaka_motion::Follower::worst_overtravel) with the set-points that brake it. An approach is so slow that the same holds.
    ///
    /// # Errors
    /// As [`start_follow`](Self::start_follow). Nothing that moves the arm was sent after [`ErrorKind::GuardTripped`] (the guard trips by the newest packet already),
    /// [`ErrorKind::NotShown`] (packets do not show what it needs), [`ErrorKind::StatusUnknown`], and [`ErrorKind::NotGuarded`] (a
    /// [`ForceLimit`](crate::ForceLimit) permits less speed: it says where, and how much).
    pub fn start_follow_until(
        &mut self,
        trajectory: &Trajectory,
        config: &FollowConfig,
        guard: impl Into<Guard>,
    ) -> Result<FollowRun<'_, S>, Error> {
        let armed = self.arm_for_set_points(&guard.into())?;
        self.begin_follow(trajectory, config, Some(armed))
    }

    fn begin_follow(
        &mut self,
        trajectory: &Trajectory,
        config: &FollowConfig,
        guard: Option<SetPointGuard>,
    ) -> Result<FollowRun<'_, S>, Error> {
        config.check()?;
        let deadline = config.deadline.and_then(|time| self.clock().now().checked_add(time));
        let orders = Arc::new(Orders::new(config.scale, deadline));
        let handle = FollowHandle { orders: Arc::clone(&orders), duration: trajectory.duration() };
        let (trajectory, config) = (trajectory.clone(), config.clone());
        let work = move |robot: &mut Robot<S>, begun: &_| {
            cycle::run(robot, (&trajectory, &config), guard.as_ref(), &orders, begun)
        };
        let (thread, ()) = ServoThread::start("jaka follow", self.lent(), work)?;
        Ok(FollowRun { handle, thread, robot: PhantomData })
    }
}

impl<S: MotionStatus> FollowRun<'_, S> {
    /// A handle for another thread.
    pub fn handle(&self) -> FollowHandle {
        self.handle.clone()
    }

    /// Waits until the arm is at rest, or it is known that it cannot be brought to rest.
    pub fn wait(mut self) -> End {
        self.thread.join().unwrap_or_else(|error| self.handle.lost(error))
    }
}

/// What the handle does, the run does, too.
impl<S: MotionStatus> std::ops::Deref for FollowRun<'_, S> {
    type Target = FollowHandle;

    fn deref(&self) -> &FollowHandle {
        &self.handle
    }
}

impl<S: MotionStatus> Drop for FollowRun<'_, S> {
    fn drop(&mut self) {
        if self.thread.was_awaited {
            return;
        }
        // It may have ended.
        let _ = self.handle.stop();
        if let Some(error) = self.thread.join().map_or_else(Some, |end| end.error) {
            log::warn!(target: "jaka_robot", "the trajectory of a run that was dropped did not end at rest: {error}");
        }
    }
}
