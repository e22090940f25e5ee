//! Lines on which nothing can be in the way: bounds of what the joints do show it.

use nalgebra::Point3;

use super::points::Course;
use super::{Checker, Solved};
use crate::limits::Point;
use crate::piece::Piece;

/// The least distance from a singularity at which the joints surely stay on their branch, where limits name a smaller one.
const APART: f64 = 0.02;

impl Checker {
    /// From each singularity.
    pub(crate) fn distances(&self, here: &Solved) -> [f64; 3] {
        self.limits.model().distances(&here.frames)
    }

    /// How far the tool centre point goes at most where the joints turn by these degrees, in mm.
    pub(crate) fn tcp_rate_at_most(&self, moved: &[f64; 6]) -> f64 {
        self.radii(Point::Tcp).iter().zip(moved).map(|(radius, moved)| radius * moved.abs().to_radians()).sum()
    }

    /// Whether joint ranges, singularities and regions are clear all along a line with these ends, for the joints on it.
    ///
    /// Where not, [`check_line`](Self::check_line) tells.
    pub(crate) fn is_clear_line(&self, joints: &Piece, ends: [&Solved; 2], distances: &[f64; 3]) -> bool {
        let hull = joints.hull();
        let turned = hull.turned(joints.seconds);
        let at_end = self.distances(ends[1]);
        let between = std::array::from_fn(|index| f64::midpoint(distances[index], at_end[index]));
        hull.is_between(self.limits.joint_min(), self.limits.joint_max())
            && self.keeps_apart(&between, &turned.map(|turned| 0.5 * turned))
            && self.limited_points().all(|point| self.is_clear_of_regions(point, ends, &turned))
    }

    /// Whether joints that turn by at most so many radians from a place keep apart from singularities, for the distances there.
    pub(crate) fn keeps_apart(&self, distances: &[f64; 3], turned: &[f64; 6]) -> bool {
        let changes = self.distances_change(turned);
        let least = self.limits.singularity_distance().max(APART);
        (0..3).all(|index| distances[index] - changes[index] >= least)
    }

    /// By how much the distances from singularities change at most where the joints turn by so many radians.
    pub(super) fn distances_change(&self, turned: &[f64; 6]) -> [f64; 3] {
        let wrist: f64 = (1..4).map(|index| turned[index] * self.radii(Point::Wrist)[index]).sum();
        [wrist / self.limits.model().reach_mm(), turned[2], turned[4]]
    }

    fn is_clear_of_regions(&self, point: Point, ends: [&Solved; 2], turned: &[f64; 6]) -> bool {
        let places = ends.map(|end| end.point(point));
        if point == Point::Tcp {
            let course = Course { rate_mm: (places[1] - places[0]).norm(), bend_mm: 0.0 };
            let at = |share: f64| Point3::from(places[0].coords.lerp(&places[1].coords, share));
            return self.along(point, 0.0, course, at).is_ok();
        }
        let clear = places.map(|at| self.beyond_regions(point, None, &at, 0.0).ok());
        let Course { rate_mm, .. } = self.course_of_turns(point, turned);
        matches!(clear, [Some(one), Some(other)] if one + other > rate_mm)
    }
}

impl Solved {
    /// Where a point of the arm is, in the arm's base.
    fn point(&self, point: Point) -> Point3<f64> {
        let frame = if point == Point::Tcp { &self.tool } else { &self.frames[point.frame()] };
        frame.translation.vector.into()
    }
}
