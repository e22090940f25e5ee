//! Distances from singularities where the tool is led.

use super::Checker;
use super::amounts::{ROUNDING, START_ROUNDING};
use crate::beyond::Exceeded;
use crate::model::Singularity;

impl Checker {
    /// Whether no singularity is nearer than the least distance, or than where the motion started.
    pub(super) fn distances_kept(&self, start: &[f64; 3], here: &[f64; 3]) -> Result<(), Exceeded> {
        let limit = self.limits.singularity_distance();
        for (index, which) in Singularity::ALL.into_iter().enumerate() {
            let (distance, least) = (here[index], limit.min(start[index]));
            if distance < (limit - ROUNDING).min(start[index] - START_ROUNDING) {
                return Err(Exceeded::Singularity { which, distance, least });
            }
        }
        Ok(())
    }

    /// Whether no singularity is between two places, for their signed distances. From a singularity the arm may go to either side.
    pub(super) fn same_sides(&self, start: &[f64; 3], here: &[f64; 3]) -> Result<(), Exceeded> {
        let least = self.limits.singularity_distance();
        let passed = |index: usize| start[index].abs() > ROUNDING && start[index] * here[index] < 0.0;
        match Singularity::ALL.into_iter().enumerate().find(|(index, _)| least > 0.0 && passed(*index)) {
            Some((_, which)) => Err(Exceeded::Singularity { which, distance: 0.0, least }),
            None => Ok(()),
        }
    }
}
