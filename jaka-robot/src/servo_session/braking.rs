//! Decision on braking by the first news of trouble.

use jaka_sync::layer::{Failure, StatusLoss};

use crate::cause::Occurrence;
use crate::{Cause, Error, ErrorKind, Evidence, StatusProblem};

/// Action of a session on an arm at speed.
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
            ErrorKind::NotAcknowledged { occurrence } => Self::after_occurrence(occurrence),
            ErrorKind::StatusUnknown { problem } => Self::after_problem(problem),
            ErrorKind::Connection(error) => Self::after_failure(Failure::of(error)),
            // A refusal may be of one set-point alone: braking does not wait for the packet that says more.
            ErrorKind::Refused { .. }
            | ErrorKind::InvalidOption { .. }
            | ErrorKind::GuardTripped { .. }
            | ErrorKind::SetPointLate { .. }
            | ErrorKind::NotShown { .. }
            | ErrorKind::WaitEnded { .. }
            | ErrorKind::WaitBroken { .. }
            | ErrorKind::NotGuarded { .. }
            | ErrorKind::FramesChanged { .. }
            | ErrorKind::PortInAddress { .. }
            | ErrorKind::BeyondLimit { .. }
            | ErrorKind::NotChecked { .. }
            | ErrorKind::ModelMismatch { .. }
            | ErrorKind::Departed { .. }
            | ErrorKind::NotAtStart { .. }
            | ErrorKind::NotAtRest { .. }
            | ErrorKind::Trajectory { .. }
            | ErrorKind::Thread { .. }
            | ErrorKind::RealtimePriority { .. } => Self::Land,
            // A protective or an emergency stop that the newest packet shows.
            ErrorKind::NotReady { .. }
            // Set-points would accumulate, and move the arm later.
            | ErrorKind::SetPointsUnanswered { .. }
            | ErrorKind::CommandsLost { .. }
            // The session has ended already.
            | ErrorKind::SessionEnded { .. }
            | ErrorKind::Stopped { .. }
            | ErrorKind::NotStopped { .. }
            | ErrorKind::NotReached { .. }
            | ErrorKind::ServoModeNotLeft { .. }
            | ErrorKind::RestNotSeen { .. }
            | ErrorKind::NotLanded { .. } => Self::Leave,
        }
    }

    fn after_failure(failure: Failure) -> Self {
        match failure {
            Failure::NotSent | Failure::Refused | Failure::UnfitReply | Failure::StatusLost | Failure::NotInState => {
                Self::Land
            }
            // Set-points would accumulate, and move the arm later.
            Failure::NotConnected | Failure::Unanswered | Failure::Reset | Failure::CommandsLost => Self::Leave,
        }
    }

    fn after_occurrence(occurrence: &Occurrence) -> Self {
        match occurrence.evidence {
            // The motion of another call was stopped.
            Evidence::Trip(_) => Self::Leave,
            Evidence::None
            | Evidence::Event { .. }
            | Evidence::Frames(_)
            | Evidence::Commands { .. }
            | Evidence::Status { .. } => Self::after_cause(occurrence.cause),
        }
    }

    fn after_cause(cause: Cause) -> Self {
        match cause {
            // A stop of the program's own goes out once the arm is braked.
            Cause::Stopped
            | Cause::StatusLost
            // Set-points of joints have no frame.
            | Cause::FramesChanged
            // Of one set-point, or of this program: the controller follows others.
            | Cause::Refused
            | Cause::NotShown
            | Cause::SetPointLate
            | Cause::Departed
            | Cause::BeyondLimit
            | Cause::NotAtStart
            | Cause::Failed => Self::Land,
            Cause::EmergencyStop
            | Cause::ProtectiveStop
            | Cause::CommandsLost
            | Cause::NotPowered
            | Cause::NotEnabled
            | Cause::ControllerError
            | Cause::SoftLimit
            | Cause::NoRemoteControl
            | Cause::ServoMode
            | Cause::Moving
            | Cause::Guard
            | Cause::Unanswered
            | Cause::Deadline
            | Cause::RestNotSeen
            | Cause::NoMotion
            | Cause::AtRest
            | Cause::Landed
            | Cause::Reached => Self::Leave,
        }
    }

    /// Commands pass, whatever the status port does.
    fn after_problem(problem: &StatusProblem) -> Self {
        match StatusLoss::of(problem) {
            StatusLoss::Silence | StatusLoss::Unreadable(_) | StatusLoss::Ended(_) => Self::Land,
        }
    }
}
