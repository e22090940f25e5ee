//! Decision on braking by the first news of trouble.

use crate::{Error, ErrorKind, Outcome, StatusProblem};

/// What a session does with an arm at speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Braking {
    /// Set-points brake and hold the arm: they still reach a controller that follows them, or may.
    Land,
    /// No set-point goes out: none reaches the controller, or the controller follows none.
    Leave,
}

impl Braking {
    /// Decision on the first news; the cause is looked for afterwards. Each kind is named, so that a new one does not
    /// compile before it is decided.
    pub(super) fn after(error: &Error) -> Self {
        match error.kind() {
            ErrorKind::NotAcknowledged { outcome } => Self::after_outcome(outcome),
            ErrorKind::StatusUnknown { problem } => Self::after_problem(problem),
            // A refusal may be of one set-point alone: braking does not wait for the packet that says more.
            ErrorKind::Refused { .. }
            | ErrorKind::UnexpectedReply { .. }
            | ErrorKind::InvalidArgument(_)
            | ErrorKind::InvalidOption { .. }
            | ErrorKind::NotInFirmware(_)
            | ErrorKind::GuardTripped { .. }
            | ErrorKind::SetPointLate { .. }
            | ErrorKind::NotShown { .. }
            | ErrorKind::StatusTimeout { .. }
            | ErrorKind::UnexpectedStatus { .. }
            | ErrorKind::WaitEnded { .. }
            | ErrorKind::WaitBroken { .. }
            | ErrorKind::StateTimeout { .. }
            | ErrorKind::NotGuarded { .. }
            | ErrorKind::PortInAddress { .. }
            | ErrorKind::Thread { .. } => Self::Land,
            #[cfg(feature = "motion")]
            ErrorKind::BeyondLimit { .. } | ErrorKind::NotChecked { .. } | ErrorKind::ModelMismatch { .. } => {
                Self::Land
            }
            #[cfg(feature = "stream")]
            ErrorKind::Departed { .. } | ErrorKind::NotAtStart { .. } | ErrorKind::Trajectory { .. } => Self::Land,
            #[cfg(feature = "realtime")]
            ErrorKind::RealtimePriority { .. } => Self::Land,
            // A protective or an emergency stop that the newest packet shows.
            ErrorKind::NotReady { .. }
            // Set-points would accumulate, and move the arm later.
            | ErrorKind::SetPointsUnanswered { .. }
            | ErrorKind::Timeout { .. }
            | ErrorKind::NotSentInTime { .. }
            | ErrorKind::ReplyLost { .. }
            | ErrorKind::Connect { .. }
            | ErrorKind::Disconnected { .. }
            | ErrorKind::CommandsLost { .. }
            // The session has ended already.
            | ErrorKind::SessionEnded { .. }
            | ErrorKind::Stopped { .. }
            | ErrorKind::NotStopped { .. }
            | ErrorKind::ServoModeNotLeft { .. }
            | ErrorKind::RestNotSeen { .. }
            | ErrorKind::NotLanded { .. } => Self::Leave,
        }
    }

    fn after_outcome(outcome: &Outcome) -> Self {
        match outcome {
            // A stop of the program's own goes out once the arm is braked.
            Outcome::Stopped | Outcome::StatusLost { .. } => Self::Land,
            Outcome::ProtectiveStop
            | Outcome::EmergencyStop
            | Outcome::NotPowered
            | Outcome::NotEnabled
            | Outcome::ControllerError { .. }
            | Outcome::ConnectionLost { .. }
            | Outcome::Guard(_)
            | Outcome::Deadline
            | Outcome::Reached
            | Outcome::AtRest
            | Outcome::NoMotion => Self::Leave,
        }
    }

    /// Commands pass, whatever the status port does.
    fn after_problem(problem: &StatusProblem) -> Self {
        match problem {
            StatusProblem::Missing { .. }
            | StatusProblem::Stale { .. }
            | StatusProblem::Resuming
            | StatusProblem::Ended { .. }
            | StatusProblem::Reconnecting
            | StatusProblem::Unreadable { .. } => Self::Land,
        }
    }
}
