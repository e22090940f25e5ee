//! Point of a trajectory.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::TrajectoryError;
use super::leg::{LegSpeeds, Tolerances};

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
