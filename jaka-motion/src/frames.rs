//! Tool, user frame and mounting.

use jaka_proto::messages::types::Pose;

use crate::transform::Transform;

/// Conversion between the flange in the arm's base and a pose as in commands: of the tool, seen from the user frame.
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
    /// Creates frames without tool, user frame and mounting: a pose is the flange, seen from the arm's base.
    pub fn new() -> Self {
        Self { mounting: Transform::identity(), user: Transform::identity(), tool: Transform::identity() }
    }

    /// Sets the tool, seen from the flange.
    #[must_use]
    pub fn with_tool(self, tool: impl Into<Transform>) -> Self {
        Self { tool: tool.into(), ..self }
    }

    /// Sets the user frame, seen from the frame in which the arm is mounted.
    #[must_use]
    pub fn with_user_frame(self, user: impl Into<Transform>) -> Self {
        Self { user: user.into(), ..self }
    }

    /// Sets the place of the arm's base in a frame of the room, for example upside down on a ceiling.
    ///
    /// No known query tells the controller's treatment of its mounting; [`Model::fit`](crate::Model::fit) finds it.
    #[must_use]
    pub fn with_mounting(self, mounting: impl Into<Transform>) -> Self {
        Self { mounting: mounting.into(), ..self }
    }

    /// Returns the arm's base, seen from the frame of poses.
    pub fn base(&self) -> Transform {
        self.user.inverse() * self.mounting
    }

    /// Returns the tool, seen from the flange.
    pub fn tool(&self) -> Transform {
        self.tool
    }

    /// Returns the pose of the tool for a flange in the arm's base.
    pub fn pose(&self, flange: impl Into<Transform>) -> Pose {
        (self.base() * flange.into() * self.tool).into()
    }

    /// Returns the flange in the arm's base for a pose of the tool.
    pub fn flange(&self, pose: impl Into<Transform>) -> Transform {
        self.base().inverse() * pose.into() * self.tool.inverse()
    }
}

/// Creates frames as [`Frames::new`] does.
impl Default for Frames {
    fn default() -> Self {
        Self::new()
    }
}
