//! Why a command was refused.

use std::time::Duration;

use jaka_proto::messages::power::{GetRobotState, GetRobotStateReply};
use jaka_proto::{ErrorCode, Refusal};
use jaka_sync::layer::{MonitorParts as _, told};

use super::{MotionStatus, Robot};
use crate::{Error, ErrorKind, Explanation};

/// How long the query may take that explains a refusal.
const PATIENCE: Duration = Duration::from_secs(1);

impl<S: MotionStatus> Robot<S> {
    /// The same error, with the reason for a refusal if the robot's state shows it.
    pub(crate) fn explained(&mut self, mut error: Error, timeout: Duration) -> Error {
        let found = error.refusal().and_then(|refusal| self.explain_within(refusal, timeout));
        let found = found.or_else(|| self.limit_explanation());
        if let ErrorKind::Refused { explanation, .. } = error.kind_mut() {
            *explanation = found;
        }
        error
    }

    /// Why the controller refused a command of the [`client`](Self::client), as far as its state shows it, and what helps.
    ///
    /// Asks the controller whether the arm is powered and enabled (`get_robot_state`, 4.12): packets may be older than the
    /// refusal. Only packets show whether the robot is stopped; stale ones count for nothing. Refused motions of the robot itself are explained in their error:
    /// [`ErrorKind::Refused`].
    pub fn explain(&mut self, error: &jaka_sync::Error) -> Option<Explanation> {
        self.explain_within(error.refusal()?, PATIENCE.min(self.client.reply_timeout()))
    }

    fn explain_within(&mut self, refusal: &Refusal, timeout: Duration) -> Option<Explanation> {
        if refusal.code == ErrorCode::PERMISSION_DENIED {
            return Some(Explanation::NoRemoteControl);
        }
        let newest = self.monitor.fresh_packet().ok();
        let mut status = newest.and_then(|newest| told(&newest.status).ok()).unwrap_or_default();
        let state = self.client.call_within(&GetRobotState::new(), PATIENCE.min(timeout));
        (status.powered_on, status.enabled) = match &state {
            Ok(state) => (Some(state.powered_on), Some(state.enabled)),
            Err(_) => (None, None),
        };
        if let Ok(Some(event)) = state.as_ref().map_or(Ok(None), GetRobotStateReply::event) {
            status.error_code = Some(format!("{:#x}", event.code()));
        }
        Explanation::of(refusal, Some(&status))
    }
}
