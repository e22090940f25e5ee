//! Ends of motions, servo sessions, streams and trajectories.

use std::error::Error as StdError;
use std::fmt;
use std::sync::Arc;

use super::Error;
use super::line::{Line, STOP_NOT_ACCEPTED, with_fact};
use crate::cause::Occurrence;
use crate::{Cause, CauseGroup, Evidence, GuardTrip, Remedy, Report, Snapshot, TripReason};

/// End of a motion, a servo session, a stream or a trajectory.
///
/// An event has the same [`cause`](Self::cause) in each kind of motion. [`reached`](Self::reached) turns an end into an
/// error, so that `?` works from the connection to the end of a motion.
///
/// # serde
/// With the feature `serde` an end is written as its `cause`, `text`, `phase`, `rest`, `evidence`, `error`, `stop` and
/// `report`, without its packets. `stop` is `null`, or has `is_accepted` and the `error`.
#[derive(Debug)]
#[non_exhaustive]
#[must_use = "a motion may have ended before its target"]
pub struct End {
    pub(crate) occurrence: Occurrence,
    /// Rest of the arm, as it was measured.
    pub rest: Rest,
    /// The last packets of a motion that the controller plans, up to ten, the newest last.
    pub packets: Vec<Arc<Snapshot>>,
    /// Error that came with the end: the error that ended a trajectory early, other than a stop by a handle or the
    /// deadline; or the failure of the query for the position of a planned motion, which is not
    /// [reached](Cause::Reached) then.
    pub error: Option<Error>,
    /// Stop that was sent at the end of a motion under a guard, because the guard tripped or because nobody would have
    /// judged it any longer. An error if the controller has not accepted it: the arm may still move. None where none
    /// was sent.
    pub stop: Option<Result<(), Error>>,
    /// Times, set-points, and the progress on a trajectory.
    pub report: Report,
}

/// Rest of an arm after a motion, as it was measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum Rest {
    /// Not seen: the arm may still brake, or move.
    NotSeen,
    /// Seen in status packets, which may be old.
    Packets,
    /// Seen in answers of the controller to queries after the motion, which agree.
    Answers,
}

/// Phase in which a call or a motion ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum Phase {
    /// Nothing that moves the arm was sent, or it did not run.
    NotSent,
    /// It was sent, and may have run.
    MayHaveRun,
    /// It has ended. The arm may still brake unless its rest was seen.
    Ended,
    /// The arm may still move.
    MayStillMove,
}

impl Rest {
    /// True if the arm was seen at rest.
    pub fn was_seen(self) -> bool {
        match self {
            Self::NotSeen => false,
            Self::Packets | Self::Answers => true,
        }
    }
}

impl End {
    /// End by this, and of the rest nothing.
    pub(crate) fn new(occurrence: impl Into<Occurrence>, rest: Rest, report: Report) -> Self {
        Self { occurrence: occurrence.into(), rest, packets: Vec::new(), error: None, stop: None, report }
    }

    /// Cause of the end, the first by [precedence](Cause#precedence) of all that is known.
    pub fn cause(&self) -> Cause {
        let of = |error: Option<&Error>| error.map_or(Cause::Reached, Error::cause);
        let stop = self.stop.as_ref().and_then(|stop| stop.as_ref().err());
        self.occurrence.cause.min(of(self.error.as_ref())).min(of(stop))
    }

    /// Evidence for the cause, besides the packets and the error.
    pub fn evidence(&self) -> &Evidence {
        &self.occurrence.evidence
    }

    /// Phase in which it ended.
    pub fn phase(&self) -> Phase {
        if self.occurrence.cause == Cause::NoMotion || self.is_before_start() {
            return Phase::NotSent;
        }
        let may_move = match (&self.stop, self.report.trajectory.is_some()) {
            (Some(accepted), _) => accepted.is_err(),
            (None, true) => !self.rest.was_seen(),
            (None, false) => self.occurrence.consequence().may_move(),
        };
        if may_move { Phase::MayStillMove } else { Phase::Ended }
    }

    /// Remedy for the cause. `None` after an accepted stop, except for an error in the evaluation of the guard.
    pub fn remedy(&self) -> Remedy {
        let stop = self.stop.as_ref().and_then(|stop| stop.as_ref().err());
        let leading = self.error.iter().chain(stop).min_by_key(|error| Error::cause(error));
        match (leading, self.occurrence.remedy()) {
            (Some(error), _) if error.cause() < self.occurrence.cause => error.remedy_of_event(),
            (Some(error), Remedy::SeeError) => error.remedy_of_event(),
            (_, remedy) if !matches!(self.stop, Some(Ok(()))) || self.trip().is_some() => remedy,
            _ => Remedy::None,
        }
    }

    /// `Ok` if the arm is at its target, and this end as an error otherwise.
    ///
    /// # Errors
    /// [`ErrorKind::NotReached`](crate::ErrorKind::NotReached): it ended otherwise, or its target is not known.
    pub fn reached(self) -> Result<(), Error> {
        if self.occurrence.cause == Cause::Reached { Ok(()) } else { Err(Error::not_reached(self)) }
    }

    /// `Ok` if the arm is at rest and nothing shows it away from its target: for motions with an unknown target, such
    /// as relative ones in a queue, and for landings.
    ///
    /// # Errors
    /// [`ErrorKind::NotReached`](crate::ErrorKind::NotReached): it ended otherwise.
    pub fn at_rest(self) -> Result<(), Error> {
        let cause = self.occurrence.cause;
        let is_done = cause.group() == CauseGroup::Done && cause != Cause::NoMotion;
        if is_done { Ok(()) } else { Err(Error::not_reached(self)) }
    }

    /// The trip, if the guard has ended the motion, or kept it from being sent, because one of its conditions holds;
    /// and this as an error otherwise.
    ///
    /// # Errors
    /// [`ErrorKind::NotReached`](crate::ErrorKind::NotReached): the motion ended otherwise, a packet could not be
    /// judged, or the controller has not accepted the stop.
    pub fn guarded(self) -> Result<Arc<GuardTrip>, Error> {
        let is_stopped = match &self.stop {
            Some(accepted) => accepted.is_ok(),
            None => true,
        };
        let trip = self.trip().filter(|trip| trip.reason == TripReason::Holds && is_stopped && !self.has_failed());
        trip.cloned().ok_or_else(|| Error::not_reached(self))
    }

    fn trip(&self) -> Option<&Arc<GuardTrip>> {
        if let Evidence::Trip(trip) = self.evidence() { Some(trip) } else { None }
    }

    /// True if an error of the controller may be behind the end, and packets never show one.
    fn may_hide_error(&self) -> bool {
        let is_as_told = matches!(self.occurrence.cause, Cause::Reached | Cause::Landed | Cause::NoMotion);
        !is_as_told && self.report.absent.contains(&"error_code")
    }

    fn is_before_start(&self) -> bool {
        self.trip().is_some_and(|trip| trip.is_before_start)
    }

    /// True if a trajectory ended by an error that is no trip of its guard alone.
    fn has_failed(&self) -> bool {
        self.report.trajectory.is_some() && self.error.as_ref().is_some_and(|error| !error.is_trip())
    }

    pub(super) fn source(&self) -> Option<&(dyn StdError + 'static)> {
        self.occurrence.source().or_else(|| self.error.as_ref().and_then(StdError::source))
    }

    /// Facts of a motion that the controller plans, and of the stop and the query for the position.
    fn planned(&self) -> String {
        let mut line = Line::of(self.occurrence.cause, self.occurrence.to_string());
        line = match &self.stop {
            Some(Ok(())) => line.followed_by("a stop was sent and accepted", None),
            Some(Err(error)) => line.followed_by(STOP_NOT_ACCEPTED, Some(error)),
            None if self.phase() == Phase::MayStillMove => line.followed_by("the arm may still move", None),
            None => line,
        };
        if let Some(error) = &self.error {
            line = line.followed_by("the query for its position failed", Some(error));
        }
        line.into_text()
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for End {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        struct Form<'e> {
            cause: Cause,
            text: String,
            phase: Phase,
            rest: Rest,
            evidence: &'e Evidence,
            error: Option<&'e Error>,
            stop: Option<Stop<'e>>,
            report: &'e Report,
        }
        #[derive(serde::Serialize)]
        struct Stop<'e> {
            is_accepted: bool,
            error: Option<&'e Error>,
        }
        let stop = self.stop.as_ref();
        let form = Form {
            cause: self.cause(),
            text: self.to_string(),
            phase: self.phase(),
            rest: self.rest,
            evidence: self.evidence(),
            error: self.error.as_ref(),
            stop: stop.map(|stop| Stop { is_accepted: stop.is_ok(), error: stop.as_ref().err() }),
            report: &self.report,
        };
        form.serialize(serializer)
    }
}

/// The fact, in one line: cause and evidence, the stop, the progress of a trajectory and the rest of its arm. For an
/// end away from the target, also that an error of the controller is invisible if packets have no error code.
impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.error {
            Some(error) if self.report.trajectory.is_some() => {
                f.write_str(&with_fact(self.cause(), error.kind().event()))?;
            }
            _ => f.write_str(&self.planned())?,
        }
        if let Some(trajectory) = self.report.trajectory.as_ref().filter(|_| self.occurrence.cause != Cause::Reached) {
            let rest = if self.rest.was_seen() { "is at rest" } else { "was not seen at rest" };
            let (reached, duration) = (trajectory.reached.as_secs_f64(), trajectory.duration.as_secs_f64());
            write!(f, " ({reached:.3} s of {duration:.3} s of the trajectory), and the arm {rest}")?;
        }
        if self.may_hide_error() {
            f.write_str("; status packets have no error code, so an error of the controller is not seen")?;
        }
        Ok(())
    }
}
