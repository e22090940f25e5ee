//! Smooth curves near points: cubic splines with the least third derivative within a tolerance of each point.

/// Place of a tool or of joints, as seven numbers of one unit.
pub(super) type Place = [f64; 7];

/// Curve through places, with continuous second derivatives: a cubic spline.
#[derive(Debug, Clone)]
pub(super) struct Spline {
    /// Parameter of each node, from 0 on.
    at: Vec<f64>,
    places: Vec<Place>,
    /// Second derivatives at the nodes.
    bends: Vec<Place>,
}

/// Symmetric matrix: each row has the diagonal and the three numbers after it.
type Banded = Vec<[f64; 4]>;

/// Number of rounds in which the weights of distances are adapted.
const ROUNDS: usize = 30;
/// Share of a tolerance that the adaptation aims at.
const AIM: f64 = 0.85;
/// Weights of distances at the start, and the least, below which rounding errors would dominate.
const WEIGHT: f64 = 1e-4;
const LEAST_WEIGHT: f64 = 1e-10;
/// Greatest factor by which a weight changes in a round.
const MOST_CHANGE: f64 = 8.0;
/// Range of the distances between nodes in the measure of smoothness, in units of the mean.
const SPACING: [f64; 2] = [0.05, 20.0];

impl Spline {
    /// Creates the smoothest curve near places whose parameters increase from 0; it starts and ends at the first and
    /// the last. Its distance from each place is at most 1, as measured by `off`.
    pub(super) fn near(at: Vec<f64>, given: &[Place], off: impl Fn(&Place) -> f64) -> Self {
        let places = smoothed(&at, given, off);
        let bends = bends(&at, &places);
        Self { at, places, bends }
    }

    /// Returns the parameters of the nodes.
    pub(super) fn nodes(&self) -> &[f64] {
        &self.at
    }

    /// Returns the place at a parameter, and its first and second derivative.
    pub(super) fn at(&self, at: f64) -> [Place; 3] {
        let index = self.at.partition_point(|node| *node <= at).clamp(1, self.at.len() - 1) - 1;
        let step = self.at[index + 1] - self.at[index];
        let (after, before) = ((at - self.at[index]) / step, (self.at[index + 1] - at) / step);
        let number = |of: &dyn Fn([f64; 2], [f64; 2]) -> f64| -> Place {
            std::array::from_fn(|which| {
                let pick = |list: &[Place]| [list[index][which], list[index + 1][which]];
                of(pick(&self.places), pick(&self.bends))
            })
        };
        let bent = |share: f64| (share * share * share - share) * step * step / 6.0;
        let sloped = |share: f64| (3.0 * share * share - 1.0) * step / 6.0;
        [
            number(&|[one, other], [bend, next]| {
                before * one + after * other + bent(before) * bend + bent(after) * next
            }),
            number(&|[one, other], [bend, next]| (other - one) / step - sloped(before) * bend + sloped(after) * next),
            number(&|_, [bend, next]| before * bend + after * next),
        ]
    }
}

/// Returns places near the given ones, with the least third derivative.
///
/// It minimises a weighted sum of the squares of the third derivative and of the distances. The weights of distances
/// rise where these are too long, and fall elsewhere, until the decisive distances are about as long as permitted.
fn smoothed(at: &[f64], given: &[Place], off: impl Fn(&Place) -> f64) -> Vec<Place> {
    let count = given.len();
    if count < 5 {
        return given.to_vec();
    }
    let (roughness, pull) = roughness(at, given);
    let inner = count - 2;
    let mut weights = vec![WEIGHT; inner];
    let mut kept: Option<Vec<Place>> = None;
    for round in 0.. {
        let mut matrix = roughness.clone();
        matrix.iter_mut().zip(&weights).for_each(|(row, weight)| row[0] += weight);
        let moved = solved(matrix, pull.clone());
        let ratios: Vec<f64> = moved.iter().map(&off).collect();
        if ratios.iter().all(|ratio| *ratio <= 1.0) {
            kept = Some(moved);
        }
        if round >= ROUNDS && (kept.is_some() || round >= 2 * ROUNDS) {
            break;
        }
        for (weight, ratio) in weights.iter_mut().zip(ratios) {
            let least = if round < ROUNDS { MOST_CHANGE.recip() } else { 1.0 };
            let factor = (ratio / AIM).powi(2).clamp(least, MOST_CHANGE);
            *weight = (*weight * factor).max(LEAST_WEIGHT);
        }
    }
    let mut places = given.to_vec();
    for (place, moved) in places[1..=inner].iter_mut().zip(kept.into_iter().flatten()) {
        place.iter_mut().zip(moved).for_each(|(number, moved)| *number += moved);
    }
    places
}

/// Returns the squares of third derivatives as a matrix for the displacements of inner places, and the pull of the
/// given places.
fn roughness(at: &[f64], given: &[Place]) -> (Banded, Vec<Place>) {
    let (count, mean) = (given.len(), at[at.len() - 1] / lengths_as_number(at.len() - 1));
    let mut spaced = vec![0.0; count];
    for index in 1..count {
        spaced[index] = spaced[index - 1] + ((at[index] - at[index - 1]) / mean).clamp(SPACING[0], SPACING[1]);
    }
    let (mut matrix, mut pull) = (vec![[0.0; 4]; count - 2], vec![[0.0; 7]; count - 2]);
    for first in 0..count - 3 {
        let near = &spaced[first..first + 4];
        let factor: [f64; 4] = std::array::from_fn(|one| {
            let others = (0..4).filter(|other| *other != one).map(|other| near[one] - near[other]);
            6.0 / others.product::<f64>()
        });
        let length = (near[3] - near[0]) / 3.0;
        let third: Place =
            std::array::from_fn(|which| (0..4).map(|one| factor[one] * given[first + one][which]).sum::<f64>());
        for one in 0..4 {
            // The ends stay fixed.
            let Some(row) = (first + one).checked_sub(1).filter(|row| *row < count - 2) else { continue };
            for other in one..4.min(count - 1 - first) {
                matrix[row][other - one] += length * factor[one] * factor[other];
            }
            pull[row].iter_mut().zip(third).for_each(|(pull, third)| *pull -= length * factor[one] * third);
        }
    }
    (matrix, pull)
}

#[expect(clippy::cast_precision_loss, reason = "a count")]
fn lengths_as_number(count: usize) -> f64 {
    count as f64
}

/// Returns the solution of a positive definite system.
fn solved(mut matrix: Banded, mut right: Vec<Place>) -> Vec<Place> {
    let count = matrix.len();
    for index in 0..count {
        let [pivot, rest @ ..] = matrix[index];
        for (one, number) in (1..).zip(rest) {
            if index + one >= count {
                break;
            }
            let factor = number / pivot;
            for (other, number) in (one..4).zip(&rest[one - 1..]) {
                matrix[index + one][other - one] -= factor * number;
            }
            let here = right[index];
            right[index + one].iter_mut().zip(here).for_each(|(right, here)| *right -= factor * here);
        }
    }
    for index in (0..count).rev() {
        let [pivot, rest @ ..] = matrix[index];
        for (one, number) in (1..).zip(rest) {
            let Some(after) = right.get(index + one).copied() else { break };
            right[index].iter_mut().zip(after).for_each(|(right, after)| *right -= number * after);
        }
        right[index].iter_mut().for_each(|right| *right /= pivot);
    }
    right
}

/// Returns the second derivatives at the nodes of the cubic spline through places, constant on the first and the last
/// interval.
fn bends(at: &[f64], places: &[Place]) -> Vec<Place> {
    let last = places.len() - 1;
    let mut bends = vec![[0.0; 7]; last + 1];
    if last < 2 {
        return bends;
    }
    // Share of the next second derivative in each; `bends` has the rest until the back substitution.
    let mut shares = vec![0.0; last + 1];
    for index in 1..last {
        let [first, second] = [at[index] - at[index - 1], at[index + 1] - at[index]];
        let mut diagonal = 2.0 * (first + second) - first * shares[index - 1];
        let mut next = second;
        if index == 1 {
            diagonal += first;
        }
        if index == last - 1 {
            (diagonal, next) = (diagonal + second, 0.0);
        }
        shares[index] = next / diagonal;
        bends[index] = std::array::from_fn(|which| {
            let [before, here, after] = [index - 1, index, index + 1].map(|index| places[index][which]);
            let right = 6.0 * ((after - here) / second - (here - before) / first);
            let before = if index == 1 { 0.0 } else { bends[index - 1][which] };
            (right - first * before) / diagonal
        });
    }
    for index in (1..last - 1).rev() {
        let after = bends[index + 1];
        bends[index].iter_mut().zip(after).for_each(|(bend, after)| *bend -= shares[index] * after);
    }
    (bends[0], bends[last]) = (bends[1], bends[last - 1]);
    bends
}

#[cfg(test)]
mod tests {
    use super::*;

    fn within(tolerance: f64) -> impl Fn(&Place) -> f64 {
        move |off| off.iter().map(|number| number * number).sum::<f64>().sqrt() / tolerance
    }

    fn even(count: u32) -> Vec<f64> {
        (0..count).map(f64::from).collect()
    }

    #[test]
    fn a_spline_has_continuous_derivatives_and_goes_through_few_places() {
        let at = vec![0.0, 1.0, 1.5, 3.0];
        let places: Vec<Place> =
            at.iter().map(|at| [0.0, 0.3, 0.6, 0.9, 1.2, 1.5, 1.8].map(|rate| f64::sin(at * rate))).collect();
        let spline = Spline::near(at.clone(), &places, within(1.0));
        for (node, place) in at.iter().zip(&places) {
            let [here, first, second] = spline.at(*node);
            let [before, first_before, second_before] = spline.at(node - 1e-9);
            for which in 0..7 {
                assert!((here[which] - place[which]).abs() < 1e-12 && (before[which] - place[which]).abs() < 1e-6);
                assert!((first[which] - first_before[which]).abs() < 1e-6);
                assert!((second[which] - second_before[which]).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn noise_within_the_tolerance_is_smoothed_away() {
        let noise = |index: u32| 0.02 * f64::from(index * index * 7919 % 101) / 100.0;
        let places: Vec<Place> =
            (0..200).map(|index| [f64::from(index), noise(index), 0.0, 0.0, 0.0, 0.0, 0.0]).collect();
        let spline = Spline::near(even(200), &places, within(0.1));
        let most = (0..1990).map(|tenth| spline.at(f64::from(tenth) / 10.0)[2][1].abs()).fold(0.0, f64::max);
        assert!(most < 2e-4, "{most}");
        for (at, place) in spline.nodes().to_vec().iter().zip(&places) {
            assert!((spline.at(*at)[0][1] - place[1]).abs() <= 0.1);
        }
    }

    #[test]
    fn bends_stay_within_the_tolerance() {
        let places: Vec<Place> = (0..300)
            .map(|index| {
                let at = f64::from(index);
                [at, if index < 150 { 0.0 } else { 0.02 * (at - 150.0) }, 0.0, 0.0, 0.0, 0.0, 0.0]
            })
            .collect();
        for tolerance in [0.001, 0.01, 0.1] {
            let spline = Spline::near(even(300), &places, within(tolerance));
            let off = spline.nodes().iter().zip(&places).map(|(at, place)| (spline.at(*at)[0][1] - place[1]).abs());
            let off = off.fold(0.0, f64::max);
            assert!(off <= tolerance && off > 0.5 * tolerance, "{off} of {tolerance}");
        }
    }
}
