//! Planning for a Zu 5: trajectories of many way-points, generated set-points, and what both consist of.

use std::f64::consts::PI;
use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;

use jaka_motion::proto::messages::types::Pose;
use jaka_motion::{
    Checker, Dynamics, Follower, Frames, Generator, Goal, Limits, Model, Point, Region, TcpVelocity, TimedPoint,
    Trajectory, TrajectoryError, VelocityFrame, Via,
};

use crate::measure::{Contender, Work};

/// Joint positions away from singularities, in degrees.
pub const JOINTS: [f64; 6] = [10.0, 60.0, 80.0, 30.0, -75.0, 15.0];
/// The period of set-points, in seconds.
pub const PERIOD: f64 = 0.008;
/// Number of way-points of a timed trajectory.
pub const WAY_POINTS: u32 = 10_000;
/// Number of timed runs for each kind of trajectory.
const RUNS: usize = 15;
/// Number of timed set-points, and of those for each goal: 20 goals a second.
const SET_POINTS: u32 = 40_000;
const EACH: u32 = 6;
/// The most that 99 of 100 generated set-points may take, in microseconds.
const SET_POINT_US: f64 = 50.0;
/// Joint position at the start of the lines, in degrees.
const HOME: [f64; 6] = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];
/// Distance from the middle of the lines to their ends, in mm.
const REACH_MM: f64 = 120.0;

/// Makes a trajectory of way-points in memory.
pub type Plan = Box<dyn Fn(&Checker) -> Result<Trajectory, TrajectoryError>>;

/// A kind of trajectory.
#[derive(Debug)]
pub struct Kind {
    /// Name of the kind.
    pub name: &'static str,
    /// Longest permitted time for 10,000 way-points, in milliseconds. With corners there is none: the time is in
    /// proportion to the duration of the motion.
    target_ms: Option<f64>,
    /// Makes so many way-points.
    pub plan: fn(u32) -> Plan,
}

/// All kinds of trajectories.
pub const KINDS: [Kind; 4] = [
    Kind {
        name: "points with times",
        target_ms: Some(100.0),
        plan: |count| {
            let points = timed(count);
            Box::new(move |checker| Trajectory::timed(&points, checker))
        },
    },
    Kind { name: "joint motions with corners", target_ms: None, plan: |count| through(joints(count), 0.5) },
    Kind { name: "lines of 1 mm with corners", target_ms: None, plan: |count| through(lines(count, 0.05), 0.1) },
    Kind {
        name: "curve through poses at 1 mm",
        target_ms: Some(600.0),
        plan: |count| {
            let points = lines(count, 0.0);
            Box::new(move |checker| Trajectory::curve(points.iter().copied()).within_mm(0.1).build(checker))
        },
    },
];

/// To and fro with all joints, each 20 s, a way-point each 50 ms.
fn timed(count: u32) -> Vec<TimedPoint> {
    let at = |number: u32| {
        let time_s = 0.05 * f64::from(number);
        TimedPoint::new(time_s, JOINTS.map(|joint| joint + 5.0 * (1.0 - (0.1 * PI * time_s).cos())))
    };
    (0..count).map(at).collect()
}

/// Way-points whose corners are rounded within a tolerance, in degrees or mm.
fn through(points: Vec<Via>, corner: f64) -> Plan {
    Box::new(move |checker| {
        Trajectory::through(points.iter().copied()).corner_mm(corner).corner_deg(corner).build(checker)
    })
}

/// Each joint at its own pace, some degrees from one point to the next.
fn joints(count: u32) -> Vec<Via> {
    let paces = [0.11, 0.14, 0.17, 0.20, 0.23, 0.26];
    let at = |number: u32| {
        let by = |joint: usize| 8.0 * (f64::from(number) * paces[joint]).sin();
        Via::from(std::array::from_fn(|joint| JOINTS[joint] + by(joint)))
    };
    (0..count).map(at).collect()
}

/// Makes a spiral of lines of 1 mm, along which the orientation changes. With a ripple in mm each point is a corner.
fn lines(count: u32, ripple_mm: f64) -> Vec<Via> {
    let start = Pose::from(Model::named("Zu 5").expect("a published arm").forward(HOME));
    let turn_mm = REACH_MM * REACH_MM / (2.0 * f64::from(WAY_POINTS));
    let first = 2.5 / turn_mm;
    let (mut angle, mut points) = (first, vec![Via::from(HOME)]);
    for number in 1..count {
        angle += 1.0 / (turn_mm * angle);
        let radius = turn_mm * angle + ripple_mm * if number % 2 == 0 { 1.0 } else { -1.0 };
        let ((sin, cos), path_mm) = (angle.sin_cos(), f64::from(number));
        points.push(Via::from(Pose {
            x: start.x + radius * cos - turn_mm * first * first.cos(),
            y: start.y + radius * sin - turn_mm * first * first.sin(),
            z: start.z + 10.0 * (0.01 * path_mm).sin(),
            rx: start.rx + 3.0 * (0.001 * path_mm).sin(),
            ..start
        }));
    }
    points
}

/// For a Zu 5 with a highest speed of the tool centre point, in a cell with a table.
///
/// # Panics
/// There is no Zu 5, or a limit makes no sense.
pub fn checker() -> Checker {
    let limits = Limits::of(Model::named("Zu 5").expect("a published arm")).with_tcp_speed(250.0).expect("a speed");
    let table = Region::half_space("table", [0.0, 0.0, -200.0], [0.0, 0.0, 1.0]).expect("a region");
    let cell = Region::inside_box("cell", [-1500.0; 3], [1500.0; 3]).expect("a region");
    Checker::new(limits.with_region(table).and_then(|limits| limits.with_region(cell)).expect("names"), Frames::new())
}

/// A generator for a Zu 5 with so many regions, up to three: a table, a cell and a post.
///
/// # Panics
/// There is no Zu 5, or a region makes no sense.
pub fn generator(regions: usize) -> Generator {
    let mut limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
    limits = limits.with_joint_accelerations([300.0; 6]).expect("accelerations");
    let all = [
        Region::half_space("table", [0.0, 0.0, 20.0], [0.0, 0.0, 1.0]),
        Region::inside_box("cell", [-900.0, -900.0, -100.0], [900.0, 900.0, 1300.0]).map(|cell| cell.of(Point::Wrist)),
        Region::outside_box("post", [-600.0, -60.0, 0.0], [-500.0, 60.0, 1500.0]),
    ];
    for region in all.into_iter().take(regions) {
        limits = limits.with_region(region.expect("a region")).expect("another name");
    }
    let dynamics = Dynamics::of(&limits);
    Generator::new(&Checker::new(limits, Frames::new()), dynamics, JOINTS.into(), PERIOD).expect("a free place")
}

/// A goal of each kind in turn, none like the one before.
pub fn goal(number: u32) -> Goal {
    let wave = |index: u32| (f64::from(number) * 0.7 + f64::from(index) * 1.3).sin();
    let six = |size: f64| [0, 1, 2, 3, 4, 5].map(|index| size * wave(index));
    match number % 3 {
        0 => {
            let by = six(25.0);
            Goal::Joints(std::array::from_fn(|index| JOINTS[index] + by[index]).into())
        }
        1 => Goal::Velocity(six(60.0)),
        _ => {
            let (linear_mm_s, angular_deg_s) =
                ([0, 1, 2].map(|axis| 200.0 * wave(axis)), [3, 4, 5].map(|axis| 20.0 * wave(axis)));
            Goal::TcpVelocity(
                TcpVelocity::new(VelocityFrame::ArmBase).with_linear(linear_mm_s).with_angular(angular_deg_s),
            )
        }
    }
}

/// Parts of planning, and trajectories of few way-points.
///
/// # Panics
/// There is no Zu 5, or a trajectory is beyond a limit.
pub fn works() -> Vec<Work<'static>> {
    let arm = Model::named("Zu 5").expect("a published arm");
    let (flange, near, own) = (arm.forward(JOINTS), JOINTS.map(|joint| joint + 0.5), checker());
    let [before, last, next] = [0.0, 0.05, 0.1].map(|by| JOINTS.map(|joint| joint + by).into());
    assert!(own.check_set_point([before, last], next, PERIOD).is_ok());
    let (mut generator, mut number) = (generator(3), 0);
    let mut works = vec![
        work("forward kinematics", || arm.forward(black_box(JOINTS))),
        work("inverse kinematics", move || arm.inverse(black_box(flange), near)),
        work("a set-point compared with limits", move || own.check_set_point([before, last], black_box(next), PERIOD)),
        work("a generated set-point", move || {
            number += 1;
            generator.next(&goal(number / EACH))
        }),
    ];
    // Of so few that a tool that counts is done in seconds.
    for (Kind { name, plan, .. }, count) in KINDS.iter().zip([1000, 10, 10, 100]) {
        let (plan, checker) = (plan(count), checker());
        works.push(work(name, move || plan(&checker).expect("within the limits")));
    }
    works
}

fn work<T>(name: &'static str, once: impl FnMut() -> T + 'static) -> Work<'static> {
    Work { name, contenders: vec![Contender::new("ours", once)], targets: Vec::new() }
}

/// Measures each kind of trajectory, and set-points without regions and with three.
///
/// # Panics
/// A trajectory is beyond a limit.
pub fn report() -> String {
    let mut out = format!("{WAY_POINTS} way-points planned, compared with limits, and a follower ready\n");
    for Kind { name, target_ms, plan } in &KINDS {
        let (plan, checker, mut duration_s) = (plan(WAY_POINTS), checker(), 0.0);
        let times = sorted((0..RUNS).map(|_| {
            let since = Instant::now();
            let trajectory = plan(&checker).expect("within the limits");
            duration_s = trajectory.duration_s();
            black_box(Follower::new(trajectory, &checker, PERIOD).expect("a period of servo mode"));
            since.elapsed().as_secs_f64() * 1e3
        }));
        let (least, p50, worst) = (times[0], times[RUNS / 2], times[RUNS - 1]);
        let times = format!("least {least:6.1} ms, p50 {p50:6.1} ms, worst {worst:6.1} ms");
        let _ = writeln!(out, "  {name:29} {times}, for {duration_s:6.1} s of motion");
        // Other work of the machine makes it longer.
        if let Some(target_ms) = target_ms {
            let met = if least <= *target_ms { "met" } else { "MISSED" };
            let _ = writeln!(out, "  target: least at most {target_ms} ms: {met}");
        }
    }
    out += "a set-point generated; goals change at 20 Hz\n";
    for (name, regions) in [("no region", 0), ("three regions", 3)] {
        let mut generator = generator(regions);
        let times = sorted((0..SET_POINTS).map(|number| {
            let goal = goal(number / EACH);
            let since = Instant::now();
            black_box(generator.next(&goal));
            since.elapsed().as_secs_f64() * 1e6
        }));
        let at = |share: usize| times[times.len() * share / 1000];
        let met = if at(990) <= SET_POINT_US { "met" } else { "MISSED" };
        let _ = writeln!(out, "  {name:29} p50 {:6.1} us, p99 {:6.1} us, p99.9 {:6.1} us", at(500), at(990), at(999));
        let _ = writeln!(out, "  target: p99 at most {SET_POINT_US} us: {met}");
    }
    out
}

fn sorted(times: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut times: Vec<_> = times.collect();
    times.sort_by(f64::total_cmp);
    times
}
