//! Why a command was refused.

use std::time::Duration;

use jaka_proto::messages::power::{GetRobotState, GetRobotStateReply};
use jaka_proto::{ErrorCode, Refusal};

use super::Arm;
use crate::Explanation;

/// How long the query may take that explains a refusal.
const PATIENCE: Duration = Duration::from_secs(1);

/// Reason for a refusal, as far as the state of the arm shows it.
pub(super) fn explain(arm: &mut Arm, refusal: &Refusal, timeout: Duration) -> Option<Explanation> {
    if refusal.code == ErrorCode::PERMISSION_DENIED {
        return Some(Explanation::NoRemoteControl);
    }
    let mut status = arm.state.fresh_packet().map(|newest| newest.status.clone()).unwrap_or_default();
    let state = arm.queries().call_within(&GetRobotState::new(), PATIENCE.min(timeout));
    (status.powered_on, status.enabled) = match &state {
        Ok(state) => (Some(state.powered_on), Some(state.enabled)),
        Err(_) => (None, None),
    };
    if let Ok(Some(event)) = state.as_ref().map_or(Ok(None), GetRobotStateReply::event) {
        status.error_code = Some(format!("{:#x}", event.code()));
    }
    Explanation::of(refusal, Some(&status))
}
