//! Set-points of a servo session, each checked before it is sent.

use std::time::Duration;

use jaka_proto::Command;
use jaka_proto::messages::servo::{ServoJ, ServoP, SetServoMode};
use jaka_proto::messages::types::{JointPosition, Pose};

use super::Unchecked;
use crate::robot::target::{Place, Quantity};
use crate::{Error, MotionStatus, Robot};

/// The last two set-points of a session, in joint positions: none where they are not known, or the robot has no limits.
#[derive(Debug, Default)]
pub(crate) struct SetPoints(Option<[JointPosition; 2]>);

impl SetPoints {
    /// Of a session that begins at rest.
    pub(crate) fn at(start: JointPosition) -> Self {
        Self(Some([start; 2]))
    }

    /// No set-point came when one was due: the next one starts from standstill.
    pub(crate) fn paused(&mut self) {
        self.0 = self.0.map(|[_, last]| [last; 2]);
    }

    /// The next one has been sent.
    pub(crate) fn sent(&mut self, joints: Option<JointPosition>) {
        self.0 = self.0.zip(joints).map(|([_, last], joints)| [last, joints]);
    }
}

impl<S: MotionStatus> Robot<S> {
    /// Before servo mode is used: the checker's frames are the controller's.
    pub(crate) fn prepare_set_points(&mut self, start: JointPosition, timeout: Duration) -> Result<(), Error> {
        let Some(limited) = &mut self.checks.0 else { return Ok(()) };
        limited.warning = None;
        let name = SetServoMode::INFO.name;
        let framed = match self.place(Quantity::Pose, timeout)? {
            Some(Place::Pose(pose)) => self.follow_frames(start, pose, name, timeout),
            _ => Err(self.not_checked(name, Unchecked::Start)),
        };
        framed.or_else(|error| self.judged(error))
    }

    /// Checks a set-point of the joints.
    pub(crate) fn check_joints(
        &mut self,
        before: &SetPoints,
        target: Option<JointPosition>,
        period: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        let Some(checker) = self.limits() else { return Ok(target) };
        let error = match (before.0, target) {
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
        before: &SetPoints,
        target: Option<Pose>,
        period: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        let Some(checker) = self.limits() else { return Ok(None) };
        let (error, joints) = match (before.0, target) {
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
