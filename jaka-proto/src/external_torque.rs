//! Torques that something outside the arm puts on its joints.

use crate::messages::status::{JointMonitor, RobotStatus};
use crate::wire::Typed;

impl RobotStatus {
    /// External torques of the six joints in Nm: the torques measured by the currents minus the torques of the
    /// controller's model for the pose. A contact changes them.
    ///
    /// `None` if the packet does not have both for all six joints (the document's rows have ten values), if a value is
    /// not finite, and if the packet does not show power: then nothing is measured.
    ///
    /// Source: captures of a newer controller and of firmware 1.5.14; no document names the two values. The model has
    /// an error of its own: compare with the torques at rest without contact, not with zero. **This is no safety
    /// function.**
    pub fn external_torques(&self) -> Option<[f64; 6]> {
        let Some(Typed::Known(data)) = &self.monitor_data else { return None };
        let joints = <&[JointMonitor; 6]>::try_from(data.joints.as_slice()).ok()?;
        if self.powered_on != Some(true) {
            return None;
        }
        let mut torques = [0.0; 6];
        for (torque, joint) in torques.iter_mut().zip(joints) {
            *torque = joint.torque - joint.model_torque?;
        }
        torques.iter().all(|torque| torque.is_finite()).then_some(torques)
    }
}
