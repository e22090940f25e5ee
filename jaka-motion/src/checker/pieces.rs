//! Parts of trajectories.

use super::amounts::ROUNDING;
use super::piece_end::PieceEnd;
use super::points::Course;
use super::{Checker, rounded_up};
use crate::beyond::{Exceeded, Found};
use crate::limits::Point;
use crate::piece::bernstein::beyond;
use crate::piece::{Hull, Piece};

/// By what share of itself the speed of the tool centre point may change between two places at which it is compared, where it is near its limit.
const SPEED_STEP: f64 = 1e-3;
/// The most places at which it is compared on one piece.
const MOST_STEPS: usize = 1_000_000;
/// How often room to stop is looked for, in seconds.
const LANDINGS: f64 = 0.008;
/// What rounding may add to an acceleration, in deg/s².
const ACCELERATION_ROUNDING: f64 = 1e-7;

impl Checker {
    /// Compares a piece with all limits; the share is that of its time. `end` is where the piece before ended, if that is known, and then where this one
    /// does.
    pub(crate) fn check_piece(&self, piece: &Piece, end: &mut Option<PieceEnd>) -> Result<(), Found> {
        let hull = piece.hull();
        if !self.is_hull_within(&hull) {
            if !piece.is_finite() {
                return Err((Exceeded::NotFinite, 0.0));
            }
            self.piece_in_ranges(piece)?;
            self.piece_in_speeds(piece)?;
            self.piece_in_accelerations(piece)?;
        }
        let has_regions = !self.limits.regions().is_empty();
        let mut is_near = false;
        if has_regions || self.limits.tcp_speed().is_some() {
            let [from, to] = piece.ends();
            let ends = [end.take().unwrap_or_else(|| self.piece_end(&from)), self.piece_end(&to)];
            self.piece_in_tcp_speed(piece, &hull, &ends)?;
            is_near = has_regions && !self.is_far_from_regions(piece, &hull, &ends[0]);
            if is_near {
                self.piece_in_regions(piece, &hull)?;
            }
            let [_, last] = ends;
            *end = Some(last);
        }
        if is_near || !self.is_far_from_range_ends(&hull) {
            self.piece_can_land(piece)?;
        }
        Ok(())
    }

    /// Whether bounds alone show that joint ranges, speeds and accelerations are kept.
    fn is_hull_within(&self, hull: &Hull) -> bool {
        let limits = &self.limits;
        let (min, max) = (limits.joint_min(), limits.joint_max());
        let at_most = |found: &[f64; 6], limits: &[f64; 6]| {
            found.iter().zip(limits).all(|(found, limit)| *found <= rounded_up(*limit))
        };
        hull.is_between(min, max)
            && at_most(&hull.speeds, limits.joint_speeds())
            && at_most(&hull.accelerations, limits.joint_accelerations())
    }

    fn piece_in_ranges(&self, piece: &Piece) -> Result<(), Found> {
        for joint in 0..6 {
            let (min, max) = (self.limits.joint_min()[joint], self.limits.joint_max()[joint]);
            if let Some((share, position_deg)) = beyond(&piece.positions(joint), min - ROUNDING, max + ROUNDING) {
                let limit_deg = if position_deg > max { max } else { min };
                return Err((Exceeded::JointRange { joint: joint + 1, position_deg, limit_deg }, share));
            }
        }
        Ok(())
    }

    fn piece_in_speeds(&self, piece: &Piece) -> Result<(), Found> {
        for (joint, limit_deg_s) in self.limits.joint_speeds().iter().copied().enumerate() {
            let most = rounded_up(limit_deg_s);
            if let Some((share, speed)) = beyond(&piece.speeds(joint), -most, most) {
                let speed_deg_s = speed.abs();
                return Err((Exceeded::JointSpeed { joint: joint + 1, speed_deg_s, limit_deg_s, near: None }, share));
            }
        }
        Ok(())
    }

    fn piece_in_accelerations(&self, piece: &Piece) -> Result<(), Found> {
        for (joint, limit_deg_s2) in self.limits.joint_accelerations().iter().copied().enumerate() {
            let most = rounded_up(limit_deg_s2) + ACCELERATION_ROUNDING;
            if let Some((share, acceleration)) = beyond(&piece.accelerations(joint), -most, most) {
                let (joint, acceleration_deg_s2) = (joint + 1, acceleration.abs());
                return Err((Exceeded::JointAcceleration { joint, acceleration_deg_s2, limit_deg_s2 }, share));
            }
        }
        Ok(())
    }

    fn piece_in_tcp_speed(&self, piece: &Piece, hull: &Hull, ends: &[PieceEnd; 2]) -> Result<(), Found> {
        let Some(limit_mm_s) = self.limits.tcp_speed() else { return Ok(()) };
        let Course { rate_mm, bend_mm } = self.course_of_piece(Point::Tcp, piece, hull);
        if rate_mm <= limit_mm_s * piece.seconds || self.tcp_speed_at_most(piece, hull, ends) <= limit_mm_s {
            return Ok(());
        }
        // How fast the speed can change for the whole of the piece.
        let change = bend_mm / piece.seconds;
        let mut share = 0.0;
        for _ in 0..MOST_STEPS {
            let here = piece.at(share);
            let speed_mm_s = self.tcp_rate(&here.joints.0, &here.velocity);
            if speed_mm_s > rounded_up(limit_mm_s) {
                return Err((Exceeded::TcpSpeed { speed_mm_s, limit_mm_s }, share));
            }
            if share >= 1.0 {
                return Ok(());
            }
            share = f64::min(share + (limit_mm_s - speed_mm_s).max(SPEED_STEP * limit_mm_s) / change, 1.0);
        }
        Err((Exceeded::TooLong, share))
    }

    fn piece_in_regions(&self, piece: &Piece, hull: &Hull) -> Result<(), Found> {
        self.limited_points().try_for_each(|point| {
            let at = |share: f64| self.point(point, &piece.joints(share));
            self.along_from(point, None, 0.0, self.course_of_piece(point, piece, hull), at)
        })
    }

    /// How a point goes on a piece.
    fn course_of_piece(&self, point: Point, piece: &Piece, hull: &Hull) -> Course {
        self.course_of_swings(point, &hull.turned(piece.seconds), &hull.swung(piece.seconds))
    }

    /// Whether no point gets to a region on a piece or where the arm lands from it, wherever it goes.
    fn is_far_from_regions(&self, piece: &Piece, hull: &Hull, start: &PieceEnd) -> bool {
        let turned = hull.turned(piece.seconds + self.room_s(hull));
        self.limited_points().all(|point| {
            let clear = self.beyond_regions(point, None, start.point(point), 0.0);
            let Course { rate_mm, .. } = self.course_of_turns(point, &turned);
            clear.is_ok_and(|clear| clear > rate_mm)
        })
    }

    /// Whether no joint gets to an end of its range where the arm lands from a piece.
    fn is_far_from_range_ends(&self, hull: &Hull) -> bool {
        let seconds = self.room_s(hull);
        let room = hull.speeds.map(|speed| seconds * speed);
        let least = std::array::from_fn(|joint| self.limits.joint_min()[joint] + room[joint]);
        hull.is_between(&least, &std::array::from_fn(|joint| self.limits.joint_max()[joint] - room[joint]))
    }

    /// For how many seconds a joint could go on with its speed on the way that it may take to land.
    fn room_s(&self, hull: &Hull) -> f64 {
        let needed = hull.speeds.iter().zip(self.limits.joint_accelerations());
        0.5 * needed.map(|(speed, acceleration)| speed / acceleration).fold(0.0, f64::max) + LANDINGS
    }

    /// Whether the arm could land straight on in joint space from each set-point.
    fn piece_can_land(&self, piece: &Piece) -> Result<(), Found> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count, and too many are cut")]
        let count = (piece.seconds / LANDINGS).ceil().clamp(1.0, 1e6) as u32;
        (0..=count).map(|place| f64::from(place) / f64::from(count)).try_for_each(|share| {
            let here = piece.at(share);
            self.can_land(&here.joints.0, &here.velocity).map_err(|exceeded| (exceeded, share))
        })
    }

    fn can_land(&self, joints: &[f64; 6], velocity: &[f64; 6]) -> Result<(), Exceeded> {
        // The last step before a set-point is half a period older than the speed at it.
        let last = std::array::from_fn(|joint| joints[joint] - velocity[joint] * LANDINGS);
        self.landing(&last, joints, LANDINGS).map_err(|(exceeded, _)| exceeded)
    }
}
