//! The room that an arm needs to stop after a set-point.

use super::Checker;
use crate::beyond::{Exceeded, Found};

/// What rounding may add to the number of periods: a landing that takes just as many does not take one more.
const PERIODS_ROUNDING: f64 = 1e-6;

impl Checker {
    /// Joint ranges and regions on the way to a stop, straight on in joint space.
    pub(super) fn landing(&self, last: &[f64; 6], target: &[f64; 6], period_s: f64) -> Result<(), Found> {
        let count = self.periods_of_landing(last, target, period_s);
        if count <= 1.0 {
            return Ok(());
        }
        // The steps are those of the set-point times 1 - k/N, for k from 1 to N.
        let steps = 0.5 * (count - 1.0);
        let end = std::array::from_fn(|index| target[index] + steps * (target[index] - last[index]));
        self.within_ranges(&end, target).map_err(|exceeded| (as_landing(exceeded), 1.0))?;
        self.regions_on_joint_way(target, &end)
            .map_err(|(exceeded, _)| (self.region_of_landing(as_landing(exceeded), &end), 1.0))
    }

    /// In how many periods the joints stop where the one that takes the longest slows down as much as it may, and the others in proportion.
    fn periods_of_landing(&self, last: &[f64; 6], target: &[f64; 6], period_s: f64) -> f64 {
        let limits = self.limits.joint_accelerations();
        let needed = |index: usize| (target[index] - last[index]).abs() / period_s / period_s / limits[index];
        ((0..6).map(needed).fold(0.0, f64::max) - PERIODS_ROUNDING).ceil()
    }

    /// With how far beyond the region the point is at the end, if that is further than where it was noticed.
    fn region_of_landing(&self, found: Exceeded, end: &[f64; 6]) -> Exceeded {
        let Exceeded::LandingRegion { name, point, by_mm } = found else { return found };
        let region = self.regions_of(point).find(|region| *region.name() == name);
        let at_end = region.map_or(by_mm, |region| self.beyond_region(region, &self.point(point, end)));
        Exceeded::LandingRegion { name, point, by_mm: by_mm.max(at_end) }
    }
}

pub(super) fn as_landing(exceeded: Exceeded) -> Exceeded {
    match exceeded {
        Exceeded::JointRange { joint, position_deg, limit_deg } => {
            Exceeded::LandingRange { joint, end_deg: position_deg, limit_deg }
        }
        Exceeded::Region { name, point, by_mm, .. } => Exceeded::LandingRegion { name, point, by_mm },
        other => other,
    }
}
