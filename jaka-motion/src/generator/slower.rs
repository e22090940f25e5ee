//! What is slow enough for the tool, where the proposed states are not.

use super::Generator;
use crate::braking::{JointState, Stop};

/// Of what the tool may do, how much is looked for: what is found is compared with all of it, more exactly.
const USED: f64 = 0.98;
/// How often the step towards the proposed states is halved at most. It is above 1e-10 then.
const HALVINGS: f64 = 32.0;
/// How often the count of halvings is bisected, which leaves an eighth of one.
const BISECTIONS: u32 = 8;
/// How many steps are compared with all limits, each a quarter of the one before.
const TRIES: u32 = 3;

impl Generator {
    /// The states on the way from as fast as before, or from braking where that is too fast already, to the proposed
    /// ones: about the furthest that the tool may get to.
    ///
    /// The jerks that lead there are means of those of both ends, and so are accelerations and speeds: they keep their
    /// limits.
    pub(super) fn slower(&self, proposed: &[JointState; 6]) -> [JointState; 6] {
        let coasted = self.coasted();
        let base = if self.may_be(&coasted) { coasted } else { self.stops().map(|stop| stop.at(self.period_s)) };
        let after = |halvings: f64| {
            let share = (-halvings).exp2();
            std::array::from_fn(|index| base[index].towards(proposed[index], share))
        };
        let (mut least, mut most) = (0.0, HALVINGS);
        for _ in 0..BISECTIONS {
            let middle = f64::midpoint(least, most);
            if self.seems_slow(&after(middle)) {
                most = middle;
            } else {
                least = middle;
            }
        }
        if most >= HALVINGS {
            return base;
        }
        let mut tries = (0..TRIES).map(|tried| after(most + 2.0 * f64::from(tried)));
        tries.find(|next| self.may_be(next)).unwrap_or(base)
    }

    /// As fast as before, with accelerations that go to zero together.
    fn coasted(&self) -> [JointState; 6] {
        let ramp_s = self.ramp_s(&self.state);
        self.state.map(|state| state.coasted(self.period_s, ramp_s))
    }

    /// In which time all accelerations can go to zero, in seconds.
    fn ramp_s(&self, states: &[JointState; 6]) -> f64 {
        let each = states.iter().zip(&self.limits).map(|(state, limits)| state.acceleration.abs() / limits.jerk);
        each.fold(0.0, f64::max)
    }

    fn may_be(&self, next: &[JointState; 6]) -> bool {
        next.iter().zip(&self.limits).all(|(state, limits)| state.is_within(*limits)) && self.check(next).is_ok()
    }

    /// Whether the tool is slow enough, as far as a few places tell, on the way to these states and where it goes on as
    /// fast from there, so that it can.
    fn seems_slow(&self, next: &[JointState; 6]) -> bool {
        let ramp_s = self.ramp_s(next);
        let settled = next.map(|state| state.coasted(ramp_s, ramp_s));
        let stepped_mm = self.checker.arm().tcp_distance(&self.joints().0, &next.map(|state| state.position));
        let rate = self.checker.arm().tcp_rate(&settled.map(|state| state.position), &settled.map(|state| state.speed));
        let fast_mm = stepped_mm.max(rate * self.period_s);
        self.checker.limits().tcp_speed().is_none_or(|limit| fast_mm <= USED * limit * self.period_s)
            && [(stepped_mm, next), (rate * self.period_s, &settled)].into_iter().all(|(stepped_mm, states)| {
                self.stopping_mm.is_infinite() || stepped_mm + self.stop_mm(states) <= USED * self.stopping_mm
            })
    }

    /// How far the tool gets from these states to rest, as the crow flies, in mm.
    fn stop_mm(&self, from: &[JointState; 6]) -> f64 {
        let ends = std::array::from_fn(|index| Stop::of(from[index], self.limits[index]).end());
        self.checker.arm().tcp_distance(&from.map(|state| state.position), &ends)
    }
}
