//! The ways from one point of a trajectory to the next.

use super::corner_path::TURN_MM;
use super::line::Line;
use super::plan::{Bounds, Corner};
use crate::checker::Arm;

/// A way straight in joint space, or on a straight line of the tool.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Leg {
    /// The number of the way-point at its start, from 1.
    pub(super) after: usize,
    /// In degrees, of all joints together; or in mm, with [`TURN_MM`] for each radian.
    pub(super) length: f64,
    /// The joints at its start.
    pub(super) start: [f64; 6],
    pub(super) path: LegPath,
}

/// Path of a leg, for each unit of its length.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum LegPath {
    Joints([f64; 6]),
    Tool(Line),
}

/// What a trajectory is planned with.
#[derive(Debug, Clone, Copy)]
pub(super) struct Budget {
    /// In deg/s, deg/s² and deg/s³.
    pub(super) speeds: [f64; 6],
    pub(super) accelerations: [f64; 6],
    pub(super) jerks: [f64; 6],
    /// In mm/s.
    pub(super) tcp_speed: f64,
}

/// How far a corner may be rounded: in mm, in degrees of the tool's turn, in degrees of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tolerances {
    pub(super) mm: f64,
    pub(super) turn_deg: f64,
    pub(super) joint_deg: f64,
}

/// What was found of a leg.
#[derive(Debug, Clone, Copy)]
pub(super) struct Survey {
    pub(super) bounds: Bounds,
    /// How the joints move at both ends for each unit of the length, in degrees.
    ends: [[f64; 6]; 2],
}

/// The share of accelerations and jerks for the bends of the joints' ways along a line.
const CURVING: f64 = 0.3;
/// A corner's way is this many times how far it is from the point, where the directions differ by 1: its speeds go as
/// `3x² - 2x³`.
const CORNER_WAY: f64 = 32.0 / 3.0;
/// Directions that differ by less than this are one.
const STRAIGHT_ON: f64 = 1e-9;
/// The cosine of the angle, some 177 degrees, beyond which a way turns back.
const TURNS_BACK: f64 = -0.9986;
/// How far apart places on a line are at which its speed is limited, in the unit of its length.
const PLACES: f64 = 25.0;
/// How far apart places on a way in joint space are at which the speed of the tool centre point is looked at, in
/// degrees.
const TCP_PLACES: f64 = 10.0;

impl Leg {
    pub(super) fn joints(after: usize, from: [f64; 6], to: [f64; 6]) -> Self {
        let moved: [f64; 6] = std::array::from_fn(|joint| to[joint] - from[joint]);
        let length = moved.iter().map(|moved| moved * moved).sum::<f64>().sqrt();
        Self { after, length, start: from, path: LegPath::Joints(moved.map(|moved| moved / length)) }
    }

    /// How fast it may be, and how the joints move at its ends.
    pub(super) fn survey(&self, budget: &Budget, arm: &Arm) -> Survey {
        match &self.path {
            LegPath::Joints(direction) => {
                Survey { bounds: self.joint_bounds(direction, budget, arm), ends: [*direction; 2] }
            }
            LegPath::Tool(line) => self.survey_line(line, budget),
        }
    }

    fn joint_bounds(&self, direction: &[f64; 6], budget: &Budget, arm: &Arm) -> Bounds {
        let least = |limits: &[f64; 6]| smallest(|joint| limits[joint] / direction[joint].abs());
        let bounds = Bounds {
            speed: least(&budget.speeds),
            acceleration: least(&budget.accelerations),
            jerk: least(&budget.jerks),
        };
        if arm.radii().tcp_rate_at_most(direction) * bounds.speed <= budget.tcp_speed {
            return bounds;
        }
        let places = places(self.length, TCP_PLACES, [1, 8]);
        let rates = places.map(|way| arm.tcp_rate(&self.joints_at(direction, way), direction));
        Bounds { speed: bounds.speed.min(budget.tcp_speed / rates.fold(0.0, f64::max)), ..bounds }
    }

    fn survey_line(&self, line: &Line, budget: &Budget) -> Survey {
        let speed = budget.tcp_speed / line.direction.moved.norm();
        let mut bounds = Bounds { speed, acceleration: f64::INFINITY, jerk: f64::INFINITY };
        let mut ends = [None; 2];
        for way in places(self.length, PLACES, [2, 100]) {
            let there = line.at(way);
            bounds = bounds.and(tool_bounds(&there.velocity, &there.acceleration, budget));
            ends = [ends[0].or(Some(there.velocity)), Some(there.velocity)];
        }
        Survey { bounds, ends: ends.map(Option::unwrap_or_default) }
    }

    /// How the corner to the next leg may be rounded, for what was found of both: not at all where a line meets a way
    /// in joints, or where the way turns back.
    pub(super) fn corner(&self, next: &Self, found: [&Survey; 2], tolerances: &Tolerances, budget: &Budget) -> Corner {
        let (way, share, cosine) = match (&self.path, &next.path) {
            (LegPath::Joints(before), LegPath::Joints(after)) => {
                let cosine = before.iter().zip(after).map(|(before, after)| before * after).sum();
                let most = largest(|joint| (after[joint] - before[joint]).abs());
                (within(tolerances.joint_deg, most), 1.0, cosine)
            }
            (LegPath::Tool(Line { direction: before, .. }), LegPath::Tool(Line { direction: after, .. })) => {
                let cosine = before.moved.dot(&after.moved) + before.turned.dot(&after.turned) * TURN_MM * TURN_MM;
                let moved = within(tolerances.mm, (after.moved - before.moved).norm());
                let turned = within(tolerances.turn_deg.to_radians(), (after.turned - before.turned).norm());
                (moved.min(turned), 1.0 - CURVING, cosine)
            }
            _ => return Corner::STOP,
        };
        let turned = |joint: usize| (found[1].ends[0][joint] - found[0].ends[1][joint]).abs();
        if cosine < TURNS_BACK {
            return Corner::STOP;
        }
        if largest(turned) < STRAIGHT_ON {
            return Corner::NONE;
        }
        let accelerating = largest(|joint| 1.5 * turned(joint) / budget.accelerations[joint] / share);
        let jerking = largest(|joint| 6.0 * turned(joint) / budget.jerks[joint] / share).sqrt();
        Corner { speed: f64::INFINITY, seconds: [accelerating, jerking] }.within(way)
    }

    /// Where the joints are after a way on a leg in joint space.
    pub(super) fn joints_at(&self, direction: &[f64; 6], way: f64) -> [f64; 6] {
        std::array::from_fn(|joint| self.start[joint] + way * direction[joint])
    }
}

/// How fast the tool may be at a place where the joints move so for each unit of the way, and change that so.
fn tool_bounds(first: &[f64; 6], second: &[f64; 6], budget: &Budget) -> Bounds {
    let Budget { speeds, accelerations, jerks, .. } = budget;
    let speed = smallest(|joint| {
        let curving = (CURVING * accelerations[joint] / second[joint].abs()).sqrt();
        curving.min(speeds[joint] / first[joint].abs())
    });
    let left = |limits: &[f64; 6]| smallest(|joint| (1.0 - CURVING) * limits[joint] / first[joint].abs());
    Bounds { speed, acceleration: left(accelerations), jerk: left(jerks) }
}

/// The longest way of a corner that is no further from its point, for directions that differ so.
fn within(tolerance: f64, differ: f64) -> f64 {
    if differ < STRAIGHT_ON { f64::INFINITY } else { CORNER_WAY * tolerance / differ }
}

/// Ways from the start to the end of a length, so far apart or less, in a number of parts that is between two.
fn places(length: f64, apart: f64, [least, most]: [u32; 2]) -> impl Iterator<Item = f64> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count")]
    let count = ((length / apart).ceil() as u32).clamp(least, most);
    (0..=count).map(move |place| f64::from(place) / f64::from(count) * length)
}

fn smallest(of: impl Fn(usize) -> f64) -> f64 {
    (0..6).map(of).fold(f64::INFINITY, f64::min)
}

fn largest(of: impl Fn(usize) -> f64) -> f64 {
    (0..6).map(of).fold(0.0, f64::max)
}
