//! Joints in motion and their stops.

/// Position of a joint, in degrees, with its speed, in deg/s, and its acceleration, in deg/s².
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct JointState {
    pub(crate) position: f64,
    pub(crate) speed: f64,
    pub(crate) acceleration: f64,
}

/// Limits of one joint, in deg/s, deg/s² and deg/s³.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct JointLimits {
    pub(crate) speed: f64,
    pub(crate) acceleration: f64,
    pub(crate) jerk: f64,
}

/// Rounding error that is allowed in a speed or an acceleration, as a share of its limit.
const ROUNDING: f64 = 1e-9;
/// Rounding error that is allowed in the number of periods: without it, a stop of a whole number of periods could take
/// one period more.
const PERIODS_ROUNDING: f64 = 1e-6;

/// Motion of a joint to rest. An acceleration that does not brake first goes to zero. The deceleration then rises to
/// the peak that the stop needs, stays there, and goes to zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stop {
    from: JointState,
    /// Durations in seconds, with their jerks.
    phases: [(f64, f64); 4],
    /// Greatest acceleration during the stop.
    top_acceleration: f64,
}

/// Deceleration of all joints along their velocity, as a share of the velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StopRates {
    /// Share of the velocity that is lost in a second.
    pub(crate) share: f64,
    /// Time until the deceleration reaches that share, in seconds.
    pub(crate) ramp_s: f64,
    pub(crate) bound: StopBound,
}

/// Bound of the deceleration with which an arm stops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum StopBound {
    /// Stop acceleration of a joint ([`Limits::stop_accelerations`](crate::Limits::stop_accelerations)).
    Joints,
    /// Stop acceleration of the tool centre point
    /// ([`Limits::stop_tcp_acceleration`](crate::Limits::stop_tcp_acceleration)).
    Tool,
    /// Acceleration of motions ([`Limits::joint_accelerations`](crate::Limits::joint_accelerations)). A stop is never
    /// gentler, so it may brake the tool harder than the tool's own bound.
    Motion,
}

/// Stop of an arm straight on in joint space, with steps between set-points that become smaller: see
/// [`Checker::straight_stop`](crate::Checker::straight_stop).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StraightStop {
    course: StopCourse,
    period_s: f64,
    bound: StopBound,
}

/// Decrease of the steps between set-points during a stop.
#[derive(Debug, Clone, Copy, PartialEq)]
enum StopCourse {
    /// Even decrease over this number of periods.
    Even(f64),
    /// Decrease by the positions of this stop, in seconds at the speed before the stop.
    Smooth(Stop),
}

impl JointState {
    pub(crate) fn at_rest(position: f64) -> Self {
        Self { position, speed: 0.0, acceleration: 0.0 }
    }

    /// Returns the state after some seconds with this jerk.
    pub(crate) fn after(self, seconds: f64, jerk: f64) -> Self {
        let Self { position, speed, acceleration } = self;
        Self {
            position: position + seconds * (speed + seconds * (acceleration / 2.0 + seconds * jerk / 6.0)),
            speed: speed + seconds * (acceleration + seconds * jerk / 2.0),
            acceleration: acceleration + seconds * jerk,
        }
    }

    /// Returns the speed of the joint after its acceleration has gone to zero with this jerk.
    pub(crate) fn coasting_speed(self, jerk: f64) -> f64 {
        self.speed + self.acceleration * self.acceleration.abs() / (2.0 * jerk)
    }

    /// Returns the state after some seconds, if the acceleration goes to zero evenly in `ramp_s` and stays there.
    pub(crate) fn coasted(self, seconds: f64, ramp_s: f64) -> Self {
        let jerk = if ramp_s > 0.0 { -self.acceleration / ramp_s } else { 0.0 };
        let mut there = self.after(ramp_s.min(seconds), jerk);
        if ramp_s <= seconds {
            there.acceleration = 0.0;
        }
        there.after((seconds - ramp_s).max(0.0), 0.0)
    }

    /// Interpolates between two states of the same time that were reached from the same state: the result has the jerks
    /// at the same share between theirs.
    pub(crate) fn towards(self, other: Self, share: f64) -> Self {
        let between = |one: f64, other: f64| one + share * (other - one);
        Self {
            position: between(self.position, other.position),
            speed: between(self.speed, other.speed),
            acceleration: between(self.acceleration, other.acceleration),
        }
    }

    /// Whether speed and acceleration are within their limits here, and stay there while the acceleration goes to zero.
    pub(crate) fn is_within(self, limits: JointLimits) -> bool {
        let below = |value: f64, limit: f64| value.abs() <= limit * (1.0 + ROUNDING);
        self.position.is_finite()
            && below(self.acceleration, limits.acceleration)
            && below(self.speed, limits.speed)
            && below(self.coasting_speed(limits.jerk), limits.speed)
    }

    /// Whether the speed stays within its limit until a state that is within it, with this jerk.
    pub(crate) fn speed_is_within(self, seconds: f64, jerk: f64, limits: JointLimits) -> bool {
        let turning = -self.acceleration / jerk;
        let is_inside = turning > 0.0 && turning < seconds;
        !is_inside || self.after(turning, jerk).speed.abs() <= limits.speed * (1.0 + ROUNDING)
    }
}

impl StopRates {
    /// Returns the stop along a velocity. Its positions are the distances that the joints still travel, in seconds at
    /// that velocity.
    pub(crate) fn stop(self) -> Stop {
        let jerk = self.share / self.ramp_s;
        Stop::within(JointState { speed: 1.0, ..JointState::default() }, [self.share, jerk, jerk])
    }

    /// Returns the longest distance that the joints still travel, in seconds at their velocity.
    pub(crate) fn length_s(self) -> f64 {
        0.5 * (1.0 / self.share + self.ramp_s)
    }
}

impl Stop {
    /// Returns the quickest stop within the limits of a joint.
    pub(crate) fn of(from: JointState, limits: JointLimits) -> Self {
        Self::within(from, [limits.acceleration, limits.jerk, limits.jerk])
    }

    /// Returns the stop with these accelerations and jerks. The last number is the jerk that takes an acceleration to
    /// zero that does not brake.
    ///
    /// A joint that already brakes harder continues to, and its acceleration goes to zero before its speed does.
    pub(crate) fn within(from: JointState, [most, jerk, release]: [f64; 3]) -> Self {
        let sign = if from.coasting_speed(release) < 0.0 { -1.0 } else { 1.0 };
        let releases = (sign * from.acceleration / release).max(0.0);
        let then = from.after(releases, -sign * release);
        let (speed, braking) = ((sign * then.speed).max(0.0), (-sign * then.acceleration).max(0.0));
        let jerk = if speed > 0.0 { jerk.max(0.5 * braking * braking / speed) } else { jerk };
        let needed = (jerk * speed + 0.5 * braking * braking).sqrt();
        let most = most.max(braking);
        let peak = needed.clamp(braking, most);
        let held =
            if needed > most { ((speed + 0.5 * braking * braking / jerk) / most - most / jerk).max(0.0) } else { 0.0 };
        let phases = [
            (releases, -sign * release),
            ((peak - braking) / jerk, -sign * jerk),
            (held, 0.0),
            (peak / jerk, sign * jerk),
        ];
        Self { from, phases, top_acceleration: from.acceleration.abs().max(peak) }
    }

    /// Returns the rest of the stop after some seconds.
    pub(crate) fn after(&self, seconds: f64) -> Self {
        let mut left = seconds;
        let phases = self.phases.map(|(duration, jerk)| {
            let passed = left.min(duration);
            left -= passed;
            (duration - passed, jerk)
        });
        Self { from: self.at(seconds), phases, ..*self }
    }

    /// Returns the duration of the stop, in seconds.
    pub(crate) fn seconds(&self) -> f64 {
        self.phases.iter().map(|(seconds, _)| seconds).sum()
    }

    /// Returns the state after some seconds.
    pub(crate) fn at(&self, seconds: f64) -> JointState {
        let (mut state, mut left) = (self.from, seconds);
        for (duration, jerk) in self.phases {
            if left < duration {
                return state.after(left, jerk);
            }
            state = state.after(duration, jerk);
            left -= duration;
        }
        JointState::at_rest(state.position)
    }

    /// Returns the position at which the joint comes to rest, in degrees.
    pub(crate) fn end(&self) -> f64 {
        self.at(f64::INFINITY).position
    }

    /// Returns the least and the largest position during the stop, in degrees.
    pub(crate) fn span(&self) -> (f64, f64) {
        let (start, end, turn) = (self.from.position, self.end(), self.turn().unwrap_or(self.from.position));
        (start.min(end).min(turn), start.max(end).max(turn))
    }

    /// Returns the highest speed during the stop.
    pub(crate) fn top_speed(&self) -> f64 {
        let (releases, jerk) = self.phases[0];
        self.from.speed.abs().max(self.from.after(releases, jerk).speed.abs())
    }

    /// Returns the largest acceleration during the stop.
    pub(crate) fn top_acceleration(&self) -> f64 {
        self.top_acceleration
    }

    /// Returns the position at which the joint turns back, if its acceleration opposes its motion by more than the stop
    /// needs.
    fn turn(&self) -> Option<f64> {
        let (releases, jerk) = self.phases[0];
        let JointState { speed, acceleration, .. } = self.from;
        if speed * jerk <= 0.0 || acceleration * jerk >= 0.0 {
            return None;
        }
        // The first zero of the speed is at a time when the acceleration still has its sign.
        let root = (acceleration * acceleration - 2.0 * jerk * speed).max(0.0).sqrt();
        let seconds = (-acceleration - root.copysign(-acceleration)) / jerk;
        (0.0..=releases).contains(&seconds).then(|| self.from.after(seconds, jerk).position)
    }
}

impl StraightStop {
    /// Returns the shorter one of two stops: at these rates, or even from the first period on, with a loss of
    /// `even_share` a second.
    pub(crate) fn new(smooth: StopRates, even_share: f64, period_s: f64) -> Self {
        let (stop, count) = (smooth.stop(), (1.0 / (even_share * period_s) - PERIODS_ROUNDING).ceil().max(1.0));
        if 0.5 * (count - 1.0) * period_s <= stop.end() {
            return Self { course: StopCourse::Even(count), period_s, bound: StopBound::Motion };
        }
        Self { course: StopCourse::Smooth(stop), period_s, bound: smooth.bound }
    }

    /// Returns the number of set-points until the arm is at rest.
    pub fn periods(&self) -> u32 {
        let periods = match self.course {
            StopCourse::Even(count) => count,
            StopCourse::Smooth(stop) => (stop.seconds() / self.period_s - PERIODS_ROUNDING).ceil(),
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the cast takes the nearest")]
        let periods = periods as u32;
        periods
    }

    /// Returns the step of the n-th set-point of the stop, from 1, as a share of the step before the stop.
    pub fn step(&self, n: u32) -> f64 {
        match self.course {
            StopCourse::Even(count) => (1.0 - f64::from(n) / count).max(0.0),
            StopCourse::Smooth(stop) => {
                let gone = |n: u32| stop.at(f64::from(n) * self.period_s).position;
                (gone(n) - gone(n.saturating_sub(1))) / self.period_s
            }
        }
    }

    /// Returns the distance that the arm still travels, as a multiple of the step before the stop.
    pub fn steps(&self) -> f64 {
        match self.course {
            StopCourse::Even(count) => 0.5 * (count - 1.0),
            StopCourse::Smooth(stop) => stop.end() / self.period_s,
        }
    }

    /// Returns the bound of the deceleration.
    pub fn bound(&self) -> StopBound {
        self.bound
    }
}

/// Returns the time until the last joint stops, in seconds.
pub(crate) fn longest_stop(stops: &[Stop; 6]) -> f64 {
    stops.iter().map(Stop::seconds).fold(0.0, f64::max)
}
