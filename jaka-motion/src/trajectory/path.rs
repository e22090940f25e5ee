//! Path of the joints, before it has times.

use nalgebra::Vector3;

use super::curve_path::Space;
use super::leg::{Leg, LegPath, LegSpeeds, Tolerances};
use super::line::TURN_MM;
use super::{Passing, TrajectoryError};
use crate::checker::{Arm, Checker};
use crate::piece::{Piece, Sample};

/// Path of the joints: polynomials of a parameter in place of time.
///
/// Between two stops the first and second derivatives of the joints are continuous. The parameter is about the length
/// of the joints' path in degrees.
#[derive(Debug, Default)]
pub(super) struct Path {
    pub(super) pieces: Vec<PathPiece>,
    /// Way-points in their order, without the first.
    pub(super) marks: Vec<Mark>,
}

/// Part of a path.
#[derive(Debug, Clone)]
pub(super) struct PathPiece {
    pub(super) joints: Piece,
    pub(super) shape: PieceShape,
    /// Number of the way-point before it, from 1.
    pub(super) after: usize,
    /// Whether the path rests at its end.
    pub(super) stops: bool,
    pub(super) speeds: LegSpeeds,
}

/// Form of a part of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PieceShape {
    /// Straight line in joint space.
    Straight,
    /// Curve, such as that of the joints on a line of the tool.
    Curve,
    /// Rounded corner.
    Corner,
}

/// Parameter at which a way-point is passed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mark {
    pub(super) at: f64,
    pub(super) passing: Passing,
}

/// Leg with the parameter of the path.
struct Scaled<'l> {
    leg: &'l Leg,
    /// Degrees of the joints' path for each unit of the leg's length.
    scale: f64,
}

/// Passage from one leg to the next.
enum Junction {
    Stop,
    /// Straight continuation.
    Through,
    /// Curve that begins and ends at this distance from the corner, by the parameter.
    Rounded(f64, Box<Piece>),
}

/// Share of a leg that one corner may take.
const HALF: f64 = 0.499;
/// Least half of a corner; a stop takes hardly longer than a shorter one.
const LEAST_HALF: f64 = 1e-4;
/// Shares of its length that are tried for a corner that is too far from its point.
const SHORTER: [f64; 8] = [1.0, 0.9, 0.8, 0.65, 0.5, 0.35, 0.2, 0.1];
/// Length of a corner as a multiple of its distance from the point, for directions that differ by 1. The direction
/// changes from one to the other as `3x² - 2x³`.
const CORNER_LENGTH: f64 = 32.0 / 3.0;
/// Difference below which directions are one.
const STRAIGHT_ON: f64 = 1e-9;
/// Cosine of the angle, some 177 degrees, beyond which a path turns back.
const TURNS_BACK: f64 = -0.9986;
/// Share of a tolerance for corners; the rest is for pieces of time, which are near the path.
const WITHIN: f64 = 0.995;

impl Path {
    /// Creates the path along legs, with their corners rounded within their tolerances.
    ///
    /// # Errors
    /// A corner is too near to a singularity.
    pub(super) fn of_legs(legs: &[Leg], checker: &Checker) -> Result<Self, TrajectoryError> {
        let legs: Vec<_> = legs.iter().map(Scaled::new).collect();
        let (mut path, mut from) = (Self::default(), 0.0);
        for (index, leg) in legs.iter().enumerate() {
            let junction = legs.get(index + 1).map_or(Junction::Stop, |next| leg.junction(next, checker));
            let to = if let Junction::Rounded(half, _) = junction { leg.length() - half } else { leg.length() };
            leg.add([from, to], &mut path);
            from = 0.0;
            let at = path.end();
            let (at, passing) = match junction {
                Junction::Stop => {
                    path.pieces.iter_mut().last().into_iter().for_each(|piece| piece.stops = true);
                    (at, Passing::Stops)
                }
                Junction::Through => (at, Passing::Through),
                Junction::Rounded(half, joints) => {
                    from = half;
                    leg.keep_apart_from_singularities(&legs[index + 1], &joints, checker)?;
                    let speeds = leg.leg.speeds.least(legs[index + 1].leg.speeds);
                    path.add(*joints, PieceShape::Corner, leg.leg.after, speeds);
                    (at + half, Passing::Rounded)
                }
            };
            path.marks.push(Mark { at, passing });
        }
        Ok(path)
    }

    pub(super) fn end(&self) -> f64 {
        self.pieces.last().map_or(0.0, |piece| piece.joints.end_s())
    }

    /// Adds a part at the end.
    pub(super) fn add(&mut self, mut joints: Piece, shape: PieceShape, after: usize, speeds: LegSpeeds) {
        joints.start_s = self.end();
        self.pieces.push(PathPiece { joints, shape, after, stops: false, speeds });
    }
}

impl<'l> Scaled<'l> {
    fn new(leg: &'l Leg) -> Self {
        let scale = match &leg.path {
            LegPath::Joints(_) | LegPath::Curve(_) => 1.0,
            LegPath::Tool(line) => line.degrees_a_unit(),
        };
        Self { leg, scale }
    }

    fn length(&self) -> f64 {
        self.leg.length * self.scale
    }

    /// Returns the joints at a parameter from its start, with their derivatives.
    fn at(&self, at: f64) -> Sample {
        let way = at / self.scale;
        match &self.leg.path {
            LegPath::Joints(direction) => Sample {
                joints: self.leg.joints_at(direction, way).into(),
                velocity: *direction,
                acceleration: [0.0; 6],
            },
            LegPath::Tool(line) => {
                let there = line.at(way);
                Sample {
                    velocity: there.velocity.map(|each| each / self.scale),
                    acceleration: there.acceleration.map(|each| each / self.scale / self.scale),
                    ..there
                }
            }
            LegPath::Curve(curve) => curve.at(way),
        }
    }

    /// Adds the part between two parameters.
    fn add(&self, [from, to]: [f64; 2], path: &mut Path) {
        match &self.leg.path {
            LegPath::Joints(_) => {
                let [one, other] = [from, to].map(|at| self.at(at));
                path.add(
                    Piece::between(0.0, to - from, &one, &other),
                    PieceShape::Straight,
                    self.leg.after,
                    self.leg.speeds,
                );
            }
            LegPath::Tool(line) => {
                for mut part in line.between(from / self.scale, to / self.scale) {
                    part.seconds *= self.scale;
                    path.add(part, PieceShape::Curve, self.leg.after, self.leg.speeds);
                }
            }
            LegPath::Curve(curve) => {
                let start = path.end();
                for (after, part) in curve.between(from, to) {
                    path.add(part, PieceShape::Curve, self.leg.after + after, self.leg.speeds);
                }
                // Marks before and after are on the corners.
                let marks = curve.marks.iter().map(|mark| start + mark - from);
                path.marks.extend(marks.map(|at| Mark { at, passing: Passing::Rounded }));
            }
        }
    }

    fn is_of_tool(&self) -> bool {
        match &self.leg.path {
            LegPath::Joints(_) => false,
            LegPath::Tool(_) => true,
            LegPath::Curve(curve) => curve.space == Space::Tool,
        }
    }

    /// Returns the passage to the next leg: a stop if the path turns back, or no tolerance is set.
    fn junction(&self, next: &Self, checker: &Checker) -> Junction {
        let tolerances = &self.leg.corner;
        let (before, after) = (self.at(self.length()), next.at(0.0));
        if self.cosine(next, [&before, &after], checker) < TURNS_BACK {
            return Junction::Stop;
        }
        let turn: [f64; 6] = std::array::from_fn(|joint| after.velocity[joint] - before.velocity[joint]);
        let bend: [f64; 6] = std::array::from_fn(|joint| after.acceleration[joint] - before.acceleration[joint]);
        if largest(&turn).max(largest(&bend)) < STRAIGHT_ON {
            return Junction::Through;
        }
        let most = self.corner_length(next, &before, &turn, tolerances, checker);
        let half = (0.5 * most).min(HALF * self.length()).min(HALF * next.length());
        if half <= LEAST_HALF {
            return Junction::Stop;
        }
        let halves = SHORTER.into_iter().map(|share| share * half);
        let mut corners = halves.map(|half| {
            let [from, to] = [self.at(self.length() - half), next.at(half)];
            (half, Piece::between(0.0, 2.0 * half, &from, &to))
        });
        let found = corners.find(|(half, corner)| self.is_within(next, *half, corner, tolerances, checker));
        found.map_or(Junction::Stop, |(half, corner)| Junction::Rounded(half, Box::new(corner)))
    }

    fn cosine(&self, next: &Self, [before, after]: [&Sample; 2], checker: &Checker) -> f64 {
        if self.is_of_tool() && next.is_of_tool() {
            let [one, other] = [before, after].map(|way| checker.arm().tool_moves(&before.joints.0, &way.velocity));
            let dot = |one: &[Vector3<f64>; 2], other: &[Vector3<f64>; 2]| {
                one[0].dot(&other[0]) + one[1].dot(&other[1]) * TURN_MM * TURN_MM
            };
            return dot(&one, &other) / (dot(&one, &one) * dot(&other, &other)).sqrt();
        }
        let dot = |one: &[f64; 6], other: &[f64; 6]| one.iter().zip(other).map(|(a, b)| a * b).sum::<f64>();
        let (before, after) = (&before.velocity, &after.velocity);
        dot(before, after) / (dot(before, before) * dot(after, after)).sqrt()
    }

    /// Returns the longest corner within the tolerances of both legs, by the parameter, for this change `turn` of
    /// direction.
    fn corner_length(
        &self,
        next: &Self,
        before: &Sample,
        turn: &[f64; 6],
        tolerances: &Tolerances,
        checker: &Checker,
    ) -> f64 {
        let length = |tolerance: f64, differ: f64| {
            if tolerance == 0.0 { 0.0 } else { CORNER_LENGTH * WITHIN * tolerance / differ.max(STRAIGHT_ON) }
        };
        let has_line = self.is_of_tool() || next.is_of_tool();
        let has_joints = !(self.is_of_tool() && next.is_of_tool());
        let mut most = f64::INFINITY;
        if has_joints {
            most = most.min(length(tolerances.joint_deg, largest(turn)));
        }
        if has_line {
            let [moved_mm, turned_rad] = checker.arm().tool_moves(&before.joints.0, turn).map(|moved| moved.norm());
            most = most.min(length(tolerances.mm, moved_mm)).min(length(tolerances.turn_deg.to_radians(), turned_rad));
        }
        most
    }

    /// Whether a corner is within the tolerances of both legs.
    fn is_within(&self, next: &Self, half: f64, corner: &Piece, tolerances: &Tolerances, checker: &Checker) -> bool {
        if let (LegPath::Joints(_), LegPath::Joints(_)) = (&self.leg.path, &next.leg.path) {
            // The bound of its length is exact.
            return true;
        }
        if !(self.is_of_tool() || next.is_of_tool()) {
            return (1..16).map(|part| f64::from(part) / 16.0).all(|share| {
                let along = (2.0 * share - 1.0) * half;
                let wanted = if along < 0.0 { self.at(self.length() + along) } else { next.at(along) };
                wanted.joints.max_distance(&corner.joints(share).into()) <= WITHIN * tolerances.joint_deg
            });
        }
        let arm = checker.arm();
        let point = next.at(0.0);
        let (middle, tool) = (corner.joints(0.5), arm.tcp(&point.joints.0));
        let there = arm.tcp(&middle);
        let off_mm = (there.translation.vector - tool.translation.vector).norm();
        let off_deg = there.rotation.angle_to(&tool.rotation).to_degrees();
        if off_mm > WITHIN * tolerances.mm || off_deg > WITHIN * tolerances.turn_deg {
            return false;
        }
        let off: [f64; 6] = std::array::from_fn(|joint| middle[joint] - point.joints.0[joint]);
        if !(self.is_of_tool() && next.is_of_tool()) && largest(&off) > WITHIN * tolerances.joint_deg {
            return false;
        }
        // The path between a corner's ends and its middle is compared, too.
        [0.125, 0.25, 0.375, 0.625, 0.75, 0.875].into_iter().all(|share| {
            let place = arm.tcp(&corner.joints(share)).translation.vector;
            let along = (2.0 * share - 1.0) * half;
            let off_mm = if along < 0.0 {
                self.off_mm(arm, &place, self.length() + along)
            } else {
                next.off_mm(arm, &place, along)
            };
            off_mm <= WITHIN * tolerances.mm
        })
    }

    /// Returns the distance of a place from the leg's path, near a parameter, in mm.
    fn off_mm(&self, arm: &Arm, place: &Vector3<f64>, at: f64) -> f64 {
        match &self.leg.path {
            LegPath::Joints(_) | LegPath::Curve(_) => {
                (arm.tcp(&self.at(at).joints.0).translation.vector - place).norm()
            }
            LegPath::Tool(line) => line.off_mm(place),
        }
    }

    /// Checks the distances from singularities on a corner between two lines. The lines were checked themselves, but
    /// the corner is off them.
    fn keep_apart_from_singularities(
        &self,
        next: &Self,
        corner: &Piece,
        checker: &Checker,
    ) -> Result<(), TrajectoryError> {
        let (LegPath::Tool(_), LegPath::Tool(line)) = (&self.leg.path, &next.leg.path) else { return Ok(()) };
        if line.is_apart_all_along(checker, std::slice::from_ref(corner)) {
            return Ok(());
        }
        let [from, to] = corner.ends();
        [0.25, 0.5, 0.75].into_iter().try_for_each(|share| {
            let kept = checker.no_nearer_to_singularities([&from, &to], &corner.joints(share));
            kept.map_err(|exceeded| TrajectoryError::between(self.leg.after, checker, exceeded))
        })
    }
}

fn largest(numbers: &[f64; 6]) -> f64 {
    numbers.iter().fold(0.0, |most: f64, number| most.max(number.abs()))
}
