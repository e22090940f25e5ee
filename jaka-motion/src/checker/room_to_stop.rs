//! The room that an arm needs to stop after a set-point.

use super::limited_points::LimitedPoints;
use crate::beyond::{Exceeded, Found};
use crate::limits::AxisLimits;
use crate::piece::{Hull, Piece};

/// Joint ranges and regions within which an arm must be able to stop, straight on in joint space.
#[derive(Debug, Clone, Copy)]
pub(super) struct RoomToStop<'a> {
    pub(super) axes: &'a AxisLimits,
    pub(super) points: LimitedPoints<'a>,
}

/// How often room to stop is looked for on a piece, in seconds.
const PERIOD_S: f64 = 0.008;

impl RoomToStop<'_> {
    /// Checks the way to a stop after a set-point.
    pub(super) fn check_step(&self, last: &[f64; 6], target: &[f64; 6], period_s: f64) -> Result<(), Exceeded> {
        let count = self.axes.periods_to_stop(last, target, period_s);
        if count <= 1.0 {
            return Ok(());
        }
        // The steps are those of the set-point times 1 - k/N, for k from 1 to N.
        let steps = 0.5 * (count - 1.0);
        let end = std::array::from_fn(|index| target[index] + steps * (target[index] - last[index]));
        self.axes.check_positions(&end, target).map_err(Exceeded::at_stop)?;
        let on_way = self.points.check_joint_way(target, &end);
        on_way.map_err(|(exceeded, _)| self.points.further_at(&end, exceeded).at_stop())
    }

    /// Checks the ways to a stop from each set-point on a piece.
    pub(super) fn check_piece(&self, piece: &Piece) -> Result<(), Found> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count, and too many are cut")]
        let count = (piece.seconds / PERIOD_S).ceil().clamp(1.0, 1e6) as u32;
        (0..=count).map(|place| f64::from(place) / f64::from(count)).try_for_each(|share| {
            let here = piece.at(share);
            let joints = &here.joints.0;
            // The last step before a set-point is half a period older than the speed at it.
            let last = std::array::from_fn(|joint| joints[joint] - here.velocity[joint] * PERIOD_S);
            self.check_step(&last, joints, PERIOD_S).map_err(|exceeded| (exceeded, share))
        })
    }

    /// Seconds for which a joint could go on with its speed on the way that it may take to stop from a piece.
    pub(super) fn seconds(&self, hull: &Hull) -> f64 {
        self.axes.seconds_to_stop(hull) + PERIOD_S
    }
}
