//! Set-points on the way to goals.

mod goals;
mod hostile;
mod retargeting;
mod tool;
mod tool_stop;

use jaka_proto::messages::types::JointPosition;

use super::Random;
use crate::{Checker, Dynamics, Frames, Generator, Goal, Limits, Model, Step};

const CYCLE: f64 = 0.008;
/// Away from singularities.
const ELBOW_UP: [f64; 6] = [10.0, 60.0, -80.0, 190.0, -90.0, 5.0];

fn zu5() -> Limits {
    Limits::of(&Model::default()).with_joint_accelerations([300.0; 6]).expect("above 0")
}

/// A generator, and its last set-points.
struct Watched {
    generator: Generator,
    dynamics: Dynamics,
    last: [[f64; 6]; 3],
}

impl Watched {
    fn new(limits: Limits, start: [f64; 6]) -> Self {
        let dynamics = Dynamics::of(&limits);
        Self::with(&Checker::new(limits, Frames::new()), dynamics, start, CYCLE)
    }

    fn with(checker: &Checker, dynamics: Dynamics, start: [f64; 6], period_s: f64) -> Self {
        let generator = Generator::new(checker, dynamics, start.into(), period_s).expect("within its limits");
        Self { generator, dynamics, last: [start; 3] }
    }

    /// The next set-point, which keeps speeds, accelerations and jerks.
    fn next(&mut self, goal: &Goal) -> Step {
        let step = self.generator.next(goal);
        let (here, period_s) = (step.joints.0, self.generator.period_s());
        for (joint, position) in here.iter().enumerate() {
            let [third, second, first] = self.last.map(|joints| joints[joint]);
            let by = [position - first, position - 2.0 * first + second, position - 3.0 * first + 3.0 * second - third];
            let limits = [self.dynamics.speeds(), self.dynamics.accelerations(), self.dynamics.jerks()];
            for (order, (by, limit)) in (1..).zip(by.into_iter().zip(limits)) {
                let rounding = 1e-12 + limit[joint] * period_s.powi(order) * 1e-8;
                let most = limit[joint] * period_s.powi(order) + rounding;
                assert!(by.abs() <= most, "joint {}, difference {order}: {by} beyond {most}, {goal:?}", joint + 1);
            }
        }
        self.last = [self.last[1], self.last[2], here];
        step
    }

    fn paused(&mut self) {
        self.generator.paused();
        self.last = [self.last[2]; 3];
    }

    /// Until the arm rests, at most so many set-points.
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

fn joints(of: [f64; 6]) -> Goal {
    Goal::Joints(JointPosition(of))
}
