//! Errors for trajectories that cannot be made.

use crate::beyond::{Beyond, Exceeded, Way};
use crate::checker::Checker;

/// Longest duration of a trajectory, in seconds: a week, a choice of this library. Times stay exact to a nanosecond.
pub(super) const LONGEST_S: f64 = 604_800.0;

jaka_proto::worded! {
    /// Error for a [`Trajectory`](crate::Trajectory) that cannot be made. Way-points are counted from 1.
    #[derive(Debug, Clone, PartialEq)]
    #[non_exhaustive]
    pub enum TrajectoryError {
        /// There are fewer than two way-points.
        TooFew {
            /// Number of way-points that were given.
            given: usize,
        } => "a trajectory takes at least 2 way-points; given {given}",
        /// A number is not finite.
        NotFinite {
            /// Number of the way-point.
            way_point: usize,
            /// Name of the quantity, for example `position`.
            what: &'static str,
        } => "way-point {way_point}: its {what} is not finite",
        /// The first way-point is not at 0 s.
        FirstTime {
            /// Time of the way-point, in seconds.
            time_s: f64,
        } => "way-point 1 is at {time_s} s; the first must be at 0 s",
        /// The time of a way-point is not after that of the one before it.
        Time {
            /// Number of the way-point.
            way_point: usize,
            /// Time of the way-point, in seconds.
            time_s: f64,
            /// Time of the way-point before it, in seconds.
            before_s: f64,
        } => "way-point {way_point} is at {time_s} s, and the one before it at {before_s} s; times must increase",
        /// Some way-points have velocities or accelerations and others do not, or they have accelerations alone.
        Uneven {
            /// Number of the first way-point that differs from way-point 1.
            way_point: usize,
            /// Quantity that is missing, or is there alone: `velocity` or `acceleration`.
            what: &'static str,
        } => (format!("way-point {way_point}: either all way-points have {}", all_or_none(what))),
        /// A joint moves at the first or the last way-point, although the arm rests before and after a trajectory.
        NotAtRest {
            /// Number of the way-point.
            way_point: usize,
            /// Number of the joint, 1 to 6.
            joint: usize,
            /// Speed of the joint, in deg/s.
            speed_deg_s: f64,
        } => (format!(
            "way-point {way_point}: joint {joint} turns at {speed_deg_s} deg/s; a trajectory {} at rest",
            if *way_point == 1 { "starts" } else { "ends" }
        )),
        /// A joint accelerates at the first or the last way-point.
        Accelerates {
            /// Number of the way-point.
            way_point: usize,
            /// Number of the joint, 1 to 6.
            joint: usize,
            /// Acceleration of the joint, in deg/s².
            acceleration_deg_s2: f64,
        } => (format!(
            "way-point {way_point}: joint {joint} accelerates by {acceleration_deg_s2} deg/s²; a trajectory {} without \
             acceleration",
            if *way_point == 1 { "starts" } else { "ends" }
        )),
        /// A joint has a higher jerk than the limits allow.
        Jerk {
            /// Number of the last way-point before the place, or of the one at it.
            after: usize,
            /// Number of the joint, 1 to 6.
            joint: usize,
            /// Largest jerk of the joint before the next way-point, in deg/s³.
            jerk_deg_s3: f64,
            /// Highest jerk that the limits allow, in deg/s³.
            limit_deg_s3: f64,
            /// Factor for all times with which no jerk exceeds its limit; speeds fall by the same factor.
            slower: f64,
        } => "after way-point {after}: joint {joint} would have a jerk of {jerk_deg_s3:.0} deg/s³; limit {limit_deg_s3} deg/s³; \
              with all times {slower:.3} times as long, no jerk exceeds its limit",
        /// The first way-point is a pose, which several joint positions reach, and no [`near`](crate::Through::near) is
        /// set.
        StartsWithPose =>
            "way-point 1 is a pose, which several joint positions reach; give joint positions near it, or a first way-point in joints",
        /// A curve goes through joint positions and poses.
        Mixed {
            /// Number of the first way-point of the other kind.
            way_point: usize,
        } => "way-point {way_point}: after the first, the points of a curve are all joint positions or all poses",
        /// A point of a curve has a speed or a tolerance of its own.
        OnCurve {
            /// Number of the way-point.
            way_point: usize,
        } => "way-point {way_point}: a point of a curve has no speed or tolerance of its own",
        /// All way-points are at one place.
        NoWay => "all way-points are at the same place",
        /// The trajectory takes longer than a week.
        TooLong {
            /// Duration in seconds.
            duration_s: f64,
        } => "the trajectory takes {duration_s:.3e} s; at most {LONGEST_S} s, a week, are allowed",
        /// A setting is invalid.
        Setting {
            /// Name of the setting, for example `corner_mm`.
            what: &'static str,
            /// Number that was given.
            given: f64,
            /// Description of the allowed numbers, for example `from 0 to 0.9`.
            expected: &'static str,
        } => "{what}: {given} is not {expected}",
        /// A way-point is beyond a limit of the arm.
        Place {
            /// Number of the way-point.
            way_point: usize,
            /// Limit that is exceeded there.
            beyond: Box<Beyond>,
        } => "way-point {way_point}: {beyond}",
        /// The trajectory is not within the arm's limits.
        Beyond {
            /// Number of the last way-point before the place, or of the one at it.
            after: usize,
            /// Time of the place, in seconds from the start, if the trajectory already has times.
            time_s: Option<f64>,
            /// Limit that is exceeded.
            beyond: Box<Beyond>,
        } => (format!("{}: {beyond}", place(*after, *time_s))),
    }
}

impl TrajectoryError {
    /// Returns the error for a limit that is exceeded somewhere after a way-point, before there are times.
    pub(super) fn between(after: usize, checker: &Checker, exceeded: Exceeded) -> Self {
        let beyond = checker.beyond_of(Way::Trajectory, exceeded);
        Self::Beyond { after, time_s: None, beyond: Box::new(beyond) }
    }

    /// Returns the error for a path after a way-point along which no joints are found.
    pub(super) fn lost(after: usize, checker: &Checker) -> Self {
        Self::between(after, checker, Exceeded::NotConfirmed)
    }
}

impl std::error::Error for TrajectoryError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Place { beyond, .. } | Self::Beyond { beyond, .. } => Some(&**beyond),
            Self::TooFew { .. }
            | Self::NotFinite { .. }
            | Self::FirstTime { .. }
            | Self::Time { .. }
            | Self::Uneven { .. }
            | Self::NotAtRest { .. }
            | Self::Accelerates { .. }
            | Self::Jerk { .. }
            | Self::StartsWithPose
            | Self::NoWay
            | Self::Mixed { .. }
            | Self::OnCurve { .. }
            | Self::TooLong { .. }
            | Self::Setting { .. } => None,
        }
    }
}

fn all_or_none(what: &str) -> String {
    if what == "velocity" { "a velocity or none".to_owned() } else { format!("{what} and velocity or none has {what}") }
}

fn place(after: usize, time_s: Option<f64>) -> String {
    time_s.map_or_else(
        || format!("between way-points {after} and {}", after + 1),
        |time_s| format!("after way-point {after}, at {time_s:.3} s"),
    )
}
