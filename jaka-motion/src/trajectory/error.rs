//! Errors for trajectories that cannot be made.

use crate::beyond::{Beyond, Exceeded, Way};
use crate::checker::Checker;

/// Longest duration of a trajectory, in seconds: a week, which is ours. Times stay exact to a nanosecond.
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
            /// The way-point.
            way_point: usize,
            /// Name of the quantity, for example `position`.
            what: &'static str,
        } => "way-point {way_point}: its {what} is not finite",
        /// The first way-point is not at 0 s.
        FirstTime {
            /// Its time in seconds.
            time_s: f64,
        } => "way-point 1 is at {time_s} s; the first must be at 0 s",
        /// A way-point does not come after the one before it.
        Time {
            /// The way-point.
            way_point: usize,
            /// Its time in seconds.
            time_s: f64,
            /// Time of the way-point before it, in seconds.
            before_s: f64,
        } => "way-point {way_point} is at {time_s} s, and the one before it at {before_s} s; times must increase",
        /// Some way-points have velocities or accelerations and others do not, or they have accelerations alone.
        Uneven {
            /// The first way-point that differs from the first of all.
            way_point: usize,
            /// Quantity that it lacks, or has alone: `velocity` or `acceleration`.
            what: &'static str,
        } => (format!("way-point {way_point}: either all way-points have {}", all_or_none(what))),
        /// The first or the last way-point is passed, although the arm rests before and after a trajectory.
        NotAtRest {
            /// The way-point.
            way_point: usize,
            /// The joint, 1 to 6.
            joint: usize,
            /// Its speed there, in deg/s.
            speed_deg_s: f64,
        } => (format!(
            "way-point {way_point}: joint {joint} turns at {speed_deg_s} deg/s; a trajectory {} at rest",
            if *way_point == 1 { "starts" } else { "ends" }
        )),
        /// A joint accelerates at the first or the last way-point.
        Accelerates {
            /// The way-point.
            way_point: usize,
            /// The joint, 1 to 6.
            joint: usize,
            /// Its acceleration there, in deg/s².
            acceleration_deg_s2: f64,
        } => (format!(
            "way-point {way_point}: joint {joint} accelerates by {acceleration_deg_s2} deg/s²; a trajectory {} without \
             acceleration",
            if *way_point == 1 { "starts" } else { "ends" }
        )),
        /// A joint has a higher jerk than the limits allow.
        Jerk {
            /// The last way-point before the place, or the one at it.
            after: usize,
            /// The joint, 1 to 6.
            joint: usize,
            /// Its largest jerk until the next way-point, in deg/s³.
            jerk_deg_s3: f64,
            /// Highest jerk that the limits allow, in deg/s³.
            limit_deg_s3: f64,
            /// Factor of all times with which the jerk is nowhere higher, and speeds are less by it.
            slower: f64,
        } => "after way-point {after}: joint {joint} would have a jerk of {jerk_deg_s3:.0} deg/s³; limit {limit_deg_s3} deg/s³; \
              nowhere, if all times are {slower:.3} times as long",
        /// The first way-point is a pose, which several joint positions reach, and [`near`](crate::Through::near) names
        /// none.
        StartsWithPose =>
            "way-point 1 is a pose, which several joint positions reach; name joint positions near it, or start with some",
        /// A curve goes through joint positions and poses.
        Mixed {
            /// First way-point of the other kind.
            way_point: usize,
        } => "way-point {way_point}: after the first, the points of a curve are all joint positions or all poses",
        /// A point of a curve has a speed or a tolerance of its own.
        OnCurve {
            /// The way-point.
            way_point: usize,
        } => "way-point {way_point}: a point of a curve has no speed or tolerance of its own",
        /// All way-points are at one place.
        NoWay => "all way-points are at one place",
        /// The trajectory takes longer than a week.
        TooLong {
            /// Its duration in seconds.
            duration_s: f64,
        } => "the trajectory takes {duration_s:.3e} s; at most {LONGEST_S} s, a week, are allowed",
        /// A setting is not what it should be.
        Setting {
            /// Name of the setting, for example `corner_mm`.
            what: &'static str,
            /// The number that was given.
            given: f64,
            /// Description of the allowed numbers, for example `finite and at least 0`.
            expected: &'static str,
        } => "{what}: {given} is not {expected}",
        /// The arm may not be at a way-point.
        Place {
            /// The way-point.
            way_point: usize,
            /// Limit that is exceeded there.
            beyond: Box<Beyond>,
        } => "way-point {way_point}: {beyond}",
        /// The trajectory is not within the arm's limits.
        Beyond {
            /// The last way-point before the place, or the one at it.
            after: usize,
            /// Time of the place, in seconds from the start, if the trajectory has got its times already.
            time_s: Option<f64>,
            /// Limit that is exceeded.
            beyond: Box<Beyond>,
        } => (format!("{}: {beyond}", place(*after, *time_s))),
    }
}

impl TrajectoryError {
    /// Limit that is exceeded somewhere after a way-point, before there are times.
    pub(super) fn between(after: usize, checker: &Checker, exceeded: Exceeded) -> Self {
        let beyond = checker.beyond_of(Way::Trajectory, exceeded);
        Self::Beyond { after, time_s: None, beyond: Box::new(beyond) }
    }

    /// Joints that are not found all along the path after a way-point.
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
