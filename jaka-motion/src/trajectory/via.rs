//! Point of a trajectory.

use jaka_proto::messages::types::{JointPosition, Pose};

use super::TrajectoryError;
use super::leg::{LegSpeeds, Tolerances};

/// A point of a trajectory, the way to it, and what differs on that way and at that point from the rest of the
/// trajectory.
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
    /// None where those of the trajectory count.
    pub(super) corner_mm: Option<f64>,
    pub(super) corner_turn_deg: Option<f64>,
    pub(super) corner_deg: Option<f64>,
}

/// Place of a [`Via`], and kind of the way to it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum ViaTarget {
    /// Straight in joint space to these joint positions.
    Joints(JointPosition),
    /// On a line to this pose of the tool.
    Line(Pose),
    /// On an arc to a pose of the tool.
    Arc {
        /// Pose on the way.
        middle: Pose,
        /// Pose at its end.
        end: Pose,
    },
}

impl Via {
    /// Straight in joint space to joint positions.
    pub fn joints(joints: impl Into<JointPosition>) -> Self {
        Self::to(ViaTarget::Joints(joints.into()))
    }

    /// On a straight line of the tool centre point to a pose of the tool in the user frame. The tool turns evenly, and
    /// the joints stay on their branch.
    pub fn line(pose: impl Into<Pose>) -> Self {
        Self::to(ViaTarget::Line(pose.into()))
    }

    /// On an arc of the tool centre point through a middle pose to another one, in the user frame, as
    /// [`Arc`](crate::Arc) has it: the tool turns evenly to the middle pose, and from there to the end. The joints stay
    /// on their branch. The way-point is the end.
    pub fn arc(middle: impl Into<Pose>, end: impl Into<Pose>) -> Self {
        Self::to(ViaTarget::Arc { middle: middle.into(), end: end.into() })
    }

    /// With this highest speed of the tool centre point on the way to it, in mm/s, where that of the trajectory is not
    /// lower.
    #[must_use]
    pub fn with_tcp_speed(mut self, mm_s: f64) -> Self {
        self.speeds.tcp_speed = mm_s;
        self
    }

    /// With these highest speeds of joints 1 to 6 on the way to it, in deg/s, where those of the trajectory are not
    /// lower.
    #[must_use]
    pub fn with_joint_speeds(mut self, deg_s: [f64; 6]) -> Self {
        self.speeds.joint_speeds = deg_s;
        self
    }

    /// With its own [`corner_mm`](crate::Through::corner_mm), as where the way goes on from it.
    #[must_use]
    pub fn with_corner_mm(mut self, tolerance: f64) -> Self {
        self.corner_mm = Some(tolerance);
        self
    }

    /// With its own [`corner_turn_deg`](crate::Through::corner_turn_deg).
    #[must_use]
    pub fn with_corner_turn_deg(mut self, tolerance: f64) -> Self {
        self.corner_turn_deg = Some(tolerance);
        self
    }

    /// With its own [`corner_deg`](crate::Through::corner_deg).
    #[must_use]
    pub fn with_corner_deg(mut self, tolerance: f64) -> Self {
        self.corner_deg = Some(tolerance);
        self
    }

    /// Its place, and the kind of the way to it.
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

    /// True where nothing differs from the rest of the trajectory.
    pub(super) fn is_plain(&self) -> bool {
        *self == Self::to(self.target)
    }

    /// Tolerances of its corner.
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

/// Joint positions in degrees.
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
