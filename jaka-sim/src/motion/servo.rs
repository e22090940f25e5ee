//! Servo mode: set-points that the drives follow.

use std::collections::VecDeque;

use super::path::Joints;
use crate::clock::CYCLE;

/// The greatest speed of a joint in servo mode, in deg/s (4.15).
const MAX_SPEED: f64 = 180.0;

/// How many set-points may wait. A client that keeps the pace has one or two.
const MOST: usize = 1000;

/// The set-points that wait, and the one that is under way.
#[derive(Debug, Clone, Default)]
pub(crate) struct Servo {
    waiting: VecDeque<SetPoint>,
}

#[derive(Debug, Clone, Copy)]
struct SetPoint {
    target: Joints,
    cycles: u32,
}

impl Servo {
    /// Where the arm will be when all set-points have been reached.
    pub(crate) fn tail(&self, now: Joints) -> Joints {
        self.waiting.back().map_or(now, |last| last.target)
    }

    /// Takes a set-point to be reached in this many cycles. One that asks more than 180 deg/s of a joint has no effect.
    pub(crate) fn push(&mut self, now: Joints, target: Joints, cycles: u32) {
        let from = self.tail(now);
        let time = CYCLE.as_secs_f64() * f64::from(cycles);
        let within = |(from, to): (&f64, &f64)| (to - from).abs() / time <= MAX_SPEED + 1e-6;
        if from.iter().zip(&target).all(within) && self.waiting.len() < MOST {
            self.waiting.push_back(SetPoint { target, cycles });
        }
    }

    pub(crate) fn clear(&mut self) {
        self.waiting.clear();
    }

    pub(crate) fn is_moving(&self) -> bool {
        !self.waiting.is_empty()
    }

    /// One cycle: an even share of the way to the set-point.
    pub(super) fn cycle(&mut self, joints: Joints) -> Joints {
        let Some(next) = self.waiting.front_mut() else {
            return joints;
        };
        let left = f64::from(next.cycles.max(1));
        let target = next.target;
        next.cycles = next.cycles.saturating_sub(1);
        if next.cycles == 0 {
            self.waiting.pop_front();
            return target;
        }
        std::array::from_fn(|i| joints[i] + (target[i] - joints[i]) / left)
    }
}
