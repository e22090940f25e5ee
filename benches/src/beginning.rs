//! Time from 10,000 way-points in memory to a follower that is ready.

use std::f64::consts::PI;
use std::fmt::Write as _;
use std::time::Instant;

use jaka_motion::proto::messages::types::Pose;
use jaka_motion::{Checker, Follower, Frames, Limits, Model, Region, TimedPoint, Trajectory, TrajectoryError, Via};

use crate::kinematics::{JOINTS, PERIOD};

/// Number of way-points of a trajectory.
pub const WAY_POINTS: u32 = 10_000;
/// Longest permitted times to make a trajectory and its follower: for points with times, for a curve in joints, and for
/// one in poses, in milliseconds.
const TIMED_MS: f64 = 100.0;
const JOINT_CURVE_MS: f64 = 150.0;
const POSE_CURVE_MS: f64 = 600.0;
/// Number of timed runs for each kind of trajectory.
const RUNS: usize = 15;
/// Joint position at the start of the lines, in degrees.
const HOME: [f64; 6] = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];
/// Distance from the middle of the lines to their ends, in mm.
const REACH_MM: f64 = 120.0;

/// Way-points in memory.
#[derive(Debug)]
pub enum Points {
    /// With times.
    Timed(Vec<TimedPoint>),
    /// Without times; with the tolerance for the rounding of corners, in degrees or mm.
    Through(Vec<Via>, f64),
    /// Without times, for a curve; with its tolerance, in degrees or mm, and the longest permitted time to make it, in
    /// milliseconds.
    Curve(Vec<Via>, f64, f64),
}

/// Makes so many way-points.
pub type Made = fn(u32) -> Points;

/// Kinds of curves, by the number of their way-points.
const CURVES: [(&str, Made); 2] = [
    ("curve in joints", |count| Points::Curve(joints(count, 0.01), 0.05, JOINT_CURVE_MS)),
    ("curve through poses at 1 mm", |count| Points::Curve(lines(count, 1.0, 0.0), 0.1, POSE_CURVE_MS)),
];

/// Each other kind of trajectory, by the number of its way-points.
pub const KINDS: [(&str, Made); 6] = [
    ("times", |count| Points::Timed(timed(count, 0))),
    ("times and speeds", |count| Points::Timed(timed(count, 1))),
    ("times, speeds, accelerations", |count| Points::Timed(timed(count, 2))),
    ("ways in joints", |count| Points::Through(joints(count, 1.0), 0.5)),
    ("lines of 1 mm", |count| Points::Through(lines(count, 1.0, 0.05), 0.1)),
    ("lines of 20 mm", |count| Points::Through(lines(count, 20.0, 0.05), 2.0)),
];

impl Points {
    /// Makes their trajectory.
    ///
    /// # Errors
    /// The trajectory is beyond a limit.
    pub fn trajectory(&self, checker: &Checker) -> Result<Trajectory, TrajectoryError> {
        match self {
            Self::Timed(points) => Trajectory::timed(points, checker),
            Self::Through(points, corner) => {
                Trajectory::through(points.iter().copied()).corner_mm(*corner).corner_deg(*corner).build(checker)
            }
            Self::Curve(points, within, _) => {
                Trajectory::curve(points.iter().copied()).within_mm(*within).within_deg(*within).build(checker)
            }
        }
    }

    /// Returns the longest permitted time to make the trajectory, in milliseconds. With corners there is none, because
    /// the time is in proportion to the duration of the motion.
    fn target_ms(&self) -> Option<f64> {
        match self {
            Self::Timed(_) => Some(TIMED_MS),
            Self::Through(..) => None,
            Self::Curve(_, _, target_ms) => Some(*target_ms),
        }
    }
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

/// To and fro with all joints, each 20 s, a way-point each 50 ms; with speeds from the first order on, and
/// accelerations from the second.
fn timed(count: u32, order: u32) -> Vec<TimedPoint> {
    let turn = 0.1 * PI;
    let at = |number: u32| {
        let (time_s, is_inner) = (0.05 * f64::from(number), number > 0 && number < count - 1);
        let (sin, cos) = (turn * time_s).sin_cos();
        let inner = |value: f64| [if is_inner { value } else { 0.0 }; 6];
        let point = TimedPoint::new(time_s, JOINTS.map(|joint| joint + 5.0 * (1.0 - cos)));
        let point = if order > 0 { point.with_velocity(inner(5.0 * turn * sin)) } else { point };
        if order > 1 { point.with_acceleration(inner(5.0 * turn * turn * cos)) } else { point }
    };
    (0..count).map(at).collect()
}

/// Each joint at its own pace, some degrees from one point to the next with a step of 1.
fn joints(count: u32, step: f64) -> Vec<Via> {
    let paces = [0.11, 0.14, 0.17, 0.20, 0.23, 0.26];
    let at = |number: u32| {
        let by = |joint: usize| 8.0 * (f64::from(number) * step * paces[joint]).sin();
        Via::from(std::array::from_fn(|joint| JOINTS[joint] + by(joint)))
    };
    (0..count).map(at).collect()
}

/// Makes a spiral of lines of a length, along which the orientation changes. With a ripple, as a share of the length,
/// each point is a corner.
fn lines(count: u32, length_mm: f64, ripple: f64) -> Vec<Via> {
    let start = Pose::from(Model::named("Zu 5").expect("a published arm").forward(HOME));
    let turn_mm = REACH_MM * REACH_MM / (2.0 * length_mm * f64::from(WAY_POINTS));
    let first = 2.5 * length_mm.min(5.0) / turn_mm;
    let (mut angle, mut points) = (first, vec![Via::from(HOME)]);
    for number in 1..count {
        angle += length_mm / (turn_mm * angle);
        let radius = turn_mm * angle + ripple * length_mm * if number % 2 == 0 { 1.0 } else { -1.0 };
        let (sin, cos) = angle.sin_cos();
        let way_mm = length_mm * f64::from(number);
        points.push(Via::from(Pose {
            x: start.x + radius * cos - turn_mm * first * first.cos(),
            y: start.y + radius * sin - turn_mm * first * first.sin(),
            z: start.z + 10.0 * (0.01 * way_mm).sin(),
            rx: start.rx + 3.0 * (0.001 * way_mm).sin(),
            ..start
        }));
    }
    points
}

/// Measures each kind of trajectory: minimum, median and maximum.
///
/// # Panics
/// A trajectory is beyond a limit.
pub fn report() -> String {
    let (mut out, checker) =
        (format!("{WAY_POINTS} way-points made, compared with limits, and a follower ready\n"), checker());
    for (name, points) in KINDS.into_iter().chain(CURVES) {
        let points = points(WAY_POINTS);
        let mut duration_s = 0.0;
        let time = |_| {
            let since = Instant::now();
            let trajectory = points.trajectory(&checker).expect("within the limits");
            duration_s = trajectory.duration_s();
            std::hint::black_box(Follower::new(trajectory, &checker, PERIOD).expect("a period of servo mode"));
            since.elapsed().as_secs_f64() * 1e3
        };
        let mut times: Vec<f64> = (0..RUNS).map(time).collect();
        times.sort_by(f64::total_cmp);
        let (least, p50, worst) = (times[0], times[RUNS / 2], times[RUNS - 1]);
        // Other work of the machine makes it longer.
        let target = points.target_ms().map_or(String::new(), |target_ms| {
            let met = if least <= target_ms { "met" } else { "MISSED" };
            format!("; target at most {target_ms} ms: {met}")
        });
        let _ = writeln!(
            out,
            "  {name:29} least {least:6.1} ms, p50 {p50:6.1} ms, worst {worst:6.1} ms, for {duration_s:6.1} s of motion{target}"
        );
    }
    out
}
