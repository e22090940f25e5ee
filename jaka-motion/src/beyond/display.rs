//! The words for what a motion would exceed.

use std::fmt;

use super::{Beyond, Exceeded, Way};

impl fmt::Display for Beyond {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (at, on_the_way) = (At(self, self.way.noun()), At(self, "its way"));
        match &self.exceeded {
            Exceeded::JointRange { joint, position_deg, limit_deg } => {
                let position = Apart(*position_deg, *limit_deg);
                write!(f, "joint {joint} would be at {position} deg{at}; limit {limit_deg}")?;
            }
            Exceeded::JointSpeed { joint, speed_deg_s, limit_deg_s, near } => {
                write!(f, "joint {joint} would turn at {} deg/s{at}", Apart(*speed_deg_s, *limit_deg_s))?;
                if let Some(near) = near {
                    write!(f, ", near the {near} singularity")?;
                }
                write!(f, "; limit {limit_deg_s}")?;
            }
            Exceeded::JointAcceleration { joint, acceleration_deg_s2, limit_deg_s2 } => {
                let acceleration = Apart(*acceleration_deg_s2, *limit_deg_s2);
                write!(f, "joint {joint} would accelerate by {acceleration} deg/s²{at}; limit {limit_deg_s2}")?;
            }
            Exceeded::NoAcceleration { most_deg_s2 } => write!(
                f,
                "no acceleration given; the controller's own is not known; give at most {} deg/s²",
                Below(*most_deg_s2)
            )?,
            Exceeded::TcpSpeed { speed_mm_s, limit_mm_s } => {
                let speed = Apart(*speed_mm_s, *limit_mm_s);
                write!(f, "the tool centre point would move at {speed} mm/s{at}; limit {limit_mm_s}")?;
            }
            Exceeded::Region { name, point, by_mm, tolerance_mm } => {
                write!(
                    f,
                    "the {point} would be {} mm beyond `{}`{on_the_way}",
                    Apart(*by_mm, 0.0),
                    name.escape_debug()
                )?;
                if *tolerance_mm > 0.0 {
                    write!(f, ", {tolerance_mm} mm of blending counted")?;
                }
            }
            Exceeded::LandingRange { joint, end_deg, limit_deg } => {
                let end = Apart(*end_deg, *limit_deg);
                write!(f, "the arm could not stop before joint {joint} is at {end} deg; limit {limit_deg}")?;
            }
            Exceeded::LandingRegion { name, point, by_mm } => {
                let (by, name) = (Apart(*by_mm, 0.0), name.escape_debug());
                write!(f, "the arm could not stop before the {point} is {by} mm beyond `{name}`")?;
            }
            Exceeded::LandingWay { way_mm, limit_mm } => {
                let way = Apart(*way_mm, *limit_mm);
                write!(
                    f,
                    "the arm could not stop before the tool centre point has gone on for {way} mm; limit {limit_mm}"
                )?;
            }
            Exceeded::OutOfReach { by_mm } => write!(f, "out of reach by {} mm{at}", Apart(*by_mm, 0.0))?,
            Exceeded::Singularity { which, .. } => {
                write!(f, "the {} passes the {which} singularity{on_the_way}", self.way.noun())?;
            }
            Exceeded::NotConfirmed => write!(f, "at the edge of reach{at}: no joint position was confirmed")?,
            Exceeded::NoArc => f.write_str("the positions of the three poses lie on a line: there is no arc")?,
            Exceeded::HalfTurn => f.write_str("the tool would turn half way round, and which way is not known")?,
            Exceeded::Pace { what, given } => write!(f, "{what}: {given} is not a {what}")?,
            Exceeded::NotFinite => f.write_str("a number of the joint positions, poses or frames is not finite")?,
            Exceeded::TooLong => f.write_str("the way is too long to be checked")?,
        }
        if self.way == Way::EndMove {
            f.write_str(", if the controller chooses so among the joint positions for the pose")?;
        }
        write!(f, " ({})", self.model)
    }
}

impl Way {
    fn noun(self) -> &'static str {
        match self {
            Self::Place => "place",
            Self::JointWay | Self::EndMove => "way",
            Self::Line => "line",
            Self::Arc => "arc",
            Self::SetPoint => "set-point",
            Self::Trajectory => "trajectory",
        }
    }
}

/// Where on the way, which goes without saying at its end.
struct At<'a>(&'a Beyond, &'static str);

impl fmt::Display for At<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(Beyond { way, share, .. }, noun) = self;
        if matches!(way, Way::Place | Way::SetPoint | Way::Trajectory) || *share >= 1.0 {
            return Ok(());
        }
        let of = if *noun == "its way" { "" } else { "the " };
        write!(f, " at {:.0} % of {of}{noun}", share * 100.0)
    }
}

/// A number with one decimal, or as many as tell it from another.
struct Apart(f64, f64);

impl fmt::Display for Apart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(number, other) = *self;
        let rounded = |number: f64, scale: f64| (number * scale).round() / scale;
        for scale in [10.0, 100.0, 1e3, 1e4, 1e5, 1e6] {
            let shown = rounded(number, scale);
            if (shown - other).abs() >= 0.5 / scale {
                return write!(f, "{shown}");
            }
        }
        write!(f, "{number}")
    }
}

/// A number rounded down to one decimal, or to three digits if it is small.
struct Below(f64);

impl fmt::Display for Below {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scale = if self.0 >= 1.0 { 10.0 } else { 1e3 };
        write!(f, "{}", (self.0 * scale).floor() / scale)
    }
}
