//! How a trajectory ended.

use std::error::Error as StdError;
use std::fmt;
use std::time::Duration;

use super::FollowProgress;
use crate::worded::worded;
use crate::{Error, ErrorKind, FollowLag, Outcome, ServoReport};

worded! {
    /// How the following of a trajectory ended.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[non_exhaustive]
    pub enum FollowOutcome {
        /// The arm is at rest at the end of the trajectory, as far as status packets can show that.
        Completed => "the trajectory was completed",
        /// It was stopped, by a handle or by a [`RobotStop`](crate::RobotStop).
        Stopped => "the trajectory was stopped before its end",
        /// It was not done by its deadline, and stopped along the trajectory.
        Deadline => "the trajectory was not done by its deadline, and was stopped",
        /// A guard has tripped, before the arm was at rest: [`FollowEnd::error`] has which, and the packet.
        Guard => "the trajectory was stopped by a guard",
        /// The controller refused a set-point.
        Refused => "the controller refused a set-point",
        /// The robot is in a protective stop.
        ProtectiveStop => "the robot is in a protective stop",
        /// The emergency stop is pressed.
        EmergencyStop => "the emergency stop is pressed",
        /// A set-point was too late: the machine was too busy ([`FollowConfig::max_gap`](crate::FollowConfig::max_gap)).
        Underrun => "a set-point was too late",
        /// A joint does not follow its set-points ([`FollowConfig::max_departure`](crate::FollowConfig::max_departure)).
        Departed => "a joint does not follow its set-points",
        /// The status is stale or cannot be read, or does not show the joints: it is not known whether the robot is stopped, or whether the joints follow.
        StatusLost => "the state of the robot is no longer known",
        /// The connection for commands is lost, or it stalls.
        LinkLost => "the connection for commands is lost or stalls",
        /// The last set-point is the end of the trajectory, and no status packet has shown the arm at rest there.
        RestNotSeen => "the arm was not seen at rest at the end of the trajectory",
        /// Something else, which the error says.
        Failed => "the trajectory could not be followed",
    }
}

impl FollowOutcome {
    /// What an error of the session means for a trajectory, where packets show this against it. What is behind a refusal is what packets show.
    pub(super) fn of(error: &Error, shown: Option<&Outcome>) -> Self {
        match shown {
            Some(Outcome::ProtectiveStop) => Self::ProtectiveStop,
            Some(Outcome::EmergencyStop) => Self::EmergencyStop,
            _ if error.is_disconnected() => Self::LinkLost,
            _ => Self::of_kind(error.kind()),
        }
    }

    fn of_kind(kind: &ErrorKind) -> Self {
        match kind {
            ErrorKind::RestNotSeen { first: Some(first), .. }
            | ErrorKind::NotLanded { first, .. }
            | ErrorKind::ServoModeNotLeft { first: Some(first), .. } => Self::of_kind(first.kind()),
            ErrorKind::RestNotSeen { first: None, .. } => Self::RestNotSeen,
            ErrorKind::ServoModeNotLeft { first: None, leaving } => Self::of_kind(leaving.kind()),
            ErrorKind::NotAcknowledged { outcome: Outcome::Stopped } => Self::Stopped,
            ErrorKind::GuardTripped { .. } => Self::Guard,
            ErrorKind::Refused { .. } => Self::Refused,
            ErrorKind::SetPointLate { .. } => Self::Underrun,
            ErrorKind::Departed { .. } => Self::Departed,
            ErrorKind::NotAcknowledged { outcome: Outcome::StatusLost { .. } }
            | ErrorKind::StatusUnknown { .. }
            | ErrorKind::NotShown { .. } => Self::StatusLost,
            ErrorKind::SetPointsUnanswered { .. } => Self::LinkLost,
            _ => Self::Failed,
        }
    }
}

/// The end of a trajectory, with what led to it.
#[derive(Debug)]
#[non_exhaustive]
#[must_use = "a trajectory may have ended before its end"]
pub struct FollowEnd {
    /// How it ended.
    pub outcome: FollowOutcome,
    /// The trajectory time of the last set-point on the trajectory.
    pub reached: Duration,
    /// How long the trajectory takes at its own speed.
    pub duration: Duration,
    /// True if the arm was braked straight on in joint space, and so off the trajectory, because braking along it would have taken too long: see
    /// [`FollowRun`](crate::FollowRun). So it is, at speed, also where the run's own thread has panicked.
    pub has_left_curve: bool,
    /// How the arm followed, by status packets; none if these do not tell.
    pub lag: Option<FollowLag>,
    /// What the servo session did, with the lateness of set-points.
    pub report: ServoReport,
    /// What ended it, where it was not its end, a handle or the deadline.
    pub error: Option<Error>,
}

impl FollowEnd {
    /// Of a run of which nothing more is known.
    pub(super) fn lost(error: Error, progress: &FollowProgress) -> Self {
        Self {
            outcome: FollowOutcome::Failed,
            reached: progress.time,
            duration: progress.duration,
            // What ends the thread ends the session, straight on.
            has_left_curve: progress.rate > 0.0,
            lag: None,
            report: ServoReport::default(),
            error: Some(error),
        }
    }

    /// `Ok` if the arm is at rest at the end of the trajectory, and this as an error otherwise.
    ///
    /// # Errors
    /// It ended otherwise.
    pub fn completed(self) -> Result<(), NotCompleted> {
        if self.outcome == FollowOutcome::Completed { Ok(()) } else { Err(NotCompleted(Box::new(self))) }
    }

    /// True if packets have shown the arm at rest at its last set-point. False where that is not known: look at the arm then.
    pub fn is_at_rest(&self) -> bool {
        self.report.rest_was_seen
    }
}

/// In one line: how far it got, whether the arm is at rest, and the cause.
impl fmt::Display for FollowEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.outcome)?;
        if self.outcome != FollowOutcome::Completed {
            let rest = if self.is_at_rest() { "is at rest" } else { "was not seen at rest" };
            let (reached, duration) = (self.reached.as_secs_f64(), self.duration.as_secs_f64());
            write!(f, " ({reached:.3} s of {duration:.3} s), and the arm {rest}")?;
        }
        self.error.as_ref().map_or(Ok(()), |error| write!(f, ": {error}"))
    }
}

/// A trajectory that was not completed, as an error.
#[derive(Debug)]
pub struct NotCompleted(Box<FollowEnd>);

impl NotCompleted {
    /// How it ended, with what led to it.
    pub fn end(&self) -> &FollowEnd {
        &self.0
    }
}

impl fmt::Display for NotCompleted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl StdError for NotCompleted {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        self.0.error.as_ref().and_then(StdError::source)
    }
}
