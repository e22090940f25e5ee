//! Set-points along a trajectory, one a period, at a rate that may change at any time.

mod overtravel;

use jaka_proto::messages::types::JointPosition;

pub use self::overtravel::Overtravel;
use self::overtravel::Travel;
use crate::checker::Checker;
use crate::trajectory::{RateChange, Trajectory};

/// Makes one set-point a period along a [`Trajectory`], and can pause, slow down, go on and stop on its curve at any
/// time.
///
/// It has a trajectory time, which advances in each period by the *rate* times the period. The rate goes smoothly to
/// the scale that is asked for: 1 for the trajectory's own speed, 0 for a standstill.
///
/// # What is promised
/// Whenever the scale changes, and however often:
/// - Each set-point is where the trajectory is at the trajectory time: also while it is paused or stops, the arm is led
///   along the curve and nowhere else.
/// - The rate is from 0 to 1, so that the joints are nowhere faster than in the trajectory.
/// - The second differences of the set-points, divided by the square of the period, are within the joint accelerations
///   of the limits if those of the trajectory are. Which change of the rate leaves room for that,
///   [`Trajectory::rate_change`] says, and each set-point is compared before it is returned.
/// - The rate's own change goes up to that in 0.1 s, which is ours; it goes down faster only where the curve leaves
///   less room.
/// - By [`brake`](Self::brake) a joint that slows down may have the acceleration of stops
///   ([`Limits::stop_accelerations`](crate::Limits::stop_accelerations)).
///
/// But for a brake, where a trajectory uses all of a joint's acceleration, the rate stays as it is until the curve
/// leaves room: [`periods_to_rest`](Self::periods_to_rest) says how long a stop takes.
///
/// Nothing is allocated but in `new`. It shares the trajectory's pieces with it, and holds some hundred bytes in
/// addition.
#[derive(Debug, Clone)]
pub struct Follower {
    trajectory: Trajectory,
    duration_s: f64,
    checker: Checker,
    period_s: f64,
    scale: f64,
    limits: ChangeLimits,
    state: State,
    /// State at the set-point before.
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
    /// Distance of each joint from the set-point before, in degrees.
    step: [f64; 6],
}

/// Accelerations within which the rate changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ChangeLimits {
    /// Of motions.
    Motion,
    /// Of stops.
    Stop,
}

/// A stop along the curve, looked at before it is made. Made by [`Follower::stopping`].
///
/// Each period of it is computed as the set-point of that period is, in some microseconds. The number of periods
/// depends on the joint accelerations that the trajectory leaves, and can be all that are left of it. A caller with a
/// deadline in a servo period therefore looks ahead in each by as many periods as it has time for.
#[derive(Debug, Clone)]
#[must_use = "it looks ahead as far as it is asked to"]
pub struct Stopping {
    follower: Follower,
    periods: u32,
}

/// Time in which the change of the rate reaches the value that the curve allows, in seconds.
const CHANGE_REACHED_S: f64 = 0.1;
/// Number of halvings of the change of the rate where it is too much for a joint.
const HALVINGS: u32 = 16;
/// Rounding error that is allowed in an acceleration, in deg/s²: the joint positions have some 16 digits.
const ROUNDING: f64 = 1e-6;

impl Follower {
    /// For an arm at rest where the trajectory starts, with a set-point each so many seconds, at the scale 1.
    ///
    /// Accelerations are compared with those of the checker's limits.
    pub fn new(trajectory: Trajectory, checker: &Checker, period_s: f64) -> Self {
        let state = State { time_s: 0.0, rate: 1.0, change: 0.0, joints: trajectory.start(), step: [0.0; 6] };
        let (duration_s, checker) = (trajectory.duration_s(), checker.clone());
        Self {
            trajectory,
            duration_s,
            checker,
            period_s,
            scale: 1.0,
            limits: ChangeLimits::Motion,
            state,
            before: state,
        }
    }

    /// Asks for a scale of the trajectory's speed, from 0 for a pause to 1; what is beyond that counts as 0 or 1, and
    /// what is not a number as 0.
    ///
    /// Before the first set-point the rate is this at once.
    pub fn set_scale(&mut self, scale: f64) {
        self.limits = ChangeLimits::Motion;
        self.scale = if scale.is_nan() { 0.0 } else { scale.clamp(0.0, 1.0) };
        if self.state.time_s == 0.0 && self.state.change == 0.0 && self.state.step.iter().all(|step| *step == 0.0) {
            self.state.rate = self.scale;
        }
    }

    /// Asks for a standstill by a stop, until another scale is asked for.
    ///
    /// The arm is braked along the trajectory within the accelerations and jerks of stops, and at once by as much as
    /// the trajectory leaves of the accelerations of motions.
    pub fn brake(&mut self) {
        self.set_scale(0.0);
        self.limits = ChangeLimits::Stop;
    }

    /// The set-point a period after the last one.
    pub fn advance(&mut self) -> JointPosition {
        self.before = self.state;
        let [wanted, fallback] = self.wanted_changes();
        self.state = self.within_accelerations(wanted, fallback);
        self.state.joints
    }

    /// No set-point has come when one was due: what comes next starts from standstill at the last one.
    pub fn paused(&mut self) {
        (self.state.rate, self.state.change, self.state.step) = (0.0, 0.0, [0.0; 6]);
    }

    /// The last set-point was not sent: what comes next follows the one before. Once after each
    /// [`advance`](Self::advance).
    pub fn take_back(&mut self) {
        self.state = self.before;
    }

    /// The last set-point, or where the trajectory starts.
    pub fn joints(&self) -> JointPosition {
        self.state.joints
    }

    /// The trajectory time of the last set-point, in seconds.
    pub fn time_s(&self) -> f64 {
        self.state.time_s
    }

    /// Returns the rate at which the trajectory time goes, from 0 to 1.
    pub fn rate(&self) -> f64 {
        self.state.rate
    }

    /// Whether the last set-point is where the trajectory ends.
    pub fn is_at_end(&self) -> bool {
        self.state.time_s >= self.duration_s
    }

    /// Whether the trajectory time stands still: in a pause, after a stop, or at the end.
    pub fn is_at_rest(&self) -> bool {
        self.state.rate == 0.0 || self.is_at_end()
    }

    /// Returns the stop that it would make if the scale were 0 from now on, or if it [brakes](Self::brake) already.
    pub fn stopping(&self) -> Stopping {
        let mut follower = self.clone();
        follower.set_scale(0.0);
        follower.limits = self.limits;
        Stopping { follower, periods: 0 }
    }

    /// Returns the number of periods until it would be at rest if the scale were 0 from now on, or if it
    /// [brakes](Self::brake) already; none if that takes more than `most`.
    ///
    /// It computes each of these set-points; [`stopping`](Self::stopping) does that bit by bit.
    pub fn periods_to_rest(&self, most: u32) -> Option<u32> {
        self.stopping().look_ahead(most)
    }

    /// The contact of the whole trajectory after which the tool centre point goes on the furthest, if that is further
    /// than `allowed_mm`; none otherwise.
    ///
    /// Any set-point may be followed by a contact, and by a call of [`brake`](Self::brake) `delay_s` after it. The
    /// computation takes the rate 1, which is the worst: at a lower one, also one that goes up or down meanwhile, the
    /// tool has gone less far when it is braked, and rests sooner. If the tool goes on further than is allowed before
    /// it is braked at all, the result is the place at which that is the furthest.
    ///
    /// Each period of the trajectory is looked at, and braking where bounds do not tell that it is short enough. It
    /// allocates a number for each.
    pub fn worst_overtravel(&self, checker: &Checker, delay_s: f64, allowed_mm: f64) -> Option<Overtravel> {
        Travel::new(self, checker, delay_s).worst(allowed_mm)
    }

    /// The trajectory.
    pub fn trajectory(&self) -> &Trajectory {
        &self.trajectory
    }

    /// The period in seconds.
    pub fn period_s(&self) -> f64 {
        self.period_s
    }

    /// Returns the wanted change of the rate in the next period, and the one to take if a joint does not allow it.
    fn wanted_changes(&self) -> [f64; 2] {
        let State { time_s, rate, .. } = self.state;
        let (from_s, to_s) = (time_s - rate * self.period_s, time_s + self.period_s);
        let RateChange { fall, rise, .. } = self.trajectory.rate_change_between(from_s, to_s, rate);
        // From 0 to 1 in one period is the most that there is.
        let [fall, rise] = [fall, rise].map(|allowed| (allowed * self.period_s).min(1.0));
        if self.limits == ChangeLimits::Stop {
            let at_once = -rate.min(fall);
            return [self.stop_change().min(at_once), at_once];
        }
        let most = if self.scale < rate { fall } else { rise };
        let wanted = self.change_within(most * (self.period_s / CHANGE_REACHED_S).min(1.0));
        [wanted.clamp(-fall, rise).clamp(-rate, 1.0 - rate), 0.0]
    }

    /// Change of the rate of a stop along the trajectory.
    fn stop_change(&self) -> f64 {
        let State { rate, joints, step, .. } = &self.state;
        let velocity = step.map(|step| step / self.period_s);
        let stop = self.checker.stop_rates(&joints.0, &velocity, self.checker.limits().stop_jerks());
        let most = (stop.share * rate * self.period_s).min(1.0);
        self.change_within(most * (self.period_s / stop.ramp_s).min(1.0)).clamp(-most.min(*rate), 0.0)
    }

    /// Change of the rate towards the scale that itself changes by no more than `jerk` from the last one.
    fn change_within(&self, jerk: f64) -> f64 {
        let State { rate, change, .. } = self.state;
        change_towards(self.scale - rate, jerk).clamp(change - jerk, change + jerk)
    }

    /// The next state with as much of a change of the rate as leaves each joint within its acceleration.
    fn within_accelerations(&self, wanted: f64, fallback: f64) -> State {
        let next = self.changed(wanted);
        if self.fits(&next) {
            return next;
        }
        // As fast as before: then the accelerations are means of those of the trajectory.
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
        // Rounding leaves it next to where it is to be.
        let rate = if (rate - self.scale).abs() < 1e-12 { self.scale } else { rate };
        let time_s = (self.state.time_s + rate * self.period_s).min(self.duration_s);
        let joints = if time_s < self.duration_s { self.trajectory.at(time_s).joints } else { self.trajectory.end() };
        let step = std::array::from_fn(|joint| joints.0[joint] - self.state.joints.0[joint]);
        State { time_s, rate, change, joints, step }
    }

    fn fits(&self, next: &State) -> bool {
        if self.limits == ChangeLimits::Stop {
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
    /// Looks ahead by at most so many periods more; in how many periods from the start of the stop it is at rest, if
    /// that was found.
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

    /// Returns the number of periods that were looked at.
    pub fn periods(&self) -> u32 {
        self.periods
    }
}

/// Returns the change of the rate in a period that brings `off` to zero as soon as possible, where the change itself
/// changes by `jerk` a period at most: changes of `k` periods that become smaller by that end at zero.
fn change_towards(off: f64, jerk: f64) -> f64 {
    if jerk <= 0.0 {
        return 0.0;
    }
    let left = off.abs() / jerk;
    let periods = (0.5 * ((1.0 + 8.0 * left).sqrt() - 1.0)).floor();
    let change = jerk * (left + 0.5 * periods * (periods + 1.0)) / (periods + 1.0);
    change.copysign(off)
}
