//! When a trajectory is where.

use std::ops::Range;

use super::TrajectoryError;
use super::corner_path::{CornerPath, SpeedRamp};
use super::leg::{Budget, Leg, LegPath, Tolerances};
use super::line::Line;
use super::plan::{Bounds, Corner, Passage, plan};
use super::{Passing, WayPoint};
use crate::beyond::{Exceeded, Way};
use crate::checker::Checker;
use crate::piece::{Piece, Sample};

/// The legs, and how fast they and their corners may be.
///
/// What lines ask of the joints is known once the joints are: legs and corners that ask too much get slower, and all is
/// planned again.
#[derive(Debug)]
pub(super) struct Timing<'a> {
    legs: &'a [Leg],
    lengths: Vec<f64>,
    bounds: Vec<Bounds>,
    corners: Vec<Corner>,
    budget: &'a Budget,
    checker: &'a Checker,
}

/// Where the pieces are that were made of a leg, and those of the corner after it.
#[derive(Debug)]
struct LegPieces {
    passage: Passage,
    of_leg: Range<usize>,
    of_corner: Range<usize>,
}

/// How often it is planned.
const ROUNDS: usize = 12;
/// A stretch need not get slower by less than this share.
const ENOUGH: f64 = 0.02;
/// How much slower than needed it gets.
const MARGIN: f64 = 0.005;
/// At how many places on a piece in joint space the speed of the tool centre point is looked at.
const TCP_PLACES: u32 = 4;

impl<'a> Timing<'a> {
    pub(super) fn new(legs: &'a [Leg], tolerances: &Tolerances, budget: &'a Budget, checker: &'a Checker) -> Self {
        let found: Vec<_> = legs.iter().map(|leg| leg.survey(budget, checker.arm())).collect();
        let pairs = legs.windows(2).zip(found.windows(2));
        let between = pairs.map(|(legs, found)| legs[0].corner(&legs[1], [&found[0], &found[1]], tolerances, budget));
        let corners = std::iter::once(Corner::STOP).chain(between).chain([Corner::STOP]).collect();
        let lengths = legs.iter().map(|leg| leg.length).collect();
        let bounds = found.into_iter().map(|found| found.bounds).collect();
        Self { legs, lengths, bounds, corners, budget, checker }
    }

    /// The pieces, and the way-points at both ends of all legs.
    pub(super) fn pieces(mut self) -> Result<(Vec<Piece>, Vec<WayPoint>), TrajectoryError> {
        let mut made: Vec<LegPieces> = Vec::with_capacity(self.legs.len());
        let mut pieces = Vec::with_capacity(4 * self.legs.len());
        for _ in 0..ROUNDS {
            let mut is_slower = false;
            for (index, passage) in plan(&self.lengths, &self.bounds, &self.corners).into_iter().enumerate() {
                let is_as_before = made.get(index).is_some_and(|made| made.passage == passage);
                if is_as_before {
                    continue;
                }
                let leg = self.make(index, passage, &mut pieces)?;
                is_slower |= self.slow_down(index, &leg, &pieces);
                if index < made.len() { made[index] = leg } else { made.push(leg) }
            }
            if !is_slower {
                break;
            }
        }
        Ok(one_after_the_other(&made, pieces))
    }

    fn make(&self, index: usize, passage: Passage, pieces: &mut Vec<Piece>) -> Result<LegPieces, TrajectoryError> {
        let first = pieces.len();
        self.make_leg(index, &passage, pieces)?;
        let of_leg = first..pieces.len();
        if passage.corner_s > 0.0 {
            self.make_corner(index, passage.speeds[2], passage.corner_s, pieces)?;
        }
        Ok(LegPieces { passage, of_corner: of_leg.end..pieces.len(), of_leg })
    }

    fn make_leg(&self, index: usize, passage: &Passage, pieces: &mut Vec<Piece>) -> Result<(), TrajectoryError> {
        let (leg, mut from) = (&self.legs[index], passage.from);
        let ([first, top, last], mut here) = (passage.speeds, None);
        for (speeds, seconds) in [[first, top], [top, top], [top, last]].into_iter().zip(passage.seconds) {
            if seconds <= 0.0 {
                continue;
            }
            let way = 0.5 * (speeds[0] + speeds[1]) * seconds;
            match &leg.path {
                LegPath::Joints(direction) => {
                    let ends = speeds.map(|speed| (direction, speed));
                    pieces.push(straight(seconds, leg.joints_at(direction, from), ends, [way, 0.0]));
                }
                LegPath::Tool(line) => {
                    here = line.follow(self.checker.arm(), &SpeedRamp { from, speeds }, seconds, here, pieces);
                    here.ok_or_else(|| lost(leg.after, self.checker))?;
                }
            }
            from += way;
        }
        Ok(())
    }

    /// The corner after a leg; legs of two kinds have none between them.
    fn make_corner(
        &self,
        index: usize,
        speed: f64,
        seconds: f64,
        pieces: &mut Vec<Piece>,
    ) -> Result<(), TrajectoryError> {
        let (leg, way) = (&self.legs[index], 0.5 * speed * seconds);
        match (&leg.path, self.legs.get(index + 1).map(|next| &next.path)) {
            (LegPath::Joints(direction), Some(LegPath::Joints(next))) => {
                let start = leg.joints_at(direction, leg.length - way);
                pieces.push(straight(seconds, start, [(direction, speed), (next, speed)], [way; 2]));
                Ok(())
            }
            (LegPath::Tool(line), Some(LegPath::Tool(next))) => {
                let before = SpeedRamp { from: -way, speeds: [speed, 0.0] };
                let after = SpeedRamp { from: 0.0, speeds: [0.0, speed] };
                let along = [(line.direction, before), (next.direction, after)];
                let there = |way: f64| SpeedRamp { from: way, speeds: [speed; 2] };
                let ends =
                    [line.moving(&there(leg.length - way), 0.0, seconds), next.moving(&there(way), 0.0, seconds)];
                let first = pieces.len();
                let followed = CornerPath { frame: next.from, along, seconds }.follow(self.checker.arm(), ends, pieces);
                followed.ok_or_else(|| lost(leg.after, self.checker))?;
                self.keep_apart_from_singularities(leg, next, &pieces[first..])
            }
            _ => Ok(()),
        }
    }

    /// The lines were checked; around a corner the arm is elsewhere.
    fn keep_apart_from_singularities(&self, leg: &Leg, next: &Line, pieces: &[Piece]) -> Result<(), TrajectoryError> {
        let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return Ok(()) };
        if next.is_apart_all_along(self.checker, pieces) {
            return Ok(());
        }
        let ends = [&first.joints(0.0), &last.joints(1.0)];
        pieces.iter().try_for_each(|piece| {
            let kept = self.checker.no_nearer_to_singularities(ends, &piece.joints(0.5));
            kept.map_err(|exceeded| beyond_on(leg.after, self.checker, exceeded))
        })
    }

    /// Whether a leg or a corner asked too much and gets slower.
    fn slow_down(&mut self, index: usize, made: &LegPieces, pieces: &[Piece]) -> bool {
        let [leg, corner] = [&made.of_leg, &made.of_corner].map(|range| {
            let factors = pieces[range.clone()].iter().map(|piece| self.factor(&self.legs[index], piece));
            factors.fold(1.0, f64::min)
        });
        let [leg_is_slower, corner_is_slower] = [leg, corner].map(|factor| factor < 1.0 - ENOUGH);
        if leg_is_slower {
            let speed = made.passage.speeds[1];
            self.bounds[index] = Bounds { speed, ..self.bounds[index] }.slowed(leg - MARGIN);
        }
        if corner_is_slower {
            let speed = made.passage.speeds[2];
            self.corners[index + 1] = Corner { speed, ..self.corners[index + 1] }.slowed(corner - MARGIN);
        }
        leg_is_slower || corner_is_slower
    }

    /// How much slower a piece has to be; above 1 if it need not.
    fn factor(&self, leg: &Leg, piece: &Piece) -> f64 {
        match leg.path {
            LegPath::Joints(_) => self.factor_by_tcp(piece),
            // No point of it is faster than its speed: around a corner both speeds together are that.
            LegPath::Tool(_) => self.factor_by_joints(piece),
        }
    }

    fn factor_by_tcp(&self, piece: &Piece) -> f64 {
        let most = self.budget.tcp_speed;
        if most.is_infinite() || self.checker.arm().radii().tcp_rate_at_most(&piece.hull().speeds) <= most {
            return 1.0;
        }
        let shares = (0..=TCP_PLACES).map(|place| f64::from(place) / f64::from(TCP_PLACES));
        let rates =
            shares.map(|share| piece.at(share)).map(|at| self.checker.arm().tcp_rate(&at.joints.0, &at.velocity));
        most / rates.fold(0.0, f64::max)
    }

    fn factor_by_joints(&self, piece: &Piece) -> f64 {
        let Budget { speeds, accelerations, jerks, .. } = self.budget;
        let least = |limits: &[f64; 6], found: [f64; 6]| {
            limits.iter().zip(found).map(|(limit, found)| limit / found).fold(f64::INFINITY, f64::min)
        };
        let hull = piece.hull();
        let least_at_once = least(speeds, hull.speeds).min(least(accelerations, hull.accelerations));
        if least_at_once.min(least(jerks, piece.jerks_at_most())) >= 1.0 {
            return 1.0;
        }
        let by_acceleration = least(accelerations, piece.top_accelerations()).sqrt();
        least(speeds, piece.top_speeds()).min(by_acceleration).min(least(jerks, piece.top_jerks()).cbrt())
    }
}

/// A piece in joint space, at both ends of which the joints move along a direction with a speed, over these ways along
/// each.
fn straight(seconds: f64, start: [f64; 6], ends: [(&[f64; 6], f64); 2], ways: [f64; 2]) -> Piece {
    let [(one, _), (other, _)] = ends;
    let moved = std::array::from_fn(|joint| ways[0] * one[joint] + ways[1] * other[joint]);
    let [from, to] = ends.map(|(direction, speed)| Sample {
        joints: start.into(),
        velocity: direction.map(|each| each * speed),
        acceleration: [0.0; 6],
    });
    Piece::moving(0.0, seconds, moved, &from, &to)
}

/// All pieces in their order and time, and the way-points at both ends of all legs.
fn one_after_the_other(made: &[LegPieces], mut pieces: Vec<Piece>) -> (Vec<Piece>, Vec<WayPoint>) {
    let count: usize = made.iter().map(|made| made.of_leg.len() + made.of_corner.len()).sum();
    if count < pieces.len() {
        // Some were made again, at the end.
        let ordered = made.iter().flat_map(|made| &pieces[made.of_leg.start..made.of_corner.end]).cloned();
        let mut all = Vec::with_capacity(count);
        all.extend(ordered);
        pieces = all;
    }
    let mut way_points = Vec::with_capacity(made.len() + 1);
    way_points.push(WayPoint { time_s: 0.0, passing: Passing::Stops });
    let (mut time_s, mut left) = (0.0, pieces.as_mut_slice());
    for LegPieces { passage, of_leg, of_corner } in made {
        let (of_both, later) = std::mem::take(&mut left).split_at_mut(of_leg.len() + of_corner.len());
        left = later;
        let leg_s: f64 = of_both[..of_leg.len()].iter().map(|piece| piece.seconds).sum();
        let (later_s, passing) = match () {
            () if passage.corner_s > 0.0 => (0.5 * passage.corner_s, Passing::Rounded),
            () if passage.speeds[2] > 0.0 => (0.0, Passing::Through),
            () => (0.0, Passing::Stops),
        };
        way_points.push(WayPoint { time_s: time_s + leg_s + later_s, passing });
        for piece in of_both {
            piece.start_s = time_s;
            time_s += piece.seconds;
        }
    }
    (pieces, way_points)
}

/// The joints were not found all along a leg.
pub(super) fn lost(after: usize, checker: &Checker) -> TrajectoryError {
    beyond_on(after, checker, Exceeded::NotConfirmed)
}

fn beyond_on(after: usize, checker: &Checker, exceeded: Exceeded) -> TrajectoryError {
    let beyond = checker.beyond_of(Way::Trajectory, exceeded);
    TrajectoryError::Beyond { after, time_s: None, beyond: Box::new(beyond) }
}
