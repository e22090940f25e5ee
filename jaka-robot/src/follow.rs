//! Trajectories, followed along their curve at any rate.

mod approach;
mod config;
mod cycle;
mod handle;
mod orders;
mod start;

use std::marker::PhantomData;
use std::sync::Arc;

use jaka_motion::Trajectory;

pub use self::config::FollowConfig;
pub use self::handle::{FollowHandle, FollowProgress};
use self::orders::Orders;
#[cfg(doc)]
use crate::ErrorKind;
use crate::guard::SetPointGuard;
use crate::servo_session::{LedArm, LentArm};
use crate::servo_thread::ServoThread;
use crate::{End, Error};

/// A robot that follows a [`Trajectory`], from [`Robot::start_follow`](crate::Robot::start_follow).
///
/// A separate thread sends a set-point in each servo period, as `servo_j` (4.15). Each set-point is a point of the
/// trajectory: [`Follower`](jaka_motion::Follower) describes the passage of trajectory time and the promises for
/// set-points. A pause, another speed and a stop, by [handles](FollowHandle), change this passage smoothly; the arm
/// stays on the curve.
///
/// # How it ends
/// - At the end of the trajectory, or after a stop, the run holds the last set-point until status packets show the arm
///   at rest there, and leaves servo mode.
/// - After a [`RobotStop`](crate::RobotStop), a [`Guard`](crate::Guard) that trips, a status that is unknown or does
///   not show the joints for half a second, a state of the robot that ends set-points
///   ([`ErrorKind::RobotState`](crate::ErrorKind::RobotState), drag mode), a set-point that the controller refuses, or
///   joints that do not follow, the run brakes the arm along the curve first. It brakes straight on in joint space
///   instead if the curve takes more than twice as long and half a second more, because the trajectory leaves no
///   acceleration for it, or longer than a [`RobotStop`](crate::RobotStop) waits:
///   [`TrajectoryReport::has_left_curve`](crate::TrajectoryReport::has_left_curve).
/// - Joints that do not follow are not held at the last set-point. In drag mode the arm is braked only while its joints
///   follow, and not held either.
/// - A protective stop, an emergency stop, and a lost or stalled connection end it at once. No source says how an arm
///   behaves that is at speed then.
///
/// After a late set-point nothing is skipped. After one that is late by three periods or more, a slow arm continues
/// from standstill; for an arm at speed the run ends ([`ServoSession`](crate::ServoSession) has details at "Late
/// set-points").
///
/// ```no_run
/// use std::time::Duration;
///
/// use jaka_robot::jaka_motion::{Limits, Model, TimedPoint, Trajectory};
/// use jaka_robot::{FollowConfig, Robot, RobotConfig};
///
/// let arm = Model::named("Zu 5").expect("a published arm");
/// let mut robot = Robot::connect("10.5.5.100")?;
/// robot.configure(&RobotConfig::new().limits(Limits::of(arm)))?;
/// let points = [
///     TimedPoint::new(0.0, [0.0, 60.0, -80.0, 190.0, -90.0, 0.0]),
///     TimedPoint::new(4.0, [10.0, 60.0, -80.0, 190.0, -90.0, 20.0]),
/// ];
/// let trajectory = Trajectory::timed(&points, robot.limits().expect("it has some"))?;
/// let run = robot.start_follow(&trajectory, &FollowConfig::new().approach(5.0))?;
/// run.handle().set_speed_scale(0.5)?;
/// run.handle().pause()?;
/// run.handle().resume()?;
/// run.wait().reached()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use = "dropping a run stops it; `wait` waits for its end"]
#[derive(Debug)]
pub struct FollowRun<'r> {
    handle: FollowHandle,
    thread: ServoThread<End>,
    robot: PhantomData<&'r mut ()>,
}

impl<'r> FollowRun<'r> {
    /// Begins a run in a separate thread.
    pub(crate) fn begin(led: LedArm<'r>, trajectory: &Trajectory, config: &FollowConfig) -> Result<Self, Error> {
        let guard = SetPointGuard::arm(led.arm, config.guard.as_ref())?;
        config.check()?;
        let deadline = config.deadline.and_then(|time| led.arm.clock().now().checked_add(time));
        let orders = Arc::new(Orders::new(config.scale, deadline));
        let handle = FollowHandle { orders: Arc::clone(&orders), duration: trajectory.duration() };
        let (trajectory, config) = (trajectory.clone(), config.clone());
        let work = move |lent: &mut LentArm, begun: &_| {
            cycle::run(lent, (&trajectory, &config), guard.as_ref(), &orders, begun)
        };
        let (thread, ()) = ServoThread::start("jaka follow", led.lent(), work)?;
        Ok(Self { handle, thread, robot: PhantomData })
    }
}

impl FollowRun<'_> {
    /// Handle that pauses, slows and stops the run, in this thread or another.
    pub fn handle(&self) -> FollowHandle {
        self.handle.clone()
    }

    /// Waits until the arm is at rest, or it is known that it cannot be brought to rest.
    pub fn wait(mut self) -> End {
        self.thread.join().unwrap_or_else(|error| self.handle.lost(error))
    }
}

impl Drop for FollowRun<'_> {
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
