//! Tracking of a moving target within limits of speed, acceleration and jerk.

use crate::clock::CYCLE;
use crate::motion::vector::minus;

/// Distance below which a tracker is at its target, in degrees or millimetres.
const NEAR: f64 = 1e-7;

/// Greatest number of simulated braking cycles.
const MOST_CYCLES: u32 = 2000;

/// Limits of change in a cycle: of position, speed and acceleration.
#[derive(Debug, Clone, Copy)]
struct ServoLimits {
    speed: f64,
    acceleration: f64,
    jerk: f64,
}

/// Tracker for a target of `N` coordinates within limits.
///
/// It follows a target within the limits exactly. After a target beyond the limits, each coordinate returns to it as
/// fast as its share of the limits allows. It does not overshoot, unless the target itself stops or turns back faster
/// than the limits allow.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tracker<const N: usize> {
    limits: ServoLimits,
    speed: [f64; N],
    acceleration: [f64; N],
}

/// Step of a tracker in a cycle.
#[derive(Debug, Clone, Copy)]
pub(super) struct TrackerStep<const N: usize> {
    /// Distance of the step, by coordinate.
    pub(super) by: [f64; N],
    /// Whether the tracker is then at its target.
    pub(super) arrives: bool,
}

impl<const N: usize> Tracker<N> {
    /// Creates a tracker at rest, with limits per second, per second squared and per second cubed.
    pub(super) fn new(speed: f64, acceleration: f64, jerk: f64) -> Self {
        let cycle = CYCLE.as_secs_f64();
        let limits = ServoLimits {
            speed: speed * cycle,
            acceleration: acceleration * cycle.powi(2),
            jerk: jerk * cycle.powi(3),
        };
        Self { limits, speed: [0.0; N], acceleration: [0.0; N] }
    }

    /// Stops at once.
    pub(super) fn halt(&mut self) {
        (self.speed, self.acceleration) = ([0.0; N], [0.0; N]);
    }

    pub(super) fn is_at_rest(&self) -> bool {
        self.speed.iter().all(|speed| speed.abs() < NEAR)
    }

    /// Computes one cycle. `off` is the offset of the tracker from its target, `way` the step of the target in this
    /// cycle.
    pub(super) fn next(&mut self, off: [f64; N], way: [f64; N]) -> TrackerStep<N> {
        let exact = minus(way, off);
        let arrives = off.iter().all(|off| off.abs() < NEAR) && self.allows(exact);
        let by = if arrives { exact } else { self.nearer(off, way) };
        self.acceleration = minus(by, self.speed);
        self.speed = by;
        TrackerStep { by, arrives }
    }

    fn allows(&self, speed: [f64; N]) -> bool {
        let acceleration = minus(speed, self.speed);
        let jerk = minus(acceleration, self.acceleration);
        let ServoLimits { speed: most_speed, acceleration: most_acceleration, jerk: most_jerk } = self.limits;
        [(speed, most_speed), (acceleration, most_acceleration), (jerk, most_jerk)]
            .iter()
            .all(|(values, most)| length(values) <= most * (1.0 + 1e-9) + 1e-12)
    }

    fn nearer(&self, off: [f64; N], way: [f64; N]) -> [f64; N] {
        // Keeps the coordinates together within the limits.
        #[expect(clippy::cast_precision_loss, reason = "there are one or three")]
        let share = 1.0 / (N as f64).sqrt();
        let ServoLimits { speed, acceleration, jerk } = self.limits;
        let limits = ServoLimits { speed: speed * share, acceleration: acceleration * share, jerk: jerk * share };
        std::array::from_fn(|i| self.speed[i] + limits.toward(off[i], way[i], self.speed[i], self.acceleration[i]))
    }
}

impl ServoLimits {
    /// Returns the acceleration that brings a coordinate to a target of constant speed without overshoot.
    fn toward(self, off: f64, way: f64, speed: f64, acceleration: f64) -> f64 {
        let stop = |acceleration: f64| {
            let relative = speed + acceleration - way;
            self.stop(off + relative, relative, acceleration)
        };
        let (mut low, mut high) = (acceleration - self.jerk, acceleration + self.jerk);
        let wanted = if stop(high) <= 0.0 {
            high
        } else if stop(low) >= 0.0 {
            low
        } else {
            for _ in 0..40 {
                let middle = f64::midpoint(low, high);
                *(if stop(middle) <= 0.0 { &mut low } else { &mut high }) = middle;
            }
            low
        };
        // Reaches the speed limit when the acceleration is zero again.
        let wanted =
            wanted.min(reducible(self.speed - speed, self.jerk)).max(-reducible(self.speed + speed, self.jerk));
        let wanted = wanted.clamp(-self.acceleration, self.acceleration);
        wanted.clamp(acceleration - self.jerk, acceleration + self.jerk)
    }

    /// Returns the offset of a coordinate from the target at the time at which its speed equals that of the target.
    fn stop(self, mut off: f64, mut speed: f64, mut acceleration: f64) -> f64 {
        for _ in 0..MOST_CYCLES {
            if speed.abs() < 1e-12 && acceleration.abs() <= self.jerk {
                break;
            }
            let wanted = -reducible(speed, self.jerk).clamp(-self.acceleration, self.acceleration);
            acceleration = wanted.clamp(acceleration - self.jerk, acceleration + self.jerk);
            speed += acceleration;
            off += speed;
        }
        off
    }
}

/// Returns the greatest value that, reduced by `decrease` each cycle to zero, has a sum of at most `sum`, with the sign
/// of `sum`.
fn reducible(sum: f64, decrease: f64) -> f64 {
    if decrease <= 0.0 {
        return 0.0;
    }
    let cycles = (((1.0 + 8.0 * sum.abs() / decrease).sqrt() - 1.0) / 2.0).floor();
    ((sum.abs() + decrease * cycles * (cycles + 1.0) / 2.0) / (cycles + 1.0)).copysign(sum)
}

fn length(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the positions of a tracker along a course.
    fn follow(limits: [f64; 3], course: impl Iterator<Item = f64>) -> Vec<f64> {
        let mut tracker = Tracker::<1>::new(limits[0], limits[1], limits[2]);
        let (mut at, mut before) = (0.0, 0.0);
        let step = |place: f64| {
            let step = tracker.next([at - before], [place - before]);
            before = place;
            at = if step.arrives { place } else { at + step.by[0] };
            at
        };
        course.map(step).collect()
    }

    /// Returns the greatest speed, acceleration and jerk, by differences.
    fn greatest(places: &[f64]) -> [f64; 3] {
        let mut values = [vec![0.0; 3], places.to_vec()].concat();
        [(); 3].map(|()| {
            values = values.windows(2).map(|pair| (pair[1] - pair[0]) / CYCLE.as_secs_f64()).collect();
            values.iter().map(|value: &f64| value.abs()).fold(0.0, f64::max)
        })
    }

    fn assert_within(places: &[f64], limits: [f64; 3]) {
        for (value, limit) in greatest(places).into_iter().zip(limits) {
            assert!(value <= limit * (1.0 + 1e-6), "{value} of {limit}");
        }
    }

    #[test]
    fn a_jump_is_followed_within_the_limits_and_without_overshoot() {
        for limits in [[180.0, 720.0, 10_000.0], [2.0, 2.0, 4.0], [1000.0, 500.0, 2000.0], [90.0, 1e5, 1e9]] {
            for to in [0.05, 0.7, -30.0, 100.0] {
                let places = follow(limits, std::iter::repeat_n(to, 10_000));
                assert_within(&places, limits);
                assert!((places[9999] - to).abs() < 1e-12, "{limits:?}, {to}: {}", places[9999]);
                let beyond = places.iter().map(|at| (at / to - 1.0) * to.abs()).fold(0.0, f64::max);
                assert!(beyond < 1e-6, "{limits:?}, {to}: {beyond}");
                // In this order, for each limit that is effective.
                assert!(to.abs() < 100.0 || greatest(&places)[0] > limits[0].min(100.0) * 0.99, "{limits:?}");
            }
        }
    }

    #[test]
    fn a_course_within_the_limits_is_followed_exactly() {
        let cycles = |time: f64| time * CYCLE.as_secs_f64();
        let course: Vec<_> = (0..1000).map(|n| 10.0 * (1.0 - cycles(f64::from(n)).cos())).collect();
        let places = follow([20.0, 20.0, 2000.0], course.iter().copied());
        assert_eq!(places, course);
    }

    #[test]
    fn a_course_that_stops_dead_is_passed_no_further_than_the_limits_ask() {
        let limits = [100.0, 500.0, 20_000.0];
        let ramp = (1..=100).map(|n| f64::from(n) * 0.4);
        let places = follow(limits, ramp.chain(std::iter::repeat_n(40.0, 200)));
        assert_within(&places, limits);
        let furthest = places.iter().copied().fold(0.0, f64::max) - 40.0;
        // 50 deg/s at 500 deg/s² give 2.5 deg, and some more for the jerk.
        assert!((2.4..4.5).contains(&furthest), "{furthest}");
        assert!((places[299] - 40.0).abs() < 1e-12);
    }
}
