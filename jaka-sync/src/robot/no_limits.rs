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

#[derive(Debug, Default)]
pub(crate) struct SetPoints(());

impl SetPoints {
    pub(crate) fn at(_start: JointPosition) -> Self {
        Self(())
    }

    pub(crate) fn sent(&mut self, _joints: Option<JointPosition>) {}

    pub(crate) fn paused(&mut self) {}
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

    pub(crate) fn prepare_set_points(&mut self, _start: JointPosition, _timeout: Duration) -> Result<(), Error> {
        Ok(())
    }

    pub(crate) fn check_joints(
        &mut self,
        _before: &SetPoints,
        target: Option<JointPosition>,
        _period: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        Ok(target)
    }

    pub(crate) fn check_pose(
        &mut self,
        _before: &SetPoints,
        _target: Option<Pose>,
        _period: Duration,
    ) -> Result<Option<JointPosition>, Error> {
        Ok(None)
    }
}
