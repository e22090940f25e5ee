//! Drives: commanded and actual joint positions.

use std::time::Duration;

use super::path::Joints;
use super::vector::minus;
use crate::clock::CYCLE;

/// Tolerance within which a joint is at its commanded position, in degrees. Packets have a lower resolution.
const NEAR: f64 = 1e-6;

/// Joints that follow their commanded positions with a first-order lag.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Drives {
    /// Time constant, in seconds.
    lag: f64,
    /// Commanded positions of the joints, in degrees.
    pub(crate) commanded: Joints,
    /// Actual positions of the joints, in degrees.
    pub(crate) actual: Joints,
    /// Commanded speeds of the joints in the last cycle, in deg/s.
    pub(crate) commanded_speed: Joints,
    /// Actual speeds of the joints in the last cycle, in deg/s.
    pub(crate) speed: Joints,
}

impl Drives {
    /// Creates drives at rest.
    pub(crate) fn new(lag: Duration, at: Joints) -> Self {
        let rest = [0.0; 6];
        Self { lag: lag.as_secs_f64(), commanded: at, actual: at, commanded_speed: rest, speed: rest }
    }

    /// Returns the commanded positions of the joints minus the actual ones, in degrees.
    pub(crate) fn deviation(&self) -> Joints {
        minus(self.commanded, self.actual)
    }

    /// Returns the commanded speeds of the joints minus the actual ones in the last cycle, in deg/s.
    pub(crate) fn speed_deviation(&self) -> Joints {
        minus(self.commanded_speed, self.speed)
    }

    /// Whether the joints are at their commanded positions.
    pub(crate) fn is_settled(&self) -> bool {
        self.commanded.iter().zip(&self.actual).all(|(commanded, actual)| (commanded - actual).abs() < NEAR)
    }

    /// Stops at once at a position.
    pub(crate) fn place(&mut self, at: Joints) {
        (self.commanded, self.actual) = (at, at);
        (self.commanded_speed, self.speed) = ([0.0; 6], [0.0; 6]);
    }

    /// Computes one cycle, in which the commanded joints move at constant speed to a position.
    pub(crate) fn follow(&mut self, to: Joints) {
        let (from, before) = (self.commanded, self.actual);
        self.commanded = to;
        self.actual = std::array::from_fn(|i| self.lagged(from[i], to[i], before[i]));
        self.commanded_speed = minus(to, from).map(|way| way / CYCLE.as_secs_f64());
        self.speed = minus(self.actual, before).map(|way| way / CYCLE.as_secs_f64());
    }

    /// Returns the position of a joint after a cycle with a constant commanded speed.
    fn lagged(&self, from: f64, to: f64, actual: f64) -> f64 {
        let cycle = CYCLE.as_secs_f64();
        // Response of a first-order lag to a ramp: in the end it is behind by the speed times the time constant.
        let behind = (to - from) / cycle * self.lag;
        let next = to - behind + (actual - from + behind) * (-cycle / self.lag).exp();
        let is_there = self.lag == 0.0 || (to - from).abs().max((next - to).abs()) < NEAR;
        if is_there { to } else { next }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(value: f64) -> Joints {
        [value, 0.0, 0.0, 0.0, 0.0, 0.0]
    }

    #[test]
    fn a_ramp_is_followed_at_speed_times_lag_and_a_hold_without_overshoot() {
        let mut drives = Drives::new(Duration::from_millis(20), at(0.0));
        let mut to = 0.0;
        for _ in 0..100 {
            to += 0.8;
            drives.follow(at(to));
        }
        // 100 deg/s times 20 ms.
        assert!((drives.deviation()[0] - 2.0).abs() < 1e-6, "{drives:?}");
        assert!((drives.speed[0] - 100.0).abs() < 1e-4 && drives.speed_deviation()[0].abs() < 1e-4, "{drives:?}");
        let mut before = drives.actual[0];
        while !drives.is_settled() {
            drives.follow(at(to));
            assert!((before..=to).contains(&drives.actual[0]), "{drives:?}");
            before = drives.actual[0];
        }
        drives.follow(at(to));
        assert_eq!(drives.actual.to_vec(), at(to).to_vec());
    }

    #[test]
    fn without_a_lag_the_joints_are_where_they_are_to_be() {
        let mut drives = Drives::new(Duration::ZERO, at(0.0));
        drives.follow(at(1.0));
        assert_eq!((drives.actual.to_vec(), drives.is_settled()), (at(1.0).to_vec(), true));
    }
}
