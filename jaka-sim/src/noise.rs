//! Noise of the encoders.

use jaka_proto::messages::types::JointPosition;

use crate::fault::SplitMix64;

/// Random numbers that are added to joint positions in answers and packets: the same in each run.
#[derive(Debug)]
pub(crate) struct Noise {
    amplitude: f64,
    generator: SplitMix64,
}

impl Noise {
    pub(crate) fn new(amplitude: f64) -> Self {
        Self { amplitude, generator: SplitMix64::new(0) }
    }

    /// True if positions are reported as they are.
    pub(crate) fn is_none(&self) -> bool {
        self.amplitude == 0.0
    }

    /// Returns joint positions as they are measured.
    pub(crate) fn of(&mut self, joints: JointPosition) -> JointPosition {
        if self.is_none() {
            return joints;
        }
        JointPosition(joints.0.map(|joint| joint + self.amplitude * self.generator.between_ones()))
    }
}
