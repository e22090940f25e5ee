//! Velocities of the tool.

use nalgebra::Vector3;

/// How the tool centre point moves and the tool turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TcpVelocity {
    /// Along x, y and z, in mm/s.
    pub linear_mm_s: [f64; 3],
    /// About x, y and z, in deg/s.
    pub angular_deg_s: [f64; 3],
    /// Whose x, y and z.
    pub frame: VelocityFrame,
}

/// Whose axes a velocity has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum VelocityFrame {
    /// The arm's own base, as [`Model::forward`](crate::Model::forward) has it.
    ArmBase,
    /// The frame in which poses are given: the user frame.
    User,
    /// The tool, which takes its axes along.
    Tool,
}

impl TcpVelocity {
    pub(crate) fn linear(&self) -> Vector3<f64> {
        self.linear_mm_s.into()
    }

    pub(crate) fn numbers(&self) -> impl Iterator<Item = f64> {
        self.linear_mm_s.into_iter().chain(self.angular_deg_s)
    }
}
