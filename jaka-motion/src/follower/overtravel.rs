//! Overtravel of the tool after a contact, if the arm then brakes along a trajectory.

use super::{Follower, State};
use crate::checker::Checker;

/// Overtravel of the tool after a contact on a trajectory: see [`Follower::worst_overtravel`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Overtravel {
    /// Trajectory time of the contact, in seconds.
    pub time_s: f64,
    /// Distance that the tool centre point travels from the contact to rest, in mm along its path; infinite if braking
    /// takes longer than 0.5 s and the rest of the trajectory is longer than the allowed distance.
    pub way_mm: f64,
    /// Time from the contact until the tool brakes, in seconds: the delay, rounded up to periods, and one period more,
    /// since the contact can come at any moment of a period.
    pub unbraked_s: f64,
    /// Greatest speed of the tool on that path, as mean over a period, in mm/s.
    pub speed_mm_s: f64,
    /// Even deceleration with the same braking distance, in mm/s²; infinite if the tool rests at once.
    pub braking_mm_s2: f64,
}

/// Distance of the tool at each set-point, in mm from the start, and the number of periods from a contact to the
/// braking.
pub(super) struct Travel<'a> {
    follower: &'a Follower,
    gone_mm: Vec<f64>,
    unbraked: usize,
}

/// Longest time that braking may take, in seconds.
const LONGEST_S: f64 = 0.5;
/// Number of contacts that share a bound.
const TOGETHER: usize = 16;
/// Numbers of periods of braking, each tried for a bound.
const AHEAD: [usize; 3] = [2, 12, 64];
/// Relative error by which [`Trajectory::rate_change`](crate::Trajectory::rate_change) may overstate a speed or an
/// acceleration.
const PEAK: f64 = 1e-4;

impl<'a> Travel<'a> {
    /// Creates the travel for a contact at any set-point at the rate 1, and braking some seconds after it.
    pub(super) fn new(follower: &'a Follower, checker: &Checker, delay_s: f64) -> Self {
        let unbraked = periods(delay_s, follower.period_s).saturating_add(1);
        let mut travel = Self { follower, gone_mm: Vec::new(), unbraked };
        let (mut way_mm, mut before) = (0.0, follower.trajectory.start());
        let found = (0..=periods(follower.duration_s, follower.period_s)).map(|place| {
            let joints = follower.trajectory.at(travel.time_at(place)).joints;
            way_mm += checker.arm().tcp_distance(&before.0, &joints.0);
            before = joints;
            way_mm
        });
        travel.gone_mm = found.collect();
        travel
    }

    /// Returns the contact with the longest travel of the tool after it, if that is longer than allowed.
    pub(super) fn worst(&self, allowed_mm: f64) -> Option<Overtravel> {
        let unbraked = self.contacts().map(|contact| (contact, self.between(contact, self.braked_from(contact))));
        let furthest = furthest(unbraked)?;
        let (contact, way_mm) = if furthest.1 > allowed_mm {
            (furthest.0, self.overtravel_mm(furthest.0))
        } else {
            self.furthest_braked(allowed_mm)?
        };
        Some(self.told(contact, way_mm))
    }

    /// Returns the contact with the longest travel of the tool to rest, and its length, if that is longer than allowed.
    fn furthest_braked(&self, allowed_mm: f64) -> Option<(usize, f64)> {
        let (contacts, mut worst) = (self.contacts(), None);
        for first in contacts.clone().step_by(TOGETHER) {
            let together = first..(first + TOGETHER).min(contacts.end);
            let braking = self.braking_at_most(self.braked_from(first), self.braked_from(together.end - 1));
            for contact in together {
                let most = worst.map_or(allowed_mm, |(_, way_mm)| way_mm);
                let rest = braking.map_or(self.last(), |periods| self.braked_from(contact) + periods);
                if self.between(contact, rest) > most {
                    worst = Some((contact, self.overtravel_mm(contact))).filter(|found| found.1 > most).or(worst);
                }
            }
        }
        worst
    }

    /// Returns a bound of the number of trajectory periods that braking still covers after any of these set-points, if
    /// it is known. For the bound the rate falls in each period by the least fall that is permitted in all of them.
    fn braking_at_most(&self, first: usize, last: usize) -> Option<usize> {
        let limits = self.follower.trajectory.joint_accelerations();
        if (0..6).any(|joint| self.follower.checker.limits().joint_accelerations()[joint] < limits[joint]) {
            return None;
        }
        AHEAD.into_iter().find_map(|ahead| {
            let (from_s, to_s) = (self.time_at(first.saturating_sub(1)), self.time_at(last + ahead + 1));
            // A joint that gains speed leaves the least room at a low rate, others at a high one.
            let at_rate = |rate: f64| self.follower.trajectory.rate_change(from_s, to_s, rate).fall;
            let fall = (at_rate(1.0 + PEAK).min(at_rate(0.0)) * (1.0 - 2.0 * PEAK) * self.follower.period_s).min(1.0);
            let falls = (1.0 / fall).floor();
            let periods = falls - 0.5 * fall * falls * (falls + 1.0);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is compared before")]
            #[expect(clippy::cast_precision_loss, reason = "a count of periods")]
            (periods <= ahead as f64).then_some(periods.ceil() as usize)
        })
    }

    fn overtravel_mm(&self, contact: usize) -> f64 {
        let rest = self.rest_from(self.braked_from(contact));
        rest.map_or(f64::INFINITY, |rest| self.between(contact, rest))
    }

    /// Returns the set-point at or after which the tool rests, if it brakes after this one; `None` if that takes too
    /// long.
    fn rest_from(&self, place: usize) -> Option<usize> {
        let (time_s, before_s) = (self.time_at(place), self.time_at(place.saturating_sub(1)));
        let (joints, before) =
            (self.follower.trajectory.at(time_s).joints, self.follower.trajectory.at(before_s).joints);
        let step = std::array::from_fn(|joint| joints.0[joint] - before.0[joint]);
        let mut braking = self.follower.clone();
        braking.state = State { time_s, rate: 1.0, change: 0.0, joints, step };
        (braking.scale, braking.brakes) = (0.0, true);
        for _ in 0..=periods(LONGEST_S, self.follower.period_s) {
            if braking.is_at_rest() {
                return Some(periods(braking.time_s(), self.follower.period_s));
            }
            braking.advance();
        }
        None
    }

    fn told(&self, contact: usize, way_mm: f64) -> Overtravel {
        let braked = self.braked_from(contact);
        let speed = |place: usize| self.between(place.saturating_sub(1), place) / self.follower.period_s;
        let (braking_mm, speed_then) = (way_mm - self.between(contact, braked), speed(braked));
        Overtravel {
            time_s: self.time_at(contact),
            way_mm,
            unbraked_s: self.seconds(self.unbraked),
            speed_mm_s: (contact + 1..=braked).map(speed).fold(0.0, f64::max),
            braking_mm_s2: if braking_mm > 0.0 { speed_then * speed_then / (2.0 * braking_mm) } else { f64::INFINITY },
        }
    }

    fn time_at(&self, place: usize) -> f64 {
        self.seconds(place).min(self.follower.duration_s)
    }

    fn seconds(&self, periods: usize) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "a count of periods")]
        let periods = periods as f64;
        periods * self.follower.period_s
    }

    /// Returns the set-points after which a contact is possible, without those at the end, which leave less travel than
    /// these.
    fn contacts(&self) -> std::ops::Range<usize> {
        0..self.last().saturating_sub(self.unbraked) + 1
    }

    /// Returns the last set-point that does not brake.
    fn braked_from(&self, contact: usize) -> usize {
        contact.saturating_add(self.unbraked).min(self.last())
    }

    fn between(&self, from: usize, to: usize) -> f64 {
        self.gone_mm[to.min(self.last())] - self.gone_mm[from]
    }

    fn last(&self) -> usize {
        self.gone_mm.len().saturating_sub(1)
    }
}

fn furthest(contacts: impl Iterator<Item = (usize, f64)>) -> Option<(usize, f64)> {
    contacts.max_by(|one, other| one.1.total_cmp(&other.1))
}

/// Returns the number of periods in a time, rounded up.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "what is beyond is cut")]
fn periods(time_s: f64, period_s: f64) -> usize {
    (time_s / period_s - 1e-9).ceil() as usize
}
