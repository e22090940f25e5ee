//! Points of the arm on their way through regions.

use nalgebra::{Isometry3, Point3, Vector3};

use super::Checker;
use super::amounts::{BEND_MM, LEAST_STEP, ROUNDING, START_ROUNDING};
use crate::beyond::{Exceeded, Found};
use crate::limits::{Point, Region, RegionFrame};
use crate::links::Links;

/// All points that regions can be for.
pub(super) const POINTS: [Point; 3] = [Point::Tcp, Point::Elbow, Point::Wrist];

/// How a point goes along a way, whose length is 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Course {
    /// The most that it moves, in mm.
    pub(super) rate_mm: f64,
    /// The most that its speed changes, in mm.
    pub(super) bend_mm: f64,
}

impl Checker {
    /// Joint ranges and regions.
    pub(super) fn place(&self, joints: &[f64; 6]) -> Result<(), Exceeded> {
        // No start is beyond the ranges: a place is not a motion that leads back.
        self.within_ranges(joints, self.limits.joint_min())?;
        self.limited_points()
            .try_for_each(|point| self.beyond_regions(point, None, &self.point(point, joints), 0.0).map(|_| ()))
    }

    /// Whether all joints are within their ranges, or no further beyond than where the motion started.
    pub(super) fn within_ranges(&self, joints: &[f64; 6], start: &[f64; 6]) -> Result<(), Exceeded> {
        let (min, max) = (self.limits.joint_min(), self.limits.joint_max());
        let least = |index: usize| (min[index] - ROUNDING).min(start[index] - START_ROUNDING);
        let most = |index: usize| (max[index] + ROUNDING).max(start[index] + START_ROUNDING);
        let beyond = |index: &usize| joints[*index] < least(*index) || joints[*index] > most(*index);
        let by = |index: usize| (min[index] - joints[index]).max(joints[index] - max[index]);
        let furthest = (0..6).filter(beyond).max_by(|one, other| by(*one).total_cmp(&by(*other)));
        furthest.map_or(Ok(()), |index| {
            let limit_deg = if joints[index] > max[index] { max[index] } else { min[index] };
            Err(Exceeded::JointRange { joint: index + 1, position_deg: joints[index], limit_deg })
        })
    }

    /// Where a point of the arm is, in the arm's base.
    pub(super) fn point(&self, point: Point, joints: &[f64; 6]) -> Point3<f64> {
        let links = &self.limits.model().links;
        let frame = links.product(0..point.frame() + 1, &links.angles(joints));
        let place = if point == Point::Tcp { frame * self.tool } else { frame };
        place.translation.vector.into()
    }

    /// The most that a point can be away from the axis of each joint, in mm; 0 for a joint that does not move it.
    pub(super) fn radii(&self, point: Point) -> &[f64; 6] {
        // In the order of `POINTS`.
        &self.radii[point as usize]
    }

    /// The points that regions are for.
    pub(super) fn limited_points(&self) -> impl Iterator<Item = Point> {
        POINTS.into_iter().filter(|point| self.regions_of(*point).next().is_some())
    }

    /// The regions for a point.
    pub(super) fn regions_of(&self, point: Point) -> impl Iterator<Item = &Region> {
        self.limits.regions().iter().filter(move |region| region.point() == point)
    }

    /// How far the point is within all its regions at least, in mm; all places are in the arm's base.
    ///
    /// Where it was at the start counts as within. Blending takes off what is `tolerance`, at the start too.
    pub(super) fn beyond_regions(
        &self,
        point: Point,
        start: Option<&Point3<f64>>,
        at: &Point3<f64>,
        tolerance: f64,
    ) -> Result<f64, Exceeded> {
        self.regions_of(point).try_fold(f64::INFINITY, |clear, region| {
            let by_mm = self.beyond_region(region, at) + tolerance;
            let allowed = self.allowed(region, start);
            if by_mm > ROUNDING.max(allowed + START_ROUNDING) {
                return Err(Exceeded::Region { name: region.name().clone(), point, by_mm, tolerance_mm: tolerance });
            }
            Ok(clear.min((allowed - by_mm).max(0.0)))
        })
    }

    /// Where a straight way between two places goes through the midst of boxes to be kept outside of, as shares of the way.
    pub(super) fn crossings<'a>(
        &'a self,
        point: Point,
        start: Option<&'a Point3<f64>>,
        way: [Point3<f64>; 2],
        tolerance: f64,
    ) -> impl Iterator<Item = f64> + 'a {
        self.regions_of(point).filter_map(move |region| {
            let seen = self.seen_from(region);
            let depth = self.allowed(region, start) - tolerance;
            region.crossed(&(seen * way[0]), &(seen * way[1]), depth)
        })
    }

    /// Checks the regions for a point along a way; `at` is its place in the arm's base for a share of the way. Where it starts counts as within.
    pub(super) fn along(
        &self,
        point: Point,
        tolerance: f64,
        course: Course,
        at: impl Fn(f64) -> Point3<f64>,
    ) -> Result<(), Found> {
        let start = self.regions_of(point).next().map(|_| at(0.0));
        self.along_from(point, start, tolerance, course, at)
    }

    /// As [`along`](Self::along), with the place that counts as within, if there is one.
    pub(super) fn along_from(
        &self,
        point: Point,
        start: Option<Point3<f64>>,
        tolerance: f64,
        course: Course,
        at: impl Fn(f64) -> Point3<f64>,
    ) -> Result<(), Found> {
        if self.regions_of(point).next().is_none() {
            return Ok(());
        }
        // A chord of this length is nowhere further from its arc than this.
        let step = (8.0 * BEND_MM / course.bend_mm).sqrt().min(1.0);
        if step.is_nan() || step < LEAST_STEP {
            return Err((Exceeded::TooLong, 0.0));
        }
        let check = |share: f64, here: &Point3<f64>| {
            self.beyond_regions(point, start.as_ref(), here, tolerance).map_err(|exceeded| (exceeded, share))
        };
        let (mut share, mut here) = (0.0, at(0.0));
        while share < 1.0 {
            let clear = check(share, &here)?;
            let next_share = f64::min(share + step.max(clear / course.rate_mm), 1.0);
            let next = at(next_share);
            for part in self.crossings(point, start.as_ref(), [here, next], tolerance) {
                let crossing = share + part * (next_share - share);
                check(crossing, &at(crossing))?;
            }
            (share, here) = (next_share, next);
        }
        check(1.0, &here).map(|_| ())
    }

    pub(super) fn beyond_region(&self, region: &Region, at: &Point3<f64>) -> f64 {
        region.beyond(&(self.seen_from(region) * at))
    }

    /// How far beyond a region a point may be: not at all, or as far as it is at the start.
    fn allowed(&self, region: &Region, start: Option<&Point3<f64>>) -> f64 {
        start.map_or(0.0, |start| self.beyond_region(region, start).max(0.0))
    }

    /// The arm's base, seen from the frame of a region.
    fn seen_from(&self, region: &Region) -> Isometry3<f64> {
        match region.frame() {
            RegionFrame::ArmBase => Isometry3::identity(),
            RegionFrame::User => self.base,
        }
    }
}

/// The most that a point can be away from the axis of each joint, in mm, with the tool centre point there on the flange.
pub(super) fn radii(links: &Links, point: Point, tool: &Vector3<f64>) -> [f64; 6] {
    let tool = if point == Point::Tcp { *tool } else { Vector3::zeros() };
    std::array::from_fn(|joint| {
        let bars = (joint + 1..=point.frame()).map(|link| links.a[link].hypot(links.d[link])).sum::<f64>();
        // The last axis is the tool's z axis.
        bars + if joint == 5 { tool.x.hypot(tool.y) } else { tool.norm() }
    })
}
