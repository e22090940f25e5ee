//! What the tool touches.

use super::World;
use crate::Contact;

/// The plane in the way of the tool centre point, and how deep the tool has been.
#[derive(Debug)]
pub(super) struct Touch {
    contact: Option<Contact>,
    deepest: f64,
}

impl Touch {
    pub(super) fn new(contact: Option<Contact>) -> Self {
        Self { contact, deepest: 0.0 }
    }
}

impl World {
    /// Puts a plane into the way, or takes it away.
    pub(crate) fn set_contact(&mut self, contact: Option<Contact>) {
        self.touch = Touch::new(contact);
        self.state.torque_sensor.contact_force = [0.0; 6];
        self.feel();
    }

    /// How deep the tool has been, in mm.
    pub(crate) fn deepest_penetration(&self) -> f64 {
        self.touch.deepest
    }

    /// The force on the tool where it is.
    pub(super) fn feel(&mut self) {
        let Some(contact) = self.touch.contact else { return };
        let tool = self.tool_at(self.state.joint_position.0);
        self.touch.deepest = self.touch.deepest.max(contact.depth(&tool));
        self.state.torque_sensor.contact_force = contact.force(&tool);
    }
}
