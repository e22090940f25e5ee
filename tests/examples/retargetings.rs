//! Retargetings of the generator in the middle of motions, as JSON lines: the state, the limits, the target, and the
//! time until rest there. `tests/outside/run retargetings` compares them with Ruckig.
//!
//! `cargo run --release -p jaka-tests --example retargetings -- 10000 28`: how many, and the seed.

use std::io::{self, BufWriter, Write};

use jaka_motion::{Checker, Dynamics, Frames, Generator, Goal, Limits, Model};
use jaka_sync::types::JointPosition;
use jaka_tests::rig::Random;
use serde_json::json;

const PERIOD_S: f64 = 0.008;
/// Longer than any way.
const MOST_PERIODS: u32 = 100_000;
/// A joint with this share of its greatest speed is at cruise: the generator uses 0.999 of the limit.
const CRUISE: f64 = 0.998;

fn main() -> io::Result<()> {
    let mut numbers = std::env::args().skip(1).map_while(|text| text.parse::<u32>().ok());
    let (count, seed) = (numbers.next().unwrap_or(10_000), numbers.next().unwrap_or(28));
    let mut out = BufWriter::new(io::stdout().lock());
    let mut random = Random::new(seed);
    let mut written = 0;
    while written < count {
        let mut run = Run::new(&mut random);
        for _ in 0..50.min(count - written) {
            // Each fifth with a joint at cruise.
            run.go_on(&mut random, written % 5 == 0);
            writeln!(out, "{}", run.retarget(&mut random))?;
            written += 1;
        }
    }
    out.flush()
}

/// A generator in the middle of motions.
struct Run {
    generator: Generator,
    dynamics: [[f64; 6]; 3],
    goal: Goal,
}

impl Run {
    fn new(random: &mut Random) -> Self {
        let mut each = |low: f64, high: f64| [0.0; 6].map(|_: f64| 10_f64.powf(random.between(low, high)));
        let (speeds, accelerations, jerks) = (each(1.0, 2.2), each(1.8, 3.0), each(2.8, 4.0));
        let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
        let limits = limits.with_tcp_speed(1e9).and_then(|limits| limits.with_joint_accelerations(accelerations));
        let limits = limits.expect("above 0");
        let dynamics = Dynamics::of(&limits).with_speeds(speeds).and_then(|dynamics| dynamics.with_jerks(jerks));
        let dynamics = dynamics.expect("within the limits");
        let checker = Checker::new(limits, Frames::new());
        let start = JointPosition([0.0, 90.0, 0.0, 90.0, 0.0, 0.0]);
        let generator = Generator::new(&checker, dynamics, start, PERIOD_S).expect("within the limits");
        Self { generator, dynamics: [speeds, accelerations, jerks], goal: target(random) }
    }

    /// Some set-points on the way to the last goal or, for a cruise, to another one until a joint has its greatest
    /// speed.
    fn go_on(&mut self, random: &mut Random, to_cruise: bool) {
        for _ in 0..random.below(200) {
            self.generator.next(&self.goal);
        }
        if !to_cruise {
            return;
        }
        for _ in 0..100 {
            self.goal = target(random);
            for _ in 0..2000 {
                let velocity = self.generator.velocity();
                if (0..6).any(|joint| velocity[joint].abs() > CRUISE * self.dynamics[0][joint]) {
                    return;
                }
                self.generator.next(&self.goal);
            }
        }
    }

    /// Gives another target; tells how long the way to it takes.
    fn retarget(&mut self, random: &mut Random) -> serde_json::Value {
        self.goal = target(random);
        let from = &self.generator;
        let state = [from.joints().0, from.velocity(), from.acceleration()];
        let mut ahead = from.clone();
        let (mut periods, mut is_bound) = (0, false);
        while periods < MOST_PERIODS {
            is_bound |= ahead.next(&self.goal).bound.is_some();
            if ahead.is_at_rest() {
                break;
            }
            periods += 1;
        }
        let Goal::Joints(target) = self.goal else { unreachable!("all goals are targets") };
        json!({
            "state": state, "limits": self.dynamics, "target": target.0, "period_s": PERIOD_S,
            "took_s": f64::from(periods) * PERIOD_S, "is_bound": is_bound,
        })
    }
}

/// Joint positions well within their ranges.
fn target(random: &mut Random) -> Goal {
    Goal::Joints(JointPosition([120.0, 60.0, 90.0, 60.0, 120.0, 200.0].map(|range| random.between(-range, range))))
}
