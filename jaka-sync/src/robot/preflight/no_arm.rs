//! In place of `arm.rs` without the feature `motion`: the arm's model is not known.

use super::commands::Commands;
use super::finding::Finding;
use crate::{MotionStatus, Robot};

#[derive(Debug, Clone, Default)]
pub(super) struct Expected(());

#[expect(clippy::unused_self, reason = "it has limits with the feature")]
impl<S: MotionStatus> Robot<S> {
    pub(super) fn expected(&self) -> Expected {
        Expected(())
    }
}

pub(super) fn read(_expected: &Expected, _commands: &mut Commands<'_>, _findings: &mut Vec<Finding>) {}
