//! Limits that a motion would exceed.

use std::fmt;
use std::sync::Arc;

use crate::model::{NoSolution, Point, Singularity};

/// Reason not to send a motion: the limit that it would exceed, and the place on its path.
///
/// ```
/// use jaka_motion::{Checker, Frames, JointSpeed, Limits, Model};
///
/// let arm = Model::named("MiniCobo").expect("a published arm");
/// let checker = Checker::new(Limits::of(arm), Frames::new());
/// let asked = JointSpeed { speed_deg_s: 20.0, acceleration_deg_s2: Some(30.0) };
/// let beyond = checker.check_joint_way([0.0; 6].into(), [0.0, 0.0, 135.5, 0.0, 0.0, 0.0].into(), asked).unwrap_err();
/// assert_eq!(beyond.to_string(), "joint 3 would be at 135.5 deg; limit 130 (MiniCobo)");
/// ```
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Beyond {
    /// Exceeded limit, or the reason that the check has no answer.
    pub exceeded: Exceeded,
    /// Kind of motion or place that was checked.
    pub way: Way,
    /// Share of the path before the place of the violation, from 0 to 1.
    pub share: f64,
    /// Name of the arm.
    pub model: &'static str,
}

/// Limit that a motion would exceed, or the reason that the check has no answer.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(tag = "kind", rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Exceeded {
    /// A joint would be beyond its range.
    JointRange {
        /// Number of the joint, 1 to 6.
        joint: usize,
        /// Position that the joint would reach, in degrees.
        position_deg: f64,
        /// End of the joint's range, in degrees.
        limit_deg: f64,
    },
    /// A joint would turn too fast.
    JointSpeed {
        /// Number of the joint, 1 to 6.
        joint: usize,
        /// Speed at which the joint would turn, in deg/s.
        speed_deg_s: f64,
        /// Highest speed that the joint may have, in deg/s.
        limit_deg_s: f64,
        /// Nearby singularity, if any.
        near: Option<Singularity>,
    },
    /// A joint would be accelerated or slowed down too much.
    JointAcceleration {
        /// Number of the joint, 1 to 6.
        joint: usize,
        /// Acceleration that the joint would have, in deg/s².
        acceleration_deg_s2: f64,
        /// Highest acceleration that the joint may have, in deg/s².
        limit_deg_s2: f64,
    },
    /// The request names no acceleration, and the controller's own acceleration is not known.
    NoAcceleration {
        /// Highest acceleration within the limits, in deg/s².
        most_deg_s2: f64,
    },
    /// The tool centre point would move too fast.
    TcpSpeed {
        /// Speed at which the tool centre point would move, in mm/s.
        speed_mm_s: f64,
        /// Highest speed that the tool centre point may have, in mm/s.
        limit_mm_s: f64,
    },
    /// A point of the arm would be beyond a region.
    Region {
        /// Name of the region.
        name: Arc<str>,
        /// Point of the arm.
        point: Point,
        /// Distance beyond the region, in mm, including the tolerance.
        by_mm: f64,
        /// Greatest distance, in mm, by which blending may move the arm away from its path.
        tolerance_mm: f64,
    },
    /// The arm could not stop after a set-point before a joint leaves its range.
    LandingRange {
        /// Number of the joint, 1 to 6.
        joint: usize,
        /// Position at which the joint would stop, in degrees.
        end_deg: f64,
        /// End of the joint's range, in degrees.
        limit_deg: f64,
    },
    /// The arm could not stop after a set-point before one of its points leaves a region.
    LandingRegion {
        /// Name of the region.
        name: Arc<str>,
        /// Point of the arm.
        point: Point,
        /// Distance beyond the region at the stop or on the path to it, in mm.
        by_mm: f64,
    },
    /// The tool centre point would travel too far after a set-point before the arm stops.
    LandingWay {
        /// Least distance that the tool centre point would still travel, in mm along its path.
        way_mm: f64,
        /// Longest distance that the tool centre point may still travel, in mm.
        limit_mm: f64,
    },
    /// The pose is out of the arm's reach.
    OutOfReach {
        /// Least change of the distance between shoulder and wrist that would bring the pose within reach, in mm.
        by_mm: f64,
    },
    /// The wrist reaches its position, but not with this orientation.
    Orientation,
    /// The arm would come too near to a singularity.
    Singularity {
        /// Singularity to which the arm would come too near.
        which: Singularity,
        /// Distance, as defined by [`SingularityDistance`](crate::SingularityDistance); 0 if a set-point is on the
        /// other side.
        distance: f64,
        /// Least permitted distance.
        least: f64,
    },
    /// The solver confirmed no joint positions for the pose. This happens at the edge of reach.
    NotConfirmed,
    /// The positions of the three poses of an arc lie on a line.
    NoArc,
    /// The tool would turn by half a turn, so the direction of its turn is undetermined.
    HalfTurn,
    /// A requested speed, acceleration or tolerance is not a valid number.
    Asked {
        /// Name of the quantity, for example `speed`.
        what: &'static str,
        /// Number in the request.
        given: f64,
    },
    /// A number of a joint position, a pose or a frame is not finite.
    NotFinite,
    /// The path needs more steps than the checker takes.
    TooLong,
}

/// Kind of motion or place that a check covers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Way {
    /// Place, at rest.
    Place,
    /// Straight path in joint space.
    JointWay,
    /// Straight line of the tool centre point.
    Line,
    /// Arc of the tool centre point.
    Arc,
    /// Paths in joint space that the controller may choose for a pose.
    EndMove,
    /// Single set-point of a servo session.
    SetPoint,
    /// Place on a trajectory.
    Trajectory,
}

/// Exceeded limit, and the share of the path at which it is exceeded.
pub(crate) type Found = (Exceeded, f64);

impl Exceeded {
    /// Returns the limit in its form for a stop after a set-point, if it has one.
    pub(crate) fn at_stop(self) -> Self {
        match self {
            Self::JointRange { joint, position_deg, limit_deg } => {
                Self::LandingRange { joint, end_deg: position_deg, limit_deg }
            }
            Self::Region { name, point, by_mm, .. } => Self::LandingRegion { name, point, by_mm },
            other => other,
        }
    }
}

impl From<NoSolution> for Exceeded {
    fn from(reason: NoSolution) -> Self {
        match reason {
            NoSolution::NotFinite => Self::NotFinite,
            NoSolution::OutOfReach { by_mm } => Self::OutOfReach { by_mm },
            NoSolution::Orientation => Self::Orientation,
            NoSolution::BeyondRange { joint, position_deg, limit_deg } => {
                Self::JointRange { joint, position_deg, limit_deg }
            }
            NoSolution::NotConfirmed => Self::NotConfirmed,
        }
    }
}

impl std::error::Error for Beyond {}

impl fmt::Display for Beyond {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (at, on_the_way) = (self.place(&format!("the {}", self.way.noun())), self.place("its path"));
        match &self.exceeded {
            Exceeded::JointRange { joint, position_deg, limit_deg } => {
                let position = apart(*position_deg, *limit_deg);
                write!(f, "joint {joint} would be at {position} deg{at}; limit {limit_deg}")?;
            }
            Exceeded::JointSpeed { joint, speed_deg_s, limit_deg_s, near } => {
                write!(f, "joint {joint} would turn at {} deg/s{at}", apart(*speed_deg_s, *limit_deg_s))?;
                if let Some(near) = near {
                    write!(f, ", near the {near} singularity")?;
                }
                write!(f, "; limit {limit_deg_s}")?;
            }
            Exceeded::JointAcceleration { joint, acceleration_deg_s2, limit_deg_s2 } => {
                let acceleration = apart(*acceleration_deg_s2, *limit_deg_s2);
                write!(f, "joint {joint} would accelerate by {acceleration} deg/s²{at}; limit {limit_deg_s2}")?;
            }
            Exceeded::NoAcceleration { most_deg_s2 } => write!(
                f,
                "no acceleration given; the controller's own is not known; give at most {} deg/s²",
                below(*most_deg_s2)
            )?,
            Exceeded::TcpSpeed { speed_mm_s, limit_mm_s } => {
                let speed = apart(*speed_mm_s, *limit_mm_s);
                write!(f, "the tool centre point would move at {speed} mm/s{at}; limit {limit_mm_s}")?;
            }
            Exceeded::Region { name, point, by_mm, tolerance_mm } => {
                write!(
                    f,
                    "the {point} would be {} mm beyond `{}`{on_the_way}",
                    apart(*by_mm, 0.0),
                    name.escape_debug()
                )?;
                if *tolerance_mm > 0.0 {
                    write!(f, ", including {tolerance_mm} mm of blending")?;
                }
            }
            Exceeded::LandingRange { joint, end_deg, limit_deg } => {
                let end = apart(*end_deg, *limit_deg);
                write!(f, "the arm could not stop before joint {joint} is at {end} deg; limit {limit_deg}")?;
            }
            Exceeded::LandingRegion { name, point, by_mm } => {
                let (by, name) = (apart(*by_mm, 0.0), name.escape_debug());
                write!(f, "the arm could not stop before the {point} is {by} mm beyond `{name}`")?;
            }
            Exceeded::LandingWay { way_mm, limit_mm } => {
                let way = apart(*way_mm, *limit_mm);
                write!(
                    f,
                    "the arm could not stop before the tool centre point has moved on by {way} mm; limit {limit_mm}"
                )?;
            }
            Exceeded::OutOfReach { by_mm } => write!(f, "out of reach by {} mm{at}", apart(*by_mm, 0.0))?,
            Exceeded::Orientation => write!(f, "the orientation is out of reach{at}")?,
            Exceeded::Singularity { which, .. } => {
                write!(f, "the {} passes the {which} singularity{on_the_way}", self.way.noun())?;
            }
            Exceeded::NotConfirmed => write!(f, "at the edge of reach{at}: no joint position was confirmed")?,
            Exceeded::NoArc => f.write_str("the positions of the three poses lie on a line: there is no arc")?,
            Exceeded::HalfTurn => f.write_str("the tool would turn by 180 deg, and the direction is not known")?,
            Exceeded::Asked { what, given } => write!(f, "{what}: {given} is not a {what}")?,
            Exceeded::NotFinite => f.write_str("a number of the joint positions, poses or frames is not finite")?,
            Exceeded::TooLong => f.write_str("the path is too long for a check")?,
        }
        if self.way == Way::EndMove {
            f.write_str(", for one of the joint positions that the controller may choose for the pose")?;
        }
        write!(f, " ({})", self.model)
    }
}

impl Way {
    fn noun(self) -> &'static str {
        match self {
            Self::Place => "place",
            Self::JointWay | Self::EndMove => "path",
            Self::Line => "line",
            Self::Arc => "arc",
            Self::SetPoint => "set-point",
            Self::Trajectory => "trajectory",
        }
    }
}

impl Beyond {
    /// Returns the place on the path as text; empty at the end of the path.
    fn place(&self, noun: &str) -> String {
        if matches!(self.way, Way::Place | Way::SetPoint | Way::Trajectory) || self.share >= 1.0 {
            return String::new();
        }
        format!(" at {:.0} % of {noun}", self.share * 100.0)
    }
}

/// Returns the number with one decimal, or with as many as distinguish it from another.
fn apart(number: f64, other: f64) -> f64 {
    let rounded = [10.0, 100.0, 1e3, 1e4, 1e5, 1e6].map(|scale| ((number * scale).round() / scale, scale));
    let shown = rounded.into_iter().find(|(shown, scale)| (shown - other).abs() >= 0.5 / scale);
    shown.map_or(number, |(shown, _)| shown)
}

/// Returns the number rounded down to one decimal, or to three significant digits if it is small.
fn below(number: f64) -> f64 {
    let scale = if number >= 1.0 { 10.0 } else { 1e3 };
    (number * scale).floor() / scale
}
