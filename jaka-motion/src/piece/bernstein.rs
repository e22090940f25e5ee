//! Polynomials by their Bernstein coefficients; their values stay between the least and the largest coefficient.

/// Number of halvings of a part of a polynomial after which its coefficients count as its values: each halving brings
/// them four times nearer.
const HALVINGS: u32 = 24;
/// Greatest relative error by which a peak is too high.
const PEAK: f64 = 1e-4;

/// Returns the value at a share of the interval, from 0 to 1.
pub(crate) fn value<const N: usize>(coefficients: &[f64; N], share: f64) -> f64 {
    let mut values = *coefficients;
    for count in (1..N).rev() {
        for index in 0..count {
            values[index] += share * (values[index + 1] - values[index]);
        }
    }
    values[0]
}

/// Returns the weight of each coefficient at a share of the interval.
pub(crate) fn weights<const N: usize>(share: f64) -> [f64; N] {
    let mut weights = [0.0; N];
    weights[0] = 1.0;
    for count in 1..N {
        for index in (1..=count).rev() {
            weights[index] = (1.0 - share) * weights[index] + share * weights[index - 1];
        }
        weights[0] *= 1.0 - share;
    }
    weights
}

/// Returns the weighted sum of coefficients.
pub(crate) fn sum<const N: usize>(weights: &[f64; N], coefficients: &[f64; N]) -> f64 {
    weights.iter().zip(coefficients).map(|(weight, coefficient)| weight * coefficient).sum()
}

/// Returns the differences of neighbours, times a factor: with the degree as factor, the derivative.
pub(crate) fn differences<const N: usize, const M: usize>(coefficients: &[f64; N], factor: f64) -> [f64; M] {
    std::array::from_fn(|index| factor * (coefficients[index + 1] - coefficients[index]))
}

/// Returns the coefficients of the part between two shares.
pub(crate) fn part<const N: usize>(coefficients: &[f64; N], from: f64, to: f64) -> [f64; N] {
    let after = split(coefficients, from)[1];
    let share = if from < 1.0 { ((to - from) / (1.0 - from)).clamp(0.0, 1.0) } else { 1.0 };
    split(&after, share)[0]
}

/// Returns the largest absolute value, or up to [`PEAK`] more.
pub(crate) fn peak<const N: usize>(coefficients: &[f64; N]) -> f64 {
    fn above<const N: usize>(coefficients: &[f64; N], found: f64, halvings: u32) -> f64 {
        let most = largest(coefficients);
        let ends = coefficients[0].abs().max(coefficients[N - 1].abs()).max(found);
        if most.is_nan() || most <= ends * (1.0 + PEAK) || halvings == 0 {
            return most.max(ends);
        }
        let [one, other] = split(coefficients, 0.5);
        let first = above(&one, ends, halvings - 1);
        above(&other, first, halvings - 1)
    }
    above(coefficients, 0.0, HALVINGS)
}

/// Returns the highest value, or more by up to twice [`PEAK`] of the largest coefficient by absolute value.
pub(crate) fn highest<const N: usize>(coefficients: &[f64; N]) -> f64 {
    let most = largest(coefficients);
    peak(&coefficients.map(|coefficient| coefficient + most)) - most
}

/// Returns the place at which a polynomial is furthest beyond two numbers, as a share, and its value there, from 128
/// steps; `None` if it stays between them.
pub(crate) fn beyond<const N: usize>(coefficients: &[f64; N], least: f64, most: f64) -> Option<(f64, f64)> {
    fn is_within<const N: usize>(coefficients: &[f64; N], least: f64, most: f64, halvings: u32) -> bool {
        let inside = |number: &f64| (least..=most).contains(number);
        if coefficients.iter().all(inside) {
            return true;
        }
        if !inside(&coefficients[0]) || !inside(&coefficients[N - 1]) || halvings == 0 {
            return false;
        }
        split(coefficients, 0.5).iter().all(|half| is_within(half, least, most, halvings - 1))
    }
    if is_within(coefficients, least, most, HALVINGS) {
        return None;
    }
    let by = |value: f64| (least - value).max(value - most);
    let places = (0..=128).map(|place| f64::from(place) / 128.0).map(|share| (share, value(coefficients, share)));
    places.max_by(|one, other| by(one.1).total_cmp(&by(other.1)))
}

/// Returns the largest coefficient by absolute value, a bound of the polynomial; NaN if a coefficient is.
pub(crate) fn largest<const N: usize>(coefficients: &[f64; N]) -> f64 {
    coefficients.iter().fold(0.0, |most: f64, number| if number.is_nan() { f64::NAN } else { most.max(number.abs()) })
}

/// Returns the coefficients of the parts before and after a share.
fn split<const N: usize>(coefficients: &[f64; N], share: f64) -> [[f64; N]; 2] {
    let (mut before, mut after) = ([0.0; N], *coefficients);
    for count in (0..N).rev() {
        before[N - 1 - count] = after[0];
        for index in 0..count {
            after[index] += share * (after[index + 1] - after[index]);
        }
    }
    [before, after]
}
