//! In place of `limits.rs` without the feature `motion`: no robot has limits.
#![allow(clippy::unused_self, clippy::unnecessary_wraps, reason = "the interface is that of `limits.rs`")]

use std::time::Duration;

use jaka_proto::messages::types::{JointPosition, Pose};

use super::batch::Begin;
use super::{MotionStatus, Robot};
use crate::{Error, Explanation, Motion};

#[derive(Debug, Default)]
pub(super) struct Checks(());

impl Checks {
    pub(super) fn forget_plan(&mut self) {}

    pub(super) fn unsettle(&mut self) {}
}

impl<S: MotionStatus> Robot<S> {
    pub(super) fn check_limits<M: Motion>(
        &mut self,
        _motion: &M,
        _begin: &Begin,
        _timeout: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        Ok(None)
    }

    pub(super) fn plan(&mut self, _end: Option<JointPosition>) {}

    pub(super) fn limit_explanation(&self) -> Option<Explanation> {
        None
    }

    pub(crate) fn prepare_set_points(
        &mut self,
        _start: JointPosition,
        _pose: Option<Pose>,
        _timeout: Duration,
    ) -> Result<(), Error> {
        Ok(())
    }

    pub(crate) fn refuses_beyond_limits(&self) -> bool {
        false
    }

    pub(crate) fn joint_accelerations(&self) -> Option<[f64; 6]> {
        None
    }

    pub(crate) fn check_joints(
        &mut self,
        _before: Option<[JointPosition; 2]>,
        target: Option<JointPosition>,
        _period: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        Ok(target)
    }

    pub(crate) fn check_pose(
        &mut self,
        _before: Option<[JointPosition; 2]>,
        _target: Option<Pose>,
        _period: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        Ok(None)
    }
}
