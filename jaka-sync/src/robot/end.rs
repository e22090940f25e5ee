//! Ends of motions.

use std::error::Error as StdError;
use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use crate::{Cause, Error, GuardTrip, Outcome, Snapshot, TripReason};

/// The end of a motion, with what led to it.
#[derive(Debug)]
#[non_exhaustive]
#[must_use = "a motion may have ended before its target"]
pub struct MotionEnd {
    /// How it ended.
    pub outcome: Outcome,
    /// How long the call waited.
    pub waited: Duration,
    /// The last packets, up to ten, the newest last.
    pub packets: Vec<Arc<Snapshot>>,
    /// Why the query for the position failed, if it did: then the outcome is not [`Outcome::Reached`].
    pub not_answered: Option<Error>,
    /// Of a motion under a guard: the stop that was sent, because the guard tripped or because nobody would have judged it any longer. An error if the controller
    /// has not accepted it: the arm may still move. None where none was sent.
    pub stop: Option<Result<(), Error>>,
}

impl MotionEnd {
    /// Cause of the end, which is the same in each way of moving.
    pub fn cause(&self) -> Cause {
        let of = |error: Option<&Error>| error.map_or(Cause::Reached, Error::cause);
        let stop = self.stop.as_ref().and_then(|stop| stop.as_ref().err());
        self.outcome.cause().min(of(self.not_answered.as_ref())).min(of(stop))
    }

    /// `Ok` if the arm is where it was sent, and this as an error otherwise.
    ///
    /// # Errors
    /// The motion ended otherwise, or its target is not known.
    pub fn reached(self) -> Result<(), NotReached> {
        if self.outcome.is_reached() { Ok(()) } else { Err(NotReached(Box::new(self))) }
    }

    /// The trip, if the guard has ended the motion, or kept it from being sent, because one of its conditions holds; and this as an error otherwise.
    ///
    /// # Errors
    /// The motion ended otherwise, a packet could not be judged, or the controller has not accepted the stop.
    pub fn guarded(self) -> Result<Arc<GuardTrip>, NotReached> {
        match &self.outcome {
            Outcome::Guard(trip) if trip.reason == TripReason::Holds && !matches!(self.stop, Some(Err(_))) => {
                Ok(Arc::clone(trip))
            }
            _ => Err(NotReached(Box::new(self))),
        }
    }

    /// `Ok` if the arm is at rest and nothing shows that it is not where it was sent; for motions whose target is
    /// not known, such as relative ones in a queue.
    ///
    /// # Errors
    /// The motion ended otherwise.
    pub fn at_rest(self) -> Result<(), NotReached> {
        if self.outcome.is_at_rest() { Ok(()) } else { Err(NotReached(Box::new(self))) }
    }
}

/// The fact: how it ended, and what became of the stop and of the query for the position.
impl fmt::Display for MotionEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.cause().fmt_with(&self.outcome.to_string(), f)?;
        if self.stop.is_none() && self.outcome.consequence().may_move() {
            f.write_str("; the arm may still move")?;
        }
        match &self.stop {
            Some(Ok(())) => f.write_str("; the arm was told to stop")?,
            Some(Err(error)) => {
                write!(f, "; the stop that followed was not accepted, so the arm may still move: {error}")?;
            }
            None => {}
        }
        match &self.not_answered {
            Some(error) => write!(f, "; the query for its position failed: {error}"),
            None => Ok(()),
        }
    }
}

/// A motion that did not end at its target, as an error.
#[derive(Debug)]
pub struct NotReached(Box<MotionEnd>);

impl NotReached {
    /// How the motion ended, with what led to it.
    pub fn end(&self) -> &MotionEnd {
        &self.0
    }
}

/// The fact and the remedy.
impl fmt::Display for NotReached {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)?;
        match self.0.stop {
            Some(Ok(())) => Ok(()),
            None | Some(Err(_)) => self.0.cause().remedy().append(f),
        }
    }
}

impl StdError for NotReached {
    fn source(&self) -> Option<&(dyn StdError + 'static)> {
        let not_answered = self.0.not_answered.as_ref();
        self.0.outcome.source().or_else(|| not_answered.and_then(StdError::source))
    }
}
