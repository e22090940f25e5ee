//! Servo sessions, streams and trajectories of a robot.

use std::time::Duration;

use jaka_motion::Trajectory;

use super::Robot;
#[cfg(doc)]
use crate::ErrorKind;
use crate::servo_session::ServoSession;
use crate::{End, Error, FollowConfig, FollowRun, MotionStatus, SessionConfig};
#[cfg(feature = "stream")]
use crate::{Stream, StreamConfig};

impl<S: MotionStatus> Robot<S> {
    /// Enters servo mode, in which set-points come one by one: waits until the controller is in it.
    ///
    /// # Errors
    /// As [`ServoSession`] says at "Entering".
    pub fn enter_servo_mode(&mut self, config: impl Into<SessionConfig>) -> Result<ServoSession<'_>, Error> {
        ServoSession::enter(self.led(), &config.into())
    }

    /// Follows a trajectory, and returns when the arm is at rest at its end, or why it is not. It stops along the
    /// trajectory where it is not done by the deadline.
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
    /// All of it is compared with the robot's limits before the first set-point, with the tool and the frames that the
    /// controller has now, whatever it was compared with before; also where the limits' policy is only to warn.
    ///
    /// # Errors
    /// Nothing moves the arm then. As [`ServoSession`](crate::ServoSession) says at "Entering";
    /// [`ErrorKind::NotChecked`] if the robot has no limits, [`ErrorKind::NotShown`] if packets do not show the joints,
    /// [`ErrorKind::Trajectory`] if the trajectory is beyond one, [`ErrorKind::NotAtStart`] if it starts elsewhere than
    /// where the controller's own answer says that the joints are to be, [`ErrorKind::BeyondLimit`] if the straight way
    /// in joint space to its start is beyond a limit, [`ErrorKind::InvalidOption`] if the configuration has a value
    /// that it does not take.
    pub fn start_follow(&mut self, trajectory: &Trajectory, config: &FollowConfig) -> Result<FollowRun<'_>, Error> {
        FollowRun::begin(self.led(), trajectory, config)
    }
}

#[cfg(feature = "stream")]
impl<S: MotionStatus> Robot<S> {
    /// Enters servo mode, in which the arm goes to targets and velocities that any thread may give at any time.
    ///
    /// It begins at rest, where the controller's own answer says that the joints are to be.
    ///
    /// # Errors
    /// As [`ServoSession`](crate::ServoSession) says at "Entering"; [`ErrorKind::NotChecked`] if the robot has no
    /// limits, by which a stream knows the arm, [`ErrorKind::NotShown`] if packets do not show the joints, by which it
    /// is known whether they follow, [`ErrorKind::BeyondLimit`] if the arm is beyond a limit, and
    /// [`ErrorKind::InvalidOption`] if the configuration has a value that it does not take, such as dynamics beyond the
    /// limits.
    pub fn stream(&mut self, config: &StreamConfig) -> Result<Stream<'_>, Error> {
        Stream::begin(self.led(), config)
    }
}
