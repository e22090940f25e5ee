//! Set-points towards goals.

mod goals;
mod hostile;
mod retargeting;
mod stops;
mod tool;
mod tool_stop;

use jaka_proto::messages::types::JointPosition;

use super::Random;
use crate::{Checker, Dynamics, Frames, Generator, Goal, Limits, Model, Step};

const CYCLE: f64 = 0.008;
/// Joint positions away from singularities.
const ELBOW_UP: [f64; 6] = [10.0, 60.0, -80.0, 190.0, -90.0, 5.0];

fn zu5() -> Limits {
    Limits::of(&Model::default()).with_joint_accelerations([300.0; 6]).expect("above 0")
}

/// Generator with its last set-points.
struct Watched {
    generator: Generator,
    dynamics: Dynamics,
    last: [[f64; 6]; 3],
    /// Number of set-points within the dynamics since the last one that was part of a stop.
    since_stop: u32,
}

/// Number of set-points after a stop whose third difference still includes it.
const STOP_SEEN: u32 = 3;

impl Watched {
    fn new(limits: Limits, start: [f64; 6]) -> Self {
        let dynamics = Dynamics::of(&limits);
        Self::with(&Checker::new(limits, Frames::new()), dynamics, start, CYCLE)
    }

    fn with(checker: &Checker, dynamics: Dynamics, start: [f64; 6], period_s: f64) -> Self {
        let generator = Generator::new(checker, dynamics, start.into(), period_s).expect("within its limits");
        Self { generator, dynamics, last: [start; 3], since_stop: STOP_SEEN }
    }

    /// Returns the next set-point, after a check of speeds, accelerations and jerks. The limits of stops apply on the
    /// path to rest and in front of a limit.
    fn next(&mut self, goal: &Goal) -> Step {
        let step = self.generator.next(goal);
        let limits = [*self.dynamics.speeds(), *self.dynamics.accelerations(), *self.dynamics.jerks()];
        let (kept, begins_stop) = (self.keeps(step.joints.0, &limits), means_rest(goal) || step.bound.is_some());
        if kept.is_err() || begins_stop {
            assert!(begins_stop || self.since_stop < STOP_SEEN, "{kept:?}, {goal:?}");
            self.since_stop = 0;
            let limits = self.generator.checker().limits();
            let larger = |one: &[f64; 6], other: &[f64; 6]| std::array::from_fn(|joint| one[joint].max(other[joint]));
            let accelerations = larger(self.dynamics.accelerations(), limits.stop_accelerations());
            let of_stops = [*self.dynamics.speeds(), accelerations, larger(self.dynamics.jerks(), limits.stop_jerks())];
            assert_eq!(self.keeps(step.joints.0, &of_stops), Ok(()), "{goal:?}");
        }
        self.since_stop = self.since_stop.saturating_add(1);
        self.last = [self.last[1], self.last[2], step.joints.0];
        step
    }

    /// Compares the differences with speeds, accelerations and jerks.
    fn keeps(&self, here: [f64; 6], limits: &[[f64; 6]; 3]) -> Result<(), String> {
        let period_s = self.generator.period_s();
        for (joint, position) in here.iter().enumerate() {
            let [third, second, first] = self.last.map(|joints| joints[joint]);
            let by = [position - first, position - 2.0 * first + second, position - 3.0 * first + 3.0 * second - third];
            for (order, (by, limit)) in (1..).zip(by.into_iter().zip(limits)) {
                let rounding = 1e-12 + limit[joint] * period_s.powi(order) * 1e-8;
                let most = limit[joint] * period_s.powi(order) + rounding;
                if by.abs() > most {
                    return Err(format!("joint {}, difference {order}: {by} beyond {most}", joint + 1));
                }
            }
        }
        Ok(())
    }

    fn paused(&mut self) {
        self.generator.paused();
        self.last = [self.last[2]; 3];
    }

    /// Advances until the arm rests, by at most this number of set-points.
    fn until_rest(&mut self, goal: &Goal, most: u32) -> u32 {
        for count in 0..most {
            self.next(goal);
            if self.generator.is_at_rest() {
                return count + 1;
            }
        }
        panic!("no rest after {most} set-points: {:?}", self.generator);
    }
}

fn means_rest(goal: &Goal) -> bool {
    match goal {
        Goal::Rest => true,
        Goal::Joints(joints) => !joints.0.iter().all(|joint| joint.is_finite()),
        Goal::Velocity(speeds) => !speeds.iter().all(|speed| speed.is_finite()),
        Goal::TcpVelocity(velocity) => {
            !velocity.linear_mm_s.iter().chain(&velocity.angular_deg_s).all(|number| number.abs() <= 1e6)
        }
    }
}

fn joints(of: [f64; 6]) -> Goal {
    Goal::Joints(JointPosition(of))
}
