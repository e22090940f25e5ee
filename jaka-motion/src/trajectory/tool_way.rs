//! The way of the tool on lines and around their corners.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3, Vector6};

use crate::checker::{Checker, Led};
use crate::piece::{Piece, Sample};

/// How a tool goes straight on, for each unit of the way: mm, and radians about its own axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Direction {
    pub(super) moved: Vector3<f64>,
    pub(super) turned: Vector3<f64>,
}

/// A stretch of the tool's way, from two directions at a frame: what is left of the one, and what is done of the other.
#[derive(Debug, Clone, Copy)]
pub(super) struct ToolWay {
    pub(super) frame: Isometry3<f64>,
    pub(super) along: [(Direction, Course); 2],
    pub(super) seconds: f64,
}

/// How far the tool is along a direction, over a stretch: its speed goes from one to another as `3x² - 2x³`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Course {
    pub(super) from: f64,
    pub(super) speeds: [f64; 2],
}

/// How far the joints may take the tool from its way, in mm and degrees.
pub(super) const OFF_WAY: (f64, f64) = (0.005, 0.001);
/// The longest way between two places at which the joints are computed, in the unit of the way.
const LONGEST: f64 = 50.0;
/// The least share of a stretch between two places.
const LEAST: f64 = 1e-6;

impl Course {
    /// Not along a direction at all.
    pub(super) const NONE: Self = Self { from: 0.0, speeds: [0.0; 2] };

    /// Way, speed and acceleration at a share of the seconds.
    fn at(&self, share: f64, seconds: f64) -> [f64; 3] {
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

impl ToolWay {
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

    /// Adds the pieces that lead the tool along, from the joints near `last`, and returns those at the end; none where they are lost.
    pub(super) fn follow(
        &self,
        checker: &Checker,
        start_s: f64,
        last: [f64; 6],
        pieces: &mut Vec<Piece>,
    ) -> Option<[f64; 6]> {
        let mut here = checker.led(&self.at(0.0), &last)?;
        let way: f64 = self.along.iter().map(|(_, course)| 0.5 * (course.speeds[0] + course.speeds[1])).sum();
        let longest = (LONGEST / (way * self.seconds)).min(1.0);
        let (mut share, mut step) = (0.0, longest);
        while share < 1.0 {
            let next_share = if share + 1.01 * step >= 1.0 { 1.0 } else { share + step };
            let seconds = (next_share - share) * self.seconds;
            match self.piece(checker, [share, next_share], start_s + share * self.seconds, &here) {
                Some((piece, next)) => {
                    pieces.push(piece);
                    (here, share, step) = (next, next_share, longest.min(2.0 * step));
                }
                None if next_share - share < LEAST || seconds < LEAST => return None,
                None => step = 0.5 * (next_share - share),
            }
        }
        Some(here.joints.0)
    }

    /// The piece between two shares, if it leads the tool along its way.
    fn piece(&self, checker: &Checker, [from, to]: [f64; 2], start_s: f64, here: &Sample) -> Option<(Piece, Sample)> {
        let seconds = (to - from) * self.seconds;
        let guess = std::array::from_fn(|joint| {
            here.joints.0[joint] + seconds * (here.velocity[joint] + 0.5 * seconds * here.acceleration[joint])
        });
        let next = checker.led(&self.at(to), &guess)?;
        let piece = Piece::between(start_s, seconds, here, &next);
        let is_on_way = |part: f64| {
            let (wanted, found) = (self.at(from + part * (to - from)).tool, checker.tool(&piece.joints(part)));
            let moved = (wanted.translation.vector - found.translation.vector).norm();
            moved <= OFF_WAY.0 && wanted.rotation.angle_to(&found.rotation).to_degrees() <= OFF_WAY.1
        };
        [0.5, 0.25, 0.75].into_iter().all(is_on_way).then_some((piece, next))
    }
}

fn together(moved: Vector3<f64>, turned: Vector3<f64>) -> Vector6<f64> {
    Vector6::new(moved.x, moved.y, moved.z, turned.x, turned.y, turned.z)
}
