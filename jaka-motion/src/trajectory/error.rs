//! Why there is no trajectory.

use std::fmt;

use crate::beyond::Beyond;

/// Why a [`Trajectory`](crate::Trajectory) cannot be made. Way-points are counted from 1.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum TrajectoryError {
    /// There are fewer than two way-points.
    TooFew {
        /// How many there are.
        given: usize,
    },
    /// A number is not finite.
    NotFinite {
        /// The way-point.
        way_point: usize,
        /// Of what.
        what: &'static str,
    },
    /// The first way-point is not at 0 s.
    FirstTime {
        /// Its time in seconds.
        time_s: f64,
    },
    /// A way-point does not come after the one before it.
    Time {
        /// The way-point.
        way_point: usize,
        /// Its time in seconds.
        time_s: f64,
        /// That of the one before, in seconds.
        before_s: f64,
    },
    /// Some way-points have velocities or accelerations and others do not, or they have accelerations alone.
    Uneven {
        /// The first way-point that differs from the first of all.
        way_point: usize,
        /// What it lacks, or has alone: `velocity` or `acceleration`.
        what: &'static str,
    },
    /// The first or the last way-point is passed, although the arm rests before and after a trajectory.
    NotAtRest {
        /// The way-point.
        way_point: usize,
        /// The joint, 1 to 6.
        joint: usize,
        /// Its speed there, in deg/s.
        speed_deg_s: f64,
    },
    /// The first way-point is a pose, for which several joint positions can be.
    StartsWithPose,
    /// All way-points are at one place.
    NoWay,
    /// A setting is not what it should be.
    Setting {
        /// Which, for example `corner_mm`.
        what: &'static str,
        /// The number that was given.
        given: f64,
        /// What it should be, for example `finite and at least 0`.
        expected: &'static str,
    },
    /// The arm may not be at a way-point.
    Place {
        /// The way-point.
        way_point: usize,
        /// What is exceeded there.
        beyond: Box<Beyond>,
    },
    /// The trajectory is not within the arm's limits.
    Beyond {
        /// The last way-point before the place, or the one at it.
        after: usize,
        /// When, in seconds from the start, if the trajectory has got its times already.
        time_s: Option<f64>,
        /// What is exceeded.
        beyond: Box<Beyond>,
    },
}

impl fmt::Display for TrajectoryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { given } => write!(f, "a trajectory takes at least 2 way-points; given {given}"),
            Self::NotFinite { way_point, what } => write!(f, "way-point {way_point}: its {what} is not finite"),
            Self::FirstTime { time_s } => write!(f, "way-point 1 is at {time_s} s; the first must be at 0 s"),
            Self::Time { way_point, time_s, before_s } => {
                write!(
                    f,
                    "way-point {way_point} is at {time_s} s, and the one before it at {before_s} s; times must increase"
                )
            }
            Self::Uneven { way_point, what: "velocity" } => {
                write!(f, "way-point {way_point}: either all way-points have a velocity or none")
            }
            Self::Uneven { way_point, what } => {
                write!(f, "way-point {way_point}: either all way-points have {what} and velocity or none has {what}")
            }
            Self::NotAtRest { way_point, joint, speed_deg_s } => {
                let place = if *way_point == 1 { "starts" } else { "ends" };
                write!(
                    f,
                    "way-point {way_point}: joint {joint} turns at {speed_deg_s} deg/s; a trajectory {place} at rest"
                )
            }
            Self::StartsWithPose => f.write_str(
                "way-point 1 is a pose, which several joint positions reach; the first must be joint positions",
            ),
            Self::NoWay => f.write_str("all way-points are at one place"),
            Self::Setting { what, given, expected } => write!(f, "{what}: {given} is not {expected}"),
            Self::Place { way_point, beyond } => write!(f, "way-point {way_point}: {beyond}"),
            Self::Beyond { after, time_s: Some(time_s), beyond } => {
                write!(f, "after way-point {after}, at {time_s:.3} s: {beyond}")
            }
            Self::Beyond { after, time_s: None, beyond } => {
                write!(f, "between way-points {after} and {}: {beyond}", after + 1)
            }
        }
    }
}

impl std::error::Error for TrajectoryError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Beyond { beyond, .. } | Self::Place { beyond, .. } => Some(beyond.as_ref()),
            _ => None,
        }
    }
}
