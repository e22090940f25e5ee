//! Contact of the tool centre point with a plane.

use std::io;

use jaka_motion::Transform;
use jaka_proto::messages::types::Pose;

/// Plane that resists the tool centre point like a spring: see [`Builder::contact`](crate::Builder::contact).
///
/// The force is the depth of the tool centre point below the plane times the stiffness, along the normal, without
/// friction and torques. The arm moves as without the plane. The torque sensor shows the force along the axes of the
/// tool frame in use if it works ([`TorqueSensor::working`](crate::TorqueSensor::working)). No document gives the axes
/// or the units of a real sensor.
///
/// ```
/// use jaka_sim::{Contact, Controller};
///
/// // A table 100 mm above the base, on which 1 mm takes 50 N.
/// let table = Contact::plane([0.0, 0.0, 100.0], [0.0, 0.0, 1.0], 50.0);
/// let controller = Controller::builder().contact(table).start()?;
/// assert_eq!(controller.deepest_penetration(), 0.0);
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    point: [f64; 3],
    normal: [f64; 3],
    stiffness: f64,
}

impl Contact {
    /// Creates a plane through a point (mm, in the frame of the base), with its outward direction, of any length, and
    /// its stiffness in N/mm.
    pub fn plane(point: [f64; 3], normal: [f64; 3], stiffness: f64) -> Self {
        let length = dot(normal, normal).sqrt();
        Self { point, normal: normal.map(|part| part / length), stiffness }
    }

    /// Returns an error for an invalid plane.
    pub(crate) fn check(&self) -> io::Result<()> {
        let is_finite = self.point.iter().chain(&self.normal).all(|part| part.is_finite());
        if is_finite && self.stiffness.is_finite() && self.stiffness >= 0.0 {
            return Ok(());
        }
        let text = "a plane has a finite point, a normal that is not zero, and a stiffness of at least 0";
        Err(io::Error::new(io::ErrorKind::InvalidInput, text))
    }

    /// Returns the depth of the tool centre point below the plane, in mm.
    pub(crate) fn depth(&self, tool: &Transform) -> f64 {
        let at = tool.position_mm();
        let above = dot([0, 1, 2].map(|i| at[i] - self.point[i]), self.normal);
        (-above).max(0.0)
    }

    /// Returns the reading of the sensor, along the axes of the tool, in N and Nm.
    pub(crate) fn force(&self, tool: &Transform) -> [f64; 6] {
        let force = self.stiffness * self.depth(tool);
        if force == 0.0 {
            return [0.0; 6];
        }
        let [x, y, z] = turned_into(tool, self.normal);
        [x * force, y * force, z * force, 0.0, 0.0, 0.0]
    }
}

/// Returns a direction relative to a frame.
fn turned_into(frame: &Transform, direction: [f64; 3]) -> [f64; 3] {
    let back = frame.inverse();
    let there = back * Transform::from(Pose::from_millimetres_degrees(direction, [0.0; 3]));
    let (there, origin) = (there.position_mm(), back.position_mm());
    [0, 1, 2].map(|i| there[i] - origin[i])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tool_that_points_down_feels_a_table_against_its_z() {
        let table = Contact::plane([5.0, 5.0, 100.0], [0.0, 0.0, 2.0], 50.0);
        let tool = |z| Transform::from(Pose::from_millimetres_degrees([300.0, 0.0, z], [180.0, 0.0, 0.0]));
        assert_eq!((table.depth(&tool(101.0)), table.force(&tool(101.0))[2].abs()), (0.0, 0.0));
        assert!((table.depth(&tool(99.5)) - 0.5).abs() < 1e-9);
        let force = table.force(&tool(99.5));
        assert!((force[2] + 25.0).abs() < 1e-9 && force[0].abs() + force[1].abs() < 1e-9, "{force:?}");
        assert!(Contact::plane([0.0; 3], [0.0; 3], 1.0).check().is_err());
    }
}
