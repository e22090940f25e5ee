//! Times of a trajectory: one speed over the whole path from stop to stop.

use super::leg::{Budget, LegSpeeds};
use super::path::{Path, PathPiece, PieceShape};
use super::slow::{SlowPlace, SlowedBy};
use super::speed::{PathLimits, Place, Speed, quickest};
use super::{Passing, TrajectoryError, WayPoint};
use crate::checker::Checker;
use crate::piece::{Piece, Sample};

/// Part of a path from rest to rest, and the limits that slow it down.
struct Stretch<'a> {
    pieces: &'a [PathPiece],
    /// Piece and share of each place.
    shares: Vec<(usize, f64)>,
    places: Vec<Place>,
    budget: &'a Budget,
    checker: &'a Checker,
}

/// Motion along a stretch.
struct Planned {
    intervals: Vec<Interval>,
    /// Factor by which the whole motion is slower.
    factor: f64,
    slow: Vec<SlowPlace>,
}

/// Motion between two places.
struct Interval {
    from: f64,
    /// Length by the parameter.
    length: f64,
    seconds: f64,
    /// Squared speed at the start, its slope and half of its second derivative; `None` if the interval starts from rest
    /// or ends there, with a constant jerk.
    squared: Option<[f64; 3]>,
    /// Whether the interval starts from rest.
    is_start: bool,
}

/// Greatest number of rounds in which places that are too fast become slower.
const ROUNDS: usize = 6;
/// Greatest excess, as a factor, that slowing the whole motion removes; above it single places become slower.
const LITTLE: f64 = 1.03;
/// Planned shares of accelerations and jerks; between two places a little more is used.
const PLANNED: [f64; 2] = [0.995, 0.98];
/// Largest factor by which a place becomes slower in a round.
const MOST_SLOWER: f64 = 1.3;
/// Duration of the constant jerk at a start and an end, in seconds.
const LAUNCH_S: f64 = 0.03;
/// Factor between neighbouring distances of places.
const GROWTH: f64 = 1.35;
/// Time between places elsewhere, in seconds, unless a piece is short.
const PLACES_S: f64 = 0.02;
/// Duration, in seconds, below which a piece of time is not cut.
const SHORT_S: f64 = 2e-4;
/// Shares and weights of the quadrature of Gauss and Legendre with five points.
const QUADRATURE: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_094_5),
    (0.230_765_344_947_158_5, 0.239_314_335_249_683_2),
    (0.5, 0.284_444_444_444_444_4),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_2),
    (0.953_089_922_969_332, 0.118_463_442_528_094_5),
];
/// Share of a piece over which the tool's speed is differenced.
const BESIDE: f64 = 1e-3;
/// Greatest distance of a piece of time from the path, in degrees of a joint.
const OFF_PATH_DEG: f64 = 1e-4;
/// Greatest such distance for each deg/s³ of the joint's limit of jerk, times the cube of the piece's seconds.
const OFF_JERK: f64 = 2.5e-5;
/// Least share of an interval for one piece of time.
const LEAST_SHARE: f64 = 1e-3;

/// Pieces of time along a path, its way-points, and places that are slower than requested.
pub(super) struct Timed {
    pub(super) pieces: Vec<Piece>,
    pub(super) passages: Vec<WayPoint>,
    pub(super) slow: Vec<SlowPlace>,
}

pub(super) fn timed(path: &Path, budget: &Budget, checker: &Checker) -> Result<Timed, TrajectoryError> {
    let mut pieces: Vec<Piece> = Vec::with_capacity(6 * path.pieces.len());
    let mut way_points = vec![WayPoint { time_s: 0.0, passing: Passing::Stops }];
    let (mut marks, mut slow) = (path.marks.iter().peekable(), Vec::new());
    for stretch in path.pieces.split_inclusive(|piece| piece.stops) {
        let start_s = pieces.last().map_or(0.0, Piece::end_s);
        let end = stretch.last().map_or(0.0, |piece| piece.joints.end_s());
        let Planned { intervals, factor, slow: places } =
            Stretch::new(stretch, budget, checker).planned(start_s, &mut pieces)?;
        slow.extend(places);
        let end_s = pieces.last().map_or(start_s, Piece::end_s);
        let last = |at: f64, passing: Passing| passing == Passing::Stops || at < end;
        let (mut intervals, mut before_s) = (intervals.iter().peekable(), 0.0);
        while let Some(mark) = marks.next_if(|mark| mark.at <= end && last(mark.at, mark.passing)) {
            let time_s = match mark.passing {
                Passing::Stops => end_s,
                Passing::Through | Passing::Rounded => {
                    while let Some(past) = intervals.next_if(|interval| interval.from + interval.length <= mark.at) {
                        before_s += past.seconds;
                    }
                    let within = intervals.peek().map_or(0.0, |interval| {
                        interval.seconds_to(((mark.at - interval.from) / interval.length).max(0.0))
                    });
                    start_s + factor * (before_s + within)
                }
            };
            way_points.push(WayPoint { time_s, passing: mark.passing });
        }
    }
    Ok(Timed { pieces, passages: way_points, slow: SlowPlace::sorted(slow) })
}

impl<'a> Stretch<'a> {
    fn new(pieces: &'a [PathPiece], budget: &'a Budget, checker: &'a Checker) -> Self {
        let mut stretch = Self { pieces, shares: Vec::new(), places: Vec::new(), budget, checker };
        stretch.shares = stretch.shares();
        let shares = std::mem::take(&mut stretch.shares);
        stretch.places = shares.iter().map(|place| stretch.place(*place)).collect();
        for (index, (piece, share)) in shares.iter().enumerate() {
            // The third derivative steps between pieces.
            if *share == 0.0 && *piece > 0 {
                stretch.places[index].third[0] = pieces[piece - 1].joints.jerk(1.0);
                let by_speed = stretch.squared_at_most(pieces[piece - 1].speeds, (*piece, 0.0));
                stretch.places[index].most = stretch.places[index].most.min(by_speed);
            }
        }
        for (index, pair) in shares.windows(2).enumerate() {
            let [(piece, from), (next, to)] = [pair[0], pair[1]];
            if pieces[piece].shape != PieceShape::Straight {
                let joints = &pieces[piece].joints;
                let middle = f64::midpoint(from, if next == piece { to } else { 1.0 });
                let there = joints.at(middle);
                stretch.places[index].middle = Some([there.velocity, there.acceleration, joints.jerk(middle)]);
            }
        }
        stretch.shares = shares;
        stretch
    }

    fn place(&self, (piece, share): (usize, f64)) -> Place {
        let by_speed = self.squared_at_most(self.pieces[piece].speeds, (piece, share));
        let piece = &self.pieces[piece].joints;
        let there = piece.at(share);
        let (first, second, third) = (there.velocity, there.acceleration, piece.jerk(share));
        let Budget { accelerations, jerks, curving, .. } = self.budget;
        let by_joints = (0..6).map(|joint| {
            let by_bend = curving * accelerations[joint] / second[joint].abs();
            by_bend.min((jerks[joint] / third[joint].abs()).powf(2.0 / 3.0))
        });
        let tool = self.tool(piece, share);
        let by_tool_bend = curving * self.budget.tcp_acceleration / tool[1].abs();
        let most = by_joints.fold(by_speed.min(by_tool_bend), f64::min);
        Place { at: piece.start_s + share * piece.seconds, first, second, third: [third; 2], tool, most, middle: None }
    }

    /// Returns the limit of the square of the path parameter's speed by the speeds of a leg.
    fn squared_at_most(&self, leg: LegSpeeds, (piece, share): (usize, f64)) -> f64 {
        let LegSpeeds { tcp_speed, joint_speeds } = self.budget.speeds_on(leg);
        let there = self.pieces[piece].joints.at(share);
        let by_joints = (0..6).map(|joint| joint_speeds[joint] / there.velocity[joint].abs());
        let by_tool = if tcp_speed.is_finite() {
            tcp_speed / self.checker.arm().tcp_rate(&there.joints.0, &there.velocity)
        } else {
            f64::INFINITY
        };
        by_joints.fold(by_tool, f64::min).powi(2)
    }

    /// Returns the derivative of the tool's distance by the path parameter, and its second derivative; 0 if the tool's
    /// acceleration is not limited.
    fn tool(&self, piece: &Piece, share: f64) -> [f64; 2] {
        if self.budget.tcp_acceleration.is_infinite() {
            return [0.0; 2];
        }
        let rate = |share: f64| {
            let there = piece.at(share);
            self.checker.arm().tcp_rate(&there.joints.0, &there.velocity)
        };
        let [from, to] = [share - BESIDE, share + BESIDE].map(|share| share.clamp(0.0, 1.0));
        [rate(share), (rate(to) - rate(from)) / (to - from) / piece.seconds]
    }

    /// Returns the places at which the speed is planned: close to one another next to rest and corners.
    fn shares(&self) -> Vec<(usize, f64)> {
        let steps = self.steps();
        let mut shares = Vec::with_capacity(8 * self.pieces.len());
        for (index, piece) in self.pieces.iter().enumerate() {
            let length = piece.joints.seconds;
            let mut places = graded(length, steps[index], self.longest(index));
            let from_end = graded(length, steps[index + 1], self.longest(index));
            places.extend(from_end[1..].iter().rev().map(|at| length - at));
            shares.extend(places.iter().map(|at| (index, at / length)));
        }
        shares.push((self.pieces.len() - 1, 1.0));
        shares
    }

    /// Returns the longest distance of places on a piece; a piece of short duration has few places.
    fn longest(&self, index: usize) -> f64 {
        let piece = &self.pieces[index];
        let [least, most] = match piece.shape {
            PieceShape::Corner => [2.0, 6.0],
            PieceShape::Curve | PieceShape::Straight => [1.0, 4.0],
        };
        let seconds = piece.joints.seconds / self.place((index, 0.5)).most.sqrt();
        piece.joints.seconds / (seconds / PLACES_S).ceil().clamp(least, most)
    }

    /// Returns the distances of places at the ends of pieces.
    fn steps(&self) -> Vec<f64> {
        let count = self.pieces.len();
        let mut steps = vec![f64::INFINITY; count + 1];
        for index in 0..count {
            let slowest =
                [0.0, 0.5, 1.0].map(|share| self.place((index, share)).most).into_iter().fold(f64::INFINITY, f64::min);
            let step = PLACES_S * slowest.sqrt();
            steps[index] = steps[index].min(step);
            steps[index + 1] = steps[index + 1].min(step);
        }
        (steps[0], steps[count]) = (self.launch(0, 0.0), self.launch(count - 1, 1.0));
        let lengths: Vec<_> = self.pieces.iter().map(|piece| (GROWTH - 1.0) * piece.joints.seconds).collect();
        for (index, length) in lengths.iter().enumerate() {
            steps[index + 1] = steps[index + 1].min(steps[index] + length);
        }
        for (index, length) in lengths.iter().enumerate().rev() {
            steps[index] = steps[index].min(steps[index + 1] + length);
        }
        steps
    }

    /// Returns the length of the start or the end with a constant jerk.
    fn launch(&self, piece: usize, share: f64) -> f64 {
        let first = self.pieces[piece].joints.at(share).velocity;
        let jerk = (0..6).map(|joint| self.budget.jerks[joint] / first[joint].abs()).fold(f64::INFINITY, f64::min);
        let whole: f64 = self.pieces.iter().map(|piece| piece.joints.seconds).sum();
        (jerk * LAUNCH_S.powi(3) / 6.0).min(whole / 24.0).min(self.pieces[piece].joints.seconds / 6.0)
    }

    /// Plans the stretch, and adds its pieces.
    fn planned(mut self, start_s: f64, pieces: &mut Vec<Piece>) -> Result<Planned, TrajectoryError> {
        let share = |limits: &[f64; 6], share: f64| limits.map(|limit| share * limit);
        let limits = PathLimits {
            accelerations: share(&self.budget.accelerations, PLANNED[0]),
            tool: PLANNED[0] * self.budget.tcp_acceleration,
            jerks: share(&self.budget.jerks, PLANNED[1]),
        };
        let before = pieces.len();
        let mut round = 1;
        loop {
            let speeds = quickest(&self.places, &limits).ok_or_else(|| {
                TrajectoryError::between(self.pieces[0].after, self.checker, crate::beyond::Exceeded::NotConfirmed)
            })?;
            let intervals = self.intervals(&speeds);
            let mut worst = 1.0_f64;
            let mut slower = Vec::new();
            for (index, interval) in intervals.iter().enumerate() {
                let from = pieces.len();
                self.follow(index, interval, pieces);
                let factor = pieces[from..].iter().map(|piece| self.factor(index, piece)).fold(1.0, f64::max);
                worst = worst.max(factor);
                if factor > LITTLE {
                    slower.push((index, factor));
                }
            }
            if slower.is_empty() || round == ROUNDS {
                one_after_the_other(&mut pieces[before..], start_s, worst);
                let slow = self.slow(&speeds, &intervals, (start_s, worst));
                return Ok(Planned { intervals, factor: worst, slow });
            }
            pieces.truncate(before);
            for (index, factor) in slower {
                let factor = factor.min(MOST_SLOWER);
                for place in index..=index + 1 {
                    let squared =
                        intervals[place.min(intervals.len() - 1)].squared.map_or(f64::INFINITY, |squared| squared[0]);
                    self.places[place].most = self.places[place].most.min(squared) / factor / factor;
                }
            }
            round += 1;
        }
    }

    /// Returns the places at which the tool is slower than requested; the whole motion is slower by a factor.
    fn slow(&self, speeds: &[Speed], intervals: &[Interval], (start_s, factor): (f64, f64)) -> Vec<SlowPlace> {
        let tcp_asked = |piece: usize| self.budget.tcp_asked.min(self.pieces[piece].speeds.tcp_speed);
        if (0..self.pieces.len()).all(|piece| tcp_asked(piece).is_infinite()) {
            return Vec::new();
        }
        let (mut time_s, mut all) = (start_s, Vec::with_capacity(speeds.len()));
        for (index, speed) in speeds.iter().enumerate() {
            time_s += factor * intervals[index].seconds;
            let (piece, share) = self.shares[index + 1];
            let joints = self.pieces[piece].joints.joints(share);
            let along = speed.squared.sqrt() / factor;
            let tool = self.checker.arm().tcp_rate(&joints, &self.places[index + 1].first) * along;
            let [_, turn] = self.places[index + 1].tool;
            let change = turn * speed.squared + self.places[index + 1].tool[0] * 0.5 * speed.slope;
            let used = self.used(index + 1, speed, &intervals[index + 1]);
            let by = SlowedBy::of(used, change.abs() / self.budget.tcp_acceleration);
            all.push(SlowPlace { time_s, share: tool / tcp_asked(piece), by });
        }
        SlowPlace::slowest(&all)
    }

    /// Returns the used shares of the limits of speeds, accelerations and jerks at a place.
    fn used(&self, place: usize, speed: &Speed, after: &Interval) -> [[f64; 6]; 3] {
        let Budget { accelerations, jerks, curving, .. } = self.budget;
        let speeds = self.budget.speeds_on(self.pieces[self.shares[place].0].speeds).joint_speeds;
        let Place { first, second, third, .. } = &self.places[place];
        let (along, change) = (speed.squared.sqrt(), 0.5 * speed.slope);
        let rounding = after.squared.map_or(0.0, |[_, _, bend]| bend);
        [
            std::array::from_fn(|joint| (first[joint] * along / speeds[joint]).abs()),
            std::array::from_fn(|joint| {
                let bent = second[joint] * speed.squared;
                let all = (bent + first[joint] * change).abs() / accelerations[joint];
                all.max(bent.abs() / (curving * accelerations[joint]))
            }),
            std::array::from_fn(|joint| {
                let curved = third[1][joint] * speed.squared + 3.0 * second[joint] * change;
                ((curved + first[joint] * rounding) * along / jerks[joint]).abs()
            }),
        ]
    }

    fn intervals(&self, speeds: &[Speed]) -> Vec<Interval> {
        let last = self.places.len() - 2;
        let pairs = self.places.windows(2).enumerate();
        pairs
            .map(|(index, pair)| {
                let (from, length) = (pair[0].at, pair[1].at - pair[0].at);
                if index == 0 || index == last {
                    let speed = speeds[if index == 0 { 0 } else { speeds.len() - 1 }].squared.sqrt();
                    return Interval {
                        from,
                        length,
                        seconds: 3.0 * length / speed,
                        squared: None,
                        is_start: index == 0,
                    };
                }
                let [one, other] = [speeds[index - 1], speeds[index]];
                let squared = [one.squared, one.slope, 0.5 * (other.slope - one.slope) / length];
                let mut interval = Interval { from, length, seconds: 0.0, squared: Some(squared), is_start: false };
                interval.seconds = interval.seconds_to(1.0);
                interval
            })
            .collect()
    }

    /// Adds the pieces of time of an interval, each as long as possible near the path.
    fn follow(&self, index: usize, interval: &Interval, pieces: &mut Vec<Piece>) {
        let (piece, first) = self.shares[index];
        let joints = &self.pieces[piece].joints;
        let start = first;
        let end = match self.shares.get(index + 1) {
            Some((next, share)) if *next == piece => *share,
            _ => 1.0,
        };
        let at = |share: f64| {
            let there = joints.at(start + share * (end - start));
            let [speed, change] = interval.speed(share);
            Sample {
                joints: there.joints,
                velocity: there.velocity.map(|each| each * speed),
                acceleration: std::array::from_fn(|joint| {
                    there.acceleration[joint] * speed * speed + there.velocity[joint] * change
                }),
            }
        };
        let (mut from, mut step) = (0.0, 1.0_f64);
        let mut here = at(0.0);
        let mut done_s = 0.0;
        while from < 1.0 {
            let to = (from + step).min(1.0);
            let next = at(to);
            let seconds = interval.seconds_to(to) - done_s;
            let made = Piece::between(0.0, seconds, &here, &next);
            let middle = f64::midpoint(from, to);
            let share_s = (interval.seconds_to(middle) - done_s) / seconds;
            let (on_path, found) = (at(middle).joints.0, made.joints(share_s));
            // The error of a piece's jerk is some 400 times this distance, divided by the cube of the piece's time.
            let near = |joint: usize| OFF_PATH_DEG.min(OFF_JERK * self.budget.jerks[joint] * seconds.powi(3));
            let is_near = (0..6).all(|joint| (on_path[joint] - found[joint]).abs() <= near(joint));
            if !is_near && to - from > LEAST_SHARE && seconds > SHORT_S {
                step = 0.5 * (to - from);
                continue;
            }
            pieces.push(made);
            (here, from, done_s) = (next, to, done_s + seconds);
        }
    }

    /// Returns the factor by which a piece of time after a place must be slower; 1 if it need not be.
    fn factor(&self, place: usize, piece: &Piece) -> f64 {
        let LegSpeeds { tcp_speed, joint_speeds } = self.budget.speeds_on(self.pieces[self.shares[place].0].speeds);
        let Budget { accelerations, jerks, tcp_acceleration, .. } = self.budget;
        let most = |found: [f64; 6], limits: &[f64; 6]| {
            found.iter().zip(limits).map(|(found, limit)| found / limit).fold(0.0, f64::max)
        };
        let hull = piece.hull();
        let by_speed =
            if most(hull.speeds, &joint_speeds) <= 1.0 { 0.0 } else { most(piece.top_speeds(), &joint_speeds) };
        let by_acceleration = if most(hull.accelerations, accelerations) <= 1.0 {
            0.0
        } else {
            most(piece.top_accelerations(), accelerations)
        };
        let by_jerk = if most(piece.jerks_at_most(), jerks) <= 1.0 { 0.0 } else { most(piece.top_jerks(), jerks) };
        let mut factor = by_speed.max(by_acceleration.sqrt()).max(by_jerk.cbrt()).max(1.0);
        let arm = self.checker.arm();
        if tcp_speed.is_finite() && arm.radii().tcp_rate_at_most(&hull.speeds) > tcp_speed {
            for eighth in 0..=8 {
                let there = piece.at(f64::from(eighth) / 8.0);
                factor = factor.max(arm.tcp_rate(&there.joints.0, &there.velocity) / tcp_speed);
            }
        }
        if tcp_acceleration.is_finite() {
            let rate = |share: f64| {
                let there = piece.at(share);
                arm.tcp_rate(&there.joints.0, &there.velocity)
            };
            let rates = [0.0, 0.25, 0.5, 0.75, 1.0].map(rate);
            let change = rates.windows(2).map(|two| (two[1] - two[0]).abs()).fold(0.0, f64::max);
            factor = factor.max((4.0 * change / piece.seconds / tcp_acceleration).sqrt());
        }
        factor
    }
}

impl Interval {
    /// Returns the speed of the parameter and its derivative by time, at a share of the length.
    fn speed(&self, share: f64) -> [f64; 2] {
        if let Some([squared, slope, bend]) = self.squared {
            let along = share * self.length;
            let squared = squared + along * (slope + along * bend);
            return [squared.max(0.0).sqrt(), 0.5 * slope + along * bend];
        }
        let left = if self.is_start { share } else { 1.0 - share };
        let seconds = self.seconds * left.cbrt();
        let jerk = 6.0 * self.length / self.seconds.powi(3);
        let change = jerk * seconds;
        [0.5 * change * seconds, if self.is_start { change } else { -change }]
    }

    /// Returns the seconds from the start to a share of the length.
    fn seconds_to(&self, share: f64) -> f64 {
        match self.squared {
            Some(_) => {
                let length = share * self.length;
                let sum = QUADRATURE.into_iter().map(|(at, weight)| weight / self.speed(at * share)[0]).sum::<f64>();
                length * sum
            }
            None if self.is_start => self.seconds * share.cbrt(),
            None => self.seconds * (1.0 - (1.0 - share).cbrt()),
        }
    }
}

/// Returns distances from an end, with steps that grow from the first one to the longest, up to the middle.
fn graded(length: f64, first: f64, longest: f64) -> Vec<f64> {
    let (mut places, mut step) = (vec![0.0], first.min(longest));
    let middle = 0.5 * length;
    loop {
        let next = places[places.len() - 1] + step;
        if next > middle - 0.25 * step {
            return places;
        }
        places.push(next);
        step = (step * GROWTH).min(longest);
    }
}

/// Sets the times of pieces, one after the other and slower by a factor.
fn one_after_the_other(pieces: &mut [Piece], start_s: f64, factor: f64) {
    let mut time_s = start_s;
    for piece in pieces {
        piece.seconds *= factor;
        piece.start_s = time_s;
        time_s += piece.seconds;
    }
}
