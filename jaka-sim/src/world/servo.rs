//! Servo mode, and the errors that end it.

use super::World;
use crate::motion::{Servo, ServoOptions};
use crate::trips::{self, Observed};

impl World {
    /// Servo mode, with the filter that is set.
    pub(super) fn servo(&self) -> Servo {
        let filter = &self.state.servo_filter;
        let options = ServoOptions { filter, tool: self.tool(), underrun: self.underrun, trips: &self.trips };
        Servo::new(self.drives.commanded, options, &self.model)
    }

    /// What has gone wrong with the motion in this cycle.
    pub(super) fn error(&mut self) -> Option<u32> {
        let drives = &self.drives;
        let observed = Observed {
            deviation: drives.deviation(),
            speed: drives.speed,
            speed_deviation: drives.speed_deviation(),
            ..Observed::default()
        };
        let of_servo = self.engine.servo.as_mut().and_then(Servo::take_error);
        of_servo.or_else(|| trips::error(&self.trips, &observed))
    }

    /// Stops with an error, as the drives do.
    pub(super) fn trip(&mut self, code: u32) {
        self.state.report(code);
        self.state.servo_mode = false;
        self.halt();
        self.make_consistent();
    }
}
