//! How fast the joints go for a tool that must be slow.

use super::Generator;
use super::dynamics::LEAST;
use crate::beyond::Exceeded;
use crate::braking::{JointLimits, JointState, Stop};

/// Of what the tool may do, how much is planned: the rest is for how joints' speeds move it on the way.
const USED: f64 = 0.9;
/// How often the speed is cut for a stop that is too long, and to how much of it.
const CUTS: u32 = 24;
const CUT: f64 = 0.8;

/// What the tool allows of rates of the joints.
pub(super) struct ToolPace {
    /// How much of the rates.
    pub(super) share: f64,
    /// Limits of the joints for that, in proportion to the rates, so that all joints do the same at a time: a straight
    /// way stays straight.
    pub(super) limits: [JointLimits; 6],
    /// What allows no more, unless it is the reserve alone.
    pub(super) exceeded: Option<Exceeded>,
}

impl Generator {
    /// What the tool allows on the way to a target; none where it allows all speeds of the joints.
    pub(super) fn tool_pace_to(&self, target: &[f64; 6]) -> Option<ToolPace> {
        let by: [f64; 6] = std::array::from_fn(|index| target[index] - self.state[index].position);
        let seconds = (0..6).map(|index| by[index].abs() / self.limits[index].speed).fold(0.0, f64::max);
        self.tool_pace(&by, 1.0 / seconds)
    }

    /// What the tool allows of these rates, of which the joints allow `most`; none where it is no less.
    pub(super) fn tool_pace(&self, rates: &[f64; 6], most: f64) -> Option<ToolPace> {
        let limit_mm_s = self.checker.limits().tcp_speed()?;
        let rate_mm = self.checker.arm().tcp_rate(&self.joints().0, rates);
        let fast = most.min(USED * limit_mm_s / rate_mm);
        let way_mm = |share: f64| self.way_to_rest(rates, share, rate_mm);
        let mut shares = (0..CUTS).scan(fast, |share, _| Some(std::mem::replace(share, CUT * *share)));
        let share = shares.find(|share| way_mm(*share) <= USED * self.stopping_mm).unwrap_or(fast);
        (share < most).then(|| {
            let (speed_mm_s, way_mm, limit_mm) = (most * rate_mm, way_mm(most), self.stopping_mm);
            let exceeded = match (speed_mm_s > limit_mm_s, way_mm > limit_mm) {
                (true, _) => Some(Exceeded::TcpSpeed { speed_mm_s, limit_mm_s }),
                (false, true) => Some(Exceeded::LandingWay { way_mm, limit_mm }),
                (false, false) => None,
            };
            ToolPace { share, limits: self.in_proportion(&rates.map(|rate| share * rate)), exceeded }
        })
    }

    /// How far the tool goes in a period at this share of the rates, and then until it rests, in mm; 0 where that does
    /// not matter.
    fn way_to_rest(&self, rates: &[f64; 6], share: f64, rate_mm: f64) -> f64 {
        if self.stopping_mm.is_infinite() {
            return 0.0;
        }
        let ends: [f64; 6] = std::array::from_fn(|index| {
            let from = JointState { speed: share * rates[index], ..JointState::default() };
            Stop::of(from, self.limits[index]).end()
        });
        share * rate_mm * self.period_s + self.checker.arm().tcp_rate(&self.joints().0, &ends)
    }

    /// Limits for these speeds, or those that the joints have.
    fn in_proportion(&self, speeds: &[f64; 6]) -> [JointLimits; 6] {
        let speeds: [f64; 6] = std::array::from_fn(|index| {
            let speed = speeds[index].abs().max(self.state[index].speed.abs()).max(LEAST);
            speed.min(self.limits[index].speed)
        });
        let least = |of: fn(&JointLimits) -> f64, start: f64| {
            self.limits.iter().zip(&speeds).map(|(limits, speed)| of(limits) / speed).fold(start, f64::min)
        };
        // As for all limits, none is reached in less than a period.
        let faster = least(|limits| limits.acceleration, 1.0 / self.period_s);
        let sooner = least(|limits| limits.jerk, faster / self.period_s);
        speeds.map(|speed| JointLimits { speed, acceleration: faster * speed, jerk: sooner * speed })
    }
}
