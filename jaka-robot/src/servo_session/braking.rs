//! Decision on braking by the first news of trouble.

use jaka_sync::layer::Failure;

use crate::cause::{Braking, Occurrence};
use crate::{Error, ErrorKind, Evidence};

/// Decision on the first news; the cause is looked for afterwards. Each kind is named, so that a new one does not
/// compile before it is decided.
pub(super) fn braking_after(error: &Error) -> Braking {
    match error.kind() {
        ErrorKind::NotSent { because, .. } => braking_after(because),
        ErrorKind::NotAcknowledged { occurrence }
        | ErrorKind::NotReady { occurrence }
        | ErrorKind::RobotState { occurrence } => after_occurrence(occurrence),
        ErrorKind::Connection(error) => after_failure(Failure::of(error)),
        // A refusal may be of one set-point alone: braking does not wait for the packet that says more. And commands
        // pass, whatever the status port does.
        ErrorKind::Refused { .. }
        | ErrorKind::StatusUnknown { .. }
        | ErrorKind::InvalidOption { .. }
        | ErrorKind::GuardTripped { .. }
        | ErrorKind::SetPointLate { .. }
        | ErrorKind::NotShown { .. }
        | ErrorKind::WaitEnded { .. }
        | ErrorKind::WaitBroken { .. }
        | ErrorKind::NotGuarded { .. }
        | ErrorKind::PortInAddress { .. }
        | ErrorKind::HasRobot
        | ErrorKind::BeyondLimit { .. }
        | ErrorKind::NotChecked { .. }
        | ErrorKind::ModelMismatch { .. }
        | ErrorKind::Departed { .. }
        | ErrorKind::NotAtStart { .. }
        | ErrorKind::NotAtRest { .. }
        | ErrorKind::Trajectory { .. }
        | ErrorKind::Thread { .. }
        | ErrorKind::RealtimePriority { .. } => Braking::Land,
        // Set-points would accumulate, and move the arm later.
        ErrorKind::SetPointsUnanswered { .. }
        | ErrorKind::CommandsLost { .. }
        // The session has ended already.
        | ErrorKind::SessionEnded { .. }
        | ErrorKind::Stopped { .. }
        | ErrorKind::NotStopped { .. }
        | ErrorKind::NotReached { .. }
        | ErrorKind::ServoModeNotLeft { .. }
        | ErrorKind::RestNotSeen { .. }
        | ErrorKind::NotLanded { .. } => Braking::Leave,
    }
}

fn after_failure(failure: Failure) -> Braking {
    match failure {
        Failure::NotSent | Failure::Refused | Failure::UnfitReply | Failure::StatusLost | Failure::NotInState => {
            Braking::Land
        }
        // Set-points would accumulate, and move the arm later.
        Failure::NotConnected | Failure::Unanswered | Failure::Reset | Failure::CommandsLost => Braking::Leave,
    }
}

fn after_occurrence(occurrence: &Occurrence) -> Braking {
    match occurrence.evidence {
        // The motion of another call was stopped.
        Evidence::Trip(_) => Braking::Leave,
        Evidence::None
        | Evidence::Event { .. }
        | Evidence::Frames(_)
        | Evidence::ServoMode { .. }
        | Evidence::Commands { .. }
        | Evidence::Status { .. } => occurrence.cause.braking(),
    }
}
