//! Curves of the fifth degree through points, computed without the code that is tested.

/// A curve through points at times, at rest at both ends.
#[derive(Debug, Clone)]
pub struct Curve {
    points: Vec<Point>,
}

/// A point of a [`Curve`].
#[derive(Debug, Clone, Copy)]
pub struct Point {
    /// Time from the start of the curve, in seconds.
    pub time_s: f64,
    /// Joint positions, in degrees.
    pub joints: [f64; 6],
    /// Joint speeds, in degrees per second.
    pub speeds: [f64; 6],
}

/// Maximum distance of a set-point from the curve, in degrees.
const ON_CURVE: f64 = 1e-6;
/// Step of the search along the curve, in seconds.
const STEP_S: f64 = 1e-3;

impl Curve {
    /// A curve with the mean speed of both sides at each inner point, and no acceleration there.
    pub fn through(points: &[(f64, [f64; 6])]) -> Self {
        let speeds = |index: usize| match (index.checked_sub(1).map(|before| points[before]), points.get(index + 1)) {
            (Some(before), Some(after)) => {
                std::array::from_fn(|joint| (after.1[joint] - before.1[joint]) / (after.0 - before.0))
            }
            _ => [0.0; 6],
        };
        let point = |(index, &(time_s, joints))| Point { time_s, joints, speeds: speeds(index) };
        Self { points: points.iter().enumerate().map(point).collect() }
    }

    /// Returns the curve, this many times as slow.
    #[must_use]
    pub fn slower(&self, factor: f64) -> Self {
        let slower = |point: &Point| Point {
            time_s: point.time_s * factor,
            speeds: point.speeds.map(|speed| speed / factor),
            ..*point
        };
        Self { points: self.points.iter().map(slower).collect() }
    }

    /// Its points, in the order of their times.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Time from its first point to its last, in seconds.
    pub fn duration_s(&self) -> f64 {
        self.points.last().map_or(0.0, |point| point.time_s)
    }

    /// Joint positions at a time.
    pub fn at(&self, time_s: f64) -> [f64; 6] {
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

    /// Times at which set-points are on the curve.
    ///
    /// # Errors
    /// As [`are_on`].
    pub fn has(&self, set_points: &[[f64; 6]]) -> Result<Vec<f64>, String> {
        are_on(&|time_s| self.at(time_s), self.duration_s(), set_points)
    }
}

/// Times at which set-points are on a curve; an error where one is off it, or before the one before it.
///
/// # Errors
/// Names the first such set-point.
pub fn are_on(curve: &dyn Fn(f64) -> [f64; 6], duration_s: f64, set_points: &[[f64; 6]]) -> Result<Vec<f64>, String> {
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

/// Largest difference of two joint positions, in degrees.
pub fn apart(one: &[f64; 6], other: &[f64; 6]) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
}

/// The first time from `least` on at which a curve is next to joint positions, and how far away they are then.
fn nearest(curve: &dyn Fn(f64) -> [f64; 6], duration_s: f64, joints: &[f64; 6], least: f64) -> (f64, f64) {
    let off = |time_s: f64| apart(&curve(time_s), joints);
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

/// Time and value of the minimum of a function between two times, if the function has one minimum there.
fn narrowed(of: &impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> (f64, f64) {
    for _ in 0..40 {
        let third = (to - from) / 3.0;
        if of(from + third) <= of(to - third) { to -= third } else { from += third }
    }
    let time_s = f64::midpoint(from, to);
    (time_s, of(time_s))
}
