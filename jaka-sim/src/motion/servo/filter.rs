//! Filter of servo mode (4.60), between the set-points and the drives.
//!
//! The document and the vendor's other texts name each filter, but do not describe its computation: this module chooses
//! it.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use jaka_motion::{Model, Transform};
use jaka_proto::messages::servo::SetServoMoveFilter;

use super::cartesian::Cartesian;
use super::tracker::Tracker;
use super::{ServoReference, Space};
use crate::clock::CYCLE;
use crate::motion::Joints;

/// Smallest number of buffered points; fewer fail (vendor's texts).
const FEWEST_POINTS: i64 = 3;

/// Greatest window width, which is 8 s.
const WIDEST: i64 = 1000;

/// Distance from its set-point, in degrees, from which a joint reaches it in the next cycle.
const NEAR: f64 = 1e-7;

/// Tolerance within which two positions are equal, in degrees.
const SAME: f64 = 1e-9;

/// Filter and its state.
#[derive(Debug, Clone)]
pub(crate) enum Filter {
    /// Unchanged set-points.
    Off,
    /// First-order low pass, which moves by this share of the remaining distance in each cycle.
    LowPass(f64),
    /// Limits for each joint.
    Limits(Box<[Tracker<1>; 6]>, Joints),
    /// Mean of the positions of the last cycles.
    Mean(VecDeque<Joints>),
    /// Limits for the tool centre point.
    Cartesian(Box<Cartesian>),
}

/// Whether the arm can follow with this filter. It cannot with a limit or a cut-off frequency of zero, or with fewer
/// than 3 points.
pub(crate) fn can_follow(settings: &SetServoMoveFilter) -> bool {
    match *settings {
        SetServoMoveFilter::JointLowPass { cutoff_frequency, .. } => cutoff_frequency > 0.0,
        SetServoMoveFilter::JointNonlinear {
            max_joint_speed: v, max_joint_acceleration: a, max_joint_jerk: j, ..
        } => v.min(a).min(j) > 0.0,
        SetServoMoveFilter::JointMean { window_width: points, .. }
        | SetServoMoveFilter::SpeedLookahead { buffer_size: points, .. } => points >= FEWEST_POINTS,
        SetServoMoveFilter::CartesianNonlinear {
            max_rotation_speed: vr,
            max_rotation_acceleration: ar,
            max_rotation_jerk: jr,
            max_translation_speed: vp,
            max_translation_acceleration: ap,
            max_translation_jerk: jp,
            ..
        } => [vr, ar, jr, vp, ap, jp].into_iter().fold(f64::INFINITY, f64::min) > 0.0,
        _ => true,
    }
}

impl Filter {
    /// Creates the filter for an arm at rest.
    pub(crate) fn new(settings: &SetServoMoveFilter, at: Joints, tool: Transform, model: &Model) -> Self {
        match *settings {
            SetServoMoveFilter::JointLowPass { cutoff_frequency, .. } => {
                Self::LowPass(-(-TAU * cutoff_frequency * CYCLE.as_secs_f64()).exp_m1())
            }
            SetServoMoveFilter::JointNonlinear { max_joint_speed, max_joint_acceleration, max_joint_jerk, .. } => {
                let tracker = Tracker::new(max_joint_speed, max_joint_acceleration, max_joint_jerk);
                Self::Limits(Box::new([tracker; 6]), at)
            }
            // The document describes filter 5 in the words of filter 3. No text describes the effect of their
            // coefficients.
            SetServoMoveFilter::JointMean { window_width: points, .. }
            | SetServoMoveFilter::SpeedLookahead { buffer_size: points, .. } => {
                Self::Mean((0..points.clamp(1, WIDEST)).map(|_| at).collect())
            }
            SetServoMoveFilter::CartesianNonlinear {
                max_rotation_speed,
                max_rotation_acceleration,
                max_rotation_jerk,
                max_translation_speed,
                max_translation_acceleration,
                max_translation_jerk,
                ..
            } => Self::Cartesian(Box::new(Cartesian::new(
                Tracker::new(max_translation_speed, max_translation_acceleration, max_translation_jerk),
                Tracker::new(max_rotation_speed, max_rotation_acceleration, max_rotation_jerk),
                model.forward(at) * tool,
                tool,
            ))),
            _ => Self::Off,
        }
    }

    /// Computes one cycle, and returns the commanded joint position; `None` if the arm cannot reach it.
    pub(super) fn next(&mut self, joints: Joints, reference: &ServoReference, model: &Model) -> Option<Joints> {
        let to = reference.joints;
        Some(match self {
            Self::Off => to,
            Self::LowPass(share) => std::array::from_fn(|i| {
                let left = to[i] - joints[i];
                if left.abs() < NEAR { to[i] } else { joints[i] + left * *share }
            }),
            Self::Limits(trackers, before) => {
                let from = std::mem::replace(before, to);
                std::array::from_fn(|i| {
                    let step = trackers[i].next([joints[i] - from[i]], [to[i] - from[i]]);
                    if step.arrives { to[i] } else { joints[i] + step.by[0] }
                })
            }
            Self::Mean(window) => {
                window.pop_front();
                window.push_back(to);
                #[expect(clippy::cast_precision_loss, reason = "it is at most 1000")]
                let count = window.len() as f64;
                // Sums differences, so that a constant position is met exactly.
                std::array::from_fn(|i| to[i] + window.iter().map(|at| at[i] - to[i]).sum::<f64>() / count)
            }
            Self::Cartesian(filter) => match reference.space {
                Space::Pose => return filter.next(joints, to, model),
                Space::Joints => filter.pass(to, model),
            },
        })
    }

    /// Whether the filter has no further effect on a constant reference.
    pub(super) fn is_settled(&self, joints: Joints, reference: &ServoReference) -> bool {
        let is_there = |at: &Joints| at.iter().zip(&reference.joints).all(|(at, to)| (at - to).abs() < SAME);
        is_there(&joints)
            && match self {
                Self::Off | Self::LowPass(_) => true,
                Self::Limits(trackers, before) => is_there(before) && trackers.iter().all(Tracker::is_at_rest),
                Self::Mean(window) => window.iter().all(is_there),
                Self::Cartesian(filter) => filter.is_at_rest(),
            }
    }
}
