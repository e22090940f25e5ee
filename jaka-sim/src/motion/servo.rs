//! Servo mode: set-points that the drives follow.

mod cartesian;
mod filter;
mod tracker;

use std::collections::VecDeque;
use std::time::Duration;

use jaka_motion::Model;

pub(crate) use self::filter::{Filter, can_follow};
use super::path::Joints;
use crate::clock::CYCLE;
use crate::trips::{self, Observed, Trip};
use crate::underrun::Underrun;

/// Greatest speed of a joint in servo mode, in deg/s (4.15).
const MAX_SPEED: f64 = 180.0;

/// Greatest number of waiting set-points. A client with the correct period has one or two.
const MOST: usize = 1000;

/// Time between set-points beyond which the acceleration counts from rest. No period is as long.
const GAP: Duration = Duration::from_millis(100);

/// Speed below which a joint is at rest, in deg/s.
const STILL: f64 = 1e-6;

/// Error code of a controller that cannot compute joint positions for a pose.
const NO_INVERSE: u32 = 0x0f_0004;

/// Servo mode since its entry: the waiting set-points, and the active one.
#[derive(Debug, Clone)]
pub(crate) struct Servo {
    waiting: VecDeque<SetPoint>,
    /// Remaining cycles of the active set-point.
    left: u32,
    reference: ServoReference,
    filter: Filter,
    /// Commanded joint positions, in degrees.
    commanded: Joints,
    underrun: Underrun,
    /// Time without set-points after one with speed.
    dry: Duration,
    trips: Vec<Trip>,
    /// Time of arrival of the last set-point.
    last: Duration,
    /// Error that ended servo mode, as a code of the vendor's table.
    error: Option<u32>,
}

/// Present position and speed along the set-points.
#[derive(Debug, Clone, Copy)]
struct ServoReference {
    joints: Joints,
    /// Speed over the period of the last set-point, or after a run-out over the last cycle, in deg/s.
    speed: Joints,
    space: Space,
}

/// Space of a set-point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Space {
    Joints,
    Pose,
}

/// Received set-point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SetPoint {
    pub(crate) target: Joints,
    pub(crate) space: Space,
    pub(crate) cycles: u32,
    /// Time of arrival of the set-point.
    pub(crate) time: Duration,
}

impl Servo {
    /// Creates the servo mode of an arm at rest.
    pub(crate) fn new(at: Joints, filter: Filter, underrun: Underrun, trips: Vec<Trip>) -> Self {
        Self {
            waiting: VecDeque::new(),
            left: 0,
            reference: ServoReference { joints: at, speed: [0.0; 6], space: Space::Joints },
            filter,
            commanded: at,
            underrun,
            dry: Duration::ZERO,
            trips,
            last: Duration::ZERO,
            error: None,
        }
    }

    /// Returns the joint position at the last set-point, in degrees.
    pub(crate) fn tail(&self) -> Joints {
        self.waiting.back().map_or(self.reference.joints, |last| last.target)
    }

    /// Adds a set-point. A set-point with more than 180 deg/s for a joint has no effect, unless the drives trip on it.
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

    /// Discards the waiting set-points.
    pub(crate) fn stop(&mut self) {
        self.waiting.clear();
        self.left = 0;
        self.reference.speed = [0.0; 6];
    }

    pub(crate) fn is_moving(&self) -> bool {
        let is_dry = self.underrun != Underrun::Hold && !self.reference.is_still();
        !self.waiting.is_empty() || is_dry || !self.filter.is_settled(self.commanded, &self.reference)
    }

    /// Takes the error that ended servo mode, as a code of the vendor's table.
    pub(crate) fn take_error(&mut self) -> Option<u32> {
        self.error.take()
    }

    /// Computes one cycle, and returns the commanded joint position.
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

    /// Moves an equal share of the distance to the set-point.
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

    /// Returns the event for a set-point with these speeds and accelerations, if there is one.
    fn trip(&self, command_speed: Joints, command_acceleration: Joints) -> Option<u32> {
        trips::error(&self.trips, &Observed { command_speed, command_acceleration, ..Observed::default() })
    }

    /// Checks a set-point against the previous one, each over its period.
    fn begin(&mut self, next: SetPoint) {
        let ServoReference { joints, speed: before, .. } = self.reference;
        let speed = next.speed(joints);
        let acceleration = std::array::from_fn(|i| (speed[i] - before[i]) / next.period());
        self.error = self.trip(speed, acceleration);
        self.reference = ServoReference { joints, speed, space: next.space };
        self.left = next.cycles.max(1);
        self.dry = Duration::ZERO;
    }

    /// Computes a cycle without a set-point after one with speed.
    fn run_dry(&mut self, model: &Model) {
        self.dry += CYCLE;
        match self.underrun {
            Underrun::Hold => {}
            Underrun::Fault(after) if self.dry < after => {}
            Underrun::Fault(_) => self.error = Some(trips::command_error(self.reference.speed)),
            Underrun::RunOut(deceleration) => self.run_out(deceleration, model),
        }
    }

    /// Continues at the last speed, which decreases at the same rate for all joints, up to the end of the joints'
    /// ranges.
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
    /// Returns the nominal period, in seconds.
    fn period(&self) -> f64 {
        CYCLE.as_secs_f64() * f64::from(self.cycles.max(1))
    }

    /// Returns the speeds of the joints on the path from a position to the set-point, in deg/s.
    fn speed(&self, from: Joints) -> Joints {
        std::array::from_fn(|i| (self.target[i] - from[i]) / self.period())
    }
}
