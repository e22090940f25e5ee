//! Trajectories through points with times.

use jaka_proto::messages::types::JointPosition;

use super::{Passing, TrajectoryError, WayPoint};
use crate::limits::rounded_up;
use crate::piece::{Piece, Sample};

/// Joint positions at a time, with their speeds and accelerations, if these are known.
///
/// With the feature `serde` it is written with the keys that `TimedPoint::from_json` reads.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct TimedPoint {
    /// Time in seconds from the start.
    pub time_s: f64,
    /// Joint positions.
    #[cfg_attr(feature = "serde", serde(rename = "joints_deg"))]
    pub joints: JointPosition,
    /// Speed of each joint, in deg/s.
    #[cfg_attr(feature = "serde", serde(rename = "velocity_deg_s", skip_serializing_if = "Option::is_none"))]
    pub velocity: Option<[f64; 6]>,
    /// Acceleration of each joint, in deg/s².
    #[cfg_attr(feature = "serde", serde(rename = "acceleration_deg_s2", skip_serializing_if = "Option::is_none"))]
    pub acceleration: Option<[f64; 6]>,
}

/// Highest speed, in deg/s, and acceleration, in deg/s², that count as rest: zero with the rounding errors of a file in
/// radians.
const REST: f64 = 1e-6;

impl TimedPoint {
    /// Creates a point from joint positions at a time in seconds.
    pub fn new(time_s: f64, joints: impl Into<JointPosition>) -> Self {
        Self { time_s, joints: joints.into(), velocity: None, acceleration: None }
    }

    /// Sets the speed of each joint, in deg/s.
    #[must_use]
    pub fn with_velocity(self, deg_s: [f64; 6]) -> Self {
        Self { velocity: Some(deg_s), ..self }
    }

    /// Sets the acceleration of each joint, in deg/s².
    #[must_use]
    pub fn with_acceleration(self, deg_s2: [f64; 6]) -> Self {
        Self { acceleration: Some(deg_s2), ..self }
    }
}

/// Returns the pieces and way-points of a trajectory through points with times.
pub(super) fn parts(points: &[TimedPoint]) -> Result<(Vec<Piece>, Vec<WayPoint>), TrajectoryError> {
    check_points(points)?;
    let samples: Vec<Sample> = match points[0].velocity {
        Some(_) if points[0].acceleration.is_some() => points.iter().map(sample).collect(),
        Some(_) => with_accelerations(points),
        None => with_spline(points),
    };
    check_rest(&samples)?;
    let ends = points.windows(2).zip(samples.windows(2));
    let pieces = ends.map(|(points, samples)| {
        Piece::between(points[0].time_s, points[1].time_s - points[0].time_s, &samples[0], &samples[1])
    });
    let last = points.len() - 1;
    let way_points = points.iter().enumerate().map(|(index, point)| {
        let passing = if index == 0 || index == last { Passing::Stops } else { Passing::Through };
        WayPoint { time_s: point.time_s, passing }
    });
    Ok((pieces.collect(), way_points.collect()))
}

/// Compares the jerks of pieces, one after each way-point, with their limits.
pub(super) fn check_jerks(pieces: &[Piece], most: &[f64; 6]) -> Result<(), TrajectoryError> {
    let mut worst: Option<(f64, TrajectoryError)> = None;
    for (after, piece) in (1..).zip(pieces) {
        let at_most = piece.jerks_at_most();
        if (0..6).all(|joint| at_most[joint] <= rounded_up(most[joint])) {
            continue;
        }
        for (index, jerk_deg_s3) in piece.top_jerks().into_iter().enumerate() {
            let (limit_deg_s3, factor) = (most[index], jerk_deg_s3 / most[index]);
            if factor > rounded_up(1.0) && worst.as_ref().is_none_or(|(worst, _)| factor > *worst) {
                let (joint, slower) = (index + 1, factor.cbrt());
                worst = Some((factor, TrajectoryError::Jerk { after, joint, jerk_deg_s3, limit_deg_s3, slower }));
            }
        }
    }
    worst.map_or(Ok(()), |(_, error)| Err(error))
}

fn sample(point: &TimedPoint) -> Sample {
    Sample {
        joints: point.joints,
        velocity: point.velocity.unwrap_or_default(),
        acceleration: point.acceleration.unwrap_or_default(),
    }
}

fn check_points(points: &[TimedPoint]) -> Result<(), TrajectoryError> {
    let [first, .., _] = points else { return Err(TrajectoryError::TooFew { given: points.len() }) };
    for (way_point, point) in (1..).zip(points) {
        check_numbers(way_point, point)?;
        let lacks = |what| Err(TrajectoryError::Uneven { way_point, what });
        if point.velocity.is_some() != first.velocity.is_some() {
            return lacks("velocity");
        }
        if point.acceleration.is_some() != first.acceleration.is_some()
            || point.velocity.is_none() && point.acceleration.is_some()
        {
            return lacks("acceleration");
        }
    }
    if first.time_s != 0.0 {
        return Err(TrajectoryError::FirstTime { time_s: first.time_s });
    }
    match (2..).zip(points.windows(2)).find(|(_, pair)| pair[1].time_s <= pair[0].time_s) {
        Some((way_point, pair)) => {
            Err(TrajectoryError::Time { way_point, time_s: pair[1].time_s, before_s: pair[0].time_s })
        }
        None => Ok(()),
    }
}

fn check_numbers(way_point: usize, point: &TimedPoint) -> Result<(), TrajectoryError> {
    let finite = |numbers: &[f64; 6]| numbers.iter().all(|number| number.is_finite());
    let numbers = [
        ("time", point.time_s.is_finite()),
        ("joint position", finite(&point.joints.0)),
        ("velocity", point.velocity.as_ref().is_none_or(finite)),
        ("acceleration", point.acceleration.as_ref().is_none_or(finite)),
    ];
    match numbers.into_iter().find(|(_, finite)| !finite) {
        Some((what, _)) => Err(TrajectoryError::NotFinite { way_point, what }),
        None => Ok(()),
    }
}

fn check_rest(samples: &[Sample]) -> Result<(), TrajectoryError> {
    for (index, sample) in [(0, samples.first()), (samples.len() - 1, samples.last())] {
        let speeds = sample.map(|sample| sample.velocity).unwrap_or_default();
        if let Some((joint, speed_deg_s)) = (1..).zip(speeds).find(|(_, speed)| speed.abs() > REST) {
            return Err(TrajectoryError::NotAtRest { way_point: index + 1, joint, speed_deg_s });
        }
        let accelerations = sample.map(|sample| sample.acceleration).unwrap_or_default();
        if let Some((joint, deg_s2)) = (1..).zip(accelerations).find(|(_, deg_s2)| deg_s2.abs() > REST) {
            return Err(TrajectoryError::Accelerates { way_point: index + 1, joint, acceleration_deg_s2: deg_s2 });
        }
    }
    Ok(())
}

/// Returns points with velocities and computed accelerations: at inner points the mean of the accelerations that
/// polynomials of the third degree have before and after them; at both ends zero.
fn with_accelerations(points: &[TimedPoint]) -> Vec<Sample> {
    let mut samples: Vec<Sample> = points.iter().map(sample).collect();
    for index in 1..points.len() - 1 {
        let [before, here, after] = [index - 1, index, index + 1].map(|index| samples[index]);
        let seconds = [index - 1, index].map(|index| points[index + 1].time_s - points[index].time_s);
        samples[index].acceleration = std::array::from_fn(|joint| {
            let mean =
                |one: &Sample, other: &Sample, seconds: f64| (other.joints.0[joint] - one.joints.0[joint]) / seconds;
            let (past, next) = (mean(&before, &here, seconds[0]), mean(&here, &after, seconds[1]));
            let speed = 2.0 * here.velocity[joint];
            let [past, next] =
                [speed + before.velocity[joint] - 3.0 * past, 3.0 * next - speed - after.velocity[joint]];
            past / seconds[0] + next / seconds[1]
        });
    }
    samples
}

/// Factors of three velocities in half of the acceleration at a point, times the seconds of the piece: the velocity at
/// the point, at the other end of the piece, and the mean one.
const INNER: [f64; 3] = [2.0, 1.0, 3.0];
/// Factors like [`INNER`], for a piece of the fourth degree whose other end is that of the trajectory, without
/// acceleration there.
const OUTER: [f64; 3] = [3.0, 0.0, 6.0];

/// Returns points with velocities and accelerations that do not step, and are zero at both ends.
///
/// At each inner point the accelerations before and after are equal, which gives an equation for its velocity and those
/// of its neighbours. Elimination and back substitution solve all of them together.
fn with_spline(points: &[TimedPoint]) -> Vec<Sample> {
    let mut samples: Vec<Sample> = points.iter().map(sample).collect();
    let last = points.len() - 1;
    let seconds = |index: usize| points[index + 1].time_s - points[index].time_s;
    let mean = |index: usize, joint: usize| {
        (points[index + 1].joints.0[joint] - points[index].joints.0[joint]) / seconds(index)
    };
    // Share of the next velocity in each; the samples have the rest until the back substitution.
    let mut shares = vec![0.0; points.len()];
    for index in 1..last {
        let (first, second) = (seconds(index - 1), seconds(index));
        let [before, after] = [(index == 1), (index + 1 == last)].map(|is_outer| if is_outer { OUTER } else { INNER });
        // The weights keep all numbers at most as large as the speeds.
        let (near, far) = (second / (first + second), first / (first + second));
        let pivot = near * before[0] + far * after[0] - near * before[1] * shares[index - 1];
        shares[index] = far * after[1] / pivot;
        samples[index].velocity = std::array::from_fn(|joint| {
            let sum = near * before[2] * mean(index - 1, joint) + far * after[2] * mean(index, joint);
            (sum - near * before[1] * samples[index - 1].velocity[joint]) / pivot
        });
    }
    for index in (1..last).rev() {
        let next = samples[index + 1].velocity;
        for (velocity, next) in samples[index].velocity.iter_mut().zip(next) {
            *velocity -= shares[index] * next;
        }
    }
    for index in 1..last {
        let [here, other, mid] = if index == 1 { OUTER } else { INNER };
        samples[index].acceleration = std::array::from_fn(|joint| {
            let speeds = here * samples[index].velocity[joint] + other * samples[index - 1].velocity[joint];
            2.0 * (speeds - mid * mean(index - 1, joint)) / seconds(index - 1)
        });
    }
    samples
}
