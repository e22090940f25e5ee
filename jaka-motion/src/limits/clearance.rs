//! Least distance from singularities.

use super::{ROUNDING, START_ROUNDING};
use crate::beyond::Exceeded;
use crate::model::Singularity;

/// Least distance from each singularity, from 0 (no limit) to below 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SingularityClearance(pub(super) f64);

/// Least distance at which the joints surely stay on their branch; it replaces a smaller one of the limits.
const APART: f64 = 0.02;
/// Number of parts of the path ahead in which distances are compared.
#[cfg(feature = "generator")]
const PARTS: u8 = 4;

impl SingularityClearance {
    /// Checks that no singularity is nearer than the least distance, or than at the start of the motion.
    pub(crate) fn check(self, start: &[f64; 3], here: &[f64; 3]) -> Result<(), Exceeded> {
        let limit = self.0;
        for (index, which) in Singularity::ALL.into_iter().enumerate() {
            let (distance, least) = (here[index], limit.min(start[index]));
            if distance < (limit - ROUNDING).min(start[index] - START_ROUNDING) {
                return Err(Exceeded::Singularity { which, distance, least });
            }
        }
        Ok(())
    }

    /// Checks that no singularity is between two places, for their signed distances, unless the least distance is 0.
    pub(crate) fn check_sides(self, start: &[f64; 3], here: &[f64; 3]) -> Result<(), Exceeded> {
        match Self::passed(start, here).filter(|_| self.0 > 0.0) {
            Some(which) => Err(self.too_near(which, 0.0)),
            None => Ok(()),
        }
    }

    /// Returns the first singularity between two places, from their signed distances. From a singularity the arm may
    /// move to either side.
    pub(crate) fn passed(start: &[f64; 3], here: &[f64; 3]) -> Option<Singularity> {
        let index = (0..3).find(|index| start[*index].abs() > ROUNDING && start[*index] * here[*index] < 0.0);
        index.map(|index| Singularity::ALL[index])
    }

    /// Whether the arm surely keeps its distance from singularities while the distances change by at most these
    /// amounts.
    pub(crate) fn is_kept(self, distances: &[f64; 3], changes: &[f64; 3]) -> bool {
        let least = self.0.max(APART);
        (0..3).all(|index| distances[index] - changes[index] >= least)
    }

    /// Returns the share of a path at which the least distance is reached, from the signed distances at its start and
    /// at shares of it. The share is zero for a singularity that is nearer already and comes nearer still.
    #[cfg(feature = "generator")]
    pub(crate) fn room(self, start: [f64; 3], at: impl Fn(f64) -> [f64; 3]) -> Option<(f64, Exceeded)> {
        let (least, mut before) = (self.0, start);
        for part in 0..PARTS {
            let (begun, done) = (f64::from(part) / f64::from(PARTS), f64::from(part + 1) / f64::from(PARTS));
            let here = at(done);
            for index in 0..3 {
                // The sign makes the distance negative beyond the singularity.
                let (one, other) = (before[index].abs(), here[index] * before[index].signum());
                if other < least && other < one {
                    let part = ((one - least) / (one - other)).max(0.0);
                    return Some((begun + part * (done - begun), self.too_near(Singularity::ALL[index], one)));
                }
            }
            before = here;
        }
        None
    }

    /// Returns the error for the nearest singularity.
    pub(crate) fn nearest(self, distances: &[f64; 3]) -> Exceeded {
        let (which, distance) = Singularity::nearest(distances);
        self.too_near(which, distance)
    }

    /// Returns the error for a singularity at a distance.
    pub(crate) fn too_near(self, which: Singularity, distance: f64) -> Exceeded {
        Exceeded::Singularity { which, distance, least: self.0 }
    }
}
