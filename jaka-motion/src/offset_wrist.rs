//! Angles of joint 6 for a pose, for wrists whose three axes do not meet.
//!
//! Joints 2 and 3 are parallel, the axis of joint 4 lies along the forearm and meets that of joint 5 in a point P, and
//! the axis of joint 6 meets that of joint 5 at an offset from P. An angle of joint 6 determines the axis `z` of joint
//! 5, and so P. Joint 1 turns the arm's plane, with the unit normal `n`, until P is in it: there are two solutions. In
//! the plane, upper arm and forearm reach P in two ways. At a solution the forearm is at a right angle to `z`.
//!
//! The product of this condition over both elbows is `k² (1 - (n·z)²) = (n·m)²`. `k` is the distance of P from the
//! shoulder along the forearm, which follows from the lengths, and `m` the moment of `z` about the shoulder. The
//! product over both normals is
//!
//! `(k² (ρ² - ν²) - μ² - c² (k² (2 - h²) - g²))² + 4 c² (ρ² - c²) k² z_z² (k² - m²) = 0`
//!
//! with `p` for P seen from the shoulder, `ρ` for its distance from the base axis, `c` for the arm's distance from its
//! plane, `h` and `g` for the horizontal parts of `z` and `m`, and `ν` and `μ` for the z coordinates of `p×z` and
//! `p×m`. In the angle of joint 6 it is a trigonometric polynomial of degree 8: it has no more than sixteen roots.

use std::f64::consts::TAU;

use arrayvec::ArrayVec;
use nalgebra::Vector3;

/// Equation for the angle of joint 6. All lengths are shares of the arm's length.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OffsetWrist {
    /// Point at which the axes of joints 5 and 6 meet, seen from the shoulder.
    pub(crate) wrist: Vector3<f64>,
    /// X and y axes of the flange.
    pub(crate) across: [Vector3<f64>; 2],
    /// Lengths of upper arm and forearm.
    pub(crate) bars: [f64; 2],
    /// Distance of the forearm from the plane through the base axis.
    pub(crate) aside: f64,
    /// Distance along the axis of joint 5 from the axis of joint 4 to that of joint 6.
    pub(crate) offset: f64,
}

/// Resolution of the search for roots.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Search {
    /// Share of the sum of the coefficients below which a value may be a root.
    pub(crate) touching: f64,
    /// Half the width of the smallest interval that is searched, in radians. The search does not separate roots that
    /// are nearer to each other.
    pub(crate) finest: f64,
}

/// Angles of joint 6, in radians.
#[derive(Debug, Default)]
pub(crate) struct SixthAngles {
    /// Separate roots.
    pub(crate) roots: ArrayVec<f64, 32>,
    /// Places at which roots meet, or just miss each other.
    pub(crate) touching: ArrayVec<f64, 64>,
}

/// Trigonometric polynomial: coefficients of the cosines and sines of multiples of the angle.
#[derive(Debug)]
struct Polynomial {
    cos: [f64; TERMS],
    sin: [f64; TERMS],
    /// Sum of the absolute values of the coefficients, no less than any value.
    sum: f64,
    /// Sum of the absolute values of the third derivative's coefficients, no less than any of its values.
    third: f64,
}

/// Number of terms, of degrees 0 to 8.
const TERMS: usize = 9;
/// Number of samples that determines the coefficients.
const PLACES: u8 = 17;
/// Number of intervals at the start of the search.
const INTERVALS: u8 = 32;
/// Angle at which the search begins, in radians. A root is unlikely there, so roots lie within intervals.
const BEGIN: f64 = 0.123_456_7;
/// Share of the largest term below which a value is rounding, so that any angle is a solution.
const ROUNDING: f64 = 1e-13;
/// Share of the sum of the coefficients that rounding may add to a value.
const NOISE: f64 = 1e-13;
/// Greatest number of steps for one root; bisection alone takes 52.
const STEPS: usize = 64;
/// Number of the smallest half-widths between two places, within a region where roots meet.
const SPACING: f64 = 50.0;

impl OffsetWrist {
    /// Returns the axis of joint 5 for sine and cosine of the angle of joint 6.
    pub(crate) fn fifth_axis(&self, sin: f64, cos: f64) -> Vector3<f64> {
        self.across[0] * sin + self.across[1] * cos
    }

    /// Returns all angles of joint 6 at which the other joints may bring the flange to its pose; `None` if any angle
    /// would do.
    pub(crate) fn sixth_angles(&self, search: Search) -> Option<SixthAngles> {
        Some(self.polynomial()?.zeros(search))
    }

    /// Returns the polynomial through its values; `None` if they are nothing but rounding.
    fn polynomial(&self) -> Option<Polynomial> {
        let turns: [(f64, f64); PLACES as usize] = {
            let mut place = 0.0;
            [(); PLACES as usize].map(|()| {
                place += 1.0;
                (TAU * place / f64::from(PLACES)).sin_cos()
            })
        };
        let (mut polynomial, mut largest) =
            (Polynomial { cos: [0.0; TERMS], sin: [0.0; TERMS], sum: 0.0, third: 0.0 }, 0.0);
        for (place, (sin, cos)) in (1_usize..).zip(turns) {
            let (value, size) = self.value(sin, cos);
            largest = f64::max(largest, size);
            for degree in 0..TERMS {
                // The last sample is a whole turn.
                let (sin, cos) = turns[(place * degree + turns.len() - 1) % turns.len()];
                let share = if degree == 0 { 1.0 } else { 2.0 } / f64::from(PLACES);
                polynomial.cos[degree] += share * value * cos;
                polynomial.sin[degree] += share * value * sin;
            }
        }
        let mut degree = 0.0_f64;
        for (cos, sin) in polynomial.cos.iter().zip(&polynomial.sin) {
            polynomial.sum += cos.hypot(*sin);
            polynomial.third += degree.powi(3) * cos.hypot(*sin);
            degree += 1.0;
        }
        // `>` and not a negated `<=`: numbers that are not finite have no roots either.
        (polynomial.sum > ROUNDING * largest).then_some(polynomial)
    }

    /// Returns the value of the equation, and the magnitude of the terms whose difference it is.
    fn value(&self, sin: f64, cos: f64) -> (f64, f64) {
        let axis = self.fifth_axis(sin, cos);
        let [upper_arm, forearm] = self.bars;
        let (point, moment) = (self.wrist - axis * self.offset, self.wrist.cross(&axis));
        let aside = self.aside * self.aside;
        let away = self.wrist.norm_squared() + self.offset * (self.offset - 2.0 * self.wrist.dot(&axis)) - aside;
        let along = (away + forearm * forearm - upper_arm * upper_arm) / (2.0 * forearm);
        let along = along * along;
        let radius = point.x * point.x + point.y * point.y;
        let level = |vector: &Vector3<f64>| vector.x * vector.x + vector.y * vector.y;
        let (nu, mu) = (self.wrist.x * axis.y - self.wrist.y * axis.x, point.x * moment.y - point.y * moment.x);
        let whole = along * (radius - nu * nu) - mu * mu - aside * (along * (2.0 - level(&axis)) - level(&moment));
        let rest = 4.0 * aside * (radius - aside) * along * axis.z * axis.z;
        let size = along * radius + mu * mu + aside * (2.0 * along + level(&moment));
        (whole * whole + rest * (along - moment.norm_squared()), size * size)
    }
}

impl Polynomial {
    /// Returns the value, and first and second derivatives.
    fn at(&self, angle: f64) -> [f64; 3] {
        let (sin, cos) = angle.sin_cos();
        let ((mut before_cos, mut before_sin), (mut this_cos, mut this_sin)) = ((cos, -sin), (1.0, 0.0));
        let (mut values, mut degree) = ([0.0; 3], 0.0);
        for (of_cos, of_sin) in self.cos.iter().zip(&self.sin) {
            let value = of_cos * this_cos + of_sin * this_sin;
            values[0] += value;
            values[1] += degree * (of_sin * this_cos - of_cos * this_sin);
            values[2] -= degree * degree * value;
            let next = (2.0 * cos * this_cos - before_cos, 2.0 * cos * this_sin - before_sin);
            (before_cos, before_sin) = (this_cos, this_sin);
            (this_cos, this_sin) = next;
            degree += 1.0;
        }
        values
    }

    /// Returns all zeros. Intervals are halved until each is known to have none, or one at most, or is as small as the
    /// search allows.
    fn zeros(&self, search: Search) -> SixthAngles {
        let (mut found, mut touching) = (SixthAngles::default(), None::<(f64, f64)>);
        let half = 0.5 * TAU / f64::from(INTERVALS);
        for interval in 0..INTERVALS {
            let mut left = ArrayVec::<(f64, f64), 64>::new();
            left.push((BEGIN + 2.0 * half * f64::from(interval), BEGIN + 2.0 * half * f64::from(interval + 1)));
            while let Some((from, to)) = left.pop() {
                let (middle, half) = (f64::midpoint(from, to), 0.5 * (to - from));
                let [value, slope, bend] = self.at(middle).map(f64::abs);
                let (turn, reach) = (half * self.third, search.touching * self.sum);
                if value > half * (slope + 0.5 * half * (bend + turn / 3.0)) + reach {
                    continue;
                }
                if slope > half * (bend + 0.5 * turn) {
                    if let Some(root) = self.zero_between(from, to) {
                        let _ = found.roots.try_push(root);
                    }
                } else if half > search.finest && !left.is_full() {
                    left.extend([(middle, to), (from, middle)]);
                } else {
                    touching = Some(match touching {
                        Some((begin, end)) if from - end < half => (begin, to),
                        other => {
                            found.touch(other, search);
                            (from, to)
                        }
                    });
                }
            }
        }
        found.touch(touching, search);
        found
    }

    /// Returns the zero in an interval in which the value is monotonic.
    fn zero_between(&self, mut from: f64, mut to: f64) -> Option<f64> {
        let [at_from, at_to] = [from, to].map(|angle| self.at(angle)[0]);
        if at_from * at_to > 0.0 {
            let (nearer, value) = if at_from.abs() < at_to.abs() { (from, at_from) } else { (to, at_to) };
            return (value.abs() < NOISE * self.sum).then_some(nearer);
        }
        let mut angle = f64::midpoint(from, to);
        for _ in 0..STEPS {
            let [value, slope, _] = self.at(angle);
            if value == 0.0 {
                break;
            }
            *(if value * at_to > 0.0 { &mut to } else { &mut from }) = angle;
            let next = angle - value / slope;
            let next = if from < next && next < to { next } else { f64::midpoint(from, to) };
            if (next - angle).abs() < f64::EPSILON {
                break;
            }
            angle = next;
        }
        Some(angle)
    }
}

impl SixthAngles {
    /// Creates a single angle, for an equation that any angle solves.
    pub(crate) fn one(angle: f64) -> Self {
        Self { roots: ArrayVec::new(), touching: std::iter::once(angle).collect() }
    }

    /// Adds places in a region where roots meet.
    fn touch(&mut self, region: Option<(f64, f64)>, search: Search) {
        let Some((from, to)) = region else { return };
        let spacing = SPACING * search.finest;
        let mut place = f64::midpoint(from, (from + spacing).min(to));
        // The ends lead to roots on either side.
        let _ = self.touching.try_push(from);
        let _ = self.touching.try_push(to);
        while place < to && self.touching.try_push(place).is_ok() {
            place += spacing;
        }
    }
}
