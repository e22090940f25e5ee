//! Speeds of the joints that give the tool a velocity, or as much of it as is allowed.

use super::{Generator, finite};
use crate::beyond::Exceeded;
use crate::braking::JointLimits;
use crate::velocity::TcpVelocity;

/// Of the speeds, what is asked for at most.
const USED: f64 = 0.99;
/// Of accelerations and jerks, what slowing in front of a limit counts on: the rest is for how the joints' speeds
/// change on the tool's way.
const COUNTED_ON: f64 = 0.5;
/// In how many periods what is left of the way in front of a limit is done at most.
const CREEP_PERIODS: f64 = 10.0;
/// A joint is fast near a singularity where its distance is below this.
const NEAR: f64 = 0.1;
/// A share of the speeds below which the motion counts as slowed.
const SLOWED: f64 = 0.98;

impl Generator {
    /// How fast the joints should go, all scaled by one factor, and what made it less than 1.
    pub(super) fn speeds_for(&self, velocity: &TcpVelocity) -> ([f64; 6], Option<Exceeded>) {
        let here = self.joints().0;
        let twist = self.checker.twist_in_base(velocity, &here);
        let (rates, distances) = self.checker.arm().rates(&here, &twist);
        let near = self.checker.limits().clearance().nearest(&distances);
        let Some(rates) = rates.filter(|rates| finite(*rates)) else { return ([0.0; 6], Some(near)) };
        let (full, too_fast) = self.full_share(velocity, &rates, &near);
        let room = self.checker.room_along(&here, &rates, self.length_to_stop(&rates, full));
        let allowed = room.as_ref().map_or(full, |(length, _)| full.min(self.share_for(&rates, *length)));
        let bound = if allowed < SLOWED * full { room.map(|(_, exceeded)| exceeded) } else { too_fast };
        (rates.map(|rate| rate * allowed), bound)
    }

    pub(super) fn tcp_velocity_beyond(&self, velocity: &TcpVelocity) -> Option<Exceeded> {
        if !finite(velocity.numbers()) {
            return Some(Exceeded::NotFinite);
        }
        let (speed_mm_s, limit_mm_s) = (velocity.linear().norm(), self.checker.limits().tcp_speed()?);
        (speed_mm_s > limit_mm_s).then_some(Exceeded::TcpSpeed { speed_mm_s, limit_mm_s })
    }

    /// The share of the velocity that speeds allow, and what allows no more.
    fn full_share(&self, velocity: &TcpVelocity, rates: &[f64; 6], near: &Exceeded) -> (f64, Option<Exceeded>) {
        let share = |index: usize| USED * self.limits[index].speed / rates[index].abs();
        let least = (0..6).map(share).fold(1.0, f64::min);
        let tcp_speed = self.checker.limits().tcp_speed().unwrap_or(f64::INFINITY);
        let tcp = USED * tcp_speed / velocity.linear().norm();
        match (least < 1.0, tcp < least) {
            (_, true) => (tcp, self.tcp_velocity_beyond(velocity)),
            (true, false) => (least, Some(self.too_fast(rates, near))),
            (false, false) => (1.0, None),
        }
    }

    /// The joint that is the fastest compared with its limit, and the singularity that is near, if one is.
    fn too_fast(&self, rates: &[f64; 6], near: &Exceeded) -> Exceeded {
        let over = |index: usize| rates[index].abs() / self.limits[index].speed;
        let index = (0..6).fold(0, |worst, index| if over(index) > over(worst) { index } else { worst });
        let near = match near {
            Exceeded::Singularity { which, distance, .. } if *distance < NEAR => Some(*which),
            _ => None,
        };
        let (speed_deg_s, limit_deg_s) = (rates[index].abs(), self.limits[index].speed);
        Exceeded::JointSpeed { joint: index + 1, speed_deg_s, limit_deg_s, near }
    }

    /// How much of a second of these rates a stop takes, from a share of them.
    fn length_to_stop(&self, rates: &[f64; 6], share: f64) -> f64 {
        let (acceleration, jerk) = self.along(rates);
        let stop = if share * jerk < acceleration * acceleration {
            share * (share / jerk).sqrt()
        } else {
            0.5 * share * (share / acceleration + acceleration / jerk)
        };
        stop.max(share * CREEP_PERIODS * self.period_s)
    }

    /// The share of the rates from which a stop takes this length.
    fn share_for(&self, rates: &[f64; 6], length: f64) -> f64 {
        let (acceleration, jerk) = self.along(rates);
        let ramp = acceleration / jerk;
        let soft = (length * length * jerk).cbrt();
        let share = if soft * jerk < acceleration * acceleration {
            soft
        } else {
            0.5 * acceleration * ((ramp * ramp + 8.0 * length / acceleration).sqrt() - ramp)
        };
        share.min(length / CREEP_PERIODS / self.period_s)
    }

    /// The most acceleration and jerk along the rates, as shares of them.
    fn along(&self, rates: &[f64; 6]) -> (f64, f64) {
        let least = |of: fn(&JointLimits) -> f64| {
            let share = |index: usize| COUNTED_ON * of(&self.limits[index]) / rates[index].abs();
            (0..6).map(share).fold(f64::MAX, f64::min)
        };
        (least(|limits| limits.acceleration), least(|limits| limits.jerk))
    }
}
