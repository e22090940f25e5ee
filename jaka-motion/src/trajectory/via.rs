//! Point of a trajectory.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::TrajectoryError;
#[cfg(feature = "trajectory-files")]
use super::file::{self, Format};
use super::leg::{LegSpeeds, Tolerances};
#[cfg(feature = "trajectory-files")]
use crate::TrajectoryFileError;

/// Point of a trajectory, the path to it, and settings of its own for that path and that point.
///
/// ```
/// use jaka_motion::Via;
/// use jaka_motion::proto::messages::types::Pose;
///
/// let above = Pose { x: 300.0, y: 0.0, z: 200.0, rx: 180.0, ry: 0.0, rz: 0.0 };
/// let points = [
///     Via::joints([0.0, 60.0, -80.0, 190.0, -90.0, 0.0]),
///     Via::line(above).with_corner_mm(20.0),
///     Via::line(Pose { z: 100.0, ..above }).with_tcp_speed(50.0),
/// ];
/// # let _ = points;
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Via {
    pub(super) target: ViaTarget,
    pub(super) speeds: LegSpeeds,
    /// Tolerance of its own; `None` for that of the trajectory.
    pub(super) corner_mm: Option<f64>,
    pub(super) corner_turn_deg: Option<f64>,
    pub(super) corner_deg: Option<f64>,
}

/// Place of a [`Via`], and kind of the path to it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum ViaTarget {
    /// Straight path in joint space to these joint positions.
    Joints(JointPosition),
    /// Line to this pose of the tool.
    Line(Pose),
    /// Arc to a pose of the tool.
    Arc {
        /// Pose on the arc.
        middle: Pose,
        /// Pose at its end.
        end: Pose,
    },
}

impl Via {
    /// Creates a point to which the path is straight in joint space.
    pub fn joints(joints: impl Into<JointPosition>) -> Self {
        Self::to(ViaTarget::Joints(joints.into()))
    }

    /// Creates a point to which the tool centre point moves on a straight line. The pose is of the tool in the user
    /// frame. The tool turns evenly, and the joints stay on their branch.
    pub fn line(pose: impl Into<Pose>) -> Self {
        Self::to(ViaTarget::Line(pose.into()))
    }

    /// Creates a point to which the tool centre point moves on an [`Arc`](crate::Arc) through a middle pose, both in
    /// the user frame. The tool turns evenly to the middle pose, and from there to the end. The joints stay on their
    /// branch. The way-point is the end.
    pub fn arc(middle: impl Into<Pose>, end: impl Into<Pose>) -> Self {
        Self::to(ViaTarget::Arc { middle: middle.into(), end: end.into() })
    }

    /// Sets the highest speed of the tool centre point on the path to it, in mm/s. A lower speed of the trajectory
    /// takes precedence.
    #[must_use]
    pub fn with_tcp_speed(mut self, mm_s: f64) -> Self {
        self.speeds.tcp_speed = mm_s;
        self
    }

    /// Sets the highest speeds of joints 1 to 6 on the path to it, in deg/s. Lower speeds of the trajectory take
    /// precedence.
    #[must_use]
    pub fn with_joint_speeds(mut self, deg_s: [f64; 6]) -> Self {
        self.speeds.joint_speeds = deg_s;
        self
    }

    /// Sets its own [`corner_mm`](crate::Through::corner_mm), for the corner at this point.
    #[must_use]
    pub fn with_corner_mm(mut self, tolerance: f64) -> Self {
        self.corner_mm = Some(tolerance);
        self
    }

    /// Sets its own [`corner_turn_deg`](crate::Through::corner_turn_deg).
    #[must_use]
    pub fn with_corner_turn_deg(mut self, tolerance: f64) -> Self {
        self.corner_turn_deg = Some(tolerance);
        self
    }

    /// Sets its own [`corner_deg`](crate::Through::corner_deg).
    #[must_use]
    pub fn with_corner_deg(mut self, tolerance: f64) -> Self {
        self.corner_deg = Some(tolerance);
        self
    }

    /// Returns its place, and the kind of the path to it.
    pub fn target(&self) -> ViaTarget {
        self.target
    }

    fn to(target: ViaTarget) -> Self {
        Self { target, speeds: LegSpeeds::ANY, corner_mm: None, corner_turn_deg: None, corner_deg: None }
    }

    pub(super) fn check(&self) -> Result<(), TrajectoryError> {
        self.speeds.check()?;
        self.corner(&Tolerances::NONE).check(["corner_mm", "corner_turn_deg", "corner_deg"])
    }

    /// Whether it has no settings of its own.
    pub(super) fn is_plain(&self) -> bool {
        *self == Self::to(self.target)
    }

    /// Returns the tolerances of its corner.
    pub(super) fn corner(&self, all: &Tolerances) -> Tolerances {
        Tolerances {
            mm: self.corner_mm.unwrap_or(all.mm),
            turn_deg: self.corner_turn_deg.unwrap_or(all.turn_deg),
            joint_deg: self.corner_deg.unwrap_or(all.joint_deg),
        }
    }
}

#[cfg(feature = "trajectory-files")]
impl Via {
    /// Reads the points of a CSV text. Errors show `file_name`.
    ///
    /// The first line that is not blank names the columns, each with its unit and in any order: `joint_1_deg` to
    /// `joint_6_deg` for joint positions, or `x_mm`, `y_mm`, `z_mm`, `rx_deg`, `ry_deg` and `rz_deg` for poses of the
    /// tool in the user frame; `rad` in place of `deg` for radians. Each line after it is a point. Fields are separated
    /// by commas and may be quoted; lines that are blank or start with `#` do not count.
    ///
    /// ```
    /// use jaka_motion::Via;
    ///
    /// let text = "x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\n400,0,300,180,0,0\n400,50,300,180,0,0\n";
    /// assert_eq!(Via::from_csv(text, "seam.csv")?.len(), 2);
    ///
    /// let errors = Via::from_csv(&text.replace("rx_deg", "rx_dge"), "seam.csv").unwrap_err();
    /// assert_eq!(errors.to_string(), "\
    ///     seam.csv:1:1: there is no column `rx_deg` or `rx_rad`\n\
    ///     seam.csv:1:1: unknown column `rx_dge`; is it `rx_deg`?");
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// All errors in the text, each at its line and with its column's name.
    pub fn from_csv(text: &str, file_name: &str) -> Result<Vec<Self>, TrajectoryFileError> {
        file::vias(Format::Csv, text, file_name)
    }

    /// Reads the points of a JSON text. Errors show `file_name`.
    ///
    /// The text is an object with a list `points` of objects, whose keys have the units: `joints_deg` or `joints_rad`,
    /// a list of six numbers; or, for a pose of the tool in the user frame, `position_mm` and `rotation_deg` or
    /// `rotation_rad`, lists of three. `tool_speed_mm_s`, `corner_mm`, `corner_turn_deg` and `corner_deg` apply only to
    /// the path to this point and to its corner.
    ///
    /// ```
    /// use jaka_motion::Via;
    ///
    /// let text = r#"{"points": [
    ///     {"joints_deg": [0, 60, -80, 190, -90, 0]},
    ///     {"position_mm": [400, 0, 300], "rotation_deg": [180, 0, 0], "corner_mm": 20},
    ///     {"position_mm": [400, 0, 200], "rotation_deg": [180, 0, 0], "tool_speed_mm_s": 50}
    /// ]}"#;
    /// assert_eq!(Via::from_json(text, "pick.json")?.len(), 3);
    ///
    /// let errors = Via::from_json(&text.replace("corner_mm", "corner_m"), "pick.json").unwrap_err();
    /// assert_eq!(errors.to_string(), "pick.json:3:77: unknown key `corner_m`; is it `corner_mm`?");
    /// # Ok::<(), jaka_motion::TrajectoryFileError>(())
    /// ```
    ///
    /// # Errors
    /// All errors in the text, each at its line and column; for a text that is not JSON, that error alone.
    pub fn from_json(text: &str, file_name: &str) -> Result<Vec<Self>, TrajectoryFileError> {
        file::vias(Format::Json, text, file_name)
    }
}

impl From<JointPosition> for Via {
    fn from(joints: JointPosition) -> Self {
        Self::joints(joints)
    }
}

/// Creates a point from joint positions in degrees.
impl From<[f64; 6]> for Via {
    fn from(joints: [f64; 6]) -> Self {
        Self::joints(joints)
    }
}

impl From<Pose> for Via {
    fn from(pose: Pose) -> Self {
        Self::line(pose)
    }
}
