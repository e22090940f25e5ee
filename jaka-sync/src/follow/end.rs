//! How a trajectory ended.

use std::error::Error as StdError;
use std::fmt;
use std::time::Duration;

use super::FollowProgress;
use crate::{Cause, Error, ErrorKind, FollowLag, ServoReport};

/// The end of a trajectory, with what led to it.
#[derive(Debug)]
#[non_exhaustive]
#[must_use = "a trajectory may have ended before its end"]
pub struct FollowEnd {
    /// Cause of the end: [`Cause::Reached`] for a trajectory that was completed.
    pub cause: Cause,
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
            cause: error.cause(),
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
        if self.cause == Cause::Reached { Ok(()) } else { Err(NotCompleted(Box::new(self))) }
    }

    /// True if packets have shown the arm at rest at its last set-point. False where that is not known: look at the arm then.
    pub fn is_at_rest(&self) -> bool {
        self.report.rest_was_seen
    }
}

/// The fact, in one line: what ended it, how far it got, and whether the arm is at rest.
impl fmt::Display for FollowEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.error.as_ref().map(Error::kind) {
            None => self.cause.fmt(f)?,
            // Another set-point was not sent, which the end says.
            Some(ErrorKind::NotAcknowledged { outcome }) => self.cause.fmt_with(&outcome.to_string(), f)?,
            Some(ErrorKind::NotReady { explanation }) => self.cause.fmt_with(&explanation.to_string(), f)?,
            Some(ErrorKind::Refused { refusal, .. }) => self.cause.fmt_with(&refusal.to_string(), f)?,
            Some(kind) => self.cause.fmt_with(&kind.to_string(), f)?,
        }
        if self.cause == Cause::Reached {
            return Ok(());
        }
        let rest = if self.is_at_rest() { "is at rest" } else { "was not seen at rest" };
        let (reached, duration) = (self.reached.as_secs_f64(), self.duration.as_secs_f64());
        write!(f, " ({reached:.3} s of {duration:.3} s of the trajectory), and the arm {rest}")
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

/// The fact and the remedy.
impl fmt::Display for NotCompleted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)?;
        self.0.cause.remedy().append(f)
    }
}

impl StdError for NotCompleted {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        self.0.error.as_ref().and_then(StdError::source)
    }
}
