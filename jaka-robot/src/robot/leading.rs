//! Motions under guards, servo sessions, streams and trajectories of a robot.

use std::time::Duration;

use super::Robot;
use jaka_motion::Trajectory;

#[cfg(doc)]
use crate::ErrorKind;
use crate::guard::SetPointGuard;
use crate::planned::GuardedRun;
use crate::servo_session::ServoSession;
use crate::{End, Error, FollowConfig, FollowRun, Guard, Motion, MotionStatus, ServoConfig};
#[cfg(feature = "stream")]
use crate::{Stream, StreamConfig};

impl<S: MotionStatus> Robot<S> {
    /// Runs a motion under a guard: sends it, and waits until it has ended or the guard has tripped, upon which the arm is stopped.
    /// [`Guard`] tells what can be expected of that, and what not: it is **not a safety function**.
    ///
    /// A guard that has tripped before the motion goes out, such as by an input that has the level already, sends nothing
    /// ([`GuardTrip::is_before_start`]). The stop is written by the thread that reads the packet, or, where it would have to wait, by one of its own, also while this one waits
    /// for the reply to the motion. If the guard tripped, the arm is then waited for until it rests, for 2 s at most.
    ///
    /// Motions that were started before are ended by the stop, too, but not by a guard that trips before this motion has gone out: wait for them
    /// first.
    ///
    /// Since nobody judges the guard after this call, the arm is stopped in each way out in which it may still move: at the deadline, when
    /// the command connection is lost, which no stop passes any more, when the status is lost or stale ([`Config::stale_after`](crate::Config::stale_after)), after an error of the controller.
    /// [`End::stop`] tells whether the stop was accepted.
    ///
    /// ```no_run
    /// use std::time::Duration;
    /// use jaka_robot::motion::MoveL;
    /// use jaka_robot::{Numbering, Robot};
    ///
    /// const IO: Numbering = Numbering::FromOne;
    /// let mut robot = Robot::connect("10.5.5.100")?;
    /// let down = MoveL::relative([0.0, 0.0, -50.0, 0.0, 0.0, 0.0], 20.0).acceleration(200.0);
    /// let trip = robot.run_until(&down, IO.tool(1).rises(), Duration::from_secs(10))?.guarded()?;
    /// println!("{trip}; the stop was written after {:?}", trip.reaction);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`run`](Self::run); where the motion may have run, the arm was stopped, and [`ErrorKind::NotStopped`] says if
    /// the controller has not accepted that. Nothing was sent after [`ErrorKind::NotShown`] (packets do not show what
    /// the guard needs), [`ErrorKind::NotGuarded`] (a [`ForceLimit`](crate::ForceLimit) permits less speed),
    /// [`ErrorKind::StatusUnknown`], also with [`allow_motion_without_status`](Self::allow_motion_without_status),
    /// [`ErrorKind::InvalidOption`] (a condition has a value that it does not take), and [`ErrorKind::Thread`].
    pub fn run_until<M: Motion>(
        &mut self,
        motion: &M,
        guard: impl Into<Guard>,
        timeout: Duration,
    ) -> Result<End, Error> {
        GuardedRun { moving: self.moving(), guard: &guard.into() }.run(motion, timeout)
    }

    /// Enters servo mode, in which set-points come one by one: waits until the controller is in it.
    ///
    /// # Errors
    /// As [`ServoSession`] says at "Entering".
    pub fn enter_servo_mode(&mut self, config: &ServoConfig) -> Result<ServoSession<'_>, Error> {
        ServoSession::enter(self.led(), config, |_, _| Ok(()))
    }

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
    pub fn start_follow(&mut self, trajectory: &Trajectory, config: &FollowConfig) -> Result<FollowRun<'_>, Error> {
        FollowRun::begin(self.led(), (trajectory, config), None)
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
    ) -> Result<FollowRun<'_>, Error> {
        let armed = SetPointGuard::new(&self.arm, &guard.into())?;
        FollowRun::begin(self.led(), (trajectory, config), Some(armed))
    }
}

#[cfg(feature = "stream")]
impl<S: MotionStatus> Robot<S> {
    /// Enters servo mode, in which the arm goes to targets and velocities that any thread may give at any time.
    ///
    /// It begins at rest, where the controller's own answer says that the joints are to be.
    ///
    /// # Errors
    /// As [`ServoSession`](crate::ServoSession) says at "Entering"; [`ErrorKind::NotChecked`] if the robot has no limits, by which a stream knows the arm,
    /// [`ErrorKind::NotShown`] if packets do not show the joints, by which it is known whether they follow, [`ErrorKind::BeyondLimit`] if the arm is beyond a limit, and
    /// [`ErrorKind::InvalidOption`] if the configuration has a value that it does not take, such as dynamics beyond the
    /// limits.
    pub fn stream(&mut self, config: &StreamConfig) -> Result<Stream<'_>, Error> {
        Stream::begin(self.led(), config, None)
    }

    /// The same under a guard: when it trips, the stream lands, and ends with [`ErrorKind::GuardTripped`]. The first set-point that brakes
    /// goes out in the next servo period after the packet.
    ///
    /// [`Guard`] tells what can be expected of that, and what not: it is **not a safety function**.
    ///
    /// # A limit of force
    /// Under a [`ForceLimit`](crate::ForceLimit) the stream is slow. The tool is never faster than with a speed that uses up the overtravel in the time for which it goes on unbraked and 0.1 s (ours), and
    /// from each set-point on it lands within the rest of the overtravel. So it is on the way to any target; a velocity of the tool that is faster is refused, with that speed as the limit
    /// ([`Generator::with_tool_stop`](jaka_motion::Generator::with_tool_stop)). It lands also where packets stay away for three of their periods, 100 ms at least.
    ///
    /// # Errors
    /// As [`stream`](Self::stream). Nothing that moves the arm was sent after [`ErrorKind::GuardTripped`] (the guard trips by the newest packet already),
    /// [`ErrorKind::NotShown`] (packets do not show what it needs), [`ErrorKind::StatusUnknown`], and [`ErrorKind::NotGuarded`] (too few packets have come to know their
    /// period).
    pub fn stream_until(&mut self, config: &StreamConfig, guard: impl Into<Guard>) -> Result<Stream<'_>, Error> {
        let armed = SetPointGuard::new(&self.arm, &guard.into())?;
        Stream::begin(self.led(), config, Some(armed))
    }
}
