//! Trajectory of a file: points with times, or points for a planned path.

use std::path::Path;

use clap::Args;
use jaka_motion::{Checker, TimedPoint, Trajectory, TrajectoryError, Via, ViaTarget};
use jaka_robot::types::JointPosition;

use crate::failure::Failure;
use crate::target::packs;
use crate::text::number::{corner, rate, six};

/// Options for planning a trajectory along points without times.
#[derive(Debug, Args)]
#[command(next_help_heading = "Points without times")]
pub(super) struct PlanArgs {
    /// Follow a smooth curve within this many mm of poses
    #[arg(long, value_name = "MM", value_parser = rate, conflicts_with_all = ["corner_mm", "corner_deg"])]
    within_mm: Option<f64>,
    /// Follow a smooth curve within this many degrees of each joint, or of the tool's rotation
    #[arg(long, value_name = "DEG", value_parser = rate, conflicts_with_all = ["corner_mm", "corner_deg"])]
    within_deg: Option<f64>,
    /// Follow lines through poses, with corners rounded within this many mm; 0 to stop at each
    #[arg(long, value_name = "MM", value_parser = corner)]
    corner_mm: Option<f64>,
    /// Follow straight paths through joint positions, with corners rounded within this many degrees; 0 to stop at each
    #[arg(long, value_name = "DEG", value_parser = corner)]
    corner_deg: Option<f64>,
    /// Move the tool centre point with at most this speed, in mm/s
    #[arg(long, value_name = "SPEED", value_parser = rate)]
    tool_speed: Option<f64>,
    /// Reach the first pose with the joints nearest to these, in degrees; without it, nearest to those of the arm
    #[arg(long, value_name = "J1,J2,J3,J4,J5,J6", value_parser = six, allow_hyphen_values = true)]
    near: Option<[f64; 6]>,
}

/// Points of a file, and the kind of trajectory to plan from them.
pub(super) enum Plan {
    Timed(String, Vec<TimedPoint>),
    Curve(String, jaka_motion::Curve, Points),
    Through(String, jaka_motion::Through, Points),
}

/// Properties of points without times.
pub(super) struct Points {
    count: usize,
    in_poses: bool,
}

impl PlanArgs {
    /// Returns the joint positions near which the first pose is reached, if given.
    pub(super) fn near(&self) -> Option<JointPosition> {
        self.near.map(Into::into)
    }

    /// Reads the plan of a file, by its name's extension and its columns.
    pub(super) fn read(&self, path: &Path) -> Result<Plan, Failure> {
        let (text, name) = (packs::read(path)?, path.display().to_string());
        let is = |end: &str| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(end));
        if !is("csv") && !is("json") {
            return Err(Failure::Usage(format!("{name}: a trajectory is a .csv or a .json file")));
        }
        let points_of = if is("csv") { Via::from_csv } else { Via::from_json };
        let (has_times, is_of_poses) = if is("csv") {
            (header(&text).contains("time"), header(&text).split(',').any(|name| name.trim() == "x_mm"))
        } else {
            (text.contains("\"time"), text.contains("\"position_mm\""))
        };
        if !has_times && (self.is_given() || is_of_poses) {
            let points = points_of(&text, &name).map_err(|errors| Failure::Usage(errors.to_string()))?;
            return self.of_points(points, name);
        }
        let points = if is("csv") { TimedPoint::from_csv(&text, &name) } else { TimedPoint::from_json(&text, &name) };
        let points = points.map_err(|errors| Failure::Usage(errors.to_string()))?;
        if self.is_given() {
            let why = "its points have times: --within-mm, --corner-mm and the like are for points without times";
            return Err(Failure::Usage(format!("{name}: {why}")));
        }
        Ok(Plan::Timed(name, points))
    }

    fn is_given(&self) -> bool {
        let numbers = [self.within_mm, self.within_deg, self.corner_mm, self.corner_deg, self.tool_speed];
        numbers.iter().any(Option::is_some) || self.near.is_some()
    }

    fn of_points(&self, points: Vec<Via>, name: String) -> Result<Plan, Failure> {
        let about = Points {
            count: points.len(),
            in_poses: points.iter().any(|via| matches!(via.target(), ViaTarget::Line(_))),
        };
        let speed = self.tool_speed.unwrap_or(f64::INFINITY);
        if self.within_mm.is_some() || self.within_deg.is_some() {
            let mut curve = Trajectory::curve(points).tcp_speed(speed);
            if let Some(tolerance) = self.within_mm {
                curve = curve.within_mm(tolerance);
            }
            if let Some(tolerance) = self.within_deg {
                curve = curve.within_deg(tolerance);
            }
            return Ok(Plan::Curve(name, curve, about));
        }
        if self.corner_mm.is_none() && self.corner_deg.is_none() {
            let why = "its points have no times: --within-mm or --within-deg plans a smooth curve near them, --corner-mm or --corner-deg a path through them";
            return Err(Failure::Usage(format!("{name}: {why}")));
        }
        let (mm, deg) = (self.corner_mm.unwrap_or_default(), self.corner_deg.unwrap_or_default());
        let mut through = Trajectory::through(points).corner_mm(mm).tcp_speed(speed);
        // For lines, the angle is the rotation of the tool.
        through = if about.in_poses && self.corner_deg.is_some() {
            through.corner_turn_deg(deg).corner_deg(deg)
        } else {
            through.corner_deg(deg)
        };
        Ok(Plan::Through(name, through, about))
    }
}

impl Plan {
    /// Plans the trajectory, within an arm's limits. Reaches poses with joints near to these.
    pub(super) fn made(&self, checker: &Checker, near: Option<JointPosition>) -> Result<Trajectory, Failure> {
        let (name, made) = match (self, near) {
            (Self::Timed(name, points), _) => (name, Trajectory::timed(points, checker)),
            (Self::Curve(name, curve, points), Some(near)) if points.in_poses => {
                (name, curve.clone().near(near).build(checker))
            }
            (Self::Through(name, through, points), Some(near)) if points.in_poses => {
                (name, through.clone().near(near).build(checker))
            }
            (Self::Curve(name, curve, _), _) => (name, curve.build(checker)),
            (Self::Through(name, through, _), _) => (name, through.build(checker)),
        };
        made.map_err(|error| {
            let hint = if error == TrajectoryError::StartsWithPose { " (--near)" } else { "" };
            Failure::Usage(format!("{name}: {error}{hint}"))
        })
    }

    /// Whether the path depends on the tool's frames.
    pub(super) fn is_in_poses(&self) -> bool {
        match self {
            Self::Timed(..) => false,
            Self::Curve(_, _, points) | Self::Through(_, _, points) => points.in_poses,
        }
    }

    /// Describes the plan in words.
    pub(super) fn told(&self) -> String {
        match self {
            Self::Timed(_, points) => format!("{} points", points.len()),
            Self::Curve(_, _, Points { count, .. }) => format!("a curve near {count} poses"),
            Self::Through(_, _, Points { count, .. }) => format!("lines through {count} poses"),
        }
    }
}

/// Returns the first line that is not empty or a comment.
fn header(text: &str) -> &str {
    let mut lines = text.trim_start_matches('\u{feff}').lines();
    lines.find(|line| !line.trim().is_empty() && !line.trim_start().starts_with('#')).unwrap_or_default()
}
