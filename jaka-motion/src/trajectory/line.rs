//! Joint positions along a straight line of the tool.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3, Vector6};

use crate::checker::{Arm, Checker, Solved};
use crate::piece::{Piece, Sample};

/// Direction of a straight motion of the tool, for each unit of length: mm, and radians about its own axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Direction {
    pub(super) moved: Vector3<f64>,
    pub(super) turned: Vector3<f64>,
}

/// Straight line of the tool, and the joints on it: polynomials of the length, computed once and timed as often as
/// needed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Line {
    /// Tool at the start.
    pub(super) from: Isometry3<f64>,
    pub(super) direction: Direction,
    /// Parts by length in place of seconds.
    parts: Vec<Piece>,
    /// Distances from the singularities, at the start.
    distances: [f64; 3],
    /// Whether all limits that [`Checker::check_line`] compares are known to be far away.
    pub(super) is_clear: bool,
}

/// Length in mm that counts as much as a turn of the tool by one radian.
pub(super) const TURN_MM: f64 = 200.0;
/// Longest distance between two places at which the joints are computed, in the unit of length.
pub(super) const LONGEST: f64 = 50.0;
/// Least share of a line between two places.
pub(super) const LEAST: f64 = 1e-6;
/// Greatest number of parts of a line.
const MOST_PARTS: usize = 50_000;
/// Greatest distance of the tool from its line between two places, in mm and degrees.
const OFF_LINE: (f64, f64) = (1e-4, 2e-5);

impl Direction {
    /// Returns the direction from one place to another, and the length, in mm with [`TURN_MM`] for each radian.
    pub(super) fn between(from: &Isometry3<f64>, to: &Isometry3<f64>) -> (Self, f64) {
        let moved = to.translation.vector - from.translation.vector;
        let turned = (from.rotation.inverse() * to.rotation).scaled_axis();
        let length = moved.norm().hypot(turned.norm() * TURN_MM);
        (Self { moved: moved / length, turned: turned / length }, length)
    }
}

impl Line {
    /// Returns the line from the arm's position, in parts no shorter than `least`, and the arm's position at the end;
    /// `None` if the joints are not found all along.
    pub(super) fn new(
        checker: &Checker,
        start: &Solved,
        direction: Direction,
        length: f64,
        least: f64,
    ) -> Option<(Self, Solved)> {
        let (arm, distances) = (checker.arm(), checker.arm().distances(&start.frames));
        let mut line = Self { from: start.tool, direction, parts: Vec::with_capacity(1), distances, is_clear: false };
        let (mut here, mut sample) = (None::<Solved>, line.going(start)?);
        in_steps(length, LONGEST, least, |ends| {
            here = Some(line.part(arm, ends, here.as_ref().unwrap_or(start), &mut sample)?);
            Some(())
        })?;
        let here = here?;
        if let [part] = line.parts.as_slice() {
            line.is_clear = checker.is_clear_line(part, [start, &here], &distances);
        }
        Some((line, here))
    }

    /// Whether the joints surely keep their distance from singularities on pieces around the line's start, which is at
    /// most the length of the pieces away.
    pub(super) fn is_apart_all_along(&self, checker: &Checker, pieces: &[Piece]) -> bool {
        let turned: [f64; 6] = std::array::from_fn(|joint| {
            let seconds: f64 = pieces.iter().map(|piece| piece.seconds * piece.hull().speeds[joint]).sum();
            2.0 * seconds.to_radians()
        });
        checker.keeps_apart(&self.distances, &turned)
    }

    /// Returns the joints at a distance along the line, with their first and second derivatives.
    pub(super) fn at(&self, way: f64) -> Sample {
        let (part, share) = self.place(way);
        part.at(share)
    }

    /// Returns the parts between two distances along the line.
    pub(super) fn between(&self, from: f64, to: f64) -> impl Iterator<Item = Piece> {
        let parts = self.parts.iter().filter(move |part| part.start_s < to && part.end_s() > from);
        parts.map(move |part| {
            let share = |way: f64| ((way - part.start_s) / part.seconds).clamp(0.0, 1.0);
            let (from, to) = (share(from), share(to));
            if from <= 0.0 && to >= 1.0 { part.clone() } else { part.part(from, to) }
        })
    }

    /// Returns the distance of a place from the line, in mm.
    pub(super) fn off_mm(&self, place: &Vector3<f64>) -> f64 {
        let (off, moved) = (place - self.from.translation.vector, self.direction.moved);
        let along = if moved.norm_squared() > 0.0 { off.dot(&moved) / moved.norm_squared() } else { 0.0 };
        (off - moved * along).norm()
    }

    /// Returns the greatest distance that the joints move for each unit of length, in degrees.
    pub(super) fn degrees_a_unit(&self) -> f64 {
        let rates = self.parts.iter().map(|part| part.at(0.0).velocity.iter().map(|rate| rate * rate).sum::<f64>());
        rates.fold(1e-12, f64::max).sqrt()
    }

    fn place(&self, way: f64) -> (&Piece, f64) {
        let part = self.parts.iter().rfind(|part| part.start_s <= way).unwrap_or(&self.parts[0]);
        (part, ((way - part.start_s) / part.seconds).clamp(0.0, 1.0))
    }

    fn tool(&self, way: f64) -> Isometry3<f64> {
        let place = self.from.translation.vector + self.direction.moved * way;
        let turn = UnitQuaternion::from_scaled_axis(self.direction.turned * way);
        Isometry3::from_parts(Translation3::from(place), self.from.rotation * turn)
    }

    /// Returns the joint positions, with their first and second derivatives for each unit of length.
    fn going(&self, here: &Solved) -> Option<Sample> {
        here.moving(&together(self.direction.moved, self.from.rotation * self.direction.turned), &Vector6::zeros())
    }

    /// Adds the part between two distances, if joints that continue bring the tool along it; returns the joints at its
    /// end.
    fn part(&mut self, arm: &Arm, [from, to]: [f64; 2], here: &Solved, sample: &mut Sample) -> Option<Solved> {
        if self.parts.len() > MOST_PARTS {
            return None;
        }
        let next = arm.led_on(here, &self.tool(to))?;
        let next_sample = self.going(&next)?;
        let part = Piece::between(from, to - from, sample, &next_sample);
        if !is_off_at_most(arm, &part.joints(0.5), &self.tool(f64::midpoint(from, to)), OFF_LINE) {
            return None;
        }
        self.parts.push(part);
        *sample = next_sample;
        Some(next)
    }
}

/// Whether joints bring the tool to a place, within these mm and degrees.
pub(super) fn is_off_at_most(arm: &Arm, joints: &[f64; 6], tool: &Isometry3<f64>, most: (f64, f64)) -> bool {
    let found = arm.tcp(joints);
    let moved = (tool.translation.vector - found.translation.vector).norm();
    moved <= most.0 && tool.rotation.angle_to(&found.rotation).to_degrees() <= most.1
}

/// Advances from 0 to an end in steps that `take` accepts, each as long as possible and at most the longest; `None` if
/// it refuses even the least.
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

pub(super) fn together(moved: Vector3<f64>, turned: Vector3<f64>) -> Vector6<f64> {
    Vector6::new(moved.x, moved.y, moved.z, turned.x, turned.y, turned.z)
}
