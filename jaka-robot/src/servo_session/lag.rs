//! Lag of an arm behind its set-points, and its distance from them apart from that.

use std::time::{Duration, Instant};

use jaka_proto::messages::types::JointPosition;

use crate::FollowLag;
use crate::guard::MeasuredLag;

/// Delays from 0 to this are compared, in ms.
const MOST_MS: usize = 500;
/// Fewer packets say nothing.
const FEWEST_PACKETS: u32 = 10;
/// Joints that have moved less than this, in degrees, say nothing about a delay.
const MOVED_DEG: f64 = 0.5;

/// The set-points of the last time, and the fit of each delay.
#[derive(Debug)]
pub(crate) struct LagFit {
    /// A ring, with when each was sent.
    recent: Vec<(Instant, JointPosition)>,
    next: usize,
    fits: Vec<Fit>,
    packets: u32,
    least: JointPosition,
    most: JointPosition,
}

/// Fit of a delay, for each joint.
#[derive(Debug, Clone, Copy, Default)]
struct Fit {
    squares: [f64; 6],
    worst: [f64; 6],
}

impl LagFit {
    /// For an arm at rest. All memory is taken here.
    pub(crate) fn new(now: Instant, start: JointPosition, period: Duration) -> Self {
        // Packets are compared a period after they came at most, but for one that is late.
        let most = Duration::from_millis(2 * MOST_MS as u64);
        let count = usize::try_from(most.as_nanos().div_ceil(period.as_nanos().max(1))).unwrap_or(MOST_MS);
        Self {
            recent: vec![(now, start); count + 2],
            next: 0,
            fits: vec![Fit::default(); MOST_MS + 1],
            packets: 0,
            least: start,
            most: start,
        }
    }

    /// A set-point was sent.
    pub(super) fn sent(&mut self, at: Instant, joints: JointPosition) {
        self.recent[self.next] = (at, joints);
        self.next = (self.next + 1) % self.recent.len();
    }

    /// A packet has come.
    pub(super) fn seen(&mut self, received: Instant, joints: JointPosition) {
        for joint in 0..6 {
            self.least.0[joint] = self.least.0[joint].min(joints.0[joint]);
            self.most.0[joint] = self.most.0[joint].max(joints.0[joint]);
        }
        self.packets = self.packets.saturating_add(1);
        let count = self.recent.len();
        // From the newest backwards, as the delay grows.
        let newest_first = |index: usize| self.recent[(self.next + 2 * count - 1 - index) % count];
        let mut index = 0;
        for (delay_ms, fit) in (0u64..).zip(&mut self.fits) {
            let Some(when) = received.checked_sub(Duration::from_millis(delay_ms)) else { return };
            while index + 1 < count && newest_first(index).0 > when {
                index += 1;
            }
            let (before, from) = newest_first(index);
            let (after, to) = newest_first(index.saturating_sub(1));
            let passed = when.saturating_duration_since(before).as_secs_f64();
            let whole = after.saturating_duration_since(before).as_secs_f64();
            let share = if whole > 0.0 { (passed / whole).min(1.0) } else { 0.0 };
            fit.add(|joint| joints.0[joint] - from.0[joint] - share * (to.0[joint] - from.0[joint]));
        }
    }

    /// The delay that fits best; `None` if the arm has hardly moved, or the delay is beyond the compared ones.
    pub(crate) fn best(&self) -> Option<FollowLag> {
        let (measured, best) = self.fit()?;
        if measured.is_lower_bound {
            return None;
        }
        let residual_deg = best.squares.map(|squares| (squares / f64::from(self.packets)).sqrt());
        Some(FollowLag { delay: measured.delay, residual_deg, worst_deg: best.worst, packets: self.packets })
    }

    /// The delay of the compared ones that fits best; `None` if the arm has hardly moved.
    pub(super) fn measured(&self) -> Option<MeasuredLag> {
        self.fit().map(|(measured, _)| measured)
    }

    fn fit(&self) -> Option<(MeasuredLag, &Fit)> {
        let has_moved = (0..6).any(|joint| self.most.0[joint] - self.least.0[joint] >= MOVED_DEG);
        if self.packets < FEWEST_PACKETS || !has_moved {
            return None;
        }
        let sum = |fit: &Fit| fit.squares.iter().sum::<f64>();
        let (delay_ms, best) = (0u64..).zip(&self.fits).min_by(|one, other| sum(one.1).total_cmp(&sum(other.1)))?;
        let measured =
            MeasuredLag { delay: Duration::from_millis(delay_ms), is_lower_bound: delay_ms == MOST_MS as u64 };
        Some((measured, best))
    }
}

impl Fit {
    fn add(&mut self, off: impl Fn(usize) -> f64) {
        for joint in 0..6 {
            let off = off(joint);
            self.squares[joint] += off * off;
            self.worst[joint] = self.worst[joint].max(off.abs());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PERIOD: Duration = Duration::from_millis(8);

    fn at(degrees: f64) -> JointPosition {
        JointPosition([0.0, degrees, 0.0, 0.0, 0.0, 0.0])
    }

    /// A wave that is sent, and packets each 30 ms in which the arm has it later.
    fn fitted(delay_ms: f64, size: f64) -> Option<FollowLag> {
        let start = Instant::now();
        let mut fit = LagFit::new(start, at(0.0), PERIOD);
        let wave = |ms: f64| size * (ms.max(0.0) / 300.0).sin();
        for cycle in 0..500u32 {
            let ms = f64::from(cycle) * 8.0;
            let now = start + PERIOD * cycle;
            fit.sent(now, at(wave(ms)));
            if cycle % 4 == 3 {
                fit.seen(now, at(wave(ms - delay_ms)));
            }
        }
        fit.best()
    }

    #[test]
    fn a_delay_is_found_with_what_remains() {
        for delay_ms in [0.0, 25.0, 130.0, 400.0] {
            let lag = fitted(delay_ms, 20.0).expect("the arm moves");
            assert!((lag.delay.as_secs_f64() * 1e3 - delay_ms).abs() <= 1.0, "{lag:?}");
            assert!(lag.residual_deg[1] < 0.1 && lag.worst_deg[1] < 0.2, "{lag:?}");
            assert_eq!((lag.residual_deg[0], lag.packets), (0.0, 125));
        }
    }

    #[test]
    fn an_arm_that_hardly_moves_or_lags_too_far_has_no_delay() {
        assert_eq!(fitted(25.0, 0.2), None);
        assert_eq!(fitted(900.0, 20.0), None);
    }
}
