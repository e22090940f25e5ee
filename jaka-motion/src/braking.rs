//! One joint in motion, and how it stops.

/// Where a joint is, in degrees, and how it moves, in deg/s and deg/s².
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

/// What rounding may add to a speed or an acceleration, as a share of its limit.
const ROUNDING: f64 = 1e-9;

/// How a joint comes to rest as soon as it can: its acceleration goes to the most that is needed, is held, and goes to
/// zero.
///
/// What remains of a stop is the stop of the state that is reached: a joint may go on from each state on the way as if
/// it began there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stop {
    from: JointState,
    /// Durations in seconds, and jerks.
    phases: [(f64, f64); 3],
}

impl JointState {
    pub(crate) fn at_rest(position: f64) -> Self {
        Self { position, speed: 0.0, acceleration: 0.0 }
    }

    /// After some seconds with this jerk.
    pub(crate) fn after(self, seconds: f64, jerk: f64) -> Self {
        let Self { position, speed, acceleration } = self;
        Self {
            position: position + seconds * (speed + seconds * (acceleration / 2.0 + seconds * jerk / 6.0)),
            speed: speed + seconds * (acceleration + seconds * jerk / 2.0),
            acceleration: acceleration + seconds * jerk,
        }
    }

    /// The speed it gets to if its acceleration goes to zero as soon as it can.
    fn coasting_speed(self, jerk: f64) -> f64 {
        self.speed + self.acceleration * self.acceleration.abs() / (2.0 * jerk)
    }

    /// After some seconds, if its acceleration goes to zero evenly in `ramp_s`, and stays there.
    pub(crate) fn coasted(self, seconds: f64, ramp_s: f64) -> Self {
        let jerk = if ramp_s > 0.0 { -self.acceleration / ramp_s } else { 0.0 };
        let mut there = self.after(ramp_s.min(seconds), jerk);
        if ramp_s <= seconds {
            there.acceleration = 0.0;
        }
        there.after((seconds - ramp_s).max(0.0), 0.0)
    }

    /// A share of the way to another state of the same time, both from the same one: by as much of the jerks.
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

    /// Whether the speed stays within its limit on the way to a state that is within it, with this jerk.
    pub(crate) fn speed_is_within(self, seconds: f64, jerk: f64, limits: JointLimits) -> bool {
        let turning = -self.acceleration / jerk;
        let is_inside = turning > 0.0 && turning < seconds;
        !is_inside || self.after(turning, jerk).speed.abs() <= limits.speed * (1.0 + ROUNDING)
    }
}

impl Stop {
    pub(crate) fn of(from: JointState, limits: JointLimits) -> Self {
        let JointLimits { acceleration: most, jerk, .. } = limits;
        let sign = if from.coasting_speed(jerk) < 0.0 { -1.0 } else { 1.0 };
        let (speed, acceleration) = (sign * from.speed, sign * from.acceleration);
        let needed = (jerk * speed + 0.5 * acceleration * acceleration).max(0.0).sqrt();
        let peak = needed.min(most);
        let held = if needed > most {
            ((speed + 0.5 * acceleration * acceleration / jerk) / most - most / jerk).max(0.0)
        } else {
            0.0
        };
        let slows = ((acceleration + peak) / jerk).max(0.0);
        Self { from, phases: [(slows, -sign * jerk), (held, 0.0), (peak / jerk, sign * jerk)] }
    }

    /// How long it takes, in seconds.
    pub(crate) fn seconds(&self) -> f64 {
        self.phases.iter().map(|(seconds, _)| seconds).sum()
    }

    /// After some seconds.
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

    /// Where it comes to rest, in degrees.
    pub(crate) fn end(&self) -> f64 {
        self.at(f64::INFINITY).position
    }

    /// The least and the largest position on the way, in degrees.
    pub(crate) fn span(&self) -> (f64, f64) {
        let (start, end, turn) = (self.from.position, self.end(), self.turn().unwrap_or(self.from.position));
        (start.min(end).min(turn), start.max(end).max(turn))
    }

    /// The highest speed on the way.
    pub(crate) fn top_speed(&self) -> f64 {
        let (ramp, jerk) = self.phases[0];
        let turning = if jerk == 0.0 { 0.0 } else { (-self.from.acceleration / jerk).clamp(0.0, ramp) };
        self.from.speed.abs().max(self.from.after(turning, jerk).speed.abs())
    }

    /// The largest acceleration on the way.
    pub(crate) fn top_acceleration(&self) -> f64 {
        let (ramp, jerk) = self.phases[0];
        self.from.acceleration.abs().max(self.from.after(ramp, jerk).acceleration.abs())
    }

    /// Where it turns back, if its acceleration is against its motion and more than it needs to stop.
    fn turn(&self) -> Option<f64> {
        let (ramp, jerk) = self.phases[0];
        let JointState { speed, acceleration, .. } = self.from;
        if speed * jerk <= 0.0 || acceleration * jerk >= 0.0 {
            return None;
        }
        // The speed is zero first where the acceleration still has its sign.
        let root = (acceleration * acceleration - 2.0 * jerk * speed).max(0.0).sqrt();
        let seconds = (-acceleration - root.copysign(-acceleration)) / jerk;
        (0.0..=ramp).contains(&seconds).then(|| self.from.after(seconds, jerk).position)
    }
}

/// How long the joint takes that stops the last, in seconds.
pub(crate) fn longest_stop(stops: &[Stop; 6]) -> f64 {
    stops.iter().map(Stop::seconds).fold(0.0, f64::max)
}
