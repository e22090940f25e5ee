//! Trajectories through points with times.

#[cfg(feature = "trajectory-files")]
mod file;

use jaka_proto::messages::types::JointPosition;

use super::{Passing, TrajectoryError, WayPoint};
#[cfg(feature = "trajectory-files")]
use crate::TrajectoryFileError;
use crate::piece::{Piece, Sample};

/// Where the joints are at a time, and how they move there, if that is known.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
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

#[cfg(feature = "trajectory-files")]
impl TimedPoint {
    /// The points of a CSV text; `file_name` is what errors name.
    ///
    /// The first line that is not blank names the columns, each with its unit and in any order: `time_s`; `joint_1_deg`
    /// to `joint_6_deg`, or `joint_1_rad` and so on; and if they are given `velocity_1_deg_s` or `velocity_1_rad_s`,
    /// and `acceleration_1_deg_s2` or `acceleration_1_rad_s2`. Each line after it is a point. Numbers are separated by
    /// commas and not quoted; lines that are blank or start with `#` do not count. The first time is 0, and times
    /// increase.
    ///
    /// ```
    /// use jaka_motion::TimedPoint;
    ///
    /// let text = "\
    /// time_s,joint_1_rad,joint_2_rad,joint_3_rad,joint_4_rad,joint_5_rad,joint_6_rad
    /// 0.0,0.0,1.0471975511965976,-1.3962634015954636,3.3161255787892263,-1.5707963267948966,0.0
    /// 1.0,0.1,1.0471975511965976,-1.3962634015954636,3.3161255787892263,-1.5707963267948966,0.0
    /// ";
    /// let points = TimedPoint::from_csv(text, "way.csv")?;
    /// assert!((points[1].joints.0[1] - 60.0).abs() < 1e-12);
    /// assert_eq!(TimedPoint::from_csv(&TimedPoint::to_csv(&points), "way.csv")?, points);
    ///
    /// let errors = TimedPoint::from_csv(&text.replace("0.1,", "O.1,").replace("joint_6_rad", "joint_6"), "way.csv").unwrap_err();
    /// assert_eq!(
    ///     errors.to_string(),
    ///     "way.csv:1:1: there is no column `joint_6_deg` or `joint_6_rad`\n\
    ///      way.csv:1:68: unknown column `joint_6`; they are `time_s`, `joint_1_deg`, `joint_1_rad` and the like\n\
    ///      way.csv:3:5: joint_1_rad: found `O.1`, expected a finite number"
    /// );
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// Everything that is wrong, at its line and column.
    pub fn from_csv(text: &str, file_name: &str) -> Result<Vec<Self>, TrajectoryFileError> {
        file::read_csv(text, file_name)
    }

    /// The points of a JSON text; `file_name` is what errors name.
    ///
    /// An object with a list `points` of objects, whose keys have the units: `time_s`; `joints_deg` or `joints_rad`, a
    /// list of six numbers; and if they are given `velocity_deg_s` or `velocity_rad_s`, and `acceleration_deg_s2` or
    /// `acceleration_rad_s2`. All points have the same. The first time is 0, and times increase.
    ///
    /// ```
    /// use jaka_motion::TimedPoint;
    ///
    /// let text = r#"{"points": [
    ///     {"time_s": 0, "joints_deg": [0, 60, -80, 190, -90, 0]},
    ///     {"time_s": 1, "joints_deg": [5, 60, -80, 190, -90, 0]}
    /// ]}"#;
    /// let points = TimedPoint::from_json(text, "way.json")?;
    /// assert_eq!((points.len(), points[1].joints.0[0]), (2, 5.0));
    /// assert_eq!(TimedPoint::from_json(&TimedPoint::to_json(&points), "way.json")?, points);
    ///
    /// let errors = TimedPoint::from_json(&text.replace("[5,", "[\"5\","), "way.json").unwrap_err();
    /// assert_eq!(errors.to_string(), "way.json:3:34: joints_deg: found `\"5\"`, expected a finite number");
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// Everything that is wrong, at its line and column; where the text is not JSON, that alone.
    pub fn from_json(text: &str, file_name: &str) -> Result<Vec<Self>, TrajectoryFileError> {
        file::read_json(text, file_name)
    }

    /// The points as CSV, in degrees, which [`from_csv`](Self::from_csv) reads as the same points.
    ///
    /// The columns are those that all points have.
    pub fn to_csv(points: &[Self]) -> String {
        file::write_csv(points)
    }

    /// The points as JSON, in degrees, which [`from_json`](Self::from_json) reads as the same points.
    ///
    /// The keys are those that all points have.
    pub fn to_json(points: &[Self]) -> String {
        file::write_json(points)
    }
}

/// The pieces and way-points of a trajectory through points with times.
pub(super) fn parts(points: &[TimedPoint]) -> Result<(Vec<Piece>, Vec<WayPoint>), TrajectoryError> {
    check_points(points)?;
    let samples: Vec<Sample> = match points[0].velocity {
        Some(_) => points.iter().map(sample).collect(),
        None => with_spline_velocities(points),
    };
    check_rest(&samples)?;
    let make = if points[0].acceleration.is_some() { Piece::between } else { Piece::cubic };
    let ends = points.windows(2).zip(samples.windows(2));
    let pieces = ends
        .map(|(points, samples)| make(points[0].time_s, points[1].time_s - points[0].time_s, &samples[0], &samples[1]));
    let last = points.len() - 1;
    let way_points = points.iter().enumerate().map(|(index, point)| {
        let passing = if index == 0 || index == last { Passing::Stops } else { Passing::Through };
        WayPoint { time_s: point.time_s, passing }
    });
    Ok((pieces.collect(), way_points.collect()))
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
/// At each inner point the acceleration before is to be that after, which gives an equation for its velocity and those
/// of its neighbours. All together are solved by elimination forwards and insertion backwards.
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
