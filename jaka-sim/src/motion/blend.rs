//! Blend from one motion into the next.

use jaka_motion::Model;

use super::path::Joints;
use super::running::Running;
use super::vector::minus;

/// Motion that continues to its end after the start of the next one.
///
/// Its remaining distance is subtracted from the position of the next motion. So the motion slows down as planned, and
/// neither position nor speed jumps.
#[derive(Debug, Clone)]
pub(super) struct Leaving {
    running: Running,
    at: Joints,
    ended: bool,
}

impl Leaving {
    pub(super) fn new(running: Running, at: Joints) -> Self {
        Self { running, at, ended: false }
    }

    /// Computes one cycle, and returns the offset of the position from the end of the motion.
    pub(super) fn cycle(&mut self, rate: f64, model: &Model) -> Joints {
        let (share, ended) = self.running.cycle(rate);
        self.at = self.running.planned.path.at(share, model, self.at).unwrap_or(self.at);
        self.ended = ended;
        self.offset()
    }

    /// Brakes, and returns the offset of the stop position from the end of the motion.
    pub(super) fn brake(&mut self, model: &Model) -> Joints {
        self.running.brake();
        let stop = self.running.stop(model, self.at);
        minus(stop, self.running.planned.end)
    }

    fn offset(&self) -> Joints {
        minus(self.at, self.running.planned.end)
    }

    pub(super) fn has_ended(&self) -> bool {
        self.ended
    }

    /// Whether it has reached its end without braking.
    pub(super) fn is_done(&self) -> bool {
        self.ended && self.running.brake.is_none()
    }
}
