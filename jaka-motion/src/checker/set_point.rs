//! Set-points of a servo session.

use nalgebra::Isometry3;

use super::pace::above_zero;
use super::{Checker, rounded_up};
use crate::beyond::{Exceeded, Found};

/// What rounding may add to an acceleration, in deg/s²: the joint positions have some 16 digits.
const ACCELERATION_ROUNDING: f64 = 1e-6;

impl Checker {
    pub(super) fn set_point(
        &self,
        [before, last]: [&[f64; 6]; 2],
        target: &[f64; 6],
        period_s: f64,
    ) -> Result<(), Found> {
        let at_end = |exceeded| (exceeded, 1.0);
        above_zero("period", period_s).map_err(at_end)?;
        self.within_ranges(target, last).map_err(at_end)?;
        let moved: [f64; 6] = std::array::from_fn(|index| target[index] - last[index]);
        let moved_before: [f64; 6] = std::array::from_fn(|index| last[index] - before[index]);
        self.joint_steps(&moved, period_s).map_err(at_end)?;
        self.joint_changes(&moved, &moved_before, period_s).map_err(at_end)?;
        self.tcp_step(last, target, period_s).map_err(at_end)?;
        self.regions_on_joint_way(last, target)?;
        self.landing(last, target, period_s)
    }

    pub(super) fn pose_set_point(
        &self,
        before: [&[f64; 6]; 2],
        target: &Isometry3<f64>,
        period_s: f64,
    ) -> Result<[f64; 6], Found> {
        let at_end = |exceeded| (exceeded, 1.0);
        let joints = self.nearest(target, before[1]).map_err(at_end)?;
        self.set_point(before, &joints, period_s)?;
        let model = self.limits.model();
        let [last, here] = [before[1], &joints].map(|joints| model.signed_distances(&model.links.frames(joints)));
        self.distances_kept(&last.map(f64::abs), &here.map(f64::abs)).map_err(at_end)?;
        self.same_sides(&last, &here).map_err(at_end)?;
        Ok(joints)
    }

    fn joint_steps(&self, moved: &[f64; 6], period_s: f64) -> Result<(), Exceeded> {
        let speeds = moved.map(|moved| moved.abs() / period_s);
        first_above(&speeds, self.limits.joint_speeds(), 0.0).map_or(Ok(()), |(joint, speed_deg_s, limit_deg_s)| {
            Err(Exceeded::JointSpeed { joint, speed_deg_s, limit_deg_s, near: None })
        })
    }

    fn joint_changes(&self, moved: &[f64; 6], before: &[f64; 6], period_s: f64) -> Result<(), Exceeded> {
        let changes: [f64; 6] = std::array::from_fn(|index| (moved[index] - before[index]).abs() / period_s / period_s);
        let above = first_above(&changes, self.limits.joint_accelerations(), ACCELERATION_ROUNDING);
        above.map_or(Ok(()), |(joint, acceleration_deg_s2, limit_deg_s2)| {
            Err(Exceeded::JointAcceleration { joint, acceleration_deg_s2, limit_deg_s2 })
        })
    }

    fn tcp_step(&self, last: &[f64; 6], target: &[f64; 6], period_s: f64) -> Result<(), Exceeded> {
        let Some(limit_mm_s) = self.limits.tcp_speed() else { return Ok(()) };
        let moved = self.tcp(target).translation.vector - self.tcp(last).translation.vector;
        let speed_mm_s = moved.norm() / period_s;
        if speed_mm_s > rounded_up(limit_mm_s) {
            return Err(Exceeded::TcpSpeed { speed_mm_s, limit_mm_s });
        }
        Ok(())
    }
}

/// The joint that is above its limit by the largest factor, with both.
fn first_above(values: &[f64; 6], limits: &[f64; 6], rounding: f64) -> Option<(usize, f64, f64)> {
    let above = |index: &usize| values[*index] > rounded_up(limits[*index]) + rounding;
    let factor = |index: &usize| values[*index] / limits[*index];
    let index = (0..6).filter(above).max_by(|one, other| factor(one).total_cmp(&factor(other)))?;
    Some((index + 1, values[index], limits[index]))
}
