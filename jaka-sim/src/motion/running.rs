//! Planned and running motions.

use jaka_motion::{Model, Transform};

use super::path::{ArmPath, Joints};
use super::profile::{Along, Brake, Profile};
use crate::clock::CYCLE;

/// Accepted motion.
#[derive(Debug, Clone)]
pub(crate) struct Planned {
    pub(crate) path: ArmPath,
    pub(crate) profile: Profile,
    pub(crate) deceleration: f64,
    pub(crate) end: Joints,
    /// Zone in which the next motion may begin before the end of this one; without it, the next one begins at the end.
    pub(crate) zone: Option<Zone>,
}

/// Zone in which a motion may blend into the next one.
#[derive(Debug, Clone)]
pub(crate) struct Zone {
    /// Tool frame relative to the flange.
    tool: Transform,
    /// Pose of the tool at the end of the motion, and the radius around it in which the next may begin, in millimetres.
    end: Transform,
    radius: f64,
}

/// Running motion.
#[derive(Debug, Clone)]
pub(super) struct Running {
    pub(super) planned: Planned,
    length: f64,
    /// Time on the profile, or of the braking: it stops in a pause, and passes slowly at a low rate.
    time: f64,
    pub(super) brake: Option<Brake>,
}

impl Zone {
    pub(crate) fn new(tool: Transform, end: Transform, radius: f64) -> Option<Self> {
        (radius > 0.0).then_some(Self { tool, end, radius })
    }

    pub(super) fn contains(&self, joints: Joints, model: &Model) -> bool {
        (model.forward(joints) * self.tool).distance_mm(&self.end) < self.radius
    }
}

impl Running {
    pub(super) fn new(planned: Planned) -> Self {
        Self { length: planned.path.length(), planned, time: 0.0, brake: None }
    }

    /// Creates the braking from these joint positions and speeds, with this deceleration of the fastest joint.
    pub(super) fn braking(from: Joints, speed: Joints, deceleration: f64) -> Self {
        let fastest = speed.iter().map(|speed| speed.abs()).fold(0.0, f64::max);
        let end = std::array::from_fn(|i| from[i] + speed[i] * fastest / deceleration / 2.0);
        let path = ArmPath::Joints { from, to: end };
        let profile = Profile::new(path.length(), fastest, deceleration);
        let brake = Brake::new(Along { distance: 0.0, speed: fastest }, deceleration);
        Self { brake: Some(brake), ..Self::new(Planned { path, profile, deceleration, end, zone: None }) }
    }

    /// Returns the share of the path at the end of a cycle, and whether the motion ends there.
    pub(super) fn cycle(&mut self, rate: f64) -> (f64, bool) {
        let (along, ended) = if let Some(brake) = self.brake {
            // The rate does not slow down braking.
            self.time += CYCLE.as_secs_f64();
            (brake.at(self.time), self.time >= brake.duration())
        } else {
            self.time += CYCLE.as_secs_f64() * rate;
            (self.planned.profile.at(self.time), self.time >= self.planned.profile.duration())
        };
        (self.share(along), ended)
    }

    /// Starts braking, unless it has already started.
    pub(super) fn brake(&mut self) {
        if self.brake.is_none() {
            let along = self.planned.profile.at(self.time);
            self.brake = Some(Brake::new(along, self.planned.deceleration));
            self.time = 0.0;
        }
    }

    /// Returns the joint position at the end of the motion, or at the end of its braking.
    pub(super) fn stop(&self, model: &Model, reference: Joints) -> Joints {
        let Some(brake) = self.brake else { return self.planned.end };
        self.planned.path.at(self.share(brake.at(brake.duration())), model, reference).unwrap_or(reference)
    }

    fn share(&self, along: Along) -> f64 {
        if self.length > 0.0 { (along.distance / self.length).min(1.0) } else { 1.0 }
    }
}
