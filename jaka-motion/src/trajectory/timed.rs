//! Trajectories through points with times.

use jaka_proto::messages::types::JointPosition;

use super::{Passing, Trajectory, TrajectoryError, WayPoint};
use crate::checker::Checker;
use crate::piece::{Piece, Sample};

/// Where the joints are at a time, and how they move there, if that is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimedPoint {
    /// The time in seconds from the start.
    pub time_s: f64,
    /// The joint positions.
    pub joints: JointPosition,
    /// The speed of each joint, in deg/s.
    pub velocity: Option<[f64; 6]>,
    /// The acceleration of each joint, in deg/s².
    pub acceleration: Option<[f64; 6]>,
}

/// The highest speed, in deg/s, that counts as rest: what is left of zero in a file of radians.
const REST: f64 = 1e-6;

impl TimedPoint {
    /// Joint positions at a time in seconds.
    pub fn new(time_s: f64, joints: impl Into<JointPosition>) -> Self {
        Self { time_s, joints: joints.into(), velocity: None, acceleration: None }
    }

    /// With the speed of each joint, in deg/s.
    #[must_use]
    pub fn with_velocity(self, deg_s: [f64; 6]) -> Self {
        Self { velocity: Some(deg_s), ..self }
    }

    /// With the acceleration of each joint, in deg/s².
    #[must_use]
    pub fn with_acceleration(self, deg_s2: [f64; 6]) -> Self {
        Self { acceleration: Some(deg_s2), ..self }
    }
}

impl Trajectory {
    /// Through points at their times, compared with an arm's limits.
    ///
    /// - With velocities and accelerations each piece is the polynomial of the fifth degree that has those of both ends.
    /// - With velocities alone it is of the third degree. Accelerations then step at the points.
    /// - With neither, pieces of the third degree have the velocities for which accelerations do not step, and rest at both ends.
    ///
    /// It does exactly what the points say, within limits, and leaves a reserve for other rates only where they do: see
    /// [`rate_change`](Self::rate_change).
    ///
    /// ```
    /// use jaka_motion::{Checker, Frames, Limits, Model, TimedPoint, Trajectory};
    ///
    /// let checker = Checker::new(Limits::of(Model::named("Zu 5").expect("a published arm")), Frames::new());
    /// let points = [
    ///     TimedPoint::new(0.0, [0.0, 60.0, -80.0, 190.0, -90.0, 0.0]),
    ///     TimedPoint::new(1.0, [10.0, 60.0, -80.0, 190.0, -90.0, 0.0]),
    ///     TimedPoint::new(2.0, [20.0, 60.0, -85.0, 190.0, -90.0, 0.0]),
    /// ];
    /// let trajectory = Trajectory::timed(&points, &checker)?;
    /// assert_eq!(trajectory.at(1.0).joints, points[1].joints);
    ///
    /// let sudden = Trajectory::timed(&points.map(|point| TimedPoint { time_s: point.time_s / 4.0, ..point }), &checker);
    /// let error = sudden.unwrap_err().to_string();
    /// assert_eq!(error, "after way-point 1, at 0.000 s: joint 1 would accelerate by 480 deg/s²; limit 72 (Zu 5)");
    /// # Ok::<(), jaka_motion::TrajectoryError>(())
    /// ```
    ///
    /// # Errors
    /// What is wrong with the points, or the first place that is beyond a limit.
    pub fn timed(points: &[TimedPoint], checker: &Checker) -> Result<Self, TrajectoryError> {
        check_points(points)?;
        let samples: Vec<Sample> = match points[0].velocity {
            Some(_) => points.iter().map(sample).collect(),
            None => with_spline_velocities(points),
        };
        check_rest(&samples)?;
        let make = if points[0].acceleration.is_some() { Piece::between } else { Piece::cubic };
        let ends = points.windows(2).zip(samples.windows(2));
        let pieces = ends.map(|(points, samples)| {
            make(points[0].time_s, points[1].time_s - points[0].time_s, &samples[0], &samples[1])
        });
        let last = points.len() - 1;
        let way_points = points.iter().enumerate().map(|(index, point)| {
            let passing = if index == 0 || index == last { Passing::Stops } else { Passing::Through };
            WayPoint { time_s: point.time_s, passing }
        });
        Self::checked(pieces.collect(), way_points.collect(), checker)
    }
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
    }
    Ok(())
}

/// Points with these velocities, and rest at both ends.
///
/// At each inner point the acceleration before is to be that after, which gives an equation for its velocity and those of its neighbours. All
/// together are solved by elimination forwards and insertion backwards.
fn with_spline_velocities(points: &[TimedPoint]) -> Vec<Sample> {
    let at_rest = |point: &TimedPoint| Sample { joints: point.joints, velocity: [0.0; 6], acceleration: [0.0; 6] };
    let mut samples: Vec<Sample> = points.iter().map(at_rest).collect();
    // The share of the next velocity in each; the rest of it is in the samples until insertion.
    let mut shares = vec![0.0; points.len()];
    for index in 1..points.len() - 1 {
        let [before, here, after] = [index - 1, index, index + 1].map(|index| &points[index]);
        let [first, second] = [here.time_s - before.time_s, after.time_s - here.time_s];
        // Weighted so that no number is larger than the speeds.
        let (near, far) = (second / (first + second), first / (first + second));
        let pivot = 2.0 - near * shares[index - 1];
        shares[index] = far / pivot;
        samples[index].velocity = std::array::from_fn(|joint| {
            let mean = |from: &TimedPoint, to: &TimedPoint, seconds: f64| {
                (to.joints.0[joint] - from.joints.0[joint]) / seconds
            };
            let sum = 3.0 * (near * mean(before, here, first) + far * mean(here, after, second));
            (sum - near * samples[index - 1].velocity[joint]) / pivot
        });
    }
    for index in (1..points.len() - 1).rev() {
        let next = samples[index + 1].velocity;
        for (velocity, next) in samples[index].velocity.iter_mut().zip(next) {
            *velocity -= shares[index] * next;
        }
    }
    samples
}
