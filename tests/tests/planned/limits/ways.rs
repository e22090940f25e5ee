//! Random ways, checked by the checker and by a witness in steps of 0.1 mm and 0.05 degrees.
//!
//! 40 of each kind, or as many as `JAKA_WAYS` says. Where the witness is within all limits the checker must not refuse;
//! where it is beyond one by more than the stated amount, the checker must.

use jaka_motion::{Beyond, JointSpeed, TcpSpeed};
use jaka_sync::types::{JointPosition, Pose};
use jaka_tests::witness::way::{Excess, Path, Steps};

use jaka_tests::rig::{AMOUNTS, Random, Rig, WITHIN, frame};

const STEPS: Steps = Steps { degrees: 0.05, millimetres: 0.1 };
const FINE: Steps = Steps { degrees: 0.001, millimetres: 0.002 };

/// Numbers of paths that passed and that were refused: a test without a refusal proves nothing.
#[derive(Debug, Default)]
struct Tally {
    passed: u32,
    refused: u32,
    /// Between a limit and the stated amount.
    either: u32,
}

impl Tally {
    fn judge<T>(&mut self, checked: &Result<T, Beyond>, excess: &Excess, what: impl Fn() -> String) {
        match (checked, excess.is_beyond(AMOUNTS), excess.is_beyond(WITHIN)) {
            (Ok(_), true, _) => panic!("sent although beyond: {excess:?}\n{}", what()),
            (Err(error), _, false) => panic!("refused although within: {error}\n{excess:?}\n{}", what()),
            (Ok(_), false, false) => self.passed += 1,
            (Err(_), true, _) => self.refused += 1,
            (_, false, true) => self.either += 1,
        }
    }

    fn is_worth_something(&self) {
        let all = self.passed + self.refused + self.either;
        assert!(self.passed * 10 >= all && self.refused * 10 >= all, "{self:?}");
    }
}

fn ways() -> u32 {
    std::env::var("JAKA_WAYS").ok().and_then(|ways| ways.parse().ok()).unwrap_or(40)
}

/// A place to start from, with a rig of its own.
fn rigs(first: u32) -> impl Iterator<Item = (u32, Random, Rig, [f64; 6])> {
    (0..ways()).filter_map(move |number| {
        let seed = first + number;
        let mut random = Random::new(seed);
        let rig = Rig::new(&mut random);
        let from = rig.place(&mut random)?;
        Some((seed, random, rig, from))
    })
}

fn by(random: &mut Random, from: [f64; 6], most: f64) -> [f64; 6] {
    let offsets = random.offsets::<6>(most);
    std::array::from_fn(|joint| from[joint] + offsets[joint])
}

#[test]
fn ways_in_joint_space() {
    let mut tally = Tally::default();
    for (seed, mut random, rig, from) in rigs(0) {
        let most = random.mostly_small(200.0);
        let to = by(&mut random, from, most);
        let speed = random.mostly_small(200.0);
        let acceleration = rig.bounds.accelerations[0] * random.between(0.2, 1.1);
        let asked = JointSpeed { speed_deg_s: speed, acceleration_deg_s2: Some(acceleration) };
        let checked = rig.checker().check_joint_way(JointPosition(from), JointPosition(to), asked);
        let excess = rig.bounds.joint_way(from, to, speed, acceleration, STEPS);
        tally.judge(&checked, &excess, || format!("seed {seed}: {from:?} to {to:?}, {asked:?}"));
    }
    tally.is_worth_something();
}

#[test]
fn lines() {
    let mut tally = Tally::default();
    for (seed, mut random, rig, from) in rigs(1_000_000) {
        let most = random.between(1.0, 60.0);
        let to = rig.pose(by(&mut random, from, most));
        let asked = TcpSpeed { speed_mm_s: random.between(10.0, 400.0), tolerance_mm: tolerance(&mut random) };
        let checked = rig.checker().check_line(JointPosition(from), to, asked);
        let path = Path::Line(in_base(&rig, to));
        let (excess, end) = tcp_way(&rig, from, path, asked, checked.is_err());
        tally.judge(&checked, &excess, || format!("seed {seed}: {from:?} to {to:?}, {asked:?}"));
        ends_there(&checked, end, seed);
    }
    tally.is_worth_something();
}

#[test]
fn arcs() {
    let mut tally = Tally::default();
    for (seed, mut random, rig, from) in rigs(2_000_000) {
        let most = random.between(1.0, 40.0);
        let (mid, to) = (by(&mut random, from, most), by(&mut random, from, most));
        let (mid, to) = (rig.pose(mid), rig.pose(to));
        let asked = TcpSpeed { speed_mm_s: random.between(10.0, 400.0), tolerance_mm: tolerance(&mut random) };
        let checked = rig.checker().check_arc(JointPosition(from), mid, to, asked);
        let path = Path::Arc(in_base(&rig, mid), in_base(&rig, to));
        let (excess, end) = tcp_way(&rig, from, path, asked, checked.is_err());
        tally.judge(&checked, &excess, || format!("seed {seed}: {from:?} by {mid:?} to {to:?}, {asked:?}"));
        ends_there(&checked, end, seed);
    }
    tally.is_worth_something();
}

#[test]
fn set_points() {
    let (mut tally, period) = (Tally::default(), 0.008);
    for (seed, mut random, mut rig, from) in rigs(3_000_000) {
        // The witness brakes with the joints alone.
        rig.limits = rig.limits.without_stop_tcp_acceleration();
        let speed = random.mostly_small(250.0);
        let last = by(&mut random, from, speed * period);
        let change = random.between(0.0, 1.3) * rig.bounds.accelerations[0] * period * period;
        let target: [f64; 6] =
            std::array::from_fn(|joint| last[joint] + (last[joint] - from[joint]) + random.between(-change, change));
        if rig.bounds.place(last).is_beyond([-0.01, -1.0, -0.01, -0.01]) {
            continue;
        }
        let before = [from, last];
        let checked = rig.checker().check_set_point(before.map(JointPosition), JointPosition(target), period);
        let excess = rig.bounds.set_point(before, target, period, STEPS);
        tally.judge(&checked, &excess, || format!("seed {seed}: {before:?} to {target:?}"));
        let pose = rig.pose(target);
        let reached = rig.checker().check_pose_set_point(before.map(JointPosition), pose, period);
        let mut excess = excess;
        excess.singularity = rig.bounds.least - rig.bounds.nearest_singularity(target);
        if !excess.is_beyond(AMOUNTS) && excess.is_beyond(WITHIN) {
            continue;
        }
        tally.judge(&reached, &excess, || format!("seed {seed}: {before:?} to {pose:?}"));
    }
    tally.is_worth_something();
}

fn tolerance(random: &mut Random) -> f64 {
    if random.one_in(2) { 0.0 } else { random.between(0.0, 20.0) }
}

/// By the witness. Near a singularity joints are fastest for less than one of its steps: what is refused is gone
/// through in finer ones.
fn tcp_way(rig: &Rig, from: [f64; 6], path: Path, asked: TcpSpeed, is_refused: bool) -> (Excess, Option<[f64; 6]>) {
    let gone = |steps| rig.bounds.tcp_way(from, path, asked.speed_mm_s, asked.tolerance_mm, steps);
    let usual = gone(STEPS);
    if is_refused && !usual.0.is_beyond(WITHIN) { gone(FINE) } else { usual }
}

fn in_base(rig: &Rig, pose: Pose) -> jaka_tests::witness::Frame {
    use jaka_tests::witness::{product, way::inverted};
    product(inverted(rig.bounds.base), frame(pose))
}

/// The joint positions at the end are those to which the way leads without a jump.
fn ends_there(checked: &Result<JointPosition, Beyond>, end: Option<[f64; 6]>, seed: u32) {
    if let (Ok(ours), Some(theirs)) = (checked, end) {
        assert!(ours.max_distance(&JointPosition(theirs)) < 1e-3, "seed {seed}: {ours:?}, {theirs:?}");
    }
}
