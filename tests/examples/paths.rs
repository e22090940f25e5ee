//! Trajectories through points and curves near them, as JSON lines: points, limits, tolerances, and the positions each
//! millisecond. `tests/outside/run paths` compares them with TOPP-RA and Ruckig.
//!
//! `cargo run --release -p jaka-tests --example paths -- 33`: the seed. With `times` in its place, the time for
//! planning.

use std::io::{self, BufWriter, Write};
use std::iter::once;
use std::time::Instant;

use jaka_motion::{Checker, Frames, Limits, Model, Trajectory, TrajectoryError, Via, ViaTarget};
use jaka_sync::types::Pose;
use jaka_tests::rig::Random;
use serde_json::{Value, json};

/// Well within all limits.
const HOME: [f64; 6] = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];
const PERIOD_S: f64 = 0.001;
const RADIUS_MM: f64 = 80.0;
/// Accelerations in deg/s²; jerks are ten times as much.
const QUICK: f64 = 300.0;
const GENTLE: f64 = 72.0;

/// A trajectory and what was asked of it.
struct Case {
    group: String,
    acceleration: f64,
    /// In mm/s.
    tcp_speed: Option<f64>,
    points: Vec<Via>,
    /// In mm, degrees of the tool's turn, degrees of a joint.
    within: [f64; 3],
    is_curve: bool,
}

fn main() -> io::Result<()> {
    let first = std::env::args().nth(1).unwrap_or_default();
    let mut out = BufWriter::new(io::stdout().lock());
    if first == "times" {
        return times(&mut out);
    }
    for case in cases(first.parse().unwrap_or(33)) {
        writeln!(out, "{}", case.told())?;
    }
    out.flush()
}

fn cases(seed: u32) -> Vec<Case> {
    let (mut random, mut cases) = (Random::new(seed), Vec::new());
    for acceleration in [QUICK, GENTLE] {
        for step_mm in [10.0, 5.0, 2.0, 1.0, 0.5, 0.2] {
            cases.push(Case {
                group: format!("circle, {acceleration} deg/s², steps of {step_mm} mm"),
                acceleration,
                tcp_speed: Some(100.0),
                points: circle(step_mm, 0.6),
                within: [0.2, 1.0, 0.0],
                is_curve: true,
            });
        }
    }
    for count in [30, 100, 300, 1000] {
        let within_deg = if count == 30 { 0.1 } else { 0.02 };
        cases.push(Case {
            group: format!("smooth curve of joints, {count} points within {within_deg} deg"),
            acceleration: QUICK,
            tcp_speed: None,
            points: (0..=count).map(|index| Via::from(wave(f64::from(index) / f64::from(count)))).collect(),
            within: [0.0, 0.0, within_deg],
            is_curve: true,
        });
    }
    cases.push(Case {
        group: "noisy seam of 200 mm, steps of 1 mm".to_owned(),
        acceleration: GENTLE,
        tcp_speed: Some(15.0),
        points: seam(&mut random),
        within: [0.2, 0.5, 0.0],
        is_curve: true,
    });
    for within_deg in [2.0, 5.0, 10.0] {
        for _ in 0..40 {
            let points = (0..4).map(|_| Via::from(HOME.map(|joint| joint + random.between(-40.0, 40.0))));
            cases.push(Case {
                group: format!("5 random joint points, corners of {within_deg} deg"),
                acceleration: QUICK,
                tcp_speed: None,
                points: once(Via::from(HOME)).chain(points).collect(),
                within: [0.0, 0.0, within_deg],
                is_curve: false,
            });
        }
    }
    for _ in 0..25 {
        let home = home();
        let pose = |random: &mut Random| {
            let [x, y, z] = [home.x, home.y, home.z].map(|at| at + random.between(-80.0, 80.0));
            let [rx, ry, rz] = [home.rx, home.ry, home.rz].map(|turn| turn + random.between(-10.0, 10.0));
            Via::from(Pose { x, y, z, rx, ry, rz })
        };
        cases.push(Case {
            group: "5 random poses, lines with corners of 5 mm".to_owned(),
            acceleration: QUICK,
            tcp_speed: Some(250.0),
            points: once(Via::from(HOME)).chain((0..4).map(|_| pose(&mut random))).collect(),
            within: [5.0, 5.0, 0.0],
            is_curve: false,
        });
    }
    cases
}

fn home() -> Pose {
    Pose::from(Model::named("Zu 5").expect("a published arm").forward(HOME))
}

/// Part of a circle.
fn circle(step_mm: f64, turns: f64) -> Vec<Via> {
    let arc = turns * std::f64::consts::TAU;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
    let count = (RADIUS_MM * arc / step_mm).round() as u32;
    let on_circle = |index: u32| {
        let (sin, cos) = (arc * f64::from(index) / f64::from(count)).sin_cos();
        Via::from(Pose { x: home().x + RADIUS_MM * (cos - 1.0), y: home().y + RADIUS_MM * sin, ..home() })
    };
    once(Via::from(HOME)).chain((1..=count).map(on_circle)).collect()
}

fn wave(share: f64) -> [f64; 6] {
    let waves = [(0.7, 0.0), (1.1, 1.0), (0.9, 2.0), (1.3, 3.0), (1.7, 4.0), (2.1, 5.0)];
    std::array::from_fn(|joint| {
        let (rate, phase) = waves[joint];
        HOME[joint] + 30.0 * (f64::sin(3.0 * rate * share + phase) - f64::sin(phase))
    })
}

/// Straight, with noise of 0.02 mm and 0.05 deg.
fn seam(random: &mut Random) -> Vec<Via> {
    let home = home();
    let noisy = |index: u32| {
        let mut noise = |most: f64| random.between(-most, most);
        let [x, y, z] = [home.x, home.y + f64::from(index), home.z].map(|at| at + noise(0.02));
        let [rx, ry, rz] = [home.rx, home.ry, home.rz].map(|turn| turn + noise(0.05));
        Via::from(Pose { x, y, z, rx, ry, rz })
    };
    once(Via::from(HOME)).chain((1..=200).map(noisy)).collect()
}

impl Case {
    fn limits(&self) -> Limits {
        let limits = Limits::of(Model::named("Zu 5").expect("a published arm"));
        limits.with_joint_accelerations([self.acceleration; 6]).expect("above 0")
    }

    fn built(&self) -> Result<Trajectory, TrajectoryError> {
        let checker = Checker::new(self.limits(), Frames::new());
        let ([mm, turn_deg, joint_deg], speed) = (self.within, self.tcp_speed.unwrap_or(f64::INFINITY));
        if self.is_curve {
            let deg = turn_deg.max(joint_deg);
            return Trajectory::curve(self.points.clone())
                .within_mm(mm)
                .within_deg(deg)
                .tcp_speed(speed)
                .build(&checker);
        }
        let through = Trajectory::through(self.points.clone()).corner_mm(mm).corner_deg(joint_deg);
        through.corner_turn_deg(turn_deg).tcp_speed(speed).build(&checker)
    }

    fn told(&self) -> Value {
        let trajectory = self.built().unwrap_or_else(|error| panic!("{}: {error}", self.group));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
        let count = (trajectory.duration_s() / PERIOD_S).ceil() as u32;
        let set_points: Vec<_> = (0..=count).map(|at| trajectory.at(f64::from(at) * PERIOD_S).joints.0).collect();
        let points: Vec<Value> = self
            .points
            .iter()
            .map(|via| match via.target() {
                ViaTarget::Joints(joints) => json!(joints.0),
                ViaTarget::Line(pose) => json!(<[f64; 6]>::from(pose)),
                other => panic!("{other:?} is in no case"),
            })
            .collect();
        json!({
            "group": self.group,
            "speeds": self.limits().joint_speeds(),
            "acceleration": self.acceleration,
            "jerk": 10.0 * self.acceleration,
            "tcp_speed": self.tcp_speed,
            "space": if self.within[0] > 0.0 { "tool" } else { "joints" },
            "within": self.within,
            "points": points,
            "duration_s": trajectory.duration_s(),
            "period_s": PERIOD_S,
            "set_points": set_points,
        })
    }
}

/// Time for planning by the number of points.
fn times(out: &mut impl Write) -> io::Result<()> {
    for count in [1_000, 10_000, 100_000] {
        let joints = (0..=count).map(|index| Via::from(wave(f64::from(index) / 1000.0))).collect();
        let turns = f64::from(count) / 628.0;
        let kinds = [("joints", joints, [0.0, 0.0, 0.1]), ("poses", circle(0.8, turns), [0.1, 1.0, 0.0])];
        for (kind, points, within) in kinds {
            let group = format!("{count} {kind}");
            let case = Case { group, acceleration: QUICK, tcp_speed: Some(100.0), points, within, is_curve: true };
            let since = Instant::now();
            let planned = case.built().unwrap_or_else(|error| panic!("{}: {error}", case.group));
            writeln!(out, "{}: {:?} for {:.1} s of motion", case.group, since.elapsed(), planned.duration_s())?;
        }
    }
    out.flush()
}
