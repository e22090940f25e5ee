//! A guard that has tripped.

use std::fmt;
use std::sync::Arc;
use std::time::Duration;

use super::remedy::Remedy;
use super::table::Cause;
use super::unknown::NotShown;
use crate::Snapshot;
#[cfg(feature = "serde")]
use crate::form;

/// Trip of a guard, and its consequences.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct GuardTrip {
    /// Index of the guard's condition that tripped: 0 for the first.
    pub condition: usize,
    /// The condition in words.
    pub text: String,
    /// Reason for the trip: the condition holds, or it cannot be judged.
    pub reason: TripReason,
    /// The packet that tripped it.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub packet: Arc<Snapshot>,
    /// From the arrival of the packet until the stop had been written, for a motion. None where no stop was written:
    /// nothing had been sent by then ([`is_before_start`](Self::is_before_start)), it could not be written, or a stream
    /// landed.
    #[cfg_attr(feature = "serde", serde(rename = "reaction_s", serialize_with = "form::some_seconds"))]
    pub reaction: Option<Duration>,
    /// True if nothing was sent, because the guard had tripped before the motion went out.
    pub is_before_start: bool,
    /// True if the arm was then seen at rest, by two answers of the controller that agree.
    pub is_at_rest: bool,
    /// Lag of the arm behind its set-points, if the tripped condition is a [`ForceLimit`](crate::ForceLimit) whose
    /// reaction is shorter, or perhaps shorter, than the lag: the path of the tool may have been longer than the
    /// overtravel. Measured in streams and trajectories under such a limit.
    pub lag: Option<LagBeyondReaction>,
}

/// Lag of an arm that is longer than the reaction of a limit of force, or perhaps longer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct LagBeyondReaction {
    /// Delay from sending a set-point to the packet that shows the arm there.
    #[cfg_attr(feature = "serde", serde(rename = "lag_s", serialize_with = "form::seconds"))]
    pub lag: Duration,
    /// True if the delay was at least [`lag`](Self::lag), the longest one that is measured, and may have been longer.
    pub is_lower_bound: bool,
    /// The limit's reaction ([`ForceLimit::reaction`](crate::ForceLimit::reaction)).
    #[cfg_attr(feature = "serde", serde(rename = "reaction_s", serialize_with = "form::seconds"))]
    pub reaction: Duration,
}

impl fmt::Display for LagBeyondReaction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { lag, reaction, .. } = self;
        let at_least = if self.is_lower_bound { "at least " } else { "" };
        let perhaps = if lag > reaction { "" } else { "perhaps " };
        write!(
            f,
            "the arm lagged {at_least}{lag:?} behind its set-points, {perhaps}longer than the limit's reaction of \
             {reaction:?}: the tool may have moved further than the overtravel"
        )
    }
}

/// Reason why a guard has tripped.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum TripReason {
    /// The condition holds.
    Holds,
    /// The packet lacks the values of the condition.
    NotShown(NotShown),
    /// The question of the user's own panicked.
    Panicked,
}

#[cfg(feature = "serde")]
impl serde::Serialize for TripReason {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        #[serde(tag = "kind", rename_all = "snake_case")]
        enum Form<'r> {
            Holds,
            NotShown { reason: &'r NotShown },
            Panicked,
        }
        let form = match self {
            Self::Holds => Form::Holds,
            Self::NotShown(reason) => Form::NotShown { reason },
            Self::Panicked => Form::Panicked,
        };
        form.serialize(serializer)
    }
}

impl GuardTrip {
    /// Cause: a packet that cannot be read trips each guard, and is none of its conditions.
    pub fn cause(&self) -> Cause {
        match self.reason {
            TripReason::Holds | TripReason::Panicked => Cause::Guard,
            TripReason::NotShown(_) if self.packet.unreadable().is_some() => Cause::StatusLost,
            TripReason::NotShown(_) => Cause::NotShown,
        }
    }

    /// Remedy for a condition that could not be evaluated, or for a lag beyond the reaction.
    pub fn remedy(&self) -> Remedy {
        match (&self.reason, &self.lag) {
            (TripReason::NotShown(reason), _) if self.cause() == Cause::NotShown => reason.remedy(),
            (TripReason::Holds | TripReason::Panicked, Some(_)) => Remedy::LengthenReaction,
            (TripReason::Holds | TripReason::Panicked, None) | (TripReason::NotShown(_), _) => self.cause().remedy(),
        }
    }

    /// Marks the trip as one before the start: nothing was sent.
    pub(crate) fn before_start(self) -> Self {
        Self { is_before_start: true, ..self }
    }
}

impl fmt::Display for GuardTrip {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.reason {
            TripReason::Holds => write!(f, "{}", self.text)?,
            TripReason::NotShown(reason) => write!(f, "it is not known whether {}: {reason}", self.text)?,
            TripReason::Panicked => write!(f, "a panic in the code that checks whether {}", self.text)?,
        }
        if self.is_before_start {
            f.write_str("; nothing was sent")?;
        }
        self.lag.as_ref().map_or(Ok(()), |lag| write!(f, "; {lag}"))
    }
}
