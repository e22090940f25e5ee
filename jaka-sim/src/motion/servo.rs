//! Servo mode: set-points that the drives follow.

mod cartesian;
mod filter;
mod tracker;

use std::collections::VecDeque;
use std::time::Duration;

use jaka_motion::{Model, Transform};
use jaka_proto::messages::servo::SetServoMoveFilter;

use self::filter::Filter;
pub(crate) use self::filter::can_follow;
use super::path::Joints;
use crate::clock::CYCLE;
use crate::trips::{self, Observed, Trip};
use crate::underrun::Underrun;

/// The greatest speed of a joint in servo mode, in deg/s (4.15).
const MAX_SPEED: f64 = 180.0;

/// Greatest number of set-points that may wait. A client that keeps the pace has one or two.
const MOST: usize = 1000;

/// The acceleration of a set-point that comes this long after the one before is that from rest. No period is as long.
const GAP: Duration = Duration::from_millis(100);

/// A joint that is slower than this stands still, in deg/s.
const STILL: f64 = 1e-6;

/// The error of a controller that cannot compute joint positions for a pose.
const NO_INVERSE: u32 = 0x0f_0004;

/// Servo mode, from where it was entered: the set-points that wait, and the one that is under way.
#[derive(Debug, Clone)]
pub(crate) struct Servo {
    waiting: VecDeque<SetPoint>,
    /// The cycles left of the set-point that is under way.
    left: u32,
    reference: ServoReference,
    filter: Filter,
    /// Commanded joint positions, in degrees.
    commanded: Joints,
    underrun: Underrun,
    /// For how long set-points have been missing while there was speed.
    dry: Duration,
    trips: Vec<Trip>,
    /// Time of arrival of the last set-point.
    last: Duration,
    /// Error that has ended servo mode, as a code of the vendor's table.
    error: Option<u32>,
}

/// Position and speed to which the set-points have led by now.
#[derive(Debug, Clone, Copy)]
struct ServoReference {
    joints: Joints,
    /// Over the period of the last set-point, or after a run-out the last cycle, in deg/s.
    speed: Joints,
    space: Space,
}

/// Space in which a set-point is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Space {
    Joints,
    Pose,
}

/// A set-point that has been received.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SetPoint {
    pub(crate) target: Joints,
    pub(crate) space: Space,
    pub(crate) cycles: u32,
    /// Time of arrival of the set-point.
    pub(crate) time: Duration,
}

/// Options of servo mode.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ServoOptions<'a> {
    pub(crate) filter: &'a SetServoMoveFilter,
    pub(crate) tool: Transform,
    pub(crate) underrun: Underrun,
    pub(crate) trips: &'a [Trip],
}

impl Servo {
    /// Servo mode of an arm that is at rest.
    pub(crate) fn new(at: Joints, options: ServoOptions<'_>, model: &Model) -> Self {
        Self {
            waiting: VecDeque::new(),
            left: 0,
            reference: ServoReference { joints: at, speed: [0.0; 6], space: Space::Joints },
            filter: Filter::new(options.filter, at, options.tool, model),
            commanded: at,
            underrun: options.underrun,
            dry: Duration::ZERO,
            trips: options.trips.to_vec(),
            last: Duration::ZERO,
            error: None,
        }
    }

    /// Joint position to which the set-points lead, in degrees.
    pub(crate) fn tail(&self) -> Joints {
        self.waiting.back().map_or(self.reference.joints, |last| last.target)
    }

    /// Takes a set-point. One that asks more than 180 deg/s of a joint has no effect, unless the drives trip on it.
    pub(crate) fn push(&mut self, set_point: SetPoint) {
        let speed = set_point.speed(self.tail());
        let within = speed.iter().all(|speed| speed.abs() <= MAX_SPEED + 1e-6);
        let is_taken = within || self.trip(speed, [0.0; 6]).is_some();
        if is_taken && self.waiting.len() < MOST {
            let is_held = self.waiting.is_empty() && !matches!(self.underrun, Underrun::RunOut(_));
            if is_held && set_point.time > self.last + GAP {
                self.reference.speed = [0.0; 6];
            }
            self.last = set_point.time;
            self.waiting.push_back(set_point);
        }
    }

    /// Forgets the set-points that wait.
    pub(super) fn stop(&mut self) {
        self.waiting.clear();
        self.left = 0;
        self.reference.speed = [0.0; 6];
    }

    pub(crate) fn is_moving(&self) -> bool {
        let is_dry = self.underrun != Underrun::Hold && !self.reference.is_still();
        !self.waiting.is_empty() || is_dry || !self.filter.is_settled(self.commanded, &self.reference)
    }

    /// Takes the error that has ended servo mode, as a code of the vendor's table.
    pub(crate) fn take_error(&mut self) -> Option<u32> {
        self.error.take()
    }

    /// One cycle: where the joints are commanded to be.
    pub(super) fn cycle(&mut self, model: &Model) -> Joints {
        if !self.waiting.is_empty() {
            self.approach();
        } else if !self.reference.is_still() {
            self.run_dry(model);
        }
        if self.error.is_none() {
            match self.filter.next(self.commanded, &self.reference, model) {
                Some(next) => self.commanded = next,
                None => self.error = Some(NO_INVERSE),
            }
        }
        self.commanded
    }

    /// An even share of the way to the set-point.
    fn approach(&mut self) {
        let Some(next) = self.waiting.front().copied() else { return };
        if self.left == 0 {
            self.begin(next);
        }
        if self.error.is_some() {
            return;
        }
        let (at, share) = (self.reference.joints, 1.0 / f64::from(self.left));
        self.left -= 1;
        self.reference.joints = std::array::from_fn(|i| at[i] + (next.target[i] - at[i]) * share);
        if self.left == 0 {
            self.reference.joints = next.target;
            self.waiting.pop_front();
        }
    }

    /// The event of a set-point that asks for these speeds and accelerations, if there is one.
    fn trip(&self, command_speed: Joints, command_acceleration: Joints) -> Option<u32> {
        trips::error(&self.trips, &Observed { command_speed, command_acceleration, ..Observed::default() })
    }

    /// Judges a set-point by the one before, each over its period.
    fn begin(&mut self, next: SetPoint) {
        let ServoReference { joints, speed: before, .. } = self.reference;
        let speed = next.speed(joints);
        let acceleration = std::array::from_fn(|i| (speed[i] - before[i]) / next.period());
        self.error = self.trip(speed, acceleration);
        self.reference = ServoReference { joints, speed, space: next.space };
        self.left = next.cycles.max(1);
        self.dry = Duration::ZERO;
    }

    /// A cycle without a set-point after one that had speed.
    fn run_dry(&mut self, model: &Model) {
        self.dry += CYCLE;
        match self.underrun {
            Underrun::Hold => {}
            Underrun::Fault(after) if self.dry < after => {}
            Underrun::Fault(_) => self.error = Some(trips::command_error(self.reference.speed)),
            Underrun::RunOut(deceleration) => self.run_out(deceleration, model),
        }
    }

    /// Goes on at the last speed, which all joints lose at the same rate, at most as far as the joints' ranges.
    fn run_out(&mut self, deceleration: f64, model: &Model) {
        let ServoReference { joints, speed, .. } = &mut self.reference;
        let cycle = CYCLE.as_secs_f64();
        let fastest = speed.iter().map(|speed| speed.abs()).fold(0.0, f64::max);
        let kept = (1.0 - deceleration.max(0.0) * cycle / fastest).max(0.0);
        *speed = speed.map(|speed| speed * kept);
        let next: Joints = std::array::from_fn(|i| joints[i] + speed[i] * cycle);
        if model.is_within_range(next) {
            *joints = next;
        } else {
            *speed = [0.0; 6];
        }
    }
}

impl ServoReference {
    fn is_still(&self) -> bool {
        self.speed.iter().all(|speed| speed.abs() < STILL)
    }
}

impl SetPoint {
    /// Its nominal period, in seconds.
    fn period(&self) -> f64 {
        CYCLE.as_secs_f64() * f64::from(self.cycles.max(1))
    }

    /// Speeds of the joints on the path from a position to the set-point, in deg/s.
    fn speed(&self, from: Joints) -> Joints {
        std::array::from_fn(|i| (self.target[i] - from[i]) / self.period())
    }
}
