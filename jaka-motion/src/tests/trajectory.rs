//! Shared helpers of the tests of trajectories.

mod curve;
#[cfg(feature = "trajectory-files")]
mod file;
mod hostile;
mod presets;
mod through;
mod timed;
mod vias;

use super::Random;
use crate::{Checker, Frames, Limits, Model, TimedPoint, Trajectory};

/// Joint positions well within all limits.
const HOME: [f64; 6] = [0.0, 60.0, -80.0, 190.0, -90.0, 0.0];

fn zu5() -> Limits {
    Limits::of(Model::named("Zu 5").expect("a published arm"))
}

fn checker() -> Checker {
    Checker::new(zu5(), Frames::new())
}

/// Steps through a trajectory as a servo session does, and compares the differences of the positions with the limits.
fn witness(trajectory: &Trajectory, checker: &Checker, period_s: f64) {
    let limits = checker.limits();
    let mut last = [trajectory.start().0; 2];
    let mut time_s = 0.0;
    while time_s < trajectory.duration_s() + 3.0 * period_s {
        let here = trajectory.at(time_s).joints.0;
        for joint in 0..6 {
            let step = here[joint] - last[1][joint];
            let change = step - (last[1][joint] - last[0][joint]);
            assert!(step.abs() <= limits.joint_speeds()[joint] * period_s * (1.0 + 1e-9), "at {time_s} s");
            let most = limits.joint_accelerations()[joint] * period_s * period_s;
            assert!(change.abs() <= most * (1.0 + 1e-9) + 1e-12, "at {time_s} s: {change} of {most}");
        }
        checker.check_set_point(last.map(Into::into), here.into(), period_s).expect("a session takes it");
        last = [last[1], here];
        time_s += period_s;
    }
}

/// Returns times throughout a trajectory.
fn times(trajectory: &Trajectory, count: u32) -> impl Iterator<Item = f64> {
    let duration_s = trajectory.duration_s();
    (0..=count).map(move |place| f64::from(place) / f64::from(count) * duration_s)
}

/// Checks that no jerk is above the planned ones; each is measured over a thousandth of a second.
fn jerks_are_within(trajectory: &Trajectory, checker: &Checker, share: f64) {
    for time_s in times(trajectory, 2000) {
        let [before, after] = [0.0, 1e-3].map(|later| trajectory.at(time_s + later).acceleration);
        for joint in 0..6 {
            let most = checker.limits().joint_jerks()[joint] * share;
            let jerk = (after[joint] - before[joint]) / 1e-3;
            assert!(jerk.abs() < most + 1e-6, "joint {} at {time_s} s: {jerk} of {most}", joint + 1);
        }
    }
}

/// Returns the distance of a point from the straight path between two others.
fn off_way<const N: usize>(point: [f64; N], from: [f64; N], to: [f64; N]) -> f64 {
    let dot = |one: &[f64; N], other: &[f64; N]| one.iter().zip(other).map(|(one, other)| one * other).sum::<f64>();
    let less = |one: [f64; N], other: [f64; N]| std::array::from_fn::<f64, N, _>(|index| one[index] - other[index]);
    let (way, done) = (less(to, from), less(point, from));
    let share = (dot(&way, &done) / dot(&way, &way)).clamp(0.0, 1.0);
    let off = std::array::from_fn::<f64, N, _>(|index| done[index] - share * way[index]);
    dot(&off, &off).sqrt()
}

/// Returns random points around [`HOME`], from 0.2 to 2 seconds apart.
fn some_points(random: &mut Random, count: usize) -> Vec<TimedPoint> {
    let mut time_s = 0.0;
    let point = |_| {
        let joints = HOME.map(|joint| joint + random.between(-10.0, 10.0));
        let point = TimedPoint::new(time_s, joints);
        time_s += random.between(0.2, 2.0);
        point
    };
    (0..count).map(point).collect()
}

/// Returns the points with their times multiplied until the trajectory is within the limits.
fn slow_enough(points: &[TimedPoint], checker: &Checker) -> (Vec<TimedPoint>, Trajectory) {
    let mut points = points.to_vec();
    for _ in 0..40 {
        if let Ok(trajectory) = Trajectory::timed(&points, checker) {
            return (points, trajectory);
        }
        for point in &mut points {
            point.time_s *= 1.3;
            point.velocity = point.velocity.map(|speeds| speeds.map(|speed| speed / 1.3));
            point.acceleration = point.acceleration.map(|all| all.map(|one| one / 1.3 / 1.3));
        }
    }
    panic!("no time is enough")
}

/// With the stated change of the rate, up to a period of it, the joints stay within their accelerations; with a little
/// more they do not.
#[test]
fn a_rate_that_changes_so_stays_within_the_accelerations() {
    let (mut random, checker) = (Random::new(4), checker());
    let limits = *checker.limits().joint_accelerations();
    for _ in 0..30 {
        let (_, trajectory) = slow_enough(&some_points(&mut random, 5), &checker);
        for _ in 0..100 {
            let (time_s, rate) = (random.between(0.0, trajectory.duration_s()), random.between(0.0, 1.0));
            let change = trajectory.rate_change(time_s, time_s, rate);
            let here = trajectory.at(time_s);
            let needed = |change: f64| {
                let used =
                    |joint: usize| (here.acceleration[joint] * rate * rate + here.velocity[joint] * change).abs();
                (0..6).map(|joint| used(joint) / limits[joint]).fold(0.0, f64::max)
            };
            for [most, sign] in [[change.fall, -1.0], [change.rise, 1.0]] {
                assert!(most >= 0.0 && (needed(sign * most) - 1.0).abs() < 1e-3, "{}", needed(sign * most));
                assert!((0..=10).all(|part| needed(sign * most * f64::from(part) / 10.0) < 1.0 + 1e-3));
            }
            let while_passing = trajectory.rate_change(time_s - 0.01, time_s + 0.01, rate);
            for later in [-0.01, -0.003, 0.0, 0.006, 0.01] {
                let then = trajectory.rate_change(time_s + later, time_s + later, rate);
                assert!(while_passing.fall <= then.fall * (1.0 + 1e-3));
                assert!(while_passing.rise <= then.rise * (1.0 + 1e-3));
            }
        }
    }
}
