//! Set-points that are generated towards goals that change at any time, judged by a witness that has their bytes alone.
//!
//! `JAKA_RETARGETINGS=10000000 cargo test --release -p jaka-tests --test servo generator::` is the long form.

pub(crate) mod goals;
pub(crate) mod judge;

use jaka_motion::{Dynamics, Generator, Goal};
use jaka_proto::Command as _;
use jaka_sync::types::JointPosition;

use self::judge::{Judge, Moves};
use jaka_tests::rig::{Random, Rig};

/// Counts of the events of the random arms.
#[derive(Debug, Default, Clone, Copy)]
struct Tally {
    goals: u32,
    set_points: u64,
    bounds: u64,
    rejections: u64,
    pauses: u32,
    landings: u32,
}

/// A random arm with its generator and its judge.
struct Run {
    random: Random,
    rig: Rig,
    generator: Generator,
    judge: Judge,
    tally: Tally,
}

impl Run {
    fn new(seed: u32) -> Option<Self> {
        let mut random = Random::new(seed);
        let mut rig = Rig::new(&mut random);
        let dynamics = some_dynamics(&mut random, &mut rig);
        let start = rig.place(&mut random)?;
        let period = 0.008 * f64::from(if random.one_in(2) { 1 } else { random.below(12) + 1 });
        let moves = Moves::of(&dynamics, period);
        let generator = Generator::new(&rig.checker(), dynamics, JointPosition(start), period).expect("within limits");
        let judge = Judge::new(rig.bounds.clone(), moves, start);
        Some(Self { random, rig, generator, judge, tally: Tally::default() })
    }

    /// Goals, each for some periods.
    fn retarget(&mut self, times: u32) -> Result<(), String> {
        for _ in 0..times {
            let goal = goals::some_goal(&mut self.random, &self.rig, self.generator.joints().0);
            self.tally.goals += 1;
            let periods = if self.random.one_in(12) { self.random.below(150) } else { self.random.below(4) };
            for _ in 0..=periods {
                self.step(&goal).map_err(|what| format!("{what}, on the way to {goal:?}"))?;
            }
            if self.random.one_in(60) {
                self.generator.paused();
                self.judge.paused();
                self.tally.pauses += 1;
            }
            if self.random.one_in(150) {
                self.land()?;
            }
        }
        Ok(())
    }

    /// The next set-point, through the bytes of its request.
    fn step(&mut self, goal: &Goal) -> Result<(), String> {
        let step = self.generator.next(goal);
        self.tally.set_points += 1;
        self.tally.bounds += u64::from(step.bound.is_some());
        self.judge.set_point(judge::joints_in(&encoded(step.joints)))
    }

    /// To rest, which is where and when the generator says.
    fn land(&mut self) -> Result<(), String> {
        let landing = self.generator.landing();
        let most = landing.time_s / self.generator.period_s() + 1.0 + 1e-6;
        let mut periods = 0.0;
        while !self.generator.is_at_rest() {
            self.step(&Goal::Rest)?;
            periods += 1.0;
            if periods > most {
                return Err(format!("no rest after {periods} periods: {landing:?}"));
            }
        }
        self.tally.landings += 1;
        self.judge.is_at(landing.joints.0)
    }
}

/// From creeping to as fast as the arm can be; the limits get the same accelerations.
pub(crate) fn some_dynamics(random: &mut Random, rig: &mut Rig) -> Dynamics {
    let mut each = |low: f64, high: f64| [0.0; 6].map(|_: f64| 10_f64.powf(random.between(low, high)));
    let (shares, accelerations, jerks) = (each(-1.5, 0.0), each(0.7, 4.5), each(1.0, 6.0));
    rig.limits = rig.limits.clone().with_joint_accelerations(accelerations).expect("above 0");
    rig.bounds.accelerations = accelerations;
    if random.one_in(2) {
        rig.limits = rig.limits.clone().with_tcp_speed(1e9).expect("above 0");
        rig.bounds.tcp_speed = 1e9;
    }
    let speeds = std::array::from_fn(|joint| rig.bounds.speeds[joint] * shares[joint]);
    let dynamics = Dynamics::of(&rig.limits).with_speeds(speeds).and_then(|dynamics| dynamics.with_jerks(jerks));
    dynamics.expect("above 0")
}

fn encoded(joints: JointPosition) -> String {
    let mut out = jaka_proto::wire::Writer::new();
    jaka_proto::messages::servo::ServoJ::absolute(joints).write_request(&mut out);
    out.as_str().to_owned()
}

fn retargetings() -> u32 {
    std::env::var("JAKA_RETARGETINGS").ok().and_then(|count| count.parse().ok()).unwrap_or(6000)
}

#[test]
fn no_set_point_is_beyond_what_was_promised() {
    let (mut seed, mut all) = (0, Tally::default());
    while all.goals < retargetings() {
        seed += 1;
        let Some(mut run) = Run::new(seed) else { continue };
        run.retarget(300).and_then(|()| run.land()).unwrap_or_else(|what| panic!("seed {seed}: {what}"));
        all = Tally {
            goals: all.goals + run.tally.goals,
            set_points: all.set_points + run.tally.set_points,
            bounds: all.bounds + run.tally.bounds,
            rejections: all.rejections + run.generator.rejections(),
            pauses: all.pauses + run.tally.pauses,
            landings: all.landings + run.tally.landings,
        };
    }
    println!("{all:?}");
    assert!(all.bounds > 0 && all.pauses > 0 && all.landings > 0);
}

/// A set-point a little off, one twice, and one left out.
#[test]
fn the_witness_sees_a_jump() {
    let mut random = Random::new(5);
    let rig = Rig::new(&mut random);
    let start = rig.place(&mut random).expect("somewhere");
    let dynamics = Dynamics::of(&rig.limits).with_jerks([2000.0; 6]).expect("above 0");
    let mut generator = Generator::new(&rig.checker(), dynamics, JointPosition(start), 0.008).expect("within limits");
    let set_points: Vec<[f64; 6]> =
        (0..60).map(|_| generator.next(&Goal::Velocity([10.0, 0.0, 0.0, 0.0, 0.0, -10.0])).joints.0).collect();
    let judged = |set_points: &[[f64; 6]]| {
        let mut judge = Judge::new(rig.bounds.clone(), Moves::of(&dynamics, 0.008), start);
        set_points.iter().try_for_each(|joints| judge.set_point(*joints))
    };
    assert_eq!(judged(&set_points), Ok(()));
    let mut off = set_points.clone();
    off[30][5] += 0.002;
    let (twice, skipped) =
        ([&set_points[..30], &set_points[29..]].concat(), [&set_points[..30], &set_points[31..]].concat());
    for jumps in [off, twice, skipped] {
        judged(&jumps).expect_err("a jump");
    }
}
