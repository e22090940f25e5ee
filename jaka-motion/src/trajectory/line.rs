//! Where the joints are along a straight line of the tool.

use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector6};

use super::corner_path::{Direction, OFF_WAY, SpeedRamp, in_steps, is_off_at_most, least_share, together};
use crate::checker::{Arm, Checker, Solved};
use crate::piece::{Piece, Sample};

/// A straight line of the tool, and the joints on it: polynomials of the way, found once and timed as often as it
/// takes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Line {
    /// The tool at the start.
    pub(super) from: Isometry3<f64>,
    pub(super) direction: Direction,
    /// By the way in the place of seconds.
    parts: Vec<Piece>,
    /// From each singularity, at the start.
    distances: [f64; 3],
    /// Whether all that [`Checker::check_line`] looks for is known to be far away.
    pub(super) is_clear: bool,
}

/// The longest way between two places at which the joints are computed, in the unit of the way.
pub(super) const LONGEST: f64 = 50.0;
/// The least share of a line between two places.
pub(super) const LEAST: f64 = 1e-6;
/// The most parts of a line.
const MOST_PARTS: usize = 50_000;
/// How far the tool may be from its line between them, in mm and degrees: a fiftieth of [`OFF_WAY`].
const OFF_LINE: (f64, f64) = (1e-4, 2e-5);

impl Line {
    /// From where the arm is, in parts that are no shorter than the least where it can be, and where it is at the end;
    /// none where the joints are not found all along.
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

    /// Whether the joints surely keep apart from singularities on pieces around its start, which is no further from
    /// them than they are long.
    pub(super) fn is_apart_all_along(&self, checker: &Checker, pieces: &[Piece]) -> bool {
        let turned: [f64; 6] = std::array::from_fn(|joint| {
            let seconds: f64 = pieces.iter().map(|piece| piece.seconds * piece.hull().speeds[joint]).sum();
            2.0 * seconds.to_radians()
        });
        checker.keeps_apart(&self.distances, &turned)
    }

    /// The joints at a way, and how they move and bend for each unit of it.
    pub(super) fn at(&self, way: f64) -> Sample {
        let (part, share) = self.place(way);
        part.at(share)
    }

    /// The joints where a course is, and how they move in time.
    pub(super) fn moving(&self, course: &SpeedRamp, share: f64, seconds: f64) -> Sample {
        let [way, speed, change] = course.at(share, seconds);
        let there = self.at(way);
        let acceleration = |joint: usize| there.acceleration[joint] * speed * speed + there.velocity[joint] * change;
        Sample {
            joints: there.joints,
            velocity: there.velocity.map(|each| each * speed),
            acceleration: std::array::from_fn(acceleration),
        }
    }

    /// Adds the pieces that lead the tool along a course in so many seconds, from where it is; where it then is. None
    /// where they are too short.
    pub(super) fn follow(
        &self,
        arm: &Arm,
        course: &SpeedRamp,
        seconds: f64,
        start: Option<Sample>,
        pieces: &mut Vec<Piece>,
    ) -> Option<Sample> {
        let way = 0.5 * (course.speeds[0] + course.speeds[1]) * seconds;
        let mut here = start.unwrap_or_else(|| self.moving(course, 0.0, seconds));
        in_steps(1.0, (LONGEST / way).min(1.0), least_share(seconds), |[from, to]| {
            let next = self.moving(course, to, seconds);
            let piece = Piece::between(0.0, (to - from) * seconds, &here, &next);
            let is_on_way = |part: f64| {
                let [way, ..] = course.at(from + part * (to - from), seconds);
                self.is_at(arm, way, &piece.joints(part))
            };
            // At one speed it is the line's own polynomial.
            let is_same = self.parts.len() == 1 && course.is_even();
            let is_on_way = is_same || [0.5, 0.25, 0.75].into_iter().all(is_on_way);
            is_on_way.then(|| {
                here = next;
                pieces.push(piece);
            })
        })?;
        Some(here)
    }

    /// Whether joints bring the tool to a way of the line, as near as a piece has to: those that are near to the line's
    /// own surely do.
    fn is_at(&self, arm: &Arm, way: f64, joints: &[f64; 6]) -> bool {
        let (part, share) = self.place(way);
        let own = part.joints(share);
        let off = std::array::from_fn(|joint| joints[joint] - own[joint]);
        let turned_deg: f64 = off.iter().map(|off: &f64| off.abs()).sum();
        let is_near = arm.radii().tcp_rate_at_most(&off) <= 0.9 * OFF_WAY.0 && turned_deg <= 0.9 * OFF_WAY.1;
        is_near || is_off_at_most(arm, joints, &self.tool(way), OFF_WAY)
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

    /// How the joints move and bend for each unit of the way.
    fn going(&self, here: &Solved) -> Option<Sample> {
        here.moving(&together(self.direction.moved, self.from.rotation * self.direction.turned), &Vector6::zeros())
    }

    /// Adds the part between two ways, where joints that go on so bring the tool along it; where they are at its end.
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
