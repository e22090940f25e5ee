//! Joints along a smooth curve, as polynomials of a parameter.

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion, Vector6};

use super::line::{TURN_MM, in_steps, is_off_at_most, together};
use super::smoothing::{Place, Spline};
use crate::arc::Arc;
use crate::beyond::Exceeded;
use crate::checker::{Checker, Solved};
use crate::piece::{Piece, Sample};

/// Smooth path near points: polynomials of a parameter, about the length of the joints' path in degrees.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CurvePath {
    pieces: Vec<Piece>,
    /// Parameters of the points between its start and its end.
    pub(super) marks: Vec<f64>,
    pub(super) space: Space,
}

/// Space in which a curve is given, and its tolerances.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Space {
    Joints,
    Tool,
}

/// Greatest distance of polynomials from a curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Nearness {
    pub(super) mm: f64,
    /// Turn of the tool or of a joint, in degrees.
    pub(super) deg: f64,
}

/// Start of a curve.
pub(super) struct Begin<'c> {
    pub(super) checker: &'c Checker,
    pub(super) start: Solved,
    /// Distances from singularities at the start of the whole curve, with opposite signs on the two sides of one.
    pub(super) distances: [f64; 3],
}

/// Parameter for which no joints were found, and the exceeded limit, if any.
pub(super) struct Lost {
    pub(super) at: f64,
    pub(super) exceeded: Option<Exceeded>,
}

/// Longest distance between two places at which the joints are computed, in mm or degrees.
const LONGEST: f64 = 50.0;
/// Least share of a curve between two such places.
const LEAST: f64 = 1e-7;
/// Greatest number of nodes in between at which polynomials are compared with the curve.
const COMPARED: usize = 32;
/// Units of a place for a turn by one radian, by its quaternion.
pub(super) const TURN_UNITS: f64 = 2.0 * TURN_MM;

/// Greatest distance from an arc of the chords between its places, in mm.
const ARC_BETWEEN_MM: f64 = 0.002;
/// Longest angle between these places, in radians, and longest turn of the tool, in degrees.
const ARC_STEP: f64 = 0.05;
const ARC_TURN_DEG: f64 = 1.0;
/// Greatest number of these places.
const ARC_PLACES: f64 = 5000.0;
/// Greatest distance of the curve from these places, and of polynomials from the curve.
const ARC_NEAR: Nearness = Nearness { mm: 0.002, deg: 0.002 };

impl CurvePath {
    /// Creates the path along a spline; also returns the joints at its end.
    pub(super) fn new(
        spline: &Spline,
        points: &[f64],
        space: Space,
        begin: &Begin<'_>,
        near: Nearness,
    ) -> Result<(Self, Solved), Lost> {
        let arm = begin.checker.arm();
        let end = spline.nodes().last().copied().unwrap_or_default();
        let start = sample(spline, 0.0, space, &begin.start).ok_or(Lost { at: 0.0, exceeded: None })?;
        let (mut here, mut from_sample, mut pieces) = (begin.start.clone(), start, Vec::new());
        let mut sides = begin.checker.signed_distances(&here.joints);
        let (mut at, mut exceeded) = (0.0, None);
        let mut take = |[from, to]: [f64; 2]| {
            at = from;
            let next = match space {
                Space::Joints => arm.at_joints(&joints(&spline.at(to)[0]))?,
                Space::Tool => arm.led_on(&here, &tool(&spline.at(to)[0]))?,
            };
            let next_sample = sample(spline, to, space, &next)?;
            let piece = Piece::between(from, to - from, &from_sample, &next_sample);
            if !is_near(spline, &piece, space, begin.checker, near) {
                return None;
            }
            let there = begin.checker.signed_distances(&next.joints);
            if space == Space::Tool {
                exceeded = begin.checker.check_apart(&begin.distances, &sides, &there).err();
                exceeded.is_none().then_some(())?;
            }
            pieces.push(piece);
            (here, from_sample, sides) = (next, next_sample, there);
            Some(())
        };
        if in_steps(end, LONGEST, LEAST * end, &mut take).is_none() {
            return Err(Lost { at, exceeded });
        }
        let scale = degrees_a_unit(&pieces);
        for piece in &mut pieces {
            piece.start_s *= scale;
            piece.seconds *= scale;
        }
        let marks = points.iter().map(|point| point * scale).collect();
        Ok((Self { pieces, marks, space }, here))
    }

    /// Creates the path along an arc of the tool, through places close to one another; also returns the joints at its
    /// end.
    pub(super) fn of_arc(arc: &Arc, begin: &Begin<'_>) -> Result<(Self, Solved), Lost> {
        let radius_mm = arc.length_mm() / arc.angle();
        let step = (8.0 * ARC_BETWEEN_MM / radius_mm).sqrt().min(ARC_STEP);
        let by_turn = arc.turn_deg() / ARC_TURN_DEG;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count, and too many are cut")]
        let count = (arc.angle() / step).max(by_turn).ceil().clamp(8.0, ARC_PLACES) as u32;
        let (mut at, mut places) = (Vec::new(), Vec::<Place>::new());
        for index in 0..=count {
            let place = of_tool(&arc.at(f64::from(index) / f64::from(count)).0, places.last());
            let way = places.last().map_or(0.0, |last| distance(last, &place));
            at.push(at.last().map_or(0.0, |last| last + way));
            places.push(place);
        }
        let near = |off: &Place| {
            let length = |off: &[f64]| off.iter().map(|off| off * off).sum::<f64>().sqrt();
            let turned = (length(&off[3..]) * 2.0 / TURN_UNITS).to_degrees();
            (length(&off[..3]) / ARC_NEAR.mm).max(turned / ARC_NEAR.deg)
        };
        Self::new(&Spline::near(at, &places, near), &[], Space::Tool, begin, ARC_NEAR)
    }

    pub(super) fn length(&self) -> f64 {
        self.pieces.last().map_or(0.0, Piece::end_s)
    }

    /// Returns the joints at a parameter, and their derivatives.
    pub(super) fn at(&self, at: f64) -> Sample {
        let index = self.pieces.partition_point(|piece| piece.start_s <= at).saturating_sub(1);
        let piece = &self.pieces[index];
        piece.at(((at - piece.start_s) / piece.seconds).clamp(0.0, 1.0))
    }

    /// Returns the pieces between two parameters, and the number of points before each.
    pub(super) fn between(&self, from: f64, to: f64) -> impl Iterator<Item = (usize, Piece)> {
        let first = self.pieces.partition_point(|piece| piece.end_s() <= from);
        let pieces = self.pieces[first..].iter().take_while(move |piece| piece.start_s < to);
        pieces.map(move |piece| {
            let share = |at: f64| ((at - piece.start_s) / piece.seconds).clamp(0.0, 1.0);
            let (one, other) = (share(from), share(to));
            let part = if one <= 0.0 && other >= 1.0 { piece.clone() } else { piece.part(one, other) };
            (self.marks.partition_point(|mark| *mark <= part.start_s), part)
        })
    }
}

pub(super) fn distance(one: &Place, other: &Place) -> f64 {
    one.iter().zip(other).map(|(one, other)| (one - other).powi(2)).sum::<f64>().sqrt()
}

/// Returns joints as a place.
pub(super) fn of_joints(joints: &[f64; 6]) -> Place {
    std::array::from_fn(|which| joints.get(which).copied().unwrap_or_default())
}

/// Returns the tool as a place. Of the two quaternions for its turn, it takes the one nearer to the place before.
pub(super) fn of_tool(tool: &Isometry3<f64>, before: Option<&Place>) -> Place {
    let (moved, turned) = (tool.translation.vector, tool.rotation.coords * TURN_UNITS);
    let sign = before.map_or(1.0, |before| {
        let dot: f64 = turned.iter().zip(&before[3..]).map(|(one, other)| one * other).sum();
        1.0_f64.copysign(dot)
    });
    let turned = turned * sign;
    [moved.x, moved.y, moved.z, turned.x, turned.y, turned.z, turned.w]
}

fn joints(place: &Place) -> [f64; 6] {
    std::array::from_fn(|which| place[which])
}

fn tool(place: &Place) -> Isometry3<f64> {
    let [x, y, z, ..] = *place;
    Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::from_quaternion(quaternion(place)))
}

fn quaternion(place: &Place) -> Quaternion<f64> {
    let [_, _, _, i, j, k, w] = *place;
    Quaternion::new(w, i, j, k)
}

/// Returns the joints at a parameter, and their derivatives; `None` if the joints cannot follow the spline.
fn sample(spline: &Spline, at: f64, space: Space, here: &Solved) -> Option<Sample> {
    let [place, first, second] = spline.at(at);
    if space == Space::Joints {
        return Some(Sample { joints: here.joints.into(), velocity: joints(&first), acceleration: joints(&second) });
    }
    let [turn, turn_rate, turn_bend] = [place, first, second].map(|place| quaternion(&place));
    let length = turn.norm();
    let turn = turn / length;
    let length_rate = turn.dot(&turn_rate);
    let rate = (turn_rate - turn * length_rate) / length;
    let length_bend = (turn_rate.dot(&turn_rate) + length * turn.dot(&turn_bend) - length_rate * length_rate) / length;
    let bend = (turn_bend - rate * (2.0 * length_rate) - turn * length_bend) / length;
    let moves = |place: &Place, turn_change: Quaternion<f64>| -> Vector6<f64> {
        let [x, y, z, ..] = *place;
        together([x, y, z].into(), (turn_change * turn.conjugate()).imag() * 2.0)
    };
    here.moving(&moves(&first, rate), &moves(&second, bend))
}

/// Whether a polynomial is near the spline in between.
fn is_near(spline: &Spline, piece: &Piece, space: Space, checker: &Checker, near: Nearness) -> bool {
    let nodes = spline.nodes();
    let (from, to) = (piece.start_s, piece.end_s());
    let first = nodes.partition_point(|node| *node <= from);
    let within = &nodes[first..nodes.partition_point(|node| *node < to).max(first)];
    let is_near_at = |at: f64| {
        let (place, found) = (spline.at(at)[0], piece.joints((at - from) / piece.seconds));
        match space {
            Space::Joints => (0..6).all(|joint| (place[joint] - found[joint]).abs() <= near.deg),
            Space::Tool => is_off_at_most(checker.arm(), &found, &tool(&place), (near.mm, near.deg)),
        }
    };
    [0.25, 0.5, 0.75].iter().all(|share| is_near_at(from + share * (to - from)))
        && within.iter().step_by(within.len() / COMPARED + 1).all(|node| is_near_at(*node))
}

/// Returns the greatest distance that the joints move for each unit, in degrees.
fn degrees_a_unit(pieces: &[Piece]) -> f64 {
    let rates = pieces.iter().map(|piece| piece.at(0.5).velocity.iter().map(|rate| rate * rate).sum::<f64>());
    rates.fold(1e-12, f64::max).sqrt()
}
