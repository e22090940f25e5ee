//! Motion of the arm, cycle by cycle.
//!
//! Planned motions wait in a queue, and each follows its path under a trapezoidal speed profile. Jogs and servo
//! set-points move the arm without the queue. The results are commanded joint positions; the drives follow them.

mod blend;
mod drives;
mod jog;
mod path;
mod profile;
mod running;
mod servo;
mod vector;

use std::collections::VecDeque;
use std::time::Duration;

use jaka_motion::Model;

use self::blend::Leaving;
pub(crate) use self::drives::Drives;
pub(crate) use self::jog::{Jogging, moved, small};
pub(crate) use self::path::{ArmPath, Joints};
pub(crate) use self::profile::Profile;
use self::running::Running;
pub(crate) use self::running::{Planned, Zone};
pub(crate) use self::servo::{Filter, Servo, SetPoint, Space, can_follow};
use self::vector::plus;
use crate::clock::CYCLE;

/// Greatest number of cycles by which the commanded position can be ahead of the arm.
const MOST_AHEAD: u128 = 100;

/// Sources of motion: queue, jog and servo mode.
#[derive(Debug, Clone, Default)]
pub(crate) struct Engine {
    queue: VecDeque<Planned>,
    running: Option<Running>,
    /// Previous motion during its blend into the running one.
    leaving: Option<Leaving>,
    /// Duration of the rest between two motions of the queue.
    pause: Duration,
    /// Remaining time of the present rest.
    resting: Duration,
    pub(crate) jog: Option<Jogging>,
    /// Servo mode, if it is on.
    pub(crate) servo: Option<Servo>,
    /// Joint position at the end of the last motion of the queue; `None` if no motion waits or runs.
    tail: Option<Joints>,
}

impl Engine {
    /// Creates an engine that rests for this long between two motions of the queue.
    pub(crate) fn new(pause: Duration) -> Self {
        Self { pause, ..Self::default() }
    }

    /// Returns the joint position at the end of all accepted motions; `now` if there are none.
    pub(crate) fn tail(&self, now: Joints) -> Joints {
        self.tail.unwrap_or(now)
    }

    /// Returns the number of motions that wait or run.
    pub(crate) fn pending(&self) -> usize {
        self.queue.len() + usize::from(self.running.is_some())
    }

    /// Queues a motion.
    pub(crate) fn enqueue(&mut self, planned: Planned) {
        self.tail = Some(planned.end);
        self.queue.push_back(planned);
    }

    /// Returns the number of motions that wait for the end of the running one.
    pub(crate) fn waiting(&self) -> usize {
        self.queue.len()
    }

    /// Brakes, and discards all waiting motions but set-points. The next motion starts at the end of the braking.
    pub(crate) fn stop(&mut self, joints: Joints, model: &Model) {
        self.queue.clear();
        self.jog = None;
        self.resting = Duration::ZERO;
        let offset = self.leaving.as_mut().map_or([0.0; 6], |leaving| leaving.brake(model));
        self.tail = self.running.as_mut().map(|running| {
            running.brake();
            plus(running.stop(model, joints), offset)
        });
    }

    /// Leaves servo mode, and brakes from these joint positions and speeds. Stops at once where the braking would leave
    /// the joints' ranges.
    pub(crate) fn leave_servo(&mut self, at: Joints, speed: Joints, deceleration: f64, model: &Model) {
        self.servo = None;
        let braking = Running::braking(at, speed, deceleration);
        if self.running.is_none() && model.is_within_range(braking.planned.end) {
            self.tail = Some(braking.planned.end);
            self.running = Some(braking);
        }
    }

    /// Stops at once.
    pub(crate) fn halt(&mut self) {
        *self = Self::new(self.pause);
    }

    /// Whether the arm has a commanded motion or motions to run.
    pub(crate) fn is_busy(&self) -> bool {
        self.pending() > 0 || self.jog.is_some() || self.servo.as_ref().is_some_and(Servo::is_moving)
    }

    /// Whether the arm rests between two motions.
    pub(crate) fn is_resting(&self) -> bool {
        !self.resting.is_zero()
    }

    /// Returns the joint position this much later, in whole cycles, without further commands.
    pub(crate) fn ahead(&self, joints: Joints, time: Duration, rate: f64, model: &Model) -> Joints {
        if time < CYCLE {
            return joints;
        }
        let mut engine = self.clone();
        let cycles = time.as_nanos() / CYCLE.as_nanos();
        (0..cycles.min(MOST_AHEAD)).fold(joints, |joints, _| engine.cycle(joints, rate, model))
    }

    /// Computes one controller cycle, and returns the commanded joint position at its end.
    pub(crate) fn cycle(&mut self, joints: Joints, rate: f64, model: &Model) -> Joints {
        if let Some(servo) = self.servo.as_mut().filter(|servo| servo.is_moving()) {
            return servo.cycle(model);
        }
        if let Some(jog) = &mut self.jog {
            let (next, goes_on) = jog.cycle(joints, rate, model);
            if !goes_on {
                self.jog = None;
            }
            return next;
        }
        self.follow(joints, rate, model)
    }

    fn follow(&mut self, joints: Joints, rate: f64, model: &Model) -> Joints {
        if self.is_resting() {
            self.resting = self.resting.saturating_sub(CYCLE);
            return joints;
        }
        if self.running.is_none() {
            self.running = self.queue.pop_front().map(Running::new);
        }
        let offset = self.leave(rate, model);
        let Some(running) = &mut self.running else {
            return joints;
        };
        let (share, ended) = running.cycle(rate);
        // Planning checked some points of the path; an unreachable point between them stops the arm.
        let Some(next) = running.planned.path.at(share, model, joints) else {
            self.queue.clear();
            self.finish();
            return joints;
        };
        if ended && self.leaving.as_ref().is_none_or(Leaving::has_ended) {
            self.finish();
        } else {
            self.blend(share, next, model);
        }
        plus(next, offset)
    }

    /// Advances the previous motion, and returns the joint offset that it still adds in this cycle, in degrees.
    fn leave(&mut self, rate: f64, model: &Model) -> Joints {
        let Some(leaving) = &mut self.leaving else { return [0.0; 6] };
        let offset = leaving.cycle(rate, model);
        if leaving.is_done() {
            self.leaving = None;
        }
        offset
    }

    /// Starts the next motion when this one is near enough to its end.
    fn blend(&mut self, share: f64, joints: Joints, model: &Model) {
        let Some(running) = &self.running else { return };
        let may_begin = share >= 0.5 && running.brake.is_none() && self.leaving.is_none();
        let is_near = running.planned.zone.as_ref().is_some_and(|zone| may_begin && zone.contains(joints, model));
        if is_near && !self.queue.is_empty() {
            self.leaving = self.running.take().map(|running| Leaving::new(running, joints));
            self.running = self.queue.pop_front().map(Running::new);
        }
    }

    /// Ends the running motion.
    fn finish(&mut self) {
        self.running = None;
        self.leaving = None;
        if self.queue.is_empty() {
            self.tail = None;
        } else {
            self.resting = self.pause;
        }
    }
}
