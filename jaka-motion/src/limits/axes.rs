//! Limits of the six joints, and checks of positions and motions of joints against them.

use super::{ROUNDING, START_ROUNDING, rounded_up};
use crate::beyond::{Exceeded, Found};
#[cfg(feature = "generator")]
use crate::braking::Stop;
use crate::braking::{StopBound, StopRates};
use crate::piece::bernstein::beyond;
use crate::piece::{Hull, Piece};
use crate::speed::{JointSpeed, longest};

/// Range, speed, acceleration and jerk of each joint, in degrees, deg/s, deg/s² and deg/s³, and acceleration and jerk
/// of its stops.
///
/// Each range is within that of the model, and not empty; the other numbers are above 0.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AxisLimits {
    pub(super) min: [f64; 6],
    pub(super) max: [f64; 6],
    pub(super) speeds: [f64; 6],
    pub(super) accelerations: [f64; 6],
    pub(super) jerks: [f64; 6],
    pub(super) stop_accelerations: [f64; 6],
    pub(super) stop_jerks: [f64; 6],
}

/// Least time in which a stop reaches its acceleration, in seconds.
const LEAST_RAMP_S: f64 = 1e-4;
/// Rounding error that is allowed in the acceleration of a set-point, in deg/s²: the joint positions have some 16
/// digits.
const STEP_ROUNDING: f64 = 1e-6;
/// Rounding error that is allowed in the acceleration on a piece, in deg/s².
const PIECE_ROUNDING: f64 = 1e-7;

impl AxisLimits {
    /// Checks that all joints are within their ranges, or no further beyond than at the start of the motion.
    pub(crate) fn check_positions(&self, joints: &[f64; 6], start: &[f64; 6]) -> Result<(), Exceeded> {
        let (min, max) = (&self.min, &self.max);
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

    /// Checks the speed and acceleration of each joint, if the joint with the longest path has the requested ones.
    pub(crate) fn check_pace(&self, moved: &[f64; 6], asked: JointSpeed) -> Result<(), Exceeded> {
        let longest = longest(moved);
        let worst = |most: &[f64; 6]| {
            let over = |index: usize| moved[index].abs() / longest / most[index];
            let index = (0..6).fold(0, |worst, index| if over(index) > over(worst) { index } else { worst });
            (index, moved[index].abs() / longest, most[index])
        };
        let (index, part, limit_deg_s) = worst(&self.speeds);
        let speed_deg_s = part * asked.speed_deg_s;
        if speed_deg_s > rounded_up(limit_deg_s) {
            return Err(Exceeded::JointSpeed { joint: index + 1, speed_deg_s, limit_deg_s, near: None });
        }
        let (index, part, limit_deg_s2) = worst(&self.accelerations);
        let Some(acceleration) = asked.acceleration_deg_s2 else {
            return Err(Exceeded::NoAcceleration { most_deg_s2: limit_deg_s2 / part });
        };
        let acceleration_deg_s2 = part * acceleration;
        if acceleration_deg_s2 > rounded_up(limit_deg_s2) {
            return Err(Exceeded::JointAcceleration { joint: index + 1, acceleration_deg_s2, limit_deg_s2 });
        }
        Ok(())
    }

    /// Checks the mean speed of each joint over the period of a set-point, and its change from the period before. The
    /// limit of the change is the acceleration of motions, and that of stops for a joint that slows down.
    pub(crate) fn check_step(&self, moved: &[f64; 6], before: &[f64; 6], period_s: f64) -> Result<(), Exceeded> {
        let speeds = moved.map(|moved| moved.abs() / period_s);
        if let Some((joint, speed_deg_s, limit_deg_s)) = first_above(&speeds, &self.speeds, 0.0) {
            return Err(Exceeded::JointSpeed { joint, speed_deg_s, limit_deg_s, near: None });
        }
        self.check_change(moved, before, period_s)
    }

    /// Checks the change of the mean speed of each joint from one period to the next.
    pub(crate) fn check_change(&self, moved: &[f64; 6], before: &[f64; 6], period_s: f64) -> Result<(), Exceeded> {
        let changes: [f64; 6] = std::array::from_fn(|index| (moved[index] - before[index]).abs() / period_s / period_s);
        let limits = std::array::from_fn(|index| {
            let turned = (moved[index] * before[index].signum()).min(0.0).abs() / period_s / period_s;
            let slows = moved[index].abs() < before[index].abs() && turned <= self.accelerations[index];
            if slows { self.most(index) } else { self.accelerations[index] }
        });
        let above = first_above(&changes, &limits, STEP_ROUNDING);
        above.map_or(Ok(()), |(joint, acceleration_deg_s2, limit_deg_s2)| {
            Err(Exceeded::JointAcceleration { joint, acceleration_deg_s2, limit_deg_s2 })
        })
    }

    /// Returns the deceleration of a stop along a velocity of the joints in deg/s, if the tool centre point has an
    /// acceleration limit of its own. The deceleration is within those of stops, reached within these jerks, and never
    /// below that of motions.
    ///
    /// `tool` is the greatest share of the velocity that the tool may lose in a second.
    pub(crate) fn stop_rates(&self, velocity: &[f64; 6], jerks: &[f64; 6], tool: f64) -> StopRates {
        let [joints, motion] = [least_share(&self.stop_accelerations, velocity), self.motion_share(velocity)];
        let (share, bound) = match joints.min(tool) {
            stop if stop <= motion => (motion, StopBound::Motion),
            stop if stop < joints => (stop, StopBound::Tool),
            stop => (stop, StopBound::Joints),
        };
        StopRates { share, ramp_s: (share / least_share(jerks, velocity)).max(LEAST_RAMP_S), bound }
    }

    /// Returns the share of a velocity by which it may change in a second within the accelerations of motions.
    pub(crate) fn motion_share(&self, velocity: &[f64; 6]) -> f64 {
        least_share(&self.accelerations, velocity)
    }

    /// Returns the greatest acceleration of a joint: of motions or of stops.
    fn most(&self, index: usize) -> f64 {
        self.accelerations[index].max(self.stop_accelerations[index])
    }

    /// Checks ranges, speeds and accelerations on a piece, by its hull if that suffices.
    pub(crate) fn check_piece(&self, piece: &Piece, hull: &Hull) -> Result<(), Found> {
        let at_most = |found: &[f64; 6], limits: &[f64; 6]| {
            found.iter().zip(limits).all(|(found, limit)| *found <= rounded_up(*limit))
        };
        if self.contain(hull)
            && at_most(&hull.speeds, &self.speeds)
            && at_most(&hull.accelerations, &self.accelerations)
        {
            return Ok(());
        }
        if !piece.is_finite() {
            return Err((Exceeded::NotFinite, 0.0));
        }
        self.check_piece_positions(piece)?;
        self.check_piece_speeds(piece)?;
        self.check_piece_accelerations(piece)
    }

    fn check_piece_positions(&self, piece: &Piece) -> Result<(), Found> {
        for joint in 0..6 {
            let (min, max) = (self.min[joint], self.max[joint]);
            if let Some((share, position_deg)) = beyond(&piece.positions(joint), min - ROUNDING, max + ROUNDING) {
                let limit_deg = if position_deg > max { max } else { min };
                return Err((Exceeded::JointRange { joint: joint + 1, position_deg, limit_deg }, share));
            }
        }
        Ok(())
    }

    fn check_piece_speeds(&self, piece: &Piece) -> Result<(), Found> {
        for (joint, limit_deg_s) in self.speeds.into_iter().enumerate() {
            let most = rounded_up(limit_deg_s);
            if let Some((share, speed)) = beyond(&piece.speeds(joint), -most, most) {
                let speed_deg_s = speed.abs();
                return Err((Exceeded::JointSpeed { joint: joint + 1, speed_deg_s, limit_deg_s, near: None }, share));
            }
        }
        Ok(())
    }

    fn check_piece_accelerations(&self, piece: &Piece) -> Result<(), Found> {
        for (joint, limit_deg_s2) in self.accelerations.into_iter().enumerate() {
            let most = rounded_up(limit_deg_s2) + PIECE_ROUNDING;
            if let Some((share, acceleration)) = beyond(&piece.accelerations(joint), -most, most) {
                let (joint, acceleration_deg_s2) = (joint + 1, acceleration.abs());
                return Err((Exceeded::JointAcceleration { joint, acceleration_deg_s2, limit_deg_s2 }, share));
            }
        }
        Ok(())
    }

    /// Checks that each joint stops within its range.
    #[cfg(feature = "generator")]
    pub(crate) fn check_stops(&self, stops: &[Stop; 6]) -> Result<(), Exceeded> {
        let (min, max) = (&self.min, &self.max);
        for (index, stop) in stops.iter().enumerate() {
            let (least, most) = stop.span();
            for (end_deg, limit_deg) in [(least, min[index]), (most, max[index])] {
                if end_deg < min[index] - ROUNDING || end_deg > max[index] + ROUNDING {
                    return Err(Exceeded::LandingRange { joint: index + 1, end_deg, limit_deg });
                }
            }
        }
        Ok(())
    }

    /// Whether the bounds of a piece are within the ranges.
    pub(crate) fn contain(&self, hull: &Hull) -> bool {
        hull.is_between(&self.min, &self.max)
    }

    /// Whether no joint reaches an end of its range if it continues for some seconds from a piece.
    pub(crate) fn contain_for(&self, hull: &Hull, seconds: f64) -> bool {
        let room = hull.speeds.map(|speed| seconds * speed);
        let least = std::array::from_fn(|joint| self.min[joint] + room[joint]);
        hull.is_between(&least, &std::array::from_fn(|joint| self.max[joint] - room[joint]))
    }

    /// Returns the seconds at a rate until a joint is at the end of its range, and the limit that it would exceed;
    /// `None` if it does not move.
    #[cfg(feature = "generator")]
    pub(crate) fn room(&self, index: usize, position: f64, rate: f64) -> Option<(f64, Exceeded)> {
        let limit_deg = if rate > 0.0 { self.max[index] } else { self.min[index] };
        let room = (limit_deg - position) / rate;
        let exceeded = Exceeded::LandingRange { joint: index + 1, end_deg: position, limit_deg };
        room.is_finite().then_some((room.max(0.0), exceeded))
    }
}

fn least_share(of: &[f64; 6], velocity: &[f64; 6]) -> f64 {
    (0..6).map(|index| of[index] / velocity[index].abs()).fold(f64::MAX, f64::min)
}

/// Returns the joint that exceeds its limit by the largest factor, with its value and its limit.
fn first_above(values: &[f64; 6], limits: &[f64; 6], rounding: f64) -> Option<(usize, f64, f64)> {
    let above = |index: &usize| values[*index] > rounded_up(limits[*index]) + rounding;
    let factor = |index: &usize| values[*index] / limits[*index];
    let index = (0..6).filter(above).max_by(|one, other| factor(one).total_cmp(&factor(other)))?;
    Some((index + 1, values[index], limits[index]))
}
