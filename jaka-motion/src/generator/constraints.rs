//! Limits of a generated motion, and the pace that they allow.

use jaka_proto::messages::types::JointPosition;

use super::{Led, finite};
use crate::beyond::{Beyond, Exceeded, Way};
use crate::braking::{JointLimits, JointState, Stop, StopBound};
use crate::checker::Checker;
use crate::limits::RATES;
use crate::speed::TcpVelocity;

/// Limits of a generated motion: limits of the arm, of its joints' dynamics, and of a tool that must be able to stop.
///
/// The parameter `state` is the state at the last set-point.
#[derive(Debug, Clone)]
pub(super) struct Constraints {
    pub(super) checker: Checker,
    pub(super) limits: [JointLimits; 6],
    /// Greatest jerk of each joint in a stop, in deg/s³.
    stop_jerks: [f64; 6],
    pub(super) period_s: f64,
    /// Longest distance that the tool may still travel until the arm stops, in mm.
    pub(super) stopping_mm: f64,
}

/// Pace that the tool allows to rates of the joints.
pub(super) struct ToolPace {
    /// Allowed share of the rates.
    pub(super) share: f64,
    /// Limits of the joints at this pace, in proportion to the rates. All joints then move alike, so a straight path
    /// stays straight.
    pub(super) limits: [JointLimits; 6],
    /// Limit that restricts the pace; `None` if only the reserve does.
    pub(super) exceeded: Option<Exceeded>,
}

/// Planned share of the tool's limits. The rest covers changes of the tool's motion along the path at constant joint
/// speeds.
const PACE_USED: f64 = 0.9;
/// Greatest number of cuts of the speed for a stop that is too long, and the factor of each cut.
const CUTS: u32 = 24;
const CUT: f64 = 0.8;
/// Share of the tool's limits that the search uses; its result is compared with the full limits, more exactly.
const STEP_USED: f64 = 0.98;
/// Greatest number of halvings of the step towards the proposed states, which leaves the step above 1e-10.
const HALVINGS: f64 = 32.0;
/// Number of bisections of the count of halvings, down to an eighth of a halving.
const BISECTIONS: u32 = 8;
/// Number of steps that are compared with all limits, each a quarter of the step before.
const TRIES: u32 = 3;
/// Greatest requested share of the speeds.
const VELOCITY_USED: f64 = 0.99;
/// Share of accelerations and jerks that slowing in front of a limit relies on. The rest covers changes of the joints'
/// speeds on the tool's path.
const COUNTED_ON: f64 = 0.5;
/// Least number of periods for the rest of the path in front of a limit.
const CREEP_PERIODS: f64 = 10.0;
/// Distance from a singularity below which an error for a fast joint names the singularity.
const NEAR: f64 = 0.1;
/// Least share of a motion's acceleration with which a joint stops, however slow it is relative to others.
const LEAST_STOP: f64 = 1e-3;
/// Share of the speeds below which the motion counts as slowed.
const SLOWED: f64 = 0.98;

impl Constraints {
    pub(super) fn new(checker: Checker, limits: [JointLimits; 6], period_s: f64) -> Self {
        let stop_jerks = std::array::from_fn(|index| limits[index].jerk.max(checker.limits().stop_jerks()[index]));
        Self { checker, limits, stop_jerks, period_s, stopping_mm: f64::INFINITY }
    }

    pub(super) fn at_rest(&self, joints: &[f64; 6]) -> Led {
        let state = joints.map(JointState::at_rest);
        let (stops, bound) = self.stops(&state);
        Led { state, stops, bound, stops_already: false }
    }

    /// Moves the arm to these states if it can stop from them.
    pub(super) fn led(&self, state: &[JointState; 6], next: [JointState; 6]) -> Result<Led, Exceeded> {
        let (stops, bound) = self.stops(&next);
        let last = positions(state);
        let rested = is_at_rest(state).then_some(&last);
        self.checker.check_stops(rested, &last, &stops, (self.period_s, self.stopping_mm))?;
        Ok(Led { state: next, stops, bound, stops_already: false })
    }

    /// Moves the arm on towards rest within the dynamics, if it can stop from the next state.
    pub(super) fn slowed(&self, state: &[JointState; 6]) -> Option<Led> {
        let stops: [Stop; 6] = std::array::from_fn(|index| Stop::of(state[index], self.limits[index]));
        self.may_be(state, stops.map(|stop| stop.at(self.period_s)))
    }

    /// Returns the paths of the joints to rest by a stop from these states. The stop follows their velocity once
    /// accelerations that do not brake have ended.
    fn stops(&self, state: &[JointState; 6]) -> ([Stop; 6], StopBound) {
        let velocity = std::array::from_fn(|index| state[index].coasting_speed(self.stop_jerks[index]));
        let rates = self.checker.stop_rates(&positions(state), &velocity, &self.stop_jerks);
        let stops = std::array::from_fn(|index| {
            let most = (rates.share * velocity[index].abs()).max(LEAST_STOP * self.limits[index].acceleration);
            let jerks = [most / rates.ramp_s, self.stop_jerks[index]];
            Stop::within(state[index], [most, jerks[0].min(jerks[1]), jerks[1]])
        });
        (stops, rates.bound)
    }

    /// Returns the nearest joint positions within the joints' ranges.
    pub(super) fn in_range(&self, target: JointPosition) -> [f64; 6] {
        let limits = self.checker.limits();
        std::array::from_fn(|index| target.0[index].clamp(limits.joint_min()[index], limits.joint_max()[index]))
    }

    /// Returns the limit of a joint that stops at the end of its range although its goal is beyond.
    pub(super) fn held_in_range(&self, state: &[JointState; 6], speeds: &[f64; 6]) -> Option<Exceeded> {
        let limits = self.checker.limits();
        (0..6).find_map(|index| {
            let (speed, position_deg) = (speeds[index], state[index].position);
            let limit_deg = if speed > 0.0 { limits.joint_max()[index] } else { limits.joint_min()[index] };
            let is_slowed = state[index].speed.abs() < 0.99 * speed.abs();
            let is_held = is_slowed && (limit_deg - position_deg).abs() < self.stopping_room(index);
            is_held.then_some(Exceeded::LandingRange { joint: index + 1, end_deg: position_deg, limit_deg })
        })
    }

    pub(super) fn speeds_beyond(&self, speeds: &[f64; 6]) -> Option<Exceeded> {
        if !finite(*speeds) {
            return Some(Exceeded::NotFinite);
        }
        let index = (0..6).find(|index| speeds[*index].abs() > self.limits[*index].speed)?;
        let (speed_deg_s, limit_deg_s) = (speeds[index].abs(), self.limits[index].speed);
        Some(Exceeded::JointSpeed { joint: index + 1, speed_deg_s, limit_deg_s, near: None })
    }

    pub(super) fn beyond(&self, exceeded: Exceeded) -> Beyond {
        self.checker.beyond_of(Way::SetPoint, exceeded)
    }

    /// Returns the pace that the tool allows on the path to a target; `None` if it allows all speeds of the joints.
    pub(super) fn tool_pace_to(&self, state: &[JointState; 6], target: &[f64; 6]) -> Option<ToolPace> {
        let by: [f64; 6] = std::array::from_fn(|index| target[index] - state[index].position);
        let seconds = (0..6).map(|index| by[index].abs() / self.limits[index].speed).fold(0.0, f64::max);
        self.tool_pace(state, &by, 1.0 / seconds)
    }

    /// Returns the pace that the tool allows for these rates; `None` if that is no less than `most`, the share that the
    /// joints allow.
    pub(super) fn tool_pace(&self, state: &[JointState; 6], rates: &[f64; 6], most: f64) -> Option<ToolPace> {
        let limit_mm_s = self.checker.limits().tcp_speed()?;
        let here = positions(state);
        let rate_mm = self.checker.arm().tcp_rate(&here, rates);
        let fast = most.min(PACE_USED * limit_mm_s / rate_mm);
        let way_mm = |share: f64| self.way_to_rest(&here, rates, share, rate_mm);
        let mut shares = (0..CUTS).scan(fast, |share, _| Some(std::mem::replace(share, CUT * *share)));
        let share = shares.find(|share| way_mm(*share) <= PACE_USED * self.stopping_mm).unwrap_or(fast);
        (share < most).then(|| {
            let (speed_mm_s, way_mm, limit_mm) = (most * rate_mm, way_mm(most), self.stopping_mm);
            let exceeded = match (speed_mm_s > limit_mm_s, way_mm > limit_mm) {
                (true, _) => Some(Exceeded::TcpSpeed { speed_mm_s, limit_mm_s }),
                (false, true) => Some(Exceeded::LandingWay { way_mm, limit_mm }),
                (false, false) => None,
            };
            ToolPace { share, limits: self.in_proportion(state, &rates.map(|rate| share * rate)), exceeded }
        })
    }

    /// Returns about the furthest states towards the proposed ones that the tool allows. The search starts from the
    /// states at constant speed, or from braking if constant speed is already too fast.
    ///
    /// The jerks to the result are means of the jerks to both ends, and so are accelerations and speeds: they keep
    /// their limits.
    pub(super) fn slower(&self, state: &[JointState; 6], proposed: &[JointState; 6]) -> Option<Led> {
        let coasted = self.coasted(state);
        let led = self.may_be(state, coasted).or_else(|| self.slowed(state))?;
        let base = led.state;
        let after = |halvings: f64| {
            let share = (-halvings).exp2();
            std::array::from_fn(|index| base[index].towards(proposed[index], share))
        };
        let (mut least, mut most) = (0.0, HALVINGS);
        for _ in 0..BISECTIONS {
            let middle = f64::midpoint(least, most);
            if self.seems_slow(state, &after(middle)) {
                most = middle;
            } else {
                least = middle;
            }
        }
        if most >= HALVINGS {
            return Some(led);
        }
        let mut tries = (0..TRIES).map(|tried| after(most + 2.0 * f64::from(tried)));
        tries.find_map(|next| self.may_be(state, next)).or(Some(led))
    }

    /// Returns the speeds of the joints for a velocity of the tool, in deg/s, all scaled by one factor, and the limit
    /// that made the factor less than 1.
    pub(super) fn speeds_for(&self, state: &[JointState; 6], velocity: &TcpVelocity) -> ([f64; 6], Option<Exceeded>) {
        let here = positions(state);
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

    /// Returns the angle that a joint needs to stop from its full speed, in degrees.
    fn stopping_room(&self, index: usize) -> f64 {
        let fast = JointState { speed: self.limits[index].speed, ..JointState::default() };
        Stop::of(fast, self.limits[index]).end()
    }

    /// Returns the distance that the tool travels in a period at this share of the rates, and then to rest, in mm; 0 if
    /// there is no bound for it.
    fn way_to_rest(&self, here: &[f64; 6], rates: &[f64; 6], share: f64, rate_mm: f64) -> f64 {
        if self.stopping_mm.is_infinite() {
            return 0.0;
        }
        let speeds = rates.map(|rate| share * rate);
        let stop = self.checker.stop_rates(here, &speeds, &self.stop_jerks).stop();
        share * rate_mm * (self.period_s + stop.end())
    }

    /// Returns the limits in proportion to these speeds, or to the joints' present speeds if they are higher.
    fn in_proportion(&self, state: &[JointState; 6], speeds: &[f64; 6]) -> [JointLimits; 6] {
        let speeds: [f64; 6] = std::array::from_fn(|index| {
            let speed = speeds[index].abs().max(state[index].speed.abs()).max(*RATES.start());
            speed.min(self.limits[index].speed)
        });
        let least = |of: fn(&JointLimits) -> f64, start: f64| {
            self.limits.iter().zip(&speeds).map(|(limits, speed)| of(limits) / speed).fold(start, f64::min)
        };
        // No limit is reached in less than a period, as in `Dynamics::joint_limits`.
        let faster = least(|limits| limits.acceleration, 1.0 / self.period_s);
        let sooner = least(|limits| limits.jerk, faster / self.period_s);
        speeds.map(|speed| JointLimits { speed, acceleration: faster * speed, jerk: sooner * speed })
    }

    /// Returns the states at constant speed, with accelerations that go to zero together.
    fn coasted(&self, state: &[JointState; 6]) -> [JointState; 6] {
        let ramp_s = self.ramp_s(state);
        state.map(|state| state.coasted(self.period_s, ramp_s))
    }

    /// Returns the time in which all accelerations can go to zero, in seconds.
    fn ramp_s(&self, states: &[JointState; 6]) -> f64 {
        let each = states.iter().zip(&self.limits).map(|(state, limits)| state.acceleration.abs() / limits.jerk);
        each.fold(0.0, f64::max)
    }

    /// Moves the arm to these states if the dynamics allow them and it can stop from them.
    fn may_be(&self, state: &[JointState; 6], next: [JointState; 6]) -> Option<Led> {
        let is_within = next.iter().zip(&self.limits).all(|(next, limits)| next.is_within(*limits));
        if is_within { self.led(state, next).ok() } else { None }
    }

    /// Whether the tool is slow enough, at a few sampled places, on the path to these states and beyond them at
    /// constant speed.
    fn seems_slow(&self, state: &[JointState; 6], next: &[JointState; 6]) -> bool {
        let ramp_s = self.ramp_s(next);
        let settled = next.map(|state| state.coasted(ramp_s, ramp_s));
        let stepped_mm = self.checker.arm().tcp_distance(&positions(state), &positions(next));
        let rate = self.checker.arm().tcp_rate(&positions(&settled), &settled.map(|state| state.speed));
        let fast_mm = stepped_mm.max(rate * self.period_s);
        self.checker.limits().tcp_speed().is_none_or(|limit| fast_mm <= STEP_USED * limit * self.period_s)
            && [(stepped_mm, next), (rate * self.period_s, &settled)].into_iter().all(|(stepped_mm, states)| {
                self.stopping_mm.is_infinite() || stepped_mm + self.stop_mm(states) <= STEP_USED * self.stopping_mm
            })
    }

    /// Returns the straight-line distance that the tool moves from these states to rest, in mm.
    fn stop_mm(&self, from: &[JointState; 6]) -> f64 {
        self.checker.arm().tcp_distance(&positions(from), &self.stops(from).0.map(|stop| stop.end()))
    }

    /// Returns the share of the velocity that the speed limits allow, and the limit that restricts it.
    fn full_share(&self, velocity: &TcpVelocity, rates: &[f64; 6], near: &Exceeded) -> (f64, Option<Exceeded>) {
        let share = |index: usize| VELOCITY_USED * self.limits[index].speed / rates[index].abs();
        let least = (0..6).map(share).fold(1.0, f64::min);
        let tcp_speed = self.checker.limits().tcp_speed().unwrap_or(f64::INFINITY);
        let tcp = VELOCITY_USED * tcp_speed / velocity.linear().norm();
        match (least < 1.0, tcp < least) {
            (_, true) => (tcp, self.tcp_velocity_beyond(velocity)),
            (true, false) => (least, Some(self.too_fast(rates, near))),
            (false, false) => (1.0, None),
        }
    }

    /// Returns the error for the joint that is fastest relative to its limit, with the nearby singularity, if any.
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

    /// Returns the length of a stop from a share of these rates, in seconds at the full rates.
    fn length_to_stop(&self, rates: &[f64; 6], share: f64) -> f64 {
        let (acceleration, jerk) = self.along(rates);
        let stop = if share * jerk < acceleration * acceleration {
            share * (share / jerk).sqrt()
        } else {
            0.5 * share * (share / acceleration + acceleration / jerk)
        };
        stop.max(share * CREEP_PERIODS * self.period_s)
    }

    /// Returns the share of the rates from which a stop takes this length.
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

    /// Returns the greatest acceleration and jerk along the rates, as shares of the rates.
    fn along(&self, rates: &[f64; 6]) -> (f64, f64) {
        let least = |of: fn(&JointLimits) -> f64| {
            let share = |index: usize| COUNTED_ON * of(&self.limits[index]) / rates[index].abs();
            (0..6).map(share).fold(f64::MAX, f64::min)
        };
        (least(|limits| limits.acceleration), least(|limits| limits.jerk))
    }
}

/// Returns the positions of the joints.
pub(super) fn positions(state: &[JointState; 6]) -> [f64; 6] {
    state.map(|state| state.position)
}

/// Whether no joint moves.
pub(super) fn is_at_rest(state: &[JointState; 6]) -> bool {
    state.iter().all(|state| *state == JointState::at_rest(state.position))
}
