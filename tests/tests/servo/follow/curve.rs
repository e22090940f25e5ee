//! Curves of the fifth degree through points, computed without the code that is tested.

use jaka_sync::jaka_motion::{Checker, TimedPoint, Trajectory, TrajectoryError};

/// A curve through points at times, which stands at both ends.
#[derive(Debug, Clone)]
pub(crate) struct Curve {
    points: Vec<Point>,
}

#[derive(Debug, Clone, Copy)]
struct Point {
    time_s: f64,
    joints: [f64; 6],
    speeds: [f64; 6],
}

/// How far a set-point may be from the curve, in degrees.
const ON_CURVE: f64 = 1e-6;
/// In which steps the curve is searched, in seconds.
const STEP_S: f64 = 1e-3;

impl Curve {
    /// With the mean speed of both sides at each inner point, and no acceleration there.
    pub(crate) fn through(points: &[(f64, [f64; 6])]) -> Self {
        let speeds = |index: usize| match (index.checked_sub(1).map(|before| points[before]), points.get(index + 1)) {
            (Some(before), Some(after)) => {
                std::array::from_fn(|joint| (after.1[joint] - before.1[joint]) / (after.0 - before.0))
            }
            _ => [0.0; 6],
        };
        let point = |(index, &(time_s, joints))| Point { time_s, joints, speeds: speeds(index) };
        Self { points: points.iter().enumerate().map(point).collect() }
    }

    /// The same, this many times as slow.
    pub(crate) fn slower(&self, factor: f64) -> Self {
        let slower = |point: &Point| Point {
            time_s: point.time_s * factor,
            speeds: point.speeds.map(|speed| speed / factor),
            ..*point
        };
        Self { points: self.points.iter().map(slower).collect() }
    }

    pub(crate) fn trajectory(&self, checker: &Checker) -> Result<Trajectory, TrajectoryError> {
        let point = |point: &Point| {
            TimedPoint::new(point.time_s, point.joints).with_velocity(point.speeds).with_acceleration([0.0; 6])
        };
        Trajectory::timed(&self.points.iter().map(point).collect::<Vec<_>>(), checker)
    }

    pub(crate) fn duration_s(&self) -> f64 {
        self.points.last().map_or(0.0, |point| point.time_s)
    }

    /// Where the joints are at a time.
    pub(crate) fn at(&self, time_s: f64) -> [f64; 6] {
        let time_s = time_s.clamp(0.0, self.duration_s());
        let next = self.points.iter().skip(1).position(|point| time_s <= point.time_s).unwrap_or(0);
        let [from, to] = [self.points[next], self.points[next + 1]];
        let seconds = to.time_s - from.time_s;
        let share = (time_s - from.time_s) / seconds;
        // Hermite's polynomials of the fifth degree.
        let [second, third] = [share * share, share.powi(3)];
        let rises = third * (10.0 - 15.0 * share + 6.0 * second);
        let leaves = share - third * (6.0 - 8.0 * share + 3.0 * second);
        let arrives = third * (-4.0 + 7.0 * share - 3.0 * second);
        std::array::from_fn(|joint| {
            from.joints[joint]
                + (to.joints[joint] - from.joints[joint]) * rises
                + seconds * (from.speeds[joint] * leaves + to.speeds[joint] * arrives)
        })
    }

    /// Fails where a set-point is off the curve, or before the one before it; the times at which they are on it.
    pub(crate) fn has(&self, set_points: &[[f64; 6]]) -> Result<Vec<f64>, String> {
        are_on(&|time_s| self.at(time_s), self.duration_s(), set_points)
    }
}

/// Fails where a set-point is off a curve, or before the one before it; the times at which they are on it.
pub(crate) fn are_on(
    curve: &impl Fn(f64) -> [f64; 6],
    duration_s: f64,
    set_points: &[[f64; 6]],
) -> Result<Vec<f64>, String> {
    let mut times = Vec::new();
    let mut least = 0.0;
    for (index, joints) in set_points.iter().enumerate() {
        let (on_s, off) = nearest(curve, duration_s, joints, least);
        if off > ON_CURVE {
            return Err(format!("set-point {index} is {off} deg from the curve: {joints:?}, next to {on_s} s"));
        }
        times.push(on_s);
        least = on_s;
    }
    Ok(times)
}

/// The first time from `least` on at which a curve is next to joint positions, and how far away they are then.
fn nearest(curve: &impl Fn(f64) -> [f64; 6], duration_s: f64, joints: &[f64; 6], least: f64) -> (f64, f64) {
    let off = |time_s: f64| super::apart(&curve(time_s), joints);
    let mut from = (least - STEP_S).max(0.0);
    let mut best = (from, off(from));
    while from < duration_s && best.1 > ON_CURVE {
        let (time_s, off) = narrowed(&off, from, from + 2.0 * STEP_S);
        if off < best.1 {
            best = (time_s, off);
        }
        from += STEP_S;
    }
    best
}

/// Where a function is the least between two times, if it has one least value there.
fn narrowed(of: &impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> (f64, f64) {
    for _ in 0..40 {
        let third = (to - from) / 3.0;
        if of(from + third) <= of(to - third) { to -= third } else { from += third }
    }
    let time_s = f64::midpoint(from, to);
    (time_s, of(time_s))
}

#[test]
fn what_is_off_the_curve_is_noticed() {
    let curve = Curve::through(&[(0.0, [0.0; 6]), (1.0, [10.0, 0.0, 0.0, 0.0, 0.0, -5.0]), (2.0, [0.0; 6])]);
    let times = [0.0, 0.1, 0.5, 0.9, 1.3, 2.0];
    let on_it = times.map(|time_s| curve.at(time_s));
    let found = curve.has(&on_it).expect("they are on it");
    assert!(found.iter().zip(times).all(|(found, time_s)| (found - time_s).abs() < 1e-2), "{found:?}");
    for (index, joint) in [(1, 0), (2, 3), (4, 5)] {
        let mut off = on_it;
        off[index][joint] += 3e-6;
        assert!(curve.has(&off).is_err_and(|what| what.starts_with(&format!("set-point {index} "))));
    }
    // Nor may it go back.
    assert!(curve.has(&[on_it[2], on_it[1], on_it[3]]).is_err());
}
