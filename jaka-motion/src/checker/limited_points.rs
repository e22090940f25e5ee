//! Points of the arm compared with regions, where the joints move.

use nalgebra::Point3;

use super::arm::Arm;
use super::piece_end::PieceEnd;
use super::placed_regions::PlacedRegions;
use super::radii::Course;
use super::solved::Solved;
use crate::beyond::{Exceeded, Found};
#[cfg(feature = "generator")]
use crate::braking::{Stop, longest_stop};
use crate::model::Point;
use crate::piece::{Hull, Piece};

/// The points of an arm that regions are for.
#[derive(Debug, Clone, Copy)]
pub(super) struct LimitedPoints<'a> {
    pub(super) arm: &'a Arm,
    pub(super) regions: PlacedRegions<'a>,
}

impl LimitedPoints<'_> {
    fn all(&self) -> impl Iterator<Item = Point> {
        Point::ALL.into_iter().filter(|point| self.regions.limit(*point))
    }

    /// Checks all points at one place.
    pub(super) fn check_place(&self, joints: &[f64; 6]) -> Result<(), Exceeded> {
        self.all()
            .try_for_each(|point| self.regions.check(point, None, &self.arm.point(point, joints), 0.0).map(|_| ()))
    }

    /// Checks all points on a way straight in joint space.
    pub(super) fn check_joint_way(&self, from: &[f64; 6], to: &[f64; 6]) -> Result<(), Found> {
        let moved: [f64; 6] = std::array::from_fn(|index| to[index] - from[index]);
        self.all().try_for_each(|point| {
            let on_way = |share| std::array::from_fn(|index| from[index] + share * moved[index]);
            let at = |share| self.arm.point(point, &on_way(share));
            self.regions.check_way(point, 0.0, self.arm.radii().course_of_way(point, &moved), at)
        })
    }

    /// Checks all points on a piece.
    pub(super) fn check_piece(&self, piece: &Piece, hull: &Hull) -> Result<(), Found> {
        self.all().try_for_each(|point| {
            let at = |share: f64| self.arm.point(point, &piece.joints(share));
            self.regions.check_way_from(point, None, 0.0, self.arm.radii().course_of_piece(point, piece, hull), at)
        })
    }

    /// Checks all points on the ways of the joints to a stop. Where the arm has rested, if it has, counts as within.
    #[cfg(feature = "generator")]
    pub(super) fn check_stops(&self, rested: Option<&[f64; 6]>, stops: &[Stop; 6]) -> Result<(), Found> {
        let seconds = longest_stop(stops);
        let turned = stops.map(|stop| stop.top_speed().to_radians() * seconds);
        let swung = stops.map(|stop| stop.top_acceleration().to_radians() * seconds * seconds);
        self.all().try_for_each(|point| {
            let at = |share: f64| self.arm.point(point, &stops.map(|stop| stop.at(share * seconds).position));
            let start = rested.map(|joints| self.arm.point(point, joints));
            let course = self.arm.radii().course_of_swings(point, &turned, &swung);
            self.regions.check_way_from(point, start, 0.0, course, at)
        })
    }

    /// Whether no point gets to a region where the joints turn by at most so many radians from a start.
    pub(super) fn are_far(&self, start: &PieceEnd, turned: &[f64; 6]) -> bool {
        self.all().all(|point| {
            let clear = self.regions.check(point, None, start.point(point), 0.0);
            clear.is_ok_and(|clear| clear > self.arm.radii().course(point, turned).rate_mm)
        })
    }

    /// Whether all points are within their regions on a line with these ends, on which the joints turn by at most so
    /// many radians.
    pub(super) fn are_clear_on_line(&self, ends: [&Solved; 2], turned: &[f64; 6]) -> bool {
        self.all().all(|point| {
            let places = ends.map(|end| end.point(point));
            if point == Point::Tcp {
                let course = Course { rate_mm: (places[1] - places[0]).norm(), bend_mm: 0.0 };
                let at = |share: f64| Point3::from(places[0].coords.lerp(&places[1].coords, share));
                return self.regions.check_way(point, 0.0, course, at).is_ok();
            }
            let clear = places.map(|at| self.regions.check(point, None, &at, 0.0).ok());
            let rate_mm = self.arm.radii().course(point, turned).rate_mm;
            matches!(clear, [Some(one), Some(other)] if one + other > rate_mm)
        })
    }

    /// With how far the point that was found beyond a region is beyond it at an end, if that is further.
    pub(super) fn further_at(&self, end: &[f64; 6], found: Exceeded) -> Exceeded {
        let Exceeded::Region { name, point, by_mm, tolerance_mm } = found else { return found };
        let at_end = self.regions.beyond_named(&name, point, &self.arm.point(point, end));
        Exceeded::Region { name, point, by_mm: at_end.map_or(by_mm, |at_end| by_mm.max(at_end)), tolerance_mm }
    }
}
