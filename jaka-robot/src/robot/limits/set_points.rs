//! Set-points of a servo session, each checked before it is sent.

use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::messages::servo::{ServoJ, ServoP, SetServoMode};
use jaka_proto::messages::types::{JointPosition, Pose};

use super::LimitPolicy;
use crate::{Error, MotionStatus, Robot, Unchecked};

impl<S: MotionStatus> Robot<S> {
    /// Before servo mode is used: the checker's frames are the controller's.
    pub(crate) fn prepare_set_points(
        &mut self,
        start: JointPosition,
        pose: Option<Pose>,
        timeout: Duration,
    ) -> Result<(), Error> {
        let Some(limited) = &mut self.checks.0 else { return Ok(()) };
        limited.warning = None;
        let name = SetServoMode::INFO.name;
        let framed = match pose {
            Some(pose) => self.follow_frames(start, pose, name, timeout),
            None => Err(self.not_checked(name, Unchecked::Start)),
        };
        framed.or_else(|error| self.judged(error))
    }

    /// The greatest accelerations of the joints, in deg/s², if the robot has limits.
    pub(crate) fn joint_accelerations(&self) -> Option<[f64; 6]> {
        self.limits().map(|checker| *checker.limits().joint_accelerations())
    }

    /// True if the robot has limits, and sends nothing that is beyond them.
    pub(crate) fn refuses_beyond_limits(&self) -> bool {
        self.checks.0.as_ref().is_some_and(|limited| limited.policy == LimitPolicy::Refuse)
    }

    /// Checks a set-point of the joints, after the last two.
    pub(crate) fn check_joints(
        &mut self,
        before: Option<[JointPosition; 2]>,
        target: Option<JointPosition>,
        period: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        let Some(checker) = self.limits() else { return Ok(target) };
        let error = match (before, target) {
            (Some(before), Some(joints)) => match checker.check_set_point(before, joints, period.as_secs_f64()) {
                Ok(()) => return Ok(target),
                Err(beyond) => self.beyond_limit(ServoJ::INFO.name, beyond),
            },
            _ => self.not_checked(ServoJ::INFO.name, Unchecked::Start),
        };
        self.judged(error).map(|()| target)
    }

    /// Checks a set-point of the tool centre point, and returns its joint positions where they are known.
    pub(crate) fn check_pose(
        &mut self,
        before: Option<[JointPosition; 2]>,
        target: Option<Pose>,
        period: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        let Some(checker) = self.limits() else { return Ok(None) };
        let (error, joints) = match (before, target) {
            (Some(before), Some(pose)) => match checker.check_pose_set_point(before, pose, period.as_secs_f64()) {
                Ok(joints) => return Ok(Some(joints)),
                Err(beyond) => {
                    let flange = checker.frames().flange(pose);
                    let joints = checker.limits().model().inverse(flange, before[1]).ok();
                    (self.beyond_limit(ServoP::INFO.name, beyond), joints)
                }
            },
            (None, _) => (self.not_checked(ServoP::INFO.name, Unchecked::Start), None),
            (_, None) => (self.not_checked(ServoP::INFO.name, Unchecked::Target), None),
        };
        self.judged(error).map(|()| joints)
    }
}
