//! Regions, and points that move through them.

use nalgebra::{Isometry3, Point3};

use super::radii::{BEND_MM, LEAST_STEP, PointMotion};
use crate::beyond::{Exceeded, Found};
use crate::limits::{ROUNDING, Region, RegionFrame, START_ROUNDING};
use crate::model::Point;

/// Regions around the base of an arm. All places are in the arm's base.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlacedRegions<'a> {
    pub(super) regions: &'a [Region],
    /// Base of the arm, seen from the user frame.
    pub(super) base: &'a Isometry3<f64>,
}

impl<'a> PlacedRegions<'a> {
    /// Whether there is a region for a point.
    pub(super) fn limit(&self, point: Point) -> bool {
        self.of(point).next().is_some()
    }

    fn of(&self, point: Point) -> impl Iterator<Item = &'a Region> + use<'a> {
        self.regions.iter().filter(move |region| region.point() == point)
    }

    /// Returns the distance of a point beyond the region of this name, in mm, if there is one for the point.
    pub(super) fn beyond_named(&self, name: &str, point: Point, at: &Point3<f64>) -> Option<f64> {
        self.of(point).find(|region| **region.name() == *name).map(|region| self.beyond(region, at))
    }

    /// Checks a point at one place, and returns its least distance from the borders of its regions, in mm.
    ///
    /// The place at the start counts as within. The distance is smaller by `tolerance`, for blending, also for a motion
    /// that starts there.
    pub(super) fn check(
        &self,
        point: Point,
        start: Option<&Point3<f64>>,
        at: &Point3<f64>,
        tolerance: f64,
    ) -> Result<f64, Exceeded> {
        self.of(point).try_fold(f64::INFINITY, |clear, region| {
            let by_mm = self.beyond(region, at) + tolerance;
            let allowed = self.allowed(region, start);
            if by_mm > ROUNDING.max(allowed + START_ROUNDING) {
                return Err(Exceeded::Region { name: region.name().clone(), point, by_mm, tolerance_mm: tolerance });
            }
            Ok(clear.min((allowed - by_mm).max(0.0)))
        })
    }

    /// Returns the shares of a straight path between two places at which it is in the middle of boxes to be kept
    /// outside of.
    pub(super) fn crossings(
        &self,
        point: Point,
        start: Option<&Point3<f64>>,
        way: [Point3<f64>; 2],
        tolerance: f64,
    ) -> impl Iterator<Item = f64> {
        self.of(point).filter_map(move |region| {
            let seen = self.seen_from(region);
            let depth = self.allowed(region, start) - tolerance;
            region.crossed(&(seen * way[0]), &(seen * way[1]), depth)
        })
    }

    /// Checks a point along a path; `at` gives its place for a share of the path. The start counts as within.
    pub(super) fn check_way(
        &self,
        point: Point,
        tolerance: f64,
        motion: PointMotion,
        at: impl Fn(f64) -> Point3<f64>,
    ) -> Result<(), Found> {
        let start = self.limit(point).then(|| at(0.0));
        self.check_way_from(point, start, tolerance, motion, at)
    }

    /// Checks a point along a path, as [`check_way`](Self::check_way) does, with `start` as the place that counts as
    /// within, if any.
    pub(super) fn check_way_from(
        &self,
        point: Point,
        start: Option<Point3<f64>>,
        tolerance: f64,
        motion: PointMotion,
        at: impl Fn(f64) -> Point3<f64>,
    ) -> Result<(), Found> {
        if !self.limit(point) {
            return Ok(());
        }
        // A chord of this length deviates from its arc by at most `BEND_MM`.
        let step = (8.0 * BEND_MM / motion.bend_mm).sqrt().min(1.0);
        if step.is_nan() || step < LEAST_STEP {
            return Err((Exceeded::TooLong, 0.0));
        }
        let check = |share: f64, here: &Point3<f64>| {
            self.check(point, start.as_ref(), here, tolerance).map_err(|exceeded| (exceeded, share))
        };
        let (mut share, mut here) = (0.0, at(0.0));
        while share < 1.0 {
            let clear = check(share, &here)?;
            let next_share = f64::min(share + step.max(clear / motion.rate_mm), 1.0);
            let next = at(next_share);
            for part in self.crossings(point, start.as_ref(), [here, next], tolerance) {
                let crossing = share + part * (next_share - share);
                check(crossing, &at(crossing))?;
            }
            (share, here) = (next_share, next);
        }
        check(1.0, &here).map(|_| ())
    }

    fn beyond(&self, region: &Region, at: &Point3<f64>) -> f64 {
        region.beyond(&(self.seen_from(region) * at))
    }

    /// Returns the distance that a point may be beyond a region, in mm: zero, or its distance at the start.
    fn allowed(&self, region: &Region, start: Option<&Point3<f64>>) -> f64 {
        start.map_or(0.0, |start| self.beyond(region, start).max(0.0))
    }

    /// Returns the arm's base, seen from the frame of a region.
    fn seen_from(&self, region: &Region) -> Isometry3<f64> {
        match region.frame() {
            RegionFrame::ArmBase => Isometry3::identity(),
            RegionFrame::User => *self.base,
        }
    }
}
