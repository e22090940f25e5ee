//! The arm in motion, cycle by cycle.
//!
//! Planned motions wait in a queue, and each follows its path under a trapezoidal speed profile. Jogs and servo set-points
//! move the arm without the queue.

mod jog;
mod path;
mod profile;
mod servo;

use std::collections::VecDeque;
use std::time::Duration;

pub(crate) use self::jog::{Jogging, Reference, small};
pub(crate) use self::path::{Arc, Frame, Joints, Path};
pub(crate) use self::profile::{Brake, Profile};
pub(crate) use self::servo::Servo;
use crate::clock::CYCLE;
use crate::kinematics::Model;

/// Everything that moves the arm.
#[derive(Debug, Default)]
pub(crate) struct Engine {
    queue: VecDeque<Planned>,
    running: Option<Running>,
    pub(crate) jog: Option<Jogging>,
    pub(crate) servo: Servo,
    /// Where the last motion of the queue ends; none if no motion waits or runs.
    tail: Option<Joints>,
    /// For how long the arm has been moving without a rest.
    busy: Duration,
}

/// A motion that has been accepted.
#[derive(Debug, Clone)]
pub(crate) struct Planned {
    pub(crate) path: Path,
    pub(crate) profile: Profile,
    pub(crate) deceleration: f64,
    pub(crate) end: Joints,
}

/// The motion that runs.
#[derive(Debug)]
struct Running {
    planned: Planned,
    length: f64,
    /// Time on the profile, or on the brake: it stands still in a pause, and goes slowly at a low rate.
    time: f64,
    brake: Option<Brake>,
}

impl Engine {
    /// Where the arm will be when all that has been accepted has ended.
    pub(crate) fn tail(&self, now: Joints) -> Joints {
        self.tail.unwrap_or(now)
    }

    /// How many motions wait or run.
    pub(crate) fn pending(&self) -> usize {
        self.queue.len() + usize::from(self.running.is_some())
    }

    /// Puts a motion behind the others.
    pub(crate) fn enqueue(&mut self, planned: Planned) {
        self.tail = Some(planned.end);
        self.queue.push_back(planned);
    }

    /// Brakes, and forgets all that waits.
    pub(crate) fn stop(&mut self) {
        self.queue.clear();
        self.jog = None;
        self.servo.clear();
        if let Some(running) = self.running.as_mut().filter(|running| running.brake.is_none()) {
            let along = running.planned.profile.at(running.time);
            running.brake = Some(Brake::new(along, running.planned.deceleration));
            running.time = 0.0;
        }
    }

    /// Stands still at once.
    pub(crate) fn halt(&mut self) {
        *self = Self::default();
    }

    /// True while the arm moves or has motions to run.
    pub(crate) fn is_busy(&self) -> bool {
        self.pending() > 0 || self.jog.is_some() || self.servo.is_moving()
    }

    /// For how long the arm has been moving without a rest.
    pub(crate) fn busy(&self) -> Duration {
        self.busy
    }

    /// One controller cycle: where the arm is at its end.
    pub(crate) fn cycle(&mut self, joints: Joints, rate: f64, model: &Model) -> Joints {
        if !self.is_busy() {
            self.busy = Duration::ZERO;
            return joints;
        }
        self.busy += CYCLE;
        if self.servo.is_moving() {
            return self.servo.cycle(joints);
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
        if self.running.is_none() {
            self.running = self.queue.pop_front().map(Running::new);
        }
        let Some(running) = &mut self.running else {
            return joints;
        };
        let (share, ended) = running.cycle(rate);
        // Paths were tried before; a place between those tried where the arm cannot be stops it.
        let next = running.planned.path.at(share, model, joints);
        if ended || next.is_none() {
            self.running = None;
            if next.is_none() {
                self.queue.clear();
            }
            if self.queue.is_empty() {
                self.tail = None;
            }
        }
        next.unwrap_or(joints)
    }
}

impl Running {
    fn new(planned: Planned) -> Self {
        Self { length: planned.path.length(), planned, time: 0.0, brake: None }
    }

    /// The share of the way done at the end of a cycle, and whether the motion has ended there.
    fn cycle(&mut self, rate: f64) -> (f64, bool) {
        let (along, ended) = if let Some(brake) = self.brake {
            // Braking is not slowed down.
            self.time += CYCLE.as_secs_f64();
            (brake.at(self.time), self.time >= brake.duration())
        } else {
            self.time += CYCLE.as_secs_f64() * rate;
            (self.planned.profile.at(self.time), self.time >= self.planned.profile.duration())
        };
        let share = if self.length > 0.0 { (along.distance / self.length).min(1.0) } else { 1.0 };
        (share, ended)
    }
}
