//! When a trajectory is where.

use super::TrajectoryError;
use super::leg::{Budget, Leg, Tolerances, Way};
use super::plan::{Bounds, Corner, Passage, plan};
use super::tool_way::{Course, ToolWay};
use super::way_point::{Passing, WayPoint};
use crate::beyond::{Exceeded, Way as Checked};
use crate::checker::Checker;
use crate::piece::{Piece, Sample};

/// The legs, and how fast they and their corners may be.
///
/// What lines ask of the joints is known once the joints are: legs and corners that ask too much get slower, and all is planned again.
#[derive(Debug)]
pub(super) struct Timing<'a> {
    legs: &'a [Leg],
    lengths: Vec<f64>,
    bounds: Vec<Bounds>,
    corners: Vec<Corner>,
    budget: &'a Budget,
    checker: &'a Checker,
}

/// The pieces that were made.
#[derive(Debug, Default)]
struct Made {
    passages: Vec<Passage>,
    pieces: Vec<Piece>,
    /// Where those of each leg end, and those of the corner after it.
    ends: Vec<[usize; 2]>,
    /// The way-points at the ends of the legs.
    way_points: Vec<WayPoint>,
    time_s: f64,
    joints: [f64; 6],
}

/// How often it is planned.
const ROUNDS: usize = 12;
/// A stretch need not get slower by less than this share.
const ENOUGH: f64 = 0.02;
/// How much slower than needed it gets.
const MARGIN: f64 = 0.005;
/// At how many places on a piece the speed of the tool centre point is looked at.
const TCP_PLACES: u32 = 4;

impl<'a> Timing<'a> {
    pub(super) fn new(
        legs: &'a [Leg],
        tolerances: &Tolerances,
        budget: &'a Budget,
        checker: &'a Checker,
    ) -> Result<Self, TrajectoryError> {
        let survey = |leg: &Leg| leg.survey(budget, checker).ok_or_else(|| lost(leg, checker));
        let found = legs.iter().map(survey).collect::<Result<Vec<_>, _>>()?;
        let pairs = legs.windows(2).zip(found.windows(2));
        let between = pairs.map(|(legs, found)| legs[0].corner(&legs[1], [&found[0], &found[1]], tolerances, budget));
        let corners = std::iter::once(Corner::STOP).chain(between).chain([Corner::STOP]).collect();
        let lengths = legs.iter().map(|leg| leg.length).collect();
        let bounds = found.into_iter().map(|found| found.bounds).collect();
        Ok(Self { legs, lengths, bounds, corners, budget, checker })
    }

    /// The pieces, and the way-points at both ends of all legs.
    pub(super) fn pieces(mut self) -> Result<(Vec<Piece>, Vec<WayPoint>), TrajectoryError> {
        let mut made = Made::default();
        for _ in 0..ROUNDS {
            made = self.make(&made)?;
            if !self.slow_down(&made) {
                break;
            }
        }
        Ok((made.pieces, made.way_points))
    }

    /// Makes all pieces; those of legs that are passed as before are copied.
    fn make(&self, before: &Made) -> Result<Made, TrajectoryError> {
        let passages = plan(&self.lengths, &self.bounds, &self.corners);
        let mut made = Made { pieces: Vec::with_capacity(4 * passages.len()), ..Made::default() };
        made.way_points.push(WayPoint { time_s: 0.0, passing: Passing::Stops });
        for (index, passage) in passages.iter().enumerate() {
            let [_, _, speed] = passage.speeds;
            let is_as_before = before.passages.get(index) == Some(passage);
            if is_as_before {
                made.copy(before.pieces_of(index)[0]);
            } else {
                self.make_leg(index, passage, &mut made)?;
            }
            let leg_end = made.pieces.len();
            let (later_s, passing) = match () {
                () if passage.corner_s > 0.0 => (0.5 * passage.corner_s, Passing::Rounded),
                () if speed > 0.0 => (0.0, Passing::Through),
                () => (0.0, Passing::Stops),
            };
            made.way_points.push(WayPoint { time_s: made.time_s + later_s, passing });
            if is_as_before {
                made.copy(before.pieces_of(index)[1]);
            } else if passage.corner_s > 0.0 {
                self.make_corner(index, speed, passage.corner_s, &mut made)?;
            }
            made.ends.push([leg_end, made.pieces.len()]);
        }
        made.passages = passages;
        Ok(made)
    }

    fn make_leg(&self, index: usize, passage: &Passage, made: &mut Made) -> Result<(), TrajectoryError> {
        let (leg, mut from) = (&self.legs[index], passage.from);
        if from == 0.0 {
            made.joints = leg.start;
        }
        let [first, top, last] = passage.speeds;
        for (speeds, seconds) in [[first, top], [top, top], [top, last]].into_iter().zip(passage.seconds) {
            if seconds <= 0.0 {
                continue;
            }
            let way = 0.5 * (speeds[0] + speeds[1]) * seconds;
            match &leg.way {
                Way::Joints(direction) => {
                    let start = leg.joints_at(direction, from);
                    made.push(seconds, start, [(direction, speeds[0]), (direction, speeds[1])], [way, 0.0]);
                }
                Way::Tool { from: frame, direction } => {
                    let along = [(*direction, Course { from, speeds }), (*direction, Course::NONE)];
                    self.lead(leg, &ToolWay { frame: *frame, along, seconds }, made)?;
                }
            }
            from += way;
        }
        Ok(())
    }

    /// The corner after a leg; legs of two kinds have none between them.
    fn make_corner(&self, index: usize, speed: f64, seconds: f64, made: &mut Made) -> Result<(), TrajectoryError> {
        let (leg, way) = (&self.legs[index], 0.5 * speed * seconds);
        match (&leg.way, self.legs.get(index + 1).map(|next| &next.way)) {
            (Way::Joints(direction), Some(Way::Joints(next))) => {
                let start = leg.joints_at(direction, leg.length - way);
                made.push(seconds, start, [(direction, speed), (next, speed)], [way; 2]);
                Ok(())
            }
            (Way::Tool { direction, .. }, Some(Way::Tool { from: frame, direction: next })) => {
                let before = Course { from: -way, speeds: [speed, 0.0] };
                let after = Course { from: 0.0, speeds: [0.0, speed] };
                let along = [(*direction, before), (*next, after)];
                let first = made.pieces.len();
                self.lead(leg, &ToolWay { frame: *frame, along, seconds }, made)?;
                self.keep_apart_from_singularities(leg, &made.pieces[first..])
            }
            _ => Ok(()),
        }
    }

    /// The lines were checked; around a corner the arm is elsewhere.
    fn keep_apart_from_singularities(&self, leg: &Leg, pieces: &[Piece]) -> Result<(), TrajectoryError> {
        let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return Ok(()) };
        let ends = [&first.joints(0.0), &last.joints(1.0)];
        pieces.iter().try_for_each(|piece| {
            let kept = self.checker.no_nearer_to_singularities(ends, &piece.joints(0.5));
            kept.map_err(|exceeded| beyond_on(leg, self.checker, exceeded))
        })
    }

    fn lead(&self, leg: &Leg, way: &ToolWay, made: &mut Made) -> Result<(), TrajectoryError> {
        let followed = way.follow(self.checker, made.time_s, made.joints, &mut made.pieces);
        made.joints = followed.ok_or_else(|| lost(leg, self.checker))?;
        made.time_s += way.seconds;
        Ok(())
    }

    /// Whether a leg or a corner asked too much and got slower.
    fn slow_down(&mut self, made: &Made) -> bool {
        let mut slower = false;
        for (index, passage) in made.passages.iter().enumerate() {
            let [leg, corner] = made.pieces_of(index).map(|pieces| {
                let factors = pieces.iter().map(|piece| self.factor(&self.legs[index], piece));
                factors.fold(1.0, f64::min)
            });
            if leg < 1.0 - ENOUGH {
                let speed = passage.speeds[1];
                self.bounds[index] = Bounds { speed, ..self.bounds[index] }.slowed(leg - MARGIN);
                slower = true;
            }
            if corner < 1.0 - ENOUGH {
                let speed = passage.speeds[2];
                self.corners[index + 1] = Corner { speed, ..self.corners[index + 1] }.slowed(corner - MARGIN);
                slower = true;
            }
        }
        slower
    }

    /// How much slower a piece has to be; above 1 if it need not.
    fn factor(&self, leg: &Leg, piece: &Piece) -> f64 {
        let Budget { speeds, accelerations, jerks, tcp_speed } = self.budget;
        let least = |limits: &[f64; 6], found: [f64; 6]| {
            limits.iter().zip(found).map(|(limit, found)| limit / found).fold(f64::INFINITY, f64::min)
        };
        let shares =
            (0..=TCP_PLACES).map(|place| f64::from(place) / f64::from(TCP_PLACES)).map(|share| piece.at(share));
        let tcp = if tcp_speed.is_finite() {
            let fastest =
                shares.map(|sample| self.checker.tcp_rate(&sample.joints.0, &sample.velocity)).fold(0.0, f64::max);
            tcp_speed / fastest
        } else {
            f64::INFINITY
        };
        match leg.way {
            Way::Joints(_) => tcp,
            Way::Tool { .. } => {
                let by_acceleration = least(accelerations, piece.top_accelerations()).sqrt();
                let by_jerk = least(jerks, piece.top_jerks()).cbrt();
                tcp.min(least(speeds, piece.top_speeds())).min(by_acceleration).min(by_jerk)
            }
        }
    }
}

impl Made {
    /// The pieces of a leg, and of the corner after it.
    fn pieces_of(&self, leg: usize) -> [&[Piece]; 2] {
        let [leg_end, corner_end] = self.ends[leg];
        let start = if leg == 0 { 0 } else { self.ends[leg - 1][1] };
        [&self.pieces[start..leg_end], &self.pieces[leg_end..corner_end]]
    }

    /// Adds pieces that were made for other times.
    fn copy(&mut self, pieces: &[Piece]) {
        for piece in pieces {
            self.pieces.push(piece.starting_at(self.time_s));
            self.time_s += piece.seconds;
        }
        self.joints = pieces.last().map_or(self.joints, |last| last.joints(1.0));
    }

    /// Adds a piece in joint space, at both ends of which the joints move along a direction with a speed, over these ways along each.
    fn push(&mut self, seconds: f64, start: [f64; 6], ends: [(&[f64; 6], f64); 2], ways: [f64; 2]) {
        let [(one, _), (other, _)] = ends;
        let moved = std::array::from_fn(|joint| ways[0] * one[joint] + ways[1] * other[joint]);
        let [from, to] = ends.map(|(direction, speed)| Sample {
            joints: start.into(),
            velocity: direction.map(|each| each * speed),
            acceleration: [0.0; 6],
        });
        self.pieces.push(Piece::moving(self.time_s, seconds, moved, &from, &to));
        self.time_s += seconds;
        self.joints = std::array::from_fn(|joint| start[joint] + moved[joint]);
    }
}

/// The joints were not found all along a leg.
fn lost(leg: &Leg, checker: &Checker) -> TrajectoryError {
    beyond_on(leg, checker, Exceeded::NotConfirmed)
}

fn beyond_on(leg: &Leg, checker: &Checker, exceeded: Exceeded) -> TrajectoryError {
    let beyond = checker.beyond_of(Checked::Trajectory, exceeded);
    TrajectoryError::Beyond { after: leg.after, time_s: None, beyond: Box::new(beyond) }
}
