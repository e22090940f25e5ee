//! Points of the arm compared with regions while the joints move.

use jaka_proto::messages::types::JointPosition;
use nalgebra::Point3;

use super::arm::Arm;
use super::placed_regions::PlacedRegions;
use super::radii::{PieceEnd, PointMotion};
use super::solved::Solved;
use super::{Checker, TOOL_USED};
use crate::beyond::{Exceeded, Found};
#[cfg(feature = "generator")]
use crate::braking::{Stop, longest_stop};
use crate::model::Point;
use crate::piece::{Hull, Piece};

/// Points of an arm that regions apply to.
#[derive(Debug, Clone, Copy)]
pub(super) struct LimitedPoints<'a> {
    pub(super) arm: &'a Arm,
    pub(super) regions: PlacedRegions<'a>,
}

/// Joint ranges and regions within which an arm must be able to stop, straight on in joint space.
#[derive(Debug, Clone, Copy)]
pub(super) struct RoomToStop<'a> {
    pub(super) checker: &'a Checker,
    pub(super) points: LimitedPoints<'a>,
}

/// Period of the search for room to stop on a piece, in seconds.
const PERIOD_S: f64 = 0.008;

impl LimitedPoints<'_> {
    fn all(&self) -> impl Iterator<Item = Point> {
        Point::ALL.into_iter().filter(|point| self.regions.limit(*point))
    }

    /// Checks all points at one place.
    pub(super) fn check_place(&self, joints: &[f64; 6]) -> Result<(), Exceeded> {
        self.all()
            .try_for_each(|point| self.regions.check(point, None, &self.arm.point(point, joints), 0.0).map(|_| ()))
    }

    /// Checks all points on a straight path in joint space.
    pub(super) fn check_joint_way(&self, from: &[f64; 6], to: &[f64; 6]) -> Result<(), Found> {
        let moved: [f64; 6] = std::array::from_fn(|index| to[index] - from[index]);
        self.all().try_for_each(|point| {
            let on_way = |share| std::array::from_fn(|index| from[index] + share * moved[index]);
            let at = |share| self.arm.point(point, &on_way(share));
            self.regions.check_way(point, 0.0, self.arm.radii().motion_of_path(point, &moved), at)
        })
    }

    /// Checks all points on a piece.
    pub(super) fn check_piece(&self, piece: &Piece, hull: &Hull) -> Result<(), Found> {
        self.all().try_for_each(|point| {
            let at = |share: f64| self.arm.point(point, &piece.joints(share));
            self.regions.check_way_from(point, None, 0.0, self.arm.radii().motion_on_piece(point, piece, hull), at)
        })
    }

    /// Checks all points on the paths of the joints to a stop. The position at which the arm has rested, if any, counts
    /// as within.
    #[cfg(feature = "generator")]
    pub(super) fn check_stops(&self, rested: Option<&[f64; 6]>, stops: &[Stop; 6]) -> Result<(), Found> {
        let seconds = longest_stop(stops);
        let turned = stops.map(|stop| stop.top_speed().to_radians() * seconds);
        let swung = stops.map(|stop| stop.top_acceleration().to_radians() * seconds * seconds);
        self.all().try_for_each(|point| {
            let at = |share: f64| self.arm.point(point, &stops.map(|stop| stop.at(share * seconds).position));
            let start = rested.map(|joints| self.arm.point(point, joints));
            let motion = self.arm.radii().motion_with_swings(point, &turned, &swung);
            self.regions.check_way_from(point, start, 0.0, motion, at)
        })
    }

    /// Whether no point gets to a region while the joints turn by at most these radians from a start.
    pub(super) fn are_far(&self, start: &PieceEnd, turned: &[f64; 6]) -> bool {
        self.all().all(|point| {
            let clear = self.regions.check(point, None, start.point(point), 0.0);
            clear.is_ok_and(|clear| clear > self.arm.radii().motion(point, turned).rate_mm)
        })
    }

    /// Whether all points are within their regions on a line with these ends, on which the joints turn by at most these
    /// radians.
    pub(super) fn are_clear_on_line(&self, ends: [&Solved; 2], turned: &[f64; 6]) -> bool {
        self.all().all(|point| {
            let places = ends.map(|end| end.point(point));
            if point == Point::Tcp {
                let motion = PointMotion { rate_mm: (places[1] - places[0]).norm(), bend_mm: 0.0 };
                let at = |share: f64| Point3::from(places[0].coords.lerp(&places[1].coords, share));
                return self.regions.check_way(point, 0.0, motion, at).is_ok();
            }
            let clear = places.map(|at| self.regions.check(point, None, &at, 0.0).ok());
            let rate_mm = self.arm.radii().motion(point, turned).rate_mm;
            matches!(clear, [Some(one), Some(other)] if one + other > rate_mm)
        })
    }

    /// Replaces the distance of a violation by the distance beyond the same region at an end, if that is greater.
    pub(super) fn further_at(&self, end: &[f64; 6], found: Exceeded) -> Exceeded {
        let Exceeded::Region { name, point, by_mm, tolerance_mm } = found else { return found };
        let at_end = self.regions.beyond_named(&name, point, &self.arm.point(point, end));
        Exceeded::Region { name, point, by_mm: at_end.map_or(by_mm, |at_end| by_mm.max(at_end)), tolerance_mm }
    }
}

impl RoomToStop<'_> {
    /// Checks the path to a stop after a set-point.
    pub(super) fn check_step(&self, last: &[f64; 6], target: &[f64; 6], period_s: f64) -> Result<(), Exceeded> {
        let steps = self.checker.straight_stop([JointPosition(*last), JointPosition(*target)], period_s).steps();
        let end = std::array::from_fn(|index| target[index] + steps * (target[index] - last[index]));
        self.checker.limits().axes().check_positions(&end, target).map_err(Exceeded::at_stop)?;
        let on_way = self.points.check_joint_way(target, &end);
        on_way.map_err(|(exceeded, _)| self.points.further_at(&end, exceeded).at_stop())
    }

    /// Checks the paths to a stop from each set-point on a piece.
    pub(super) fn check_piece(&self, piece: &Piece) -> Result<(), Found> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count, and too many are cut")]
        let count = (piece.seconds / PERIOD_S).ceil().clamp(1.0, 1e6) as u32;
        (0..=count).map(|place| f64::from(place) / f64::from(count)).try_for_each(|share| {
            let here = piece.at(share);
            let joints = &here.joints.0;
            // The mean time of the last step is half a period before the speed at the set-point.
            let last = std::array::from_fn(|joint| joints[joint] - here.velocity[joint] * PERIOD_S);
            self.check_step(&last, joints, PERIOD_S).map_err(|exceeded| (exceeded, share))
        })
    }

    /// Returns the longest path to a stop from a piece, as seconds at the joints' speeds.
    pub(super) fn seconds(&self, hull: &Hull) -> f64 {
        let (limits, velocity) = (self.checker.limits(), &hull.speeds);
        let tool = limits.stop_tcp_acceleration().map_or(f64::INFINITY, |most| {
            // Each joint may be slower at this place than its speed in the hull.
            TOOL_USED * most / self.points.arm.radii().tcp_rate_at_most(velocity)
        });
        limits.axes().stop_rates(velocity, limits.stop_jerks(), tool).length_s() + PERIOD_S
    }
}
