//! Tool, user frame and mounting.

use jaka_proto::messages::types::Pose;

use crate::transform::Transform;

/// Between the flange in the arm's base and a pose as commands have it: of the tool, seen from the user frame.
///
/// ```
/// use jaka_motion::Frames;
/// use jaka_proto::messages::types::Pose;
///
/// let flange = Pose::from_millimetres_degrees([500.0, 0.0, 300.0], [180.0, 0.0, 0.0]);
/// let gripper = Pose::from_millimetres_degrees([0.0, 0.0, 120.0], [0.0; 3]);
/// let table = Pose::from_millimetres_degrees([400.0, 0.0, 0.0], [0.0; 3]);
/// let frames = Frames::new().with_tool(gripper).with_user_frame(table);
/// let pose = frames.pose(flange);
/// assert_eq!(pose.position_mm().map(f64::round), [100.0, 0.0, 180.0]);
/// assert!(frames.flange(pose).distance_mm(&flange.into()) < 1e-9);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frames {
    mounting: Transform,
    user: Transform,
    tool: Transform,
}

impl Frames {
    /// The flange itself, seen from the arm's base.
    pub fn new() -> Self {
        Self { mounting: Transform::identity(), user: Transform::identity(), tool: Transform::identity() }
    }

    /// With this tool, seen from the flange.
    #[must_use]
    pub fn with_tool(self, tool: impl Into<Transform>) -> Self {
        Self { tool: tool.into(), ..self }
    }

    /// Seen from this user frame, in the frame in which the arm is mounted.
    #[must_use]
    pub fn with_user_frame(self, user: impl Into<Transform>) -> Self {
        Self { user: user.into(), ..self }
    }

    /// With the arm's base here, for example upside down on a ceiling, in a frame of the room.
    ///
    /// No known query says how a controller takes its mounting into account; [`Model::fit`](crate::Model::fit) finds
    /// it.
    #[must_use]
    pub fn with_mounting(self, mounting: impl Into<Transform>) -> Self {
        Self { mounting: mounting.into(), ..self }
    }

    /// The arm's base, seen from where poses are given.
    pub fn base(&self) -> Transform {
        self.user.inverse() * self.mounting
    }

    /// The tool, seen from the flange.
    pub fn tool(&self) -> Transform {
        self.tool
    }

    /// The pose of the tool for a flange in the arm's base.
    pub fn pose(&self, flange: impl Into<Transform>) -> Pose {
        (self.base() * flange.into() * self.tool).into()
    }

    /// The flange in the arm's base for a pose of the tool.
    pub fn flange(&self, pose: impl Into<Transform>) -> Transform {
        self.base().inverse() * pose.into() * self.tool.inverse()
    }
}

/// As [`Frames::new`].
impl Default for Frames {
    fn default() -> Self {
        Self::new()
    }
}
