//! Random trajectories on random arms, judged by a witness that knows the arm by the vendor's drawings and the
//! set-points alone.
//!
//! `JAKA_TRAJECTORIES=1000 cargo test --release -p jaka-tests --test servo trajectories::` is the long form.

use jaka_motion::{Checker, Passing, Through, TimedPoint, Trajectory, Via, ViaTarget};
use jaka_sync::types::Pose;
use jaka_tests::witness::{apart, product};

use crate::generator::judge::{Judge, Moves};
use jaka_tests::rig::{Random, Rig, frame};

/// A trajectory, and what was asked of it.
struct Case {
    rig: Rig,
    trajectory: Trajectory,
    points: Vec<Via>,
    /// In degrees, mm, and degrees of the tool's turn; none for points with times.
    tolerances: Option<[f64; 3]>,
}

#[derive(Debug, Default)]
struct Tally {
    trajectories: u32,
    refused: u32,
    lines: u32,
    rounded: u32,
    set_points: u32,
}

/// The most set-points of a trajectory at one period that are judged.
const MOST: u32 = 6000;
/// Largest deviation of the tool from its line, in mm and degrees, with the error of the drawings' figures.
const OFF_LINE: (f64, f64) = (0.006, 0.0015);

fn trajectories() -> u32 {
    std::env::var("JAKA_TRAJECTORIES").ok().and_then(|count| count.parse().ok()).unwrap_or(30)
}

/// Points in joints, on lines, or both.
fn some_points(random: &mut Random, rig: &Rig, start: [f64; 6]) -> Vec<Via> {
    let kind = random.below(4);
    let room = random.mostly_small(40.0);
    let mut points = vec![Via::from(start)];
    for _ in 0..=random.below(6) {
        let offsets = random.offsets::<6>(room);
        let joints: [f64; 6] = std::array::from_fn(|joint| start[joint] + offsets[joint]);
        let is_line = kind == 0 || kind == 1 && random.one_in(2);
        points.push(if is_line { rig.pose(joints).into() } else { joints.into() });
    }
    points
}

fn some_through(random: &mut Random, points: &[Via]) -> (Through, [f64; 3]) {
    let mut tolerance = |most: f64| if random.one_in(4) { 0.0 } else { random.mostly_small(most) };
    let tolerances = [tolerance(10.0), tolerance(20.0), 0.1 + tolerance(5.0)];
    let [deg, mm, turn_deg] = tolerances;
    let through = Trajectory::through(points.iter().copied()).corner_deg(deg).corner_mm(mm).corner_turn_deg(turn_deg);
    (if random.one_in(2) { through.tcp_speed(random.between(5.0, 500.0)) } else { through }, tolerances)
}

/// Points with times and perhaps velocities, in as much time as they need, or nearly.
fn some_timed(random: &mut Random, points: &[Via], checker: &Checker) -> Option<Trajectory> {
    let (velocities, last) = (random.one_in(2), points.len() - 1);
    let mut time_s = 0.0;
    let mut timed = Vec::new();
    for (index, point) in points.iter().enumerate() {
        let ViaTarget::Joints(joints) = point.target() else { return None };
        let point = TimedPoint::new(time_s, joints);
        let most = if index == 0 || index == last { 0.0 } else { 10.0 };
        timed.push(if velocities { point.with_velocity(random.offsets(most)) } else { point });
        time_s += random.between(0.05, 1.0);
    }
    for _ in 0..30 {
        if let Ok(trajectory) = Trajectory::timed(&timed, checker) {
            return Some(trajectory);
        }
        for point in &mut timed {
            point.time_s *= 1.2;
            point.velocity = point.velocity.map(|speeds| speeds.map(|speed| speed / 1.2));
        }
    }
    None
}

fn some_case(seed: u32) -> Option<Result<Case, String>> {
    let mut random = Random::new(seed);
    let rig = Rig::new(&mut random);
    let start = rig.place(&mut random)?;
    let points = some_points(&mut random, &rig, start);
    let checker = rig.checker();
    if random.one_in(3) {
        let trajectory = some_timed(&mut random, &points, &checker)?;
        return Some(Ok(Case { rig, trajectory, points, tolerances: None }));
    }
    let (through, tolerances) = some_through(&mut random, &points);
    let built = through.build(&checker).map_err(|error| error.to_string());
    Some(built.map(|trajectory| Case { rig, trajectory, points, tolerances: Some(tolerances) }))
}

impl Case {
    fn has_lines(&self) -> bool {
        self.points.iter().any(|point| matches!(point.target(), ViaTarget::Line(_)))
    }

    /// Set-points at a period, as a session sends them and judges them.
    fn judge(&self, period: f64) -> Result<u32, String> {
        let limits = &self.rig.limits;
        let accelerations = *limits.joint_accelerations();
        let jerks = accelerations.map(|most| if self.tolerances.is_some() { 10.0 * most } else { f64::INFINITY });
        let moves = Moves { limits: [*limits.joint_speeds(), accelerations, jerks], stops: None, period };
        let start = self.trajectory.start();
        let (mut judge, checker) = (Judge::new(self.rig.bounds.clone(), moves, start.0), self.rig.checker());
        let mut last = [start; 2];
        for number in 0..MOST {
            let time_s = f64::from(number) * period;
            let here = self.trajectory.at(time_s).joints;
            judge.set_point(here.0).map_err(|what| format!("{what}, at {time_s} s of {period}"))?;
            let taken = checker.check_set_point(last, here, period);
            taken.map_err(|beyond| format!("{beyond}, at {time_s} s of {period}"))?;
            last = [last[1], here];
            if time_s > self.trajectory.duration_s() + 2.0 * period {
                return Ok(number);
            }
        }
        Ok(MOST)
    }

    /// The tool, seen from where poses are given.
    fn tool(&self, joints: [f64; 6]) -> [[f64; 4]; 3] {
        product(self.rig.bounds.base, self.rig.bounds.tcp(joints))
    }

    fn way_points_are_passed(&self) -> Result<(), String> {
        let [deg, mm, turn_deg] = self.tolerances.unwrap_or_default();
        for (point, way_point) in self.points.iter().zip(self.trajectory.way_points()) {
            let there = self.trajectory.at(way_point.time_s);
            let rounds = way_point.passing == Passing::Rounded;
            let (off, most) = match point.target() {
                // Where a way in joints ends and a line begins, it stops.
                ViaTarget::Joints(joints) => {
                    ((there.joints.max_distance(&joints), 0.0), (if rounds { deg } else { 0.0 } + 1e-9, 0.0))
                }
                ViaTarget::Line(pose) => {
                    let (mm, turn_deg) = if rounds { (mm, turn_deg) } else { (0.0, 0.0) };
                    let off = apart(self.tool(there.joints.0), frame(pose));
                    (off, (mm + OFF_LINE.0, turn_deg * 1.01 + OFF_LINE.1))
                }
                other => panic!("{other:?} is in none"),
            };
            if off.0 > most.0 || off.1 > most.1 {
                return Err(format!("{off:?} off {point:?}, at most {most:?}, {way_point:?}"));
            }
            if way_point.passing == Passing::Stops && there.velocity.iter().any(|speed| speed.abs() > 1e-6) {
                return Err(format!("it does not stop: {there:?}"));
            }
        }
        Ok(())
    }

    /// On lines the tool is no further off than a corner may be, and nowhere nearer to a singularity than it may be.
    fn lines_are_straight(&self) -> Result<(), String> {
        let Some([_, mm, _]) = self.tolerances else { return Ok(()) };
        let (ways, ends) = (self.points.windows(2), self.trajectory.way_points().windows(2));
        let start = self.tool(self.trajectory.start().0).map(|row| row[3]);
        let mut from = start;
        for (ways, ends) in ways.zip(ends) {
            let ViaTarget::Line(to) = ways[1].target() else {
                let ViaTarget::Joints(joints) = ways[1].target() else { continue };
                from = self.tool(joints.0).map(|row| row[3]);
                continue;
            };
            let to = Pose::position_mm(&to);
            // A line that starts nearer to a singularity may lead away from it.
            let nearest = |time_s: f64| self.rig.bounds.nearest_singularity(self.trajectory.at(time_s).joints.0);
            let least = self.rig.bounds.least.min(nearest(ends[0].time_s)).min(nearest(ends[1].time_s));
            for place in 0..=60 {
                let time_s = ends[0].time_s + f64::from(place) / 60.0 * (ends[1].time_s - ends[0].time_s);
                let joints = self.trajectory.at(time_s).joints.0;
                let off = off_line(self.tool(joints).map(|row| row[3]), from, to);
                if off > mm + OFF_LINE.0 {
                    return Err(format!("{off} mm off its line at {time_s} s"));
                }
                let distance = self.rig.bounds.nearest_singularity(joints);
                if distance < least - Checker::AMOUNT_SINGULARITY - 1e-6 {
                    return Err(format!("{distance} from a singularity at {time_s} s"));
                }
            }
            from = to;
        }
        Ok(())
    }
}

/// Distance of a place from the straight path between two others, in mm.
fn off_line(place: [f64; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
    let less = |one: [f64; 3], other: [f64; 3]| -> [f64; 3] { std::array::from_fn(|axis| one[axis] - other[axis]) };
    let dot = |one: [f64; 3], other: [f64; 3]| one.iter().zip(other).map(|(one, other)| one * other).sum::<f64>();
    let (way, done) = (less(to, from), less(place, from));
    let share = if dot(way, way) > 0.0 { (dot(way, done) / dot(way, way)).clamp(0.0, 1.0) } else { 0.0 };
    let off = less(done, way.map(|part| part * share));
    dot(off, off).sqrt()
}

#[test]
fn no_set_point_is_beyond_a_limit() {
    let (mut seed, mut tally) = (0, Tally::default());
    while tally.trajectories < trajectories() {
        seed += 1;
        let Some(made) = some_case(seed) else { continue };
        let Ok(case) = made else {
            tally.refused += 1;
            continue;
        };
        let judged = || {
            case.way_points_are_passed().and_then(|()| case.lines_are_straight())?;
            [0.008, 0.001, 0.013].into_iter().map(|period| case.judge(period)).sum::<Result<u32, _>>()
        };
        let set_points = judged()
            .unwrap_or_else(|what| panic!("seed {seed}: {what}; {:?}, corners of {:?}", case.points, case.tolerances));
        let is_rounded = case.trajectory.way_points().iter().any(|point| point.passing == Passing::Rounded);
        tally.trajectories += 1;
        tally.lines += u32::from(case.has_lines());
        tally.rounded += u32::from(is_rounded);
        tally.set_points += set_points;
    }
    println!("{tally:?}");
    assert!(tally.lines > 0 && tally.rounded > 0 && tally.refused > 0, "{tally:?}");
}
