//! The way to where a trajectory starts.

use jaka_motion::{Bound, Checker, Dynamics, Generator, Goal};
use jaka_proto::messages::types::JointPosition;

use super::{FollowConfig, start};
use crate::Error;
use crate::error::OptionName;
use crate::guard::SetPointGuard;
use crate::servo_session::{beyond_limit, generator, not_generated};

/// The way to where a trajectory starts, which is held for two periods there or more, so that the trajectory begins from a standstill at its start exactly.
#[derive(Debug)]
pub(super) struct Approach {
    generator: Generator,
    start: JointPosition,
    held: u32,
    /// For how many periods the start is to be held.
    hold: u32,
    /// True if the arm stands and does not get to the start.
    pub(super) is_blocked: bool,
    /// What slowed the last set-point.
    bound: Option<Bound>,
}

/// How fast the last hundredth of a degree is gone that counts as being there, in deg/s.
const NEXT_TO_NOTHING: f64 = 1.0;
/// How near the generator gets to its goal, in degrees; with some room.
const THERE: f64 = 2e-6;
const PERIODS_HELD: u32 = 2;

/// What asks for it.
const OPTION: OptionName = FollowConfig::option("approach");

impl Approach {
    pub(super) fn new(
        checker: &Checker,
        [from, start]: [JointPosition; 2],
        speed_deg_s: Option<f64>,
        period_s: f64,
        guard: Option<&SetPointGuard>,
    ) -> Result<Self, Error> {
        let speed = speed_deg_s.unwrap_or(NEXT_TO_NOTHING);
        let speeds = checker.limits().joint_speeds().map(|most| most.min(speed));
        let dynamics =
            Dynamics::of(checker.limits()).with_speeds(speeds).map_err(|error| not_generated(error, OPTION))?;
        let generator = generator(checker, (dynamics, OPTION), from, period_s, guard)?;
        // What is touched on the way is known before the trajectory begins.
        let hold = PERIODS_HELD + guard.map_or(0, |guard| guard.periods_unknown(period_s));
        Ok(Self { generator, start, held: 0, hold, is_blocked: false, bound: None })
    }

    /// True once the start was held for so long that the trajectory can begin.
    pub(super) fn is_done(&self) -> bool {
        self.held >= self.hold
    }

    /// Fails where it is blocked, with what is in the way, as far as that is known.
    pub(super) fn check(&self) -> Result<(), Error> {
        match &self.bound {
            _ if !self.is_blocked => Ok(()),
            Some(Bound::Limit(beyond)) => Err(beyond_limit(beyond.clone())),
            _ => Err(start::not_at_start(self.generator.joints(), self.start)),
        }
    }

    pub(super) fn is_at_rest(&self) -> bool {
        self.generator.is_at_rest()
    }

    /// The next set-point on the way.
    pub(super) fn advance(&mut self) -> JointPosition {
        if self.is_there() {
            self.held += 1;
            return self.start;
        }
        let stood_at = self.is_at_rest().then(|| self.generator.joints());
        let step = self.generator.next(&Goal::Joints(self.start));
        // Whatever keeps it there: it would stand for ever.
        self.is_blocked = self.is_at_rest() && stood_at == Some(step.joints) && !self.is_there();
        self.bound = step.bound;
        step.joints
    }

    /// The next set-point on the way to a standstill.
    pub(super) fn brake(&mut self) -> JointPosition {
        if self.held > 0 { self.start } else { self.generator.next(&Goal::Rest).joints }
    }

    pub(super) fn paused(&mut self) {
        self.generator.paused();
    }

    pub(super) fn take_back(&mut self) {
        if self.held > 0 {
            self.held -= 1;
        } else {
            self.generator.take_back();
        }
    }

    fn is_there(&self) -> bool {
        self.is_at_rest() && self.generator.joints().max_distance(&self.start) <= THERE
    }
}
