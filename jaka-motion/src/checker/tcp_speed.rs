//! Check of the speed of the tool centre point.

use super::Checker;
use super::arm::Arm;
use super::radii::PieceEnd;
use super::radii::{LEAST_STEP, PointMotion};
use crate::beyond::{Exceeded, Found};
#[cfg(feature = "generator")]
use crate::braking::{Stop, longest_stop};
#[cfg(feature = "generator")]
use crate::limits::START_ROUNDING;
use crate::limits::rounded_up;
use crate::model::Point;
use crate::piece::{Hull, Piece};
use crate::speed::{JointSpeed, longest};

/// Speed limit for the tool centre point of an arm.
#[derive(Debug, Clone, Copy)]
pub(super) struct TcpSpeedLimit<'a> {
    pub(super) arm: &'a Arm,
    /// Limit in mm/s, if there is one.
    pub(super) limit_mm_s: Option<f64>,
}

/// Greatest relative change of the speed between two places on a piece, near the limit.
const SPEED_STEP: f64 = 1e-3;
/// Greatest number of places on one piece at which the speed is compared.
const MOST_STEPS: usize = 1_000_000;
/// Greatest number of periods of a stop in which the speed is compared.
#[cfg(feature = "generator")]
const MOST_PERIODS: f64 = 4096.0;

impl TcpSpeedLimit<'_> {
    /// Checks one speed.
    pub(super) fn check(&self, speed_mm_s: f64) -> Result<(), Exceeded> {
        let above = self.limit_mm_s.filter(|limit_mm_s| speed_mm_s > rounded_up(*limit_mm_s));
        above.map_or(Ok(()), |limit_mm_s| Err(Exceeded::TcpSpeed { speed_mm_s, limit_mm_s }))
    }

    /// Checks the mean speed over the period of a set-point.
    pub(super) fn check_step(&self, last: &[f64; 6], target: &[f64; 6], period_s: f64) -> Result<(), Exceeded> {
        let Some(_) = self.limit_mm_s else { return Ok(()) };
        self.check(self.arm.tcp_distance(target, last) / period_s)
    }

    /// Checks the speed on a straight path in joint space.
    pub(super) fn check_joint_way(&self, from: &[f64; 6], moved: &[f64; 6], asked: JointSpeed) -> Result<(), Found> {
        let Some(limit_mm_s) = self.limit_mm_s else { return Ok(()) };
        let seconds = longest(moved) / asked.speed_deg_s;
        let (most, motion) = (limit_mm_s * seconds, self.arm.radii().motion_of_path(Point::Tcp, moved));
        if motion.rate_mm <= most {
            return Ok(());
        }
        let mut share = 0.0;
        loop {
            let here = std::array::from_fn(|index| from[index] + share * moved[index]);
            let rate = self.arm.tcp_rate(&here, moved);
            if rate > rounded_up(most) {
                return Err((Exceeded::TcpSpeed { speed_mm_s: rate / seconds, limit_mm_s }, share));
            }
            if share >= 1.0 {
                return Ok(());
            }
            let step = ((1.0 + Checker::AMOUNT_SPEED) * most - rate) / motion.bend_mm;
            if step.is_nan() || step < LEAST_STEP {
                return Err((Exceeded::TooLong, share));
            }
            share = f64::min(share + step, 1.0);
        }
    }

    /// Checks the speed on a piece, by bounds if these suffice.
    pub(super) fn check_piece(&self, piece: &Piece, hull: &Hull, ends: &[PieceEnd; 2]) -> Result<(), Found> {
        let Some(limit_mm_s) = self.limit_mm_s else { return Ok(()) };
        let radii = self.arm.radii();
        let PointMotion { rate_mm, bend_mm } = radii.motion_on_piece(Point::Tcp, piece, hull);
        if rate_mm <= limit_mm_s * piece.seconds || radii.tcp_speed_at_most(piece, hull, ends) <= limit_mm_s {
            return Ok(());
        }
        // Greatest change of the speed over the whole piece.
        let change = bend_mm / piece.seconds;
        let mut share = 0.0;
        for _ in 0..MOST_STEPS {
            let here = piece.at(share);
            let speed_mm_s = self.arm.tcp_rate(&here.joints.0, &here.velocity);
            self.check(speed_mm_s).map_err(|exceeded| (exceeded, share))?;
            if share >= 1.0 {
                return Ok(());
            }
            share = f64::min(share + (limit_mm_s - speed_mm_s).max(SPEED_STEP * limit_mm_s) / change, 1.0);
        }
        Err((Exceeded::TooLong, share))
    }

    /// Checks the mean speed over each period from the last set-point to rest, and that the tool centre point travels
    /// no more than `limit_mm`.
    #[cfg(feature = "generator")]
    pub(super) fn check_stops(
        &self,
        last: &[f64; 6],
        stops: &[Stop; 6],
        period_s: f64,
        limit_mm: f64,
    ) -> Result<(), Exceeded> {
        let Some(limit_mm_s) = self.limit_mm_s else { return Ok(()) };
        let (seconds, mut done, mut way_mm) = (longest_stop(stops), 0.0, 0.0);
        if seconds > MOST_PERIODS * period_s {
            return Err(Exceeded::TooLong);
        }
        let mut before = self.arm.point(Point::Tcp, last);
        loop {
            let here = self.arm.point(Point::Tcp, &stops.map(|stop| stop.at(done).position));
            let step_mm = (here - before).norm();
            let speed_mm_s = step_mm / period_s;
            way_mm += step_mm;
            if speed_mm_s > rounded_up(limit_mm_s) + START_ROUNDING / period_s {
                return Err(Exceeded::TcpSpeed { speed_mm_s, limit_mm_s });
            }
            if way_mm > limit_mm {
                return Err(Exceeded::LandingWay { way_mm, limit_mm });
            }
            if done >= seconds {
                return Ok(());
            }
            (before, done) = (here, done + period_s);
        }
    }
}
