//! Set-points along a trajectory, one a period, at a rate that may change at any time.

mod overtravel;

use jaka_proto::messages::types::JointPosition;

pub use self::overtravel::Overtravel;
use self::overtravel::Travel;
use crate::checker::Checker;
use crate::trajectory::{RateChange, Trajectory, TrajectoryError};

/// Makes one set-point a period along a [`Trajectory`]. It can pause, slow down, continue and stop on the curve at any
/// time.
///
/// Its trajectory time advances in each period by the *rate* times the period. The rate goes smoothly to the requested
/// scale: 1 for the trajectory's own speed, 0 for a standstill.
///
/// # What is promised
/// Whenever the scale changes, and however often:
/// - Each set-point is the trajectory's position at the trajectory time. So the arm moves along the curve and nowhere
///   else, also during a pause or a stop.
/// - The rate is from 0 to 1, so no joint is faster than in the trajectory.
/// - The second differences of the set-points, divided by the square of the period, are within the joint accelerations
///   of the limits if those of the trajectory are. [`Trajectory::rate_change`] gives the change of the rate that leaves
///   room for that, and each set-point is compared before it is returned.
/// - The rate's own change reaches that value in 0.1 s, a choice of this library. It falls faster only where the curve
///   leaves less room.
/// - By [`brake`](Self::brake) a joint that slows down may have the acceleration of stops
///   ([`Limits::stop_accelerations`](crate::Limits::stop_accelerations)).
///
/// Where a trajectory uses all of a joint's acceleration, the rate stays constant until the curve leaves room, except
/// for a brake. [`stopping`](Self::stopping) computes the duration of a stop.
///
/// Only `new` allocates. The follower shares the trajectory's pieces, and holds some hundred bytes in addition.
#[derive(Debug, Clone)]
pub struct Follower {
    trajectory: Trajectory,
    duration_s: f64,
    checker: Checker,
    period_s: f64,
    scale: f64,
    /// True if the rate changes within the accelerations of stops, and not of motions.
    brakes: bool,
    state: State,
    /// State at the previous set-point.
    before: State,
}

/// Progress along the trajectory.
#[derive(Debug, Clone, Copy)]
struct State {
    time_s: f64,
    rate: f64,
    /// Change of the rate in the last period.
    change: f64,
    joints: JointPosition,
    /// Distance of each joint from the previous set-point, in degrees.
    step: [f64; 6],
}

/// Look-ahead along a stop on the curve before it is made. Made by [`Follower::stopping`].
///
/// Each of its periods is computed as the set-point of that period is, in some microseconds. The number of periods
/// depends on the joint accelerations that the trajectory leaves, and can be all the rest of it. A caller with a
/// deadline in a servo period therefore looks ahead in each period by as many periods as it has time for.
#[derive(Debug, Clone)]
#[must_use = "it looks ahead as far as it is asked to"]
pub struct Stopping {
    follower: Follower,
    periods: u32,
}

/// Permitted periods of set-points, in seconds.
pub(crate) const PERIODS: std::ops::RangeInclusive<f64> = 0.001..=1.0;
/// Time in which the change of the rate reaches the value that the curve allows, in seconds.
const CHANGE_REACHED_S: f64 = 0.1;
/// Number of halvings of a change of the rate that is too much for a joint.
const HALVINGS: u32 = 16;
/// Rounding error that is allowed in an acceleration, in deg/s²: the joint positions have some 16 digits.
const ROUNDING: f64 = 1e-6;

impl Follower {
    /// Creates a follower for an arm at rest at the start of the trajectory, with a set-point each `period_s`, at the
    /// scale 1.
    ///
    /// It compares accelerations with those of the checker's limits.
    ///
    /// # Errors
    /// The period is not from 1 ms to 1 s.
    pub fn new(trajectory: Trajectory, checker: &Checker, period_s: f64) -> Result<Self, TrajectoryError> {
        if !PERIODS.contains(&period_s) {
            let expected = "from 0.001 to 1";
            return Err(TrajectoryError::Setting { what: "period_s", given: period_s, expected });
        }
        let state = State { time_s: 0.0, rate: 1.0, change: 0.0, joints: trajectory.start(), step: [0.0; 6] };
        let (duration_s, checker) = (trajectory.duration_s(), checker.clone());
        Ok(Self { trajectory, duration_s, checker, period_s, scale: 1.0, brakes: false, state, before: state })
    }

    /// Sets the requested scale of the trajectory's speed, from 0 for a pause to 1. Numbers beyond that count as 0 or
    /// 1, and not-a-number as 0.
    ///
    /// Before the first set-point the rate takes this value at once.
    pub fn set_scale(&mut self, scale: f64) {
        self.brakes = false;
        self.scale = if scale.is_nan() { 0.0 } else { scale.clamp(0.0, 1.0) };
        if self.state.time_s == 0.0 && self.state.change == 0.0 && self.state.step.iter().all(|step| *step == 0.0) {
            self.state.rate = self.scale;
        }
    }

    /// Requests a standstill by a stop, until the next scale is set.
    ///
    /// The arm brakes along the trajectory within the accelerations and jerks of stops, and at once by as much as the
    /// trajectory leaves of the accelerations of motions.
    pub fn brake(&mut self) {
        self.set_scale(0.0);
        self.brakes = true;
    }

    /// Returns the set-point a period after the last one.
    pub fn advance(&mut self) -> JointPosition {
        self.before = self.state;
        let [wanted, fallback] = self.wanted_changes();
        self.state = self.within_accelerations(wanted, fallback);
        self.state.joints
    }

    /// Reports that a set-point was missed: the next one starts from standstill at the last one.
    pub fn paused(&mut self) {
        (self.state.rate, self.state.change, self.state.step) = (0.0, 0.0, [0.0; 6]);
    }

    /// Reports that the last set-point was not sent: the next one follows the one before. Valid once after each
    /// [`advance`](Self::advance).
    pub fn take_back(&mut self) {
        self.state = self.before;
    }

    /// Returns the last set-point, or the start of the trajectory.
    pub fn joints(&self) -> JointPosition {
        self.state.joints
    }

    /// Returns the trajectory time of the last set-point, in seconds.
    pub fn time_s(&self) -> f64 {
        self.state.time_s
    }

    /// Returns the rate at which the trajectory time advances, from 0 to 1.
    pub fn rate(&self) -> f64 {
        self.state.rate
    }

    /// Whether the last set-point is the end of the trajectory.
    pub fn is_at_end(&self) -> bool {
        self.state.time_s >= self.duration_s
    }

    /// Whether the trajectory time does not advance: in a pause, after a stop, or at the end.
    pub fn is_at_rest(&self) -> bool {
        self.state.rate == 0.0 || self.is_at_end()
    }

    /// Returns the stop for a scale of 0 from now on, or for a brake if it [brakes](Self::brake) already.
    pub fn stopping(&self) -> Stopping {
        let mut follower = self.clone();
        follower.set_scale(0.0);
        follower.brakes = self.brakes;
        Stopping { follower, periods: 0 }
    }

    /// Returns the contact on the trajectory with the longest travel of the tool centre point after it, if that is
    /// longer than `allowed_mm`; `None` otherwise.
    ///
    /// A contact, and a call of [`brake`](Self::brake) `delay_s` after it, may follow any set-point. The computation
    /// uses the rate 1, which is the worst case. At a lower rate, also one that changes meanwhile, the tool has
    /// travelled less when it brakes, and rests sooner. If the tool travels further than is allowed before it brakes at
    /// all, the result is the contact for which that travel is the longest.
    ///
    /// It looks at each period of the trajectory, and at braking where bounds do not show that it is short enough. It
    /// allocates a number for each period. Not-a-number counts as an endless delay, and as no allowed distance.
    pub fn worst_overtravel(&self, checker: &Checker, delay_s: f64, allowed_mm: f64) -> Option<Overtravel> {
        let delay_s = if delay_s.is_nan() { f64::INFINITY } else { delay_s };
        Travel::new(self, checker, delay_s).worst(if allowed_mm.is_nan() { 0.0 } else { allowed_mm })
    }

    /// Returns the trajectory.
    pub fn trajectory(&self) -> &Trajectory {
        &self.trajectory
    }

    /// Returns the period in seconds.
    pub fn period_s(&self) -> f64 {
        self.period_s
    }

    /// Returns the wanted change of the rate in the next period, and the fallback if a joint does not allow it.
    fn wanted_changes(&self) -> [f64; 2] {
        let State { time_s, rate, .. } = self.state;
        let (from_s, to_s) = (time_s - rate * self.period_s, time_s + self.period_s);
        let RateChange { fall, rise, .. } = self.trajectory.rate_change(from_s, to_s, rate);
        // A change from 0 to 1 in one period is the greatest possible.
        let [fall, rise] = [fall, rise].map(|allowed| (allowed * self.period_s).min(1.0));
        if self.brakes {
            let at_once = -rate.min(fall);
            return [self.stop_change().min(at_once), at_once];
        }
        let most = if self.scale < rate { fall } else { rise };
        let wanted = self.change_within(most * (self.period_s / CHANGE_REACHED_S).min(1.0));
        [wanted.clamp(-fall, rise).clamp(-rate, 1.0 - rate), 0.0]
    }

    /// Returns the change of the rate for a stop along the trajectory.
    fn stop_change(&self) -> f64 {
        let State { rate, joints, step, .. } = &self.state;
        let velocity = step.map(|step| step / self.period_s);
        let stop = self.checker.stop_rates(&joints.0, &velocity, self.checker.limits().stop_jerks());
        let most = (stop.share * rate * self.period_s).min(1.0);
        self.change_within(most * (self.period_s / stop.ramp_s).min(1.0)).clamp(-most.min(*rate), 0.0)
    }

    /// Returns the change of the rate towards the scale that differs from the last change by no more than `jerk`.
    fn change_within(&self, jerk: f64) -> f64 {
        let State { rate, change, .. } = self.state;
        change_towards(self.scale - rate, jerk).clamp(change - jerk, change + jerk)
    }

    /// Returns the next state with the greatest change of the rate that keeps each joint within its acceleration.
    fn within_accelerations(&self, wanted: f64, fallback: f64) -> State {
        let next = self.changed(wanted);
        if self.fits(&next) {
            return next;
        }
        // At the same rate the accelerations are means of those of the trajectory.
        let (mut fitting, mut least, mut most) = (self.changed(0.0), 0.0, wanted);
        let sure = self.changed(fallback);
        if self.fits(&sure) {
            (fitting, least) = (sure, fallback);
        }
        for _ in 0..HALVINGS {
            let change = f64::midpoint(least, most);
            let next = self.changed(change);
            if self.fits(&next) {
                (fitting, least) = (next, change);
            } else {
                most = change;
            }
        }
        fitting
    }

    fn changed(&self, change: f64) -> State {
        let rate = self.state.rate + change;
        // Rounding leaves the rate next to its goal.
        let rate = if (rate - self.scale).abs() < 1e-12 { self.scale } else { rate };
        let time_s = (self.state.time_s + rate * self.period_s).min(self.duration_s);
        let joints = if time_s < self.duration_s { self.trajectory.at(time_s).joints } else { self.trajectory.end() };
        let step = std::array::from_fn(|joint| joints.0[joint] - self.state.joints.0[joint]);
        State { time_s, rate, change, joints, step }
    }

    fn fits(&self, next: &State) -> bool {
        if self.brakes {
            return self.checker.limits().axes().check_change(&next.step, &self.state.step, self.period_s).is_ok();
        }
        let (squared, limits) = (self.period_s * self.period_s, self.checker.limits().joint_accelerations());
        (0..6).all(|joint| {
            let acceleration = (next.step[joint] - self.state.step[joint]).abs() / squared;
            acceleration <= limits[joint] * (1.0 + 1e-9) + ROUNDING
        })
    }
}

impl Stopping {
    /// Looks ahead by at most this number of further periods. Returns the number of periods from the start of the stop
    /// to rest, if it was found.
    pub fn look_ahead(&mut self, periods: u32) -> Option<u32> {
        let last = self.periods.saturating_add(periods);
        while !self.follower.is_at_rest() {
            if self.periods == last {
                return None;
            }
            self.follower.advance();
            self.periods += 1;
        }
        Some(self.periods)
    }

    /// Returns the number of periods that were computed.
    pub fn periods(&self) -> u32 {
        self.periods
    }
}

/// Returns the change of the rate in a period that brings `off` to zero as soon as possible, if the change itself
/// changes by at most `jerk` a period: changes of `k` periods that become smaller by that end at zero.
fn change_towards(off: f64, jerk: f64) -> f64 {
    if jerk <= 0.0 {
        return 0.0;
    }
    let left = off.abs() / jerk;
    let periods = (0.5 * ((1.0 + 8.0 * left).sqrt() - 1.0)).floor();
    let change = jerk * (left + 0.5 * periods * (periods + 1.0)) / (periods + 1.0);
    change.copysign(off)
}
