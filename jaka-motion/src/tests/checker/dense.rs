//! Random ways against a check in steps so small that nothing is missed, which shares only the kinematics and the regions' formulas.

use super::{SLOW, some_frames, some_region};
use crate::tests::{Random, from_pose};
use crate::{Arc, Beyond, Checker, Frames, JointPace, Limits, Model, Point, RegionFrame, TcpPace, Transform};

/// How far a way is beyond each kind of limit at the worst; below 0 where it is within.
#[derive(Debug, Clone, Copy)]
struct Worst {
    range_deg: f64,
    /// As a share of the limit.
    speed: f64,
    /// With the change from step to step, since the speed of a step is its mean.
    speed_at_most: f64,
    tcp_speed: f64,
    region_mm: f64,
    singularity: f64,
    /// The joints went on without a jump, to the end.
    followed: bool,
}

impl Worst {
    fn none() -> Self {
        let none = f64::NEG_INFINITY;
        Self {
            range_deg: none,
            speed: none,
            speed_at_most: none,
            tcp_speed: none,
            region_mm: none,
            singularity: none,
            followed: true,
        }
    }

    fn is_beyond(&self) -> bool {
        !self.followed
            || self.range_deg > Checker::AMOUNT_DEG
            || self.speed > Checker::AMOUNT_SPEED
            || self.tcp_speed > Checker::AMOUNT_SPEED
            || self.region_mm > Checker::AMOUNT_MM
            || self.singularity > Checker::AMOUNT_SINGULARITY
    }

    fn is_within(&self) -> bool {
        self.followed
            && self.range_deg < -1e-4
            && self.speed_at_most < -1e-4
            && self.tcp_speed < -1e-4
            && self.region_mm < -1e-4
            && self.singularity < -1e-4
    }

    fn place(&mut self, checker: &Checker, joints: &[f64; 6], start: &[f64; 6], tolerance: f64) {
        let (limits, model) = (checker.limits(), checker.limits().model());
        for index in 0..6 {
            let (min, max) = (limits.joint_min()[index], limits.joint_max()[index]);
            let out = |joints: &[f64; 6]| (min - joints[index]).max(joints[index] - max);
            self.range_deg = self.range_deg.max(out(joints) - out(start).max(0.0));
        }
        for region in limits.regions() {
            let out = |joints: &[f64; 6]| {
                let frames = model.joint_frames(*joints);
                let point = match region.point() {
                    Point::Tcp => frames[5] * checker.frames().tool(),
                    Point::Elbow => frames[2],
                    Point::Wrist => frames[4],
                };
                let seen = match region.frame() {
                    RegionFrame::ArmBase => point,
                    RegionFrame::User => checker.frames().base() * point,
                };
                region.beyond(&seen.position_mm().into()) + tolerance
            };
            self.region_mm = self.region_mm.max(out(joints) - out(start).max(0.0));
        }
    }

    fn distances(&mut self, limits: &Limits, joints: &[f64; 6], start: &[f64; 6]) {
        let of = |joints: &[f64; 6]| {
            let distance = limits.model().singularity_distance(*joints);
            [distance.shoulder, distance.elbow, distance.wrist]
        };
        for (here, start) in of(joints).into_iter().zip(of(start)) {
            self.singularity = self.singularity.max(limits.singularity_distance().min(start) - here);
        }
    }

    fn joint_speeds(&mut self, limits: &Limits, moved: [f64; 6], before: [f64; 6], seconds: f64) {
        for index in 0..6 {
            let most = limits.joint_speeds()[index] * seconds;
            self.speed = self.speed.max(moved[index].abs() / most - 1.0);
            let change = 2.0 * (moved[index] - before[index]).abs();
            self.speed_at_most = self.speed_at_most.max((moved[index].abs() + change) / most - 1.0);
        }
    }
}

fn moved(from: &[f64; 6], to: &[f64; 6]) -> [f64; 6] {
    std::array::from_fn(|index| to[index] - from[index])
}

/// A line or an arc in steps of 0.1 mm and 0.05 degrees.
fn led(
    checker: &Checker,
    from: [f64; 6],
    at: impl Fn(f64) -> Transform,
    length_mm: f64,
    turn: f64,
    pace: TcpPace,
) -> Worst {
    let (limits, mut worst) = (checker.limits(), Worst::none());
    let unlimited = Model { joint_min: [-720.0; 6], joint_max: [720.0; 6], ..limits.model().clone() };
    let steps = (length_mm / 0.1).max(turn / 0.05).ceil().max(1.0);
    worst.tcp_speed = limits.tcp_speed().map_or(-1.0, |most| pace.speed_mm_s / most - 1.0);
    worst.place(checker, &from, &from, pace.tolerance_mm);
    let (mut joints, mut step, mut before) = (from, 0.0, None);
    while step < steps {
        step += 1.0;
        let flange = at(step / steps) * checker.frames().tool().inverse();
        let Ok(next) = unlimited.inverse(flange, joints) else { return Worst { followed: false, ..worst } };
        let by = moved(&joints, &next.0);
        if by.iter().any(|by| by.abs() > 30.0) {
            return Worst { followed: false, ..worst };
        }
        worst.joint_speeds(limits, by, before.unwrap_or(by), length_mm / pace.speed_mm_s / steps);
        before = Some(by);
        joints = next.0;
        worst.place(checker, &joints, &from, pace.tolerance_mm);
        worst.distances(limits, &joints, &from);
    }
    worst
}

fn joint_way(checker: &Checker, from: [f64; 6], to: [f64; 6], pace: JointPace) -> Worst {
    let (limits, mut worst, by) = (checker.limits(), Worst::none(), moved(&from, &to));
    let longest = by.iter().fold(0.0_f64, |most, by| most.max(by.abs()));
    let seconds = longest / pace.speed_deg_s;
    worst.joint_speeds(limits, by, by, seconds);
    worst.singularity = -1.0;
    worst.tcp_speed = -1.0;
    let steps = (longest / 0.05).ceil();
    let (mut step, mut place) = (0.0, None::<Transform>);
    while step <= steps {
        let joints: [f64; 6] = std::array::from_fn(|index| from[index] + by[index] * step / steps);
        worst.place(checker, &joints, &from, 0.0);
        let tcp = limits.model().forward(joints) * checker.frames().tool();
        if let (Some(before), Some(most)) = (place, limits.tcp_speed()) {
            worst.tcp_speed = worst.tcp_speed.max(before.distance_mm(&tcp) * steps / seconds / most - 1.0);
        }
        (place, step) = (Some(tcp), step + 1.0);
    }
    worst
}

/// Limits of which some are near what a way needs, and which so are exceeded about as often as not.
fn some_limits(random: &mut Random, model: &Model, frames: &Frames, [from, middle]: [[f64; 6]; 2]) -> Limits {
    let mut limits = Limits::of(model).with_singularity_distance(0.0).expect("a distance");
    if random.one_in(4.0) {
        limits = limits.with_singularity_distance(random.between(0.0, 0.2)).expect("a distance");
    }
    for joint in (1..=6).filter(|_| random.one_in(6.0)).collect::<Vec<_>>() {
        let (min, max) = (model.joint_min()[joint - 1], model.joint_max()[joint - 1]);
        let ends = [-random.between(-0.5, 60.0), random.between(-0.5, 60.0)];
        let [low, high] = ends.map(|end| (from[joint - 1] + end).clamp(min, max));
        limits = limits.with_joint_range(joint, low.min(high), high).expect("within the model's");
    }
    if random.one_in(3.0) {
        let speeds = model.joint_speed().map(|speed| speed * random.between(0.1, 1.0));
        limits = limits.with_joint_speeds(speeds).expect("at most the model's");
    }
    for (number, point) in [Point::Tcp, Point::Elbow, Point::Wrist].into_iter().enumerate() {
        if random.one_in(3.0) {
            let joint_frames = model.joint_frames(middle);
            let at = [joint_frames[5] * frames.tool(), joint_frames[2], joint_frames[4]][number];
            let user = random.one_in(2.0);
            let (seen, frame) = if user { (frames.base() * at, RegionFrame::User) } else { (at, RegionFrame::ArmBase) };
            let name = format!("region {number}");
            let region = some_region(random, &name, seen.position_mm(), 200.0).expect("a region");
            limits = limits.with_region(region.of(point).seen_from(frame)).expect("another name");
        }
    }
    limits
}

impl Random {
    fn one_in(&mut self, times: f64) -> bool {
        self.between(0.0, times) < 1.0
    }
}

#[derive(Debug, Default)]
struct Counts {
    passed: u32,
    refused: u32,
    kinds: std::collections::BTreeMap<String, u32>,
}

impl Counts {
    fn compare(&mut self, worst: Worst, found: &Result<(), Beyond>, what: &dyn std::fmt::Debug) {
        match found {
            Ok(()) => assert!(!worst.is_beyond(), "passed {worst:?}\n{what:?}"),
            Err(beyond) => assert!(!worst.is_within(), "{beyond} {beyond:?}\n{worst:?}\n{what:?}"),
        }
        *(if found.is_ok() { &mut self.passed } else { &mut self.refused }) += 1;
        if let Err(beyond) = found {
            let kind = format!("{:?}", beyond.exceeded);
            let kind = kind.split(&[' ', '{'][..]).next().unwrap_or_default().to_owned();
            *self.kinds.entry(kind).or_default() += 1;
        }
    }

    fn both(&self, least: u32) {
        assert!(self.passed >= least && self.refused >= least, "{self:?}");
    }
}

/// A model, and joint positions away from singularities.
fn some_start(random: &mut Random) -> (&'static Model, [f64; 6]) {
    let models = Model::published();
    loop {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an index")]
        let model = &models[(random.between(0.0, 20.0) as usize).min(19)];
        let joints = random.joints(model);
        let distance = model.singularity_distance(joints);
        if distance.shoulder.min(distance.elbow).min(distance.wrist) > 0.05 {
            return (model, joints);
        }
    }
}

fn some_rounds() -> u32 {
    std::env::var("ROUNDS").ok().and_then(|rounds| rounds.parse().ok()).unwrap_or(20)
}

fn shifted(random: &mut Random, from: Transform, mm: f64, deg: f64) -> Transform {
    let by: [f64; 3] = std::array::from_fn(|_| random.between(-mm, mm));
    let turn: [f64; 3] = std::array::from_fn(|_| random.between(-deg, deg));
    from.displaced(&from_pose([by[0], by[1], by[2], turn[0], turn[1], turn[2]]))
}

#[test]
fn lines_and_arcs_agree_with_a_dense_check() {
    let (mut random, mut lines, mut arcs) = (Random::new(71), Counts::default(), Counts::default());
    for round in 0..some_rounds() {
        let (model, from) = some_start(&mut random);
        let frames = some_frames(&mut random);
        let start = model.forward(from) * frames.tool();
        let (mm, deg) = (random.between(5.0, 250.0), random.between(0.0, 60.0));
        let (mid, end) = (shifted(&mut random, start, mm, deg), shifted(&mut random, start, mm, deg));
        let Ok(middle) = model.inverse(start.between(&mid, 0.6) * frames.tool().inverse(), from) else { continue };
        let limits = some_limits(&mut random, model, &frames, [from, middle.0]);
        let tolerance_mm = if random.one_in(3.0) { random.between(0.0, 20.0) } else { 0.0 };
        let pace = TcpPace { speed_mm_s: random.between(2.0, 150.0), tolerance_mm, ..SLOW };
        let checker = Checker::new(limits, frames);
        let (mid_pose, end_pose) = ((frames.base() * mid).into(), (frames.base() * end).into());

        let found = checker.check_line(from.into(), mid_pose, pace).map(|_| ());
        let worst = led(
            &checker,
            from,
            |share| start.between(&mid, share),
            start.distance_mm(&mid),
            start.angle_deg(&mid),
            pace,
        );
        lines.compare(worst, &found, &(round, &checker, from, mid, pace));

        let Some(arc) = Arc::through(start, mid, end) else { continue };
        let found = checker.check_arc(from.into(), mid_pose, end_pose, pace).map(|_| ());
        let worst = led(&checker, from, |share| arc.at(share), arc.length_mm(), arc.turn_deg(), pace);
        arcs.compare(worst, &found, &(round, &checker, from, mid, end, pace));
    }
    lines.both(some_rounds() / 10);
    println!("{lines:?} {arcs:?}");
}

#[test]
fn joint_ways_agree_with_a_dense_check() {
    let (mut random, mut ways) = (Random::new(73), Counts::default());
    for round in 0..4 * some_rounds() {
        let (model, from) = some_start(&mut random);
        let frames = some_frames(&mut random);
        let most = random.between(1.0, 60.0);
        let to: [f64; 6] = std::array::from_fn(|index| {
            (from[index] + random.between(-most, most)).clamp(model.joint_min()[index], model.joint_max()[index])
        });
        let middle = std::array::from_fn(|index| f64::midpoint(from[index], to[index]));
        let mut limits = some_limits(&mut random, model, &frames, [from, middle]);
        if random.one_in(2.0) {
            limits = limits.with_tcp_speed(random.between(20.0, 1500.0)).expect("a speed");
        }
        let pace = JointPace { speed_deg_s: random.between(1.0, 120.0), acceleration_deg_s2: Some(1.0) };
        let checker = Checker::new(limits, frames);
        let found = checker.check_joint_way(from.into(), to.into(), pace);
        ways.compare(joint_way(&checker, from, to, pace), &found, &(round, &checker, from, to, pace));
    }
    ways.both(some_rounds() / 10);
    println!("{ways:?}");
}
