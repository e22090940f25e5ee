//! Quickest speed along a path from rest to rest, within accelerations and jerks of the joints.
//!
//! The unknown is the squared speed of the path parameter as a function of that parameter: a quadratic spline over the
//! places, which starts and ends with a constant jerk. Accelerations are linear in it. A jerk is linear in it, times
//! the speed: the limit divided by the speed is convex, and its tangent at the last iterate is a conservative bound. A
//! primal-dual interior-point method starts from a speed within all limits and improves it window by window, so the
//! planning time is proportional to the number of places.

use std::ops::Range;

/// Place on a path at which its speed is planned.
#[derive(Debug, Clone)]
pub(super) struct Place {
    /// Path parameter.
    pub(super) at: f64,
    /// First and second derivative of the joints by the path parameter.
    pub(super) first: [f64; 6],
    pub(super) second: [f64; 6],
    /// Third derivative before and after the place.
    pub(super) third: [[f64; 6]; 2],
    /// Derivative of the tool's distance by the path parameter, and its second derivative; 0 if the tool's acceleration
    /// is not limited.
    pub(super) tool: [f64; 2],
    /// Limit of the square of the path parameter's speed.
    pub(super) most: f64,
    /// First, second and third derivative midway between this place and the next, if they differ from those at the
    /// places.
    pub(super) middle: Option<[[f64; 6]; 3]>,
}

/// Limits of the joints' accelerations and jerks, and of the tool's acceleration along its path.
#[derive(Debug, Clone, Copy)]
pub(super) struct PathLimits {
    pub(super) accelerations: [f64; 6],
    pub(super) tool: f64,
    pub(super) jerks: [f64; 6],
}

/// Speed at a place.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Speed {
    /// Square of the path parameter's speed.
    pub(super) squared: f64,
    /// Derivative of `squared` by the path parameter: twice the acceleration.
    pub(super) slope: f64,
}

/// Bound of a combination of three neighbouring coefficients, on both sides.
#[derive(Debug)]
struct Row {
    /// First of the coefficients.
    base: usize,
    weights: [f64; 3],
    bound: f64,
    /// Weights of the squared speed whose root divides the bound, for a jerk.
    speed: Option<[f64; 3]>,
    multipliers: [f64; 2],
    /// Room on both sides of the combination, its inverse, and the derivative of the bound by the squared speed.
    left: [f64; 2],
    inverse: [f64; 2],
    change: f64,
}

/// Coefficients of the quadratic spline, and their bounds.
struct Problem<'p> {
    /// Places except the first and the last.
    inner: &'p [Place],
    limits: &'p PathLimits,
    /// Squared speeds that the path hardly exceeds.
    reference: Vec<f64>,
    /// Distances between places, without the ends.
    steps: Vec<f64>,
    /// Weights of the coefficients before and after each place in the squared speed there.
    weights: Vec<[f64; 2]>,
    /// Factor of their difference in the slope at the place.
    slopes: Vec<f64>,
    /// Length of the path around each place.
    lengths: Vec<f64>,
    /// Length of the path around each coefficient.
    spans: Vec<f64>,
    /// Factors between the first two and the last two coefficients.
    ends: [f64; 2],
    /// Limit of each squared speed, and its multiplier.
    most: Vec<f64>,
    multipliers: Vec<f64>,
    coefficients: Vec<f64>,
    /// Multipliers of the coefficients' least value, 0.
    floors: Vec<f64>,
}

/// Gradient and matrix of a Newton step: each row has the diagonal and the two numbers after it.
struct Newton {
    /// Index of the first coefficient.
    first: usize,
    gradient: Vec<f64>,
    matrix: Vec<[f64; 3]>,
}

/// Limits of the path parameter's motion around a coefficient.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    most: f64,
    acceleration: f64,
    jerk: f64,
}

/// Greatest number of iterations in a window; some 15 suffice.
const ITERATIONS: usize = 60;
/// Remaining gain, as a share of the duration, at which the iteration ends.
const GAP: f64 = 0.004;
/// Number of coefficients by which windows advance.
const ADVANCE: usize = 200;
/// Number of coefficients that a window has in common with the next.
const OVERLAP: usize = 40;
/// Share of a limit that a joint must be able to reach, or the limit is ignored.
const MATTERS: f64 = 0.98;
/// Share of the distance to a bound that one step may take.
const FAR: f64 = 0.99;
/// Greatest factor between a multiplier and its value on the central path.
const NEAR: f64 = 1000.0;
/// Greatest share of each bound that the first speed uses.
const START: f64 = 0.9;

/// Plans the speed at each place except the first and the last, at which the path rests. There are at least five
/// places, and their parameters increase. Returns `None` if no speed is found.
pub(super) fn quickest(places: &[Place], limits: &PathLimits) -> Option<Vec<Speed>> {
    let mut problem = Problem::new(places, limits);
    let last = problem.coefficients.len() - 1;
    let mut from = 1;
    loop {
        let to = if from + 2 * ADVANCE + OVERLAP >= last { last } else { from + ADVANCE + OVERLAP };
        problem.solve(from..to)?;
        if to == last {
            return Some((0..places.len() - 2).map(|place| problem.speed(place)).collect());
        }
        from += ADVANCE;
    }
}

impl PathLimits {
    /// Returns the greatest acceleration of the path parameter from rest.
    fn acceleration(&self, place: &Place) -> f64 {
        let by_joints = least(|joint| self.accelerations[joint] / place.first[joint].abs());
        if self.tool.is_finite() { by_joints.min(self.tool / place.tool[0]) } else { by_joints }
    }
}

impl<'p> Problem<'p> {
    fn new(places: &'p [Place], limits: &'p PathLimits) -> Self {
        let inner = &places[1..places.len() - 1];
        let (count, last) = (inner.len(), inner.len() - 1);
        let steps: Vec<f64> = inner.windows(2).map(|pair| pair[1].at - pair[0].at).collect();
        let step = |index: Option<usize>| index.and_then(|index| steps.get(index)).copied().unwrap_or(0.0);
        let around = |place: usize| [step(place.checked_sub(1)), step(Some(place))];
        let launches = [inner[0].at - places[0].at, places[count + 1].at - inner[last].at];
        let mut most: Vec<f64> = inner.iter().map(|place| place.most).collect();
        let mut lengths: Vec<f64> = (0..count).map(|place| 0.5 * around(place).iter().sum::<f64>()).collect();
        let mut spans = vec![0.0; count + 1];
        spans[1..count].copy_from_slice(&steps);
        for (place, span, launch) in [(0, 1, launches[0]), (last, last, launches[1])] {
            // At a constant jerk from rest the speed is three times the mean.
            lengths[place] += 3.0 * launch;
            spans[span] += 3.0 * launch;
            let jerk = least(|joint| limits.jerks[joint] / inner[place].first[joint].abs());
            let acceleration = limits.acceleration(&inner[place]);
            let by_jerk = 9.0 * launch * launch * (jerk / (6.0 * launch)).powf(2.0 / 3.0);
            most[place] = most[place].min(by_jerk).min(1.5 * acceleration * launch);
        }
        let ends = [steps[0] / launches[0], steps[last - 1] / launches[1]].map(|ratio| 1.0 / (1.0 + 2.0 / 3.0 * ratio));
        let weights = (0..count).map(around).map(|[before, after]| [after, before].map(|step| step / (before + after)));
        let mut problem = Self {
            weights: weights.collect(),
            slopes: (0..count).map(|place| 2.0 / around(place).iter().sum::<f64>()).collect(),
            inner,
            limits,
            reference: Vec::new(),
            multipliers: vec![0.0; count],
            coefficients: vec![0.0; count + 1],
            floors: vec![0.0; count + 1],
            steps,
            lengths,
            spans,
            ends,
            most,
        };
        problem.reference = problem.reference();
        problem.start(launches);
        problem
    }

    /// Returns the squared speeds that the path hardly exceeds: at full jerk and full acceleration away from each
    /// limit.
    fn reference(&self) -> Vec<f64> {
        let Self { inner, limits, .. } = self;
        let jerk = |place: &Place| least(|joint| limits.jerks[joint] / place.first[joint].abs());
        let mut squared = self.most.clone();
        let rises: Vec<f64> = inner.iter().map(|place| 2.0 * limits.acceleration(place)).collect();
        self.sweep(&mut squared, &rises);
        // At a constant jerk from rest, this power of the speed grows in proportion to the path.
        let mut powers: Vec<f64> = squared.into_iter().map(|squared| squared.powf(0.75)).collect();
        let rises: Vec<f64> = inner.iter().map(|place| 1.5 * (2.0 * jerk(place)).sqrt()).collect();
        self.sweep(&mut powers, &rises);
        powers.into_iter().map(|power| power.powf(4.0 / 3.0)).collect()
    }

    /// Lowers values until none rises faster than permitted, in either direction.
    fn sweep(&self, values: &mut [f64], rises: &[f64]) {
        for (place, step) in self.steps.iter().enumerate() {
            values[place + 1] = values[place + 1].min(values[place] + step * rises[place]);
        }
        for (place, step) in self.steps.iter().enumerate().rev() {
            values[place] = values[place].min(values[place + 1] + step * rises[place + 1]);
        }
    }

    /// Returns the bounds that involve some coefficients, in the order of their first ones, without those that cannot
    /// be active.
    fn rows_of(&self, window: &Range<usize>) -> Vec<Row> {
        let from = window.start.saturating_sub(2);
        let mut rows = Vec::with_capacity(16 * window.len());
        for index in from..(window.end + 1).min(self.inner.len()) {
            if index > from {
                self.add_jerks(index - 1, index, &mut rows);
            }
            if index < window.end {
                self.add_rows(index, &mut rows);
            }
        }
        rows
    }

    /// Adds the bounds at a place and between it and the next.
    fn add_rows(&self, index: usize, rows: &mut Vec<Row>) {
        let Place { first, second, tool, .. } = &self.inner[index];
        if self.limits.tool.is_finite() {
            let [before, after] = self.at_place(index, tool[1], 0.5 * tool[0]);
            rows.push(Row::new(index, [before, after, 0.0], self.limits.tool, None));
        }
        for joint in matters(first, second, [[0.0; 6]; 2], self.reference[index], self.limits).0 {
            let [before, after] = self.at_place(index, second[joint], 0.5 * first[joint]);
            rows.push(Row::new(index, [before, after, 0.0], self.limits.accelerations[joint], None));
        }
        if index < self.steps.len() {
            self.add_jerks(index, index, rows);
            self.add_middle(index, rows);
        }
    }

    /// Adds the bounds of jerks at a place that is an end of an interval.
    fn add_jerks(&self, interval: usize, index: usize, rows: &mut Vec<Row>) {
        let Place { first, second, third, .. } = &self.inner[index];
        let at = index - interval;
        for joint in matters(first, second, *third, self.reference[index], self.limits).1 {
            let weigh = |squared, slope| spread(self.at_place(index, squared, slope), at);
            let weights = self.jerk(interval, weigh(third[1 - at][joint], 1.5 * second[joint]), first[joint]);
            rows.push(Row::new(interval, weights, self.limits.jerks[joint], Some(weigh(1.0, 0.0))));
        }
    }

    /// Adds the bounds midway between a place and the next.
    fn add_middle(&self, interval: usize, rows: &mut Vec<Row>) {
        let ([squared, slope], reference) = (self.at_middle(interval), self.reference[interval]);
        let most = self.most[interval].max(self.most[interval + 1]);
        if reference >= 0.5 * most {
            rows.push(Row::new(interval, squared, most, None));
        }
        let Some([first, second, third]) = self.inner[interval].middle else { return };
        for joint in matters(&first, &second, [third; 2], reference, self.limits).1 {
            let here = std::array::from_fn(|at| third[joint] * squared[at] + 1.5 * second[joint] * slope[at]);
            let weights = self.jerk(interval, here, first[joint]);
            rows.push(Row::new(interval, weights, self.limits.jerks[joint], Some(squared)));
        }
    }

    /// Returns the weights of the two coefficients around a place in these multiples of the squared speed and of its
    /// slope.
    fn at_place(&self, place: usize, squared: f64, slope: f64) -> [f64; 2] {
        let ([before, after], slope) = (self.weights[place], slope * self.slopes[place]);
        [squared * before - slope, squared * after + slope]
    }

    /// Returns the weights of three coefficients in the squared speed midway between two places, and in its slope
    /// there.
    fn at_middle(&self, interval: usize) -> [[f64; 3]; 2] {
        let bend = 0.125 * self.steps[interval] * self.steps[interval];
        let mean = |squared: f64, slope: f64| -> [f64; 3] {
            let [one, other] = [0, 1].map(|at| spread(self.at_place(interval + at, 0.5 * squared, 0.5 * slope), at));
            std::array::from_fn(|at| one[at] + other[at])
        };
        let (squared, second) = (mean(1.0, 0.0), self.second_derivative(interval));
        [std::array::from_fn(|at| squared[at] - bend * second[at]), mean(0.0, 1.0)]
    }

    /// Returns the weights of three coefficients in the second derivative between two places.
    fn second_derivative(&self, interval: usize) -> [f64; 3] {
        let (step, [before, after]) = (self.steps[interval], [self.slopes[interval], self.slopes[interval + 1]]);
        [before / step, -(before + after) / step, after / step]
    }

    /// Returns the weights of a jerk, divided by the speed, from the weights of the lower derivatives and of the second
    /// one.
    fn jerk(&self, interval: usize, lower: [f64; 3], first: f64) -> [f64; 3] {
        let second = self.second_derivative(interval);
        std::array::from_fn(|at| lower[at] + 0.5 * first * second[at])
    }

    /// Starts from a speed that nearly uses the limits, scaled down until it is within all of them.
    fn start(&mut self, launches: [f64; 2]) {
        self.coefficients = self.ramps(launches);
        let last = self.coefficients.len() - 1;
        self.coefficients[0] = self.ends[0] * self.coefficients[1];
        self.coefficients[last] = self.ends[1] * self.coefficients[last - 1];
        let mut share = 1.0_f64;
        let mut rows = Vec::with_capacity(32);
        for (index, most) in self.most.iter().enumerate() {
            share = share.min(START * most / self.squared(index));
            if index > 0 {
                self.add_jerks(index - 1, index, &mut rows);
            }
            self.add_rows(index, &mut rows);
            share = rows.drain(..).map(|row| row.share(&self.coefficients)).fold(share, f64::min);
        }
        self.coefficients.iter_mut().for_each(|coefficient| *coefficient *= share);
    }

    /// Returns squared speeds at the coefficients that rise from each limit without acceleration at first, in both
    /// directions, and have round tops.
    fn ramps(&self, launches: [f64; 2]) -> Vec<f64> {
        let Self { inner, limits, .. } = self;
        let count = inner.len();
        let near = |index: usize| [index.saturating_sub(1), index.min(count - 1)];
        let at: Vec<f64> =
            (0..=count).map(|index| f64::midpoint(inner[near(index)[0]].at, inner[near(index)[1]].at)).collect();
        let lowest =
            |index: usize, of: &dyn Fn(usize) -> f64| near(index).map(of).into_iter().fold(f64::INFINITY, f64::min);
        let accelerations = |place: usize| {
            let Place { first, second, tool, .. } = &inner[place];
            let left = |limit: f64, second: f64| (limit - second.abs() * self.most[place]).max(0.1 * limit);
            let by_joints = least(|joint| left(limits.accelerations[joint], second[joint]) / first[joint].abs());
            if limits.tool.is_finite() { by_joints.min(left(limits.tool, tool[1]) / tool[0]) } else { by_joints }
        };
        let jerks = |place: usize| least(|joint| limits.jerks[joint] / inner[place].first[joint].abs());
        let stretches: Vec<Stretch> = (0..=count)
            .map(|index| Stretch {
                most: lowest(index, &|place| self.most[place]),
                acceleration: lowest(index, &accelerations),
                jerk: lowest(index, &jerks),
            })
            .collect();
        let distances: Vec<f64> = at.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let forwards = rising(&stretches, &distances, launches[0]);
        let (mirrored, back): (Vec<_>, Vec<_>) =
            (stretches.iter().rev().copied().collect(), distances.iter().rev().copied().collect());
        let backwards = rising(&mirrored, &back, launches[1]);
        let mut squared: Vec<f64> =
            forwards.into_iter().zip(backwards.into_iter().rev()).map(|(one, other)| one.min(other)).collect();
        round_tops(&mut squared, &stretches, &at);
        squared
    }

    fn squared(&self, place: usize) -> f64 {
        let [before, after] = self.weights[place];
        before * self.coefficients[place] + after * self.coefficients[place + 1]
    }

    fn speed(&self, place: usize) -> Speed {
        let slope = (self.coefficients[place + 1] - self.coefficients[place]) * self.slopes[place];
        Speed { squared: self.squared(place), slope }
    }

    /// Returns the duration around some coefficients: the mean of the durations by the places and by the coefficients,
    /// since no speed between two places is below both.
    fn duration(&self, window: &Range<usize>) -> f64 {
        let places = places(window).map(|place| self.lengths[place] / self.squared(place).sqrt());
        let between = window.clone().map(|index| self.spans[index] / self.coefficients[index].sqrt());
        0.5 * (places.sum::<f64>() + between.sum::<f64>())
    }

    /// Improves some coefficients, with the others fixed; `None` if a number is not finite.
    fn solve(&mut self, window: Range<usize>) -> Option<()> {
        let mut rows = self.rows_of(&window);
        #[expect(clippy::cast_precision_loss, reason = "a count")]
        let bounds = (2 * rows.len() + 2 * window.len() + 1) as f64;
        let mut duration = self.duration(&window);
        let mut centre = 0.3 * duration / bounds;
        self.centre(&window, &mut rows, centre);
        for _ in 0..ITERATIONS {
            let step = self.step(&window, &rows, centre);
            let (share, gap) = self.take(&window, &mut rows, &step, centre);
            if !gap.is_finite() {
                return None;
            }
            let before = std::mem::replace(&mut duration, self.duration(&window));
            let gained = before - duration;
            if gap < GAP * duration && gained < GAP * duration && share > 0.3 {
                break;
            }
            let next = gap
                * if share > 0.9 {
                    0.15
                } else if share > 0.5 {
                    0.4
                } else {
                    1.0
                };
            // While the speed still rises a lot, the iterates keep away from the bounds.
            centre = if gained > 0.1 * duration { next.max(0.3 * duration) } else { next } / bounds;
        }
        Some(())
    }

    /// Gives each bound its multiplier on the central path.
    fn centre(&mut self, window: &Range<usize>, rows: &mut [Row], centre: f64) {
        for row in rows {
            row.evaluate(&self.coefficients);
            row.multipliers = row.inverse.map(|inverse| centre * inverse);
        }
        for place in places(window) {
            self.multipliers[place] = centre / (self.most[place] - self.squared(place));
        }
        for index in window.clone() {
            self.floors[index] = centre / self.coefficients[index];
        }
    }

    /// Returns the Newton step of some coefficients towards the central path, from two coefficients before them on.
    fn step(&self, window: &Range<usize>, rows: &[Row], centre: f64) -> Newton {
        let first = window.start.saturating_sub(2);
        // The count includes one more than the coefficients at the end, for rows of two.
        let count = (window.end + 2).min(self.coefficients.len() + 1) - first;
        let mut newton = Newton { first, gradient: vec![0.0; count], matrix: vec![[0.0; 3]; count] };
        let Newton { gradient, matrix, .. } = &mut newton;
        for place in places(window) {
            let (squared, [before, after], at) = (self.squared(place), self.weights[place], place - first);
            let slower = 0.5 * self.lengths[place] / (squared * squared.sqrt());
            let left = self.most[place] - squared;
            let slope = -0.5 * slower + centre / left;
            let bend = 0.75 * slower / squared + self.multipliers[place] / left;
            gradient[at] += slope * before;
            gradient[at + 1] += slope * after;
            matrix[at][0] += bend * before * before;
            matrix[at][1] += bend * before * after;
            matrix[at + 1][0] += bend * after * after;
        }
        for index in window.clone() {
            let (squared, at) = (self.coefficients[index], index - first);
            let slower = 0.5 * self.spans[index] / (squared * squared.sqrt());
            gradient[at] -= 0.5 * slower + centre / squared;
            matrix[at][0] += 0.75 * slower / squared + self.floors[index] / squared;
        }
        for row in rows {
            let base = row.base - first;
            let (gradient, matrix) = (&mut gradient[base..base + 3], &mut matrix[base..base + 3]);
            for ((gains, inverse), multiplier) in row.gains().into_iter().zip(row.inverse).zip(row.multipliers) {
                let (push, bend) = (centre * inverse, multiplier * inverse);
                for one in 0..3 {
                    gradient[one] -= push * gains[one];
                    let weighed = bend * gains[one];
                    for other in one..3 {
                        matrix[one][other - one] += weighed * gains[other];
                    }
                }
            }
        }
        self.solve_banded(window, newton)
    }

    /// Solves for the step: coefficients outside the window are fixed, but the first and the last coefficient follow
    /// their neighbours.
    fn solve_banded(&self, window: &Range<usize>, mut newton: Newton) -> Newton {
        let last = self.coefficients.len() - 1;
        let (from, to) = (window.start - newton.first, window.end - newton.first);
        let Newton { gradient: step, matrix, .. } = &mut newton;
        for slope in step.iter_mut() {
            *slope = -*slope;
        }
        if window.start == 1 {
            let factor = self.ends[0];
            step[1] += factor * step[0];
            matrix[1][0] += factor * (2.0 * matrix[0][1] + factor * matrix[0][0]);
            matrix[1][1] += factor * matrix[0][2];
        }
        if window.end == last {
            let (factor, end) = (self.ends[1], to);
            step[end - 1] += factor * step[end];
            matrix[end - 1][0] += factor * (2.0 * matrix[end - 1][1] + factor * matrix[end][0]);
            matrix[end - 2][1] += factor * matrix[end - 2][2];
        }
        for index in from..to {
            let [pivot, near, far] = matrix[index];
            let pivot = pivot.max(f64::MIN_POSITIVE);
            if index + 1 < to {
                let factor = near / pivot;
                step[index + 1] -= factor * step[index];
                matrix[index + 1][0] -= factor * near;
                matrix[index + 1][1] -= factor * far;
            }
            if index + 2 < to {
                let factor = far / pivot;
                step[index + 2] -= factor * step[index];
                matrix[index + 2][0] -= factor * far;
            }
        }
        for index in (from..to).rev() {
            let [pivot, near, far] = matrix[index];
            let mut left = step[index];
            if index + 1 < to {
                left -= near * step[index + 1];
            }
            if index + 2 < to {
                left -= far * step[index + 2];
            }
            step[index] = left / pivot.max(f64::MIN_POSITIVE);
        }
        step[..from].fill(0.0);
        step[to..].fill(0.0);
        if window.start == 1 {
            step[0] = self.ends[0] * step[1];
        }
        if window.end == last {
            step[to] = self.ends[1] * step[to - 1];
        }
        newton
    }

    /// Takes as much of a step as the bounds allow, and as much of the step of the multipliers. Returns the share of it
    /// that the bounds allowed, and the remaining gain.
    fn take(&mut self, window: &Range<usize>, rows: &mut [Row], newton: &Newton, centre: f64) -> (f64, f64) {
        let Newton { first, gradient: step, .. } = newton;
        // Largest shares of the room and of a multiplier that a whole step takes.
        let (mut part, mut dual_part) = (FAR, FAR);
        let mut change = |inverse: f64, moved: f64, multiplier: f64| {
            part = part.max(-moved * inverse);
            let change = (centre - multiplier * moved) * inverse - multiplier;
            if -change > dual_part * multiplier {
                dual_part = -change / multiplier;
            }
            change
        };
        let mut changes = Vec::with_capacity(rows.len());
        for row in &*rows {
            let near = &step[row.base - first..row.base - first + 3];
            let dot = |gains: &[f64; 3]| gains[0] * near[0] + gains[1] * near[1] + gains[2] * near[2];
            let gains = row.gains();
            let moved = [dot(&gains[0]), dot(&gains[1])];
            changes.push([
                change(row.inverse[0], moved[0], row.multipliers[0]),
                change(row.inverse[1], moved[1], row.multipliers[1]),
            ]);
        }
        let of_places: Vec<f64> = places(window)
            .map(|place| {
                let [before, after] = self.weights[place];
                let moved = before * step[place - first] + after * step[place + 1 - first];
                change((self.most[place] - self.squared(place)).recip(), -moved, self.multipliers[place])
            })
            .collect();
        let of_floors: Vec<f64> = window
            .clone()
            .map(|index| change(self.coefficients[index].recip(), step[index - first], self.floors[index]))
            .collect();
        let (share, dual_share) = (FAR / part, FAR / dual_part);
        let moved = &mut self.coefficients[*first..];
        moved.iter_mut().zip(step).for_each(|(coefficient, step)| *coefficient += share * step);
        let mut gap = 0.0;
        for (row, changes) in rows.iter_mut().zip(changes) {
            row.evaluate(&self.coefficients);
            for ((multiplier, inverse), change) in row.multipliers.iter_mut().zip(row.inverse).zip(changes) {
                *multiplier = near_centre(*multiplier + dual_share * change, centre * inverse);
            }
            gap += row.left[0] * row.multipliers[0] + row.left[1] * row.multipliers[1];
        }
        for (place, change) in places(window).zip(of_places) {
            let multiplier = self.multipliers[place] + dual_share * change;
            self.multipliers[place] = near_centre(multiplier, centre / (self.most[place] - self.squared(place)));
            gap += (self.most[place] - self.squared(place)) * self.multipliers[place];
        }
        for (index, change) in window.clone().zip(of_floors) {
            self.floors[index] =
                near_centre(self.floors[index] + dual_share * change, centre / self.coefficients[index]);
            gap += self.coefficients[index] * self.floors[index];
        }
        (share.min(dual_share), gap)
    }
}

impl Row {
    fn new(base: usize, weights: [f64; 3], bound: f64, speed: Option<[f64; 3]>) -> Self {
        Self { base, weights, bound, speed, multipliers: [0.0; 2], left: [0.0; 2], inverse: [0.0; 2], change: 0.0 }
    }

    /// Returns the share of some coefficients that is within the bound with room to spare.
    fn share(&self, coefficients: &[f64]) -> f64 {
        let near = |at: usize| coefficients.get(self.base + at).copied().unwrap_or_default();
        let dot = |weights: &[f64; 3]| weights[0] * near(0) + weights[1] * near(1) + weights[2] * near(2);
        let share = START * self.bound / dot(&self.weights).abs();
        self.speed.map_or(share, |speed| (share / dot(&speed).sqrt()).powf(2.0 / 3.0))
    }

    /// Computes the room at some coefficients. The third weight of the last rows is 0.
    fn evaluate(&mut self, coefficients: &[f64]) {
        let near = |at: usize| coefficients.get(self.base + at).copied().unwrap_or_default();
        let near = [near(0), near(1), near(2)];
        let dot = |weights: &[f64; 3]| weights[0] * near[0] + weights[1] * near[1] + weights[2] * near[2];
        let mut bound = self.bound;
        if let Some(speed) = &self.speed {
            let squared = dot(speed);
            bound /= squared.sqrt();
            self.change = -0.5 * bound / squared;
        }
        let value = dot(&self.weights);
        self.left = [bound - value, bound + value];
        self.inverse = self.left.map(f64::recip);
    }

    /// Returns the weights of the coefficients in the change of the room on both sides.
    fn gains(&self) -> [[f64; 3]; 2] {
        let [one, two, three] = self.weights;
        let [first, second, third] = self.speed.unwrap_or_default();
        let [first, second, third] = [self.change * first, self.change * second, self.change * third];
        [[first - one, second - two, third - three], [first + one, second + two, third + three]]
    }
}

/// Returns the places whose speeds depend on some coefficients.
fn places(window: &Range<usize>) -> Range<usize> {
    window.start - 1..window.end
}

/// Returns the joints whose acceleration, and those whose jerk, may reach their limits at squared speeds up to a
/// reference.
fn matters(
    first: &[f64; 6],
    second: &[f64; 6],
    third: [[f64; 6]; 2],
    reference: f64,
    limits: &PathLimits,
) -> (impl Iterator<Item = usize> + use<>, impl Iterator<Item = usize> + use<>) {
    let (PathLimits { accelerations, jerks, .. }, speed) = (*limits, reference.sqrt());
    let bent = |joint: usize| second[joint].abs() * reference;
    let slope = 2.0 * least(|joint| (accelerations[joint] + bent(joint)) / first[joint].abs());
    let curved = |joint: usize| {
        let third = third[0][joint].abs().max(third[1][joint].abs());
        third * reference * speed + 1.5 * second[joint].abs() * slope * speed
    };
    let change = 2.0 * least(|joint| (jerks[joint] + curved(joint)) / first[joint].abs());
    let by_acceleration = std::array::from_fn::<_, 6, _>(|joint| {
        bent(joint) + 0.5 * first[joint].abs() * slope > MATTERS * accelerations[joint]
    });
    let by_jerk = std::array::from_fn::<_, 6, _>(|joint| {
        curved(joint) + 0.5 * first[joint].abs() * change > MATTERS * jerks[joint]
    });
    let listed = |matters: [bool; 6]| (0..6).filter(move |joint| matters[*joint]);
    (listed(by_acceleration), listed(by_jerk))
}

/// Returns a multiplier that is not far from its value on the central path. Numbers that are not finite, or beyond a
/// bound, stay so: the gap shows them.
fn near_centre(multiplier: f64, central: f64) -> f64 {
    multiplier.max(central * NEAR.recip()).min(NEAR * central)
}

/// Returns squared speeds that rise as fast as the limits allow, from rest at a distance before the first.
fn rising(stretches: &[Stretch], distances: &[f64], launch: f64) -> Vec<f64> {
    let first = stretches[0];
    let seconds = (6.0 * launch / first.jerk).cbrt();
    let (mut speed, mut acceleration) = (0.5 * first.jerk * seconds * seconds, first.jerk * seconds);
    let mut squared = Vec::with_capacity(stretches.len());
    for (index, stretch) in stretches.iter().enumerate() {
        if index > 0 && distances[index - 1] > 0.0 {
            let distance = distances[index - 1];
            let mut seconds = distance / speed.max(1e-300);
            // Newton's method from above.
            for _ in 0..6 {
                let done = seconds * (speed + seconds * (0.5 * acceleration + seconds * stretch.jerk / 6.0));
                let rate = speed + seconds * (acceleration + 0.5 * seconds * stretch.jerk);
                seconds -= (done - distance) / rate;
            }
            let jerk = stretch.jerk.min(((stretch.acceleration - acceleration) / seconds).max(0.0));
            acceleration = acceleration.min(stretch.acceleration);
            speed += seconds * (acceleration + 0.5 * seconds * jerk);
            acceleration += seconds * jerk;
        }
        if speed * speed > stretch.most {
            (speed, acceleration) = (stretch.most.sqrt(), 0.0);
        }
        squared.push(speed * speed);
    }
    squared
}

/// Lowers squared speeds until their downward curvature is within the jerks.
fn round_tops(squared: &mut [f64], stretches: &[Stretch], at: &[f64]) {
    // With the double integral of the permitted curvature added, they must be convex: so is the lower hull of the
    // points.
    let bend: Vec<f64> =
        stretches.iter().zip(&*squared).map(|(stretch, squared)| 2.0 * stretch.jerk / squared.sqrt()).collect();
    let (mut slope, mut sum) = (0.0, 0.0);
    let mut sums = vec![0.0; at.len()];
    for index in 1..at.len() {
        let step = at[index] - at[index - 1];
        let mean = bend[index].min(bend[index - 1]);
        sum += step * (slope + 0.5 * step * mean);
        slope += step * mean;
        sums[index] = sum;
    }
    let mut hull: Vec<usize> = Vec::with_capacity(at.len());
    let heights: Vec<f64> = squared.iter().zip(&sums).map(|(squared, sum)| squared + sum).collect();
    let height = |index: usize| heights[index];
    for index in 0..at.len() {
        while let [.., one, other] = hull.as_slice() {
            let to_other = (height(*other) - height(*one)) * (at[index] - at[*one]);
            if to_other < (height(index) - height(*one)) * (at[*other] - at[*one]) {
                break;
            }
            hull.pop();
        }
        hull.push(index);
    }
    for pair in hull.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let rise = (height(to) - height(from)) / (at[to] - at[from]);
        let lowered: Vec<f64> =
            (from + 1..to).map(|index| height(from) + rise * (at[index] - at[from]) - sums[index]).collect();
        squared[from + 1..to].copy_from_slice(&lowered);
    }
}

/// Returns two weights as the first or the last two of three.
fn spread(weights: [f64; 2], at: usize) -> [f64; 3] {
    if at == 0 { [weights[0], weights[1], 0.0] } else { [0.0, weights[0], weights[1]] }
}

fn least(of: impl Fn(usize) -> f64) -> f64 {
    (0..6).map(of).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn straight(length: f64, limits: &PathLimits, speed: f64) -> Vec<Place> {
        let launch = (limits.jerks[0] * 0.03_f64.powi(3) / 6.0).min(length / 24.0);
        let (mut places, mut step) = (vec![0.0, launch], 0.3 * launch);
        while places[places.len() - 1] + step < 0.5 * length {
            places.push(places[places.len() - 1] + step);
            step = (1.3 * step).min(length / 60.0);
        }
        places.extend(places.clone().into_iter().rev().map(|at| length - at));
        let first = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let place = |at| Place {
            at,
            first,
            second: [0.0; 6],
            third: [[0.0; 6]; 2],
            tool: [0.0; 2],
            most: speed * speed,
            middle: None,
        };
        places.into_iter().map(place).collect()
    }

    fn duration(places: &[Place], speeds: &[Speed]) -> f64 {
        let inner = &places[1..places.len() - 1];
        let pairs = inner.windows(2).zip(speeds.windows(2));
        let between: f64 = pairs
            .map(|(places, speeds)| {
                2.0 * (places[1].at - places[0].at) / (speeds[0].squared.sqrt() + speeds[1].squared.sqrt())
            })
            .sum();
        let launches = 3.0 * inner[0].at / speeds[0].squared.sqrt();
        between + 2.0 * launches
    }

    #[test]
    fn a_straight_path_takes_the_time_of_the_closed_form() {
        let limits = PathLimits { accelerations: [300.0; 6], tool: f64::INFINITY, jerks: [3000.0; 6] };
        for (length, expected) in [(100.0, 1.0 + 100.0 / 300.0 + 0.1), (10.0, 4.0 * (10.0_f64 / 6000.0).cbrt())] {
            let places = straight(length, &limits, 100.0);
            let took = duration(&places, &quickest(&places, &limits).expect("it can be planned"));
            assert!((1.0..1.03).contains(&(took / expected)), "{took} s, {expected} s");
        }
    }
}
