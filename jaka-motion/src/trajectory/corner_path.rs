//! The path of the tool around the corners of lines.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3, Vector6};

use crate::checker::{Arm, Led};
use crate::piece::{Piece, Sample};

/// How a tool goes straight on, for each unit of the way: mm, and radians about its own axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Direction {
    pub(super) moved: Vector3<f64>,
    pub(super) turned: Vector3<f64>,
}

/// A stretch of the tool's path, from two directions at a frame: what is left of the one, and what is done of the
/// other.
#[derive(Debug, Clone, Copy)]
pub(super) struct CornerPath {
    pub(super) frame: Isometry3<f64>,
    pub(super) along: [(Direction, SpeedRamp); 2],
    pub(super) seconds: f64,
}

/// How far the tool is along a direction, over a stretch: its speed goes from one to another as `3x² - 2x³`.
#[derive(Debug, Clone, Copy)]
pub(super) struct SpeedRamp {
    pub(super) from: f64,
    pub(super) speeds: [f64; 2],
}

/// How far the joints may take the tool from its way, in mm and degrees.
pub(super) const OFF_WAY: (f64, f64) = (0.005, 0.001);
/// The least share of a stretch between two places.
const LEAST: f64 = 1e-6;

/// The length in mm that counts as much as a turn of the tool by one radian.
pub(super) const TURN_MM: f64 = 200.0;

impl Direction {
    /// From one place to another, and how long the way is, in mm with [`TURN_MM`] for each radian.
    pub(super) fn between(from: &Isometry3<f64>, to: &Isometry3<f64>) -> (Self, f64) {
        let moved = to.translation.vector - from.translation.vector;
        let turned = (from.rotation.inverse() * to.rotation).scaled_axis();
        let length = moved.norm().hypot(turned.norm() * TURN_MM);
        (Self { moved: moved / length, turned: turned / length }, length)
    }
}

impl SpeedRamp {
    /// Whether it has one speed.
    pub(super) fn is_even(&self) -> bool {
        self.speeds[0].total_cmp(&self.speeds[1]).is_eq()
    }

    /// Way, speed and acceleration at a share of the seconds.
    pub(super) fn at(&self, share: f64, seconds: f64) -> [f64; 3] {
        let [first, last] = self.speeds;
        let x = share;
        let (way, speed, change) = (x * x * x * (1.0 - 0.5 * x), x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x));
        [
            self.from + seconds * (first * x + (last - first) * way),
            first + (last - first) * speed,
            (last - first) * change / seconds,
        ]
    }
}

impl CornerPath {
    /// How the tool moves at a share of the time.
    pub(super) fn at(&self, share: f64) -> Led {
        let [(one, first), (other, second)] = self.along;
        let (first, second) = (first.at(share, self.seconds), second.at(share, self.seconds));
        let turn = UnitQuaternion::from_scaled_axis(one.turned * first[0]);
        let [before, after] = [self.frame.rotation * one.turned, self.frame.rotation * (turn * other.turned)];
        let (spin, swing) = (before * first[1], after * second[1]);
        let moved = |order: usize| one.moved * first[order] + other.moved * second[order];
        let turned = before * first[2] + after * second[2] + spin.cross(&swing);
        let rotation = self.frame.rotation * turn * UnitQuaternion::from_scaled_axis(other.turned * second[0]);
        let place = self.frame.translation.vector + moved(0);
        Led {
            tool: Isometry3::from_parts(Translation3::from(place), rotation),
            velocity: together(moved(1), spin + swing),
            acceleration: together(moved(2), turned),
        }
    }

    /// Adds the pieces that lead the tool along, between what the joints do at both ends; none where they are lost.
    pub(super) fn follow(&self, arm: &Arm, [first, last]: [Sample; 2], pieces: &mut Vec<Piece>) -> Option<()> {
        let mut here = first;
        in_steps(1.0, 1.0, least_share(self.seconds), |[from, to]| {
            let seconds = (to - from) * self.seconds;
            let next = if to < 1.0 { arm.led(&self.at(to), &gone_on(&here, seconds))? } else { last };
            let piece = Piece::between(0.0, seconds, &here, &next);
            let is_on_way =
                |part: f64| is_off_at_most(arm, &piece.joints(part), &self.at(from + part * (to - from)).tool, OFF_WAY);
            let is_on_way = [0.5, 0.25, 0.75].into_iter().all(is_on_way);
            is_on_way.then(|| {
                here = next;
                pieces.push(piece);
            })
        })
    }
}

/// Whether joints bring the tool to a place, within mm and degrees.
pub(super) fn is_off_at_most(arm: &Arm, joints: &[f64; 6], tool: &Isometry3<f64>, most: (f64, f64)) -> bool {
    let found = arm.tcp(joints);
    let moved = (tool.translation.vector - found.translation.vector).norm();
    moved <= most.0 && tool.rotation.angle_to(&found.rotation).to_degrees() <= most.1
}

/// Goes from 0 to an end in steps that `take` takes, each as long as it can be and at most the longest; none where it
/// takes not even the least.
pub(super) fn in_steps(end: f64, longest: f64, least: f64, mut take: impl FnMut([f64; 2]) -> Option<()>) -> Option<()> {
    let (mut at, mut step) = (0.0, longest);
    while at < end {
        let next = if at + 1.01 * step >= end { end } else { at + step };
        match take([at, next]) {
            Some(()) => (at, step) = (next, longest.min(2.0 * step)),
            None if next - at <= least => return None,
            None => step = 0.5 * (next - at),
        }
    }
    Some(())
}

/// The least share of a stretch of so many seconds between two places: neither itself nor its time is too small.
pub(super) fn least_share(seconds: f64) -> f64 {
    LEAST.max(LEAST / seconds)
}

/// The joints after some seconds if they go on so.
fn gone_on(here: &Sample, seconds: f64) -> [f64; 6] {
    std::array::from_fn(|joint| {
        here.joints.0[joint] + seconds * (here.velocity[joint] + 0.5 * seconds * here.acceleration[joint])
    })
}

pub(super) fn together(moved: Vector3<f64>, turned: Vector3<f64>) -> Vector6<f64> {
    Vector6::new(moved.x, moved.y, moved.z, turned.x, turned.y, turned.z)
}
