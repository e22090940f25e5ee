//! The way around a corner, from one motion into the next.

use jaka_motion::Model;

use super::path::Joints;
use super::running::Running;
use super::vector::minus;

/// A motion that goes on to its end while the next has begun.
///
/// What it still has to do is taken off from the next one's place. So the arm leaves it slowing down as planned, and
/// neither its place nor its speed jumps.
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

    /// One cycle: how far its place is from its end.
    pub(super) fn cycle(&mut self, rate: f64, model: &Model) -> Joints {
        let (share, ended) = self.running.cycle(rate);
        self.at = self.running.planned.path.at(share, model, self.at).unwrap_or(self.at);
        self.ended = ended;
        self.offset()
    }

    /// Brakes, and says where that ends, from the end of the motion.
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

    /// True where it has come to its end and not been stopped before.
    pub(super) fn is_done(&self) -> bool {
        self.ended && self.running.brake.is_none()
    }
}
