//! A guard of set-points, evaluated in each cycle.

use std::time::Duration;

use jaka_motion::{Checker, Follower};
use jaka_proto::Command;
use jaka_proto::messages::servo::ServoJ;

use super::{Armed, ForceLimit, Guard, packet_period};
use crate::arm::{Arm, ArmState, unknown};
use crate::{Error, ErrorKind, GuardTrip, LagBeyondReaction, NotGuarded, StatusProblem, TripReason};

/// A guard of set-points: evaluated in each cycle, without a wait.
#[derive(Debug)]
pub(crate) struct SetPointGuard {
    armed: Armed,
    force: Option<Force>,
    depends_on_frames: bool,
}

/// Lag of an arm behind its set-points, as far as it is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct MeasuredLag {
    pub(crate) delay: Duration,
    /// True for the longest delay that is measured: the lag may be longer.
    pub(crate) is_lower_bound: bool,
}

/// The limits of force in a guard.
#[derive(Debug)]
struct Force {
    /// Limit of each condition of the guard, in their order; none for a condition of another kind.
    limits: Vec<Option<ForceLimit>>,
    /// The longest time between two of the last packets.
    period: Duration,
}

/// Part of the overtravel for braking: the path of the tool at its highest speed in this time, in seconds. Ours.
const BRAKING_S: f64 = 0.05;

impl SetPointGuard {
    /// Arms a guard for set-points, if there is one. Fails if it has tripped already or cannot be judged.
    pub(crate) fn arm(arm: &Arm, guard: Option<&Guard>) -> Result<Option<Self>, Error> {
        let Some(guard) = guard else { return Ok(None) };
        guard.check()?;
        arm.check_acknowledged()?;
        let patience = arm.state.stale_after();
        let no_status = |problem| arm.attach(unknown(problem));
        arm.state.status_within(patience).map_err(no_status)?;
        let force = if guard.force_limits().next().is_none() {
            None
        } else {
            let limits = guard.force_limit_of_each().map(Option::<&_>::copied).collect();
            let period =
                packet_period(arm, Duration::MAX).ok_or_else(|| arm.attach(not_guarded(NotGuarded::PeriodUnknown)))?;
            Some(Force { limits, period })
        };
        let armed = Armed::new(guard, &arm.state, patience).map_err(no_status)?;
        match armed.trip() {
            None => Ok(Some(Self { armed, force, depends_on_frames: guard.depends_on_frames() })),
            Some(GuardTrip { reason: TripReason::NotShown(reason), .. }) => {
                Err(arm.attach(ErrorKind::NotShown { what: guard.to_string(), reason }))
            }
            Some(trip) => Err(arm.attach(trip.before_start())),
        }
    }

    /// Fails once the guard has tripped, or its status is unknown, also if the program has allowed motion without
    /// status; under a limit of force also after packets have stayed away too long.
    ///
    /// `lag` is the lag of the arm behind its set-points; a trip reports it if it is too long.
    pub(crate) fn check(&self, state: &ArmState, lag: impl FnOnce() -> Option<MeasuredLag>) -> Result<(), Error> {
        self.check_tripped(lag)?;
        let age = state.fresh_status().map_err(unknown)?.age();
        let fresh_for = self.force.as_ref().map_or(Duration::MAX, |force| super::longest_silence(force.period));
        if age > fresh_for { Err(unknown(StatusProblem::Stale { age })) } else { Ok(()) }
    }

    /// Fails once the guard has tripped.
    pub(crate) fn check_tripped(&self, lag: impl FnOnce() -> Option<MeasuredLag>) -> Result<(), Error> {
        match (self.armed.trip(), self.armed.broken()) {
            (Some(trip), _) => {
                let lag = self.lag_beyond_reaction(trip.condition, lag);
                Err(GuardTrip { lag, ..trip }.into())
            }
            (None, Some(problem)) => Err(unknown(problem)),
            (None, None) => Ok(()),
        }
    }

    /// Lag of the arm, if a limit of force has tripped whose reaction is shorter, or perhaps shorter.
    fn lag_beyond_reaction(
        &self,
        condition: usize,
        lag: impl FnOnce() -> Option<MeasuredLag>,
    ) -> Option<LagBeyondReaction> {
        let reaction = self.force.as_ref()?.limits.get(condition)?.as_ref()?.reaction;
        let MeasuredLag { delay, is_lower_bound } = lag()?;
        (delay > reaction || is_lower_bound).then_some(LagBeyondReaction { lag: delay, is_lower_bound, reaction })
    }

    /// Fails once the guard has tripped, before anything that moves the arm was sent.
    pub(crate) fn check_before_start(&self) -> Result<(), Error> {
        match self.armed.trip() {
            Some(trip) => Err(trip.before_start().into()),
            None => self.check_tripped(|| None),
        }
    }

    /// True if a condition is about the tool centre point, or may be.
    pub(crate) fn depends_on_frames(&self) -> bool {
        self.depends_on_frames
    }

    /// Fails if the path of the tool after a contact is too long somewhere on a trajectory.
    pub(crate) fn check_trajectory(&self, follower: &Follower, checker: &Checker) -> Result<(), Error> {
        let Some(force) = &self.force else { return Ok(()) };
        force.unbraked_s(follower.period_s()).try_for_each(|(limit, unbraked_s)| {
            let Some(worst) = follower.worst_overtravel(checker, unbraked_s, limit.overtravel_mm) else {
                return Ok(());
            };
            let way_points = follower.trajectory().way_points();
            let after = way_points.partition_point(|way_point| way_point.time_s <= worst.time_s);
            Err(not_guarded(limit.too_fast_along(after, &worst, force.period)))
        })
    }

    /// Highest speed of the tool, in mm/s, at which a limit of force leaves room to brake after a contact, and the path
    /// in mm that is left for braking; `None` without such a limit.
    pub(crate) fn tool_stop(&self, cycle_s: f64) -> Option<[f64; 2]> {
        let force = self.force.as_ref()?;
        let all = || force.unbraked_s(cycle_s);
        let speeds = all().map(|(limit, time_s)| limit.overtravel_mm / (time_s + BRAKING_S));
        let speed_mm_s = speeds.fold(f64::INFINITY, f64::min);
        let ways = all().map(|(limit, time_s)| limit.overtravel_mm - speed_mm_s * time_s);
        Some([speed_mm_s, ways.fold(f64::INFINITY, f64::min)])
    }

    /// Number of periods of so many seconds for which an arm must rest until a contact before is known.
    pub(crate) fn periods_unknown(&self, cycle_s: f64) -> u32 {
        let longest = self.force.iter().flat_map(|force| force.unbraked_s(cycle_s));
        let longest_s = longest.map(|(_, time_s)| time_s).fold(0.0, f64::max);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "what is beyond is cut")]
        let periods = (longest_s / cycle_s).ceil() as u32;
        periods
    }
}

impl Force {
    fn unbraked_s(&self, cycle_s: f64) -> impl Iterator<Item = (&ForceLimit, f64)> {
        self.limits.iter().flatten().map(move |limit| (limit, limit.unbraked_s(self.period, cycle_s)))
    }
}

fn not_guarded(reason: NotGuarded) -> Error {
    ErrorKind::NotGuarded { command: ServoJ::INFO.name.to_owned(), reason }.into()
}
