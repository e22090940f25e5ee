//! Requested speeds.

#[cfg(feature = "generator")]
use nalgebra::Vector3;

use crate::beyond::Exceeded;

/// Requested speed of a straight motion in joint space: speed of the joint with the longest path, the others less in
/// proportion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointSpeed {
    /// Speed, in deg/s.
    pub speed_deg_s: f64,
    /// Acceleration, in deg/s². The checker refuses a motion without one, since the controller's own is not known.
    pub acceleration_deg_s2: Option<f64>,
}

/// Requested speed of a line or an arc, and the greatest distance by which blending may move the arm away from its
/// path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TcpSpeed {
    /// Speed of the tool centre point, in mm/s.
    pub speed_mm_s: f64,
    /// Greatest distance of the arm from its path, in mm. It reduces the permitted distance of regions, at the start
    /// too. The checker refuses a tolerance longer than the arm with its tool.
    pub tolerance_mm: f64,
}

/// Velocity of the tool centre point, and angular velocity of the tool.
#[cfg(feature = "generator")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct TcpVelocity {
    /// Velocity along x, y and z, in mm/s.
    pub linear_mm_s: [f64; 3],
    /// Angular velocity about x, y and z, in deg/s.
    pub angular_deg_s: [f64; 3],
    /// Frame of x, y and z.
    pub frame: VelocityFrame,
}

/// Frame of the axes of a velocity.
#[cfg(feature = "generator")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum VelocityFrame {
    /// Base of the arm, as in [`Model::forward`](crate::Model::forward).
    ArmBase,
    /// User frame, the frame of poses.
    User,
    /// Tool, whose axes move with it.
    Tool,
}

impl JointSpeed {
    pub(crate) fn check(&self) -> Result<(), Exceeded> {
        above_zero("speed", self.speed_deg_s)?;
        self.acceleration_deg_s2.map_or(Ok(()), |given| above_zero("acceleration", given))
    }
}

impl TcpSpeed {
    /// Checks the numbers; `reach_mm` is the reach of the arm with its tool.
    pub(crate) fn check(&self, reach_mm: f64) -> Result<(), Exceeded> {
        above_zero("speed", self.speed_mm_s)?;
        let tolerance = self.tolerance_mm;
        if tolerance.is_finite() && (0.0..=reach_mm).contains(&tolerance) {
            Ok(())
        } else {
            Err(Exceeded::Asked { what: "tolerance", given: tolerance })
        }
    }
}

#[cfg(feature = "generator")]
impl TcpVelocity {
    /// Creates a velocity of zero, in the axes of a frame.
    pub fn new(frame: VelocityFrame) -> Self {
        Self { linear_mm_s: [0.0; 3], angular_deg_s: [0.0; 3], frame }
    }

    /// Sets the velocity of the tool centre point along x, y and z, in mm/s.
    #[must_use]
    pub fn with_linear(self, mm_s: [f64; 3]) -> Self {
        Self { linear_mm_s: mm_s, ..self }
    }

    /// Sets the turn of the tool about x, y and z, in deg/s.
    #[must_use]
    pub fn with_angular(self, deg_s: [f64; 3]) -> Self {
        Self { angular_deg_s: deg_s, ..self }
    }

    pub(crate) fn linear(&self) -> Vector3<f64> {
        self.linear_mm_s.into()
    }

    pub(crate) fn numbers(&self) -> impl Iterator<Item = f64> {
        self.linear_mm_s.into_iter().chain(self.angular_deg_s)
    }
}

pub(crate) fn above_zero(what: &'static str, given: f64) -> Result<(), Exceeded> {
    if given.is_finite() && given > 0.0 { Ok(()) } else { Err(Exceeded::Asked { what, given }) }
}

/// Returns the longest path of a joint, in degrees.
pub(crate) fn longest(moved: &[f64; 6]) -> f64 {
    moved.iter().fold(0.0, |longest, moved| longest.max(moved.abs()))
}
