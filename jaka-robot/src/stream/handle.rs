//! Targets and velocities from any thread.

use std::sync::Arc;
use std::time::Duration;

use jaka_motion::{Bound, Generator, Goal, TcpVelocity};
use jaka_proto::messages::types::{JointPosition, Pose};

use super::target::Targets;
use crate::Error;
use crate::error::OptionName;
use crate::error::SessionEnd;
use crate::place::Quantity;
use crate::servo_session::beyond_limit;

/// Sets targets and velocities of a [`Stream`](super::Stream), from any thread. Each replaces the previous one at once,
/// and the arm changes over smoothly.
#[derive(Debug, Clone)]
pub struct StreamHandle {
    pub(super) targets: Arc<Targets>,
    /// Generator that checks goals; it makes no set-points.
    pub(super) desk: Arc<Generator>,
}

/// Longest time for which a velocity may be given.
const LONGEST: Duration = Duration::from_millis(500);

impl StreamHandle {
    /// Goes to these joint positions, which all joints reach at the same time, and stays there. In degrees.
    ///
    /// # Errors
    /// [`ErrorKind::BeyondLimit`](crate::ErrorKind::BeyondLimit) if the target is beyond a limit; the arm continues as
    /// before. [`ErrorKind::SessionEnded`](crate::ErrorKind::SessionEnded) if the stream lands or has ended.
    pub fn set_joints(&self, target: impl Into<JointPosition>) -> Result<(), Error> {
        self.give((Quantity::Joints, Goal::Joints(target.into())), None)
    }

    /// Goes to a pose of the tool centre point, and stays there. The arm moves in joints, on its present branch: the
    /// tool does **not** move on a straight line.
    ///
    /// Poses are in the tool and user frame that were selected when the stream began. Once status packets show another
    /// one, the stream lands, with [`Cause::FramesChanged`](crate::Cause::FramesChanged).
    ///
    /// # Errors
    /// As [`set_joints`](Self::set_joints); also if only another branch reaches the pose.
    pub fn set_pose(&self, target: impl Into<Pose>) -> Result<(), Error> {
        let found = self.desk.checker().joints_on_branch(self.joints(), target.into());
        self.give((Quantity::Pose, Goal::Joints(found.map_err(beyond_limit)?)), None)
    }

    /// Moves the joints with these speeds, in deg/s, for a time of at most 500 ms, and brakes then unless another goal
    /// was given.
    ///
    /// A joint stops at the end of its range. Give the velocity again for as long as it is wanted.
    ///
    /// # Errors
    /// [`ErrorKind::BeyondLimit`](crate::ErrorKind::BeyondLimit) if a joint may not be as fast,
    /// [`ErrorKind::InvalidOption`](crate::ErrorKind::InvalidOption) for a longer time,
    /// [`ErrorKind::SessionEnded`](crate::ErrorKind::SessionEnded) if the stream lands or has ended.
    pub fn set_joint_velocity(&self, deg_s: [f64; 6], for_at_most: Duration) -> Result<(), Error> {
        self.give((Quantity::Joints, Goal::Velocity(deg_s)), Some(for_at_most))
    }

    /// Moves the tool centre point with a velocity, for a time of at most 500 ms, and brakes then unless another goal
    /// was given.
    ///
    /// Once status packets show another tool or user frame than when the stream began, the stream lands, also after the
    /// velocity has ended and until another goal is given in joints.
    ///
    /// Near limits, regions and singularities all of it is scaled down together, to zero if need be: the tool slows
    /// down and keeps its direction.
    ///
    /// # Errors
    /// As [`set_joint_velocity`](Self::set_joint_velocity).
    pub fn set_tcp_velocity(&self, velocity: TcpVelocity, for_at_most: Duration) -> Result<(), Error> {
        self.give((Quantity::Pose, Goal::TcpVelocity(velocity)), Some(for_at_most))
    }

    /// Brakes the arm, and holds it.
    ///
    /// # Errors
    /// [`ErrorKind::SessionEnded`](crate::ErrorKind::SessionEnded) if the stream lands or has ended.
    pub fn rest(&self) -> Result<(), Error> {
        self.give((Quantity::Joints, Goal::Rest), None)
    }

    /// Joint positions of the last set-point, also while the stream lands and after its end. The arm lags behind them.
    pub fn joints(&self) -> JointPosition {
        self.targets.joints()
    }

    /// Bound that slows or holds the arm at the last set-point, beyond the speeds, accelerations and jerks of the
    /// stream: the reason for a missed goal or a lower speed. `None` without such a bound.
    pub fn bound(&self) -> Option<Bound> {
        self.targets.bound()
    }

    /// Waits until the set-points have reached the last target, or come to rest after a velocity, and says whether they
    /// have within `timeout`.
    ///
    /// # Errors
    /// [`ErrorKind::SessionEnded`](crate::ErrorKind::SessionEnded) if the stream lands or has ended.
    pub fn wait_for_rest(&self, timeout: Duration) -> Result<bool, Error> {
        self.targets.wait_for_rest(timeout).map_err(SessionEnd::into_error)
    }

    fn give(&self, (given_in, goal): (Quantity, Goal), for_at_most: Option<Duration>) -> Result<(), Error> {
        if let Some(time) = for_at_most.filter(|time| *time > LONGEST) {
            let expected = format!("at most {LONGEST:?}: give the velocity again before it expires");
            return Err(OptionName::new("StreamHandle", "for_at_most").refuse(format_args!("{time:?}"), expected));
        }
        self.desk.check_goal(&goal).map_err(beyond_limit)?;
        self.targets.give((given_in, goal), for_at_most).map_err(SessionEnd::into_error)
    }
}
