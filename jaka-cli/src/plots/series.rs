//! Quantity over time.

use itertools::Itertools as _;
use std::mem;

/// Values over time, in seconds; `None` where the value is unknown.
#[derive(Debug, Clone, Default)]
pub(crate) struct Series {
    points: Vec<(f64, Option<f64>)>,
}

/// Point of a curve.
pub(super) type Point = (f64, f64);

impl Series {
    /// Adds a value after the previous ones.
    pub(crate) fn push(&mut self, time: f64, value: Option<f64>) {
        self.points.push((time, value));
    }

    /// Adds a value of a quantity that is constant until it changes. Does not keep a value equal to the last one.
    pub(crate) fn push_change(&mut self, time: f64, value: Option<f64>) {
        if value.is_none() {
            self.interrupt(time);
        } else if self.points.last().is_none_or(|(_, last)| *last != value) {
            self.points.push((time, value));
        }
    }

    /// Keeps the last value until this time; afterwards the value is unknown.
    pub(crate) fn interrupt(&mut self, time: f64) {
        if let Some(&(_, last @ Some(_))) = self.points.last() {
            self.points.extend([(time, last), (time, None)]);
        }
    }

    /// Whether it has two different values.
    pub(crate) fn changes(&self) -> bool {
        self.range().is_some_and(|(low, high)| low < high)
    }

    /// Returns the lowest and the highest value; `None` without values.
    pub(crate) fn range(&self) -> Option<(f64, f64)> {
        self.points.iter().filter_map(|(_, value)| *value).minmax().into_option()
    }

    /// Returns curves up to a time, with the lowest, the highest and the last value in each of this many columns. A
    /// column without known values interrupts them.
    pub(super) fn curves(&self, end: f64, columns: u32) -> Vec<Vec<Point>> {
        let shown: Vec<_> = self.points.iter().copied().filter(|(time, _)| *time <= end).collect();
        let column = |(time, _): &(f64, Option<f64>)| (time / end * f64::from(columns)).floor();
        let (mut curves, mut curve, mut is_interrupted) = (Vec::new(), Vec::new(), false);
        for points in shown.chunk_by(|one, other| column(one) >= column(other)) {
            if is_interrupted || points[0].1.is_none() {
                curves.push(mem::take(&mut curve));
            }
            is_interrupted = points.last().is_some_and(|(_, value)| value.is_none());
            let known: Vec<_> = points.iter().filter_map(|&(time, value)| Some((time, value?))).collect();
            drawn(&known).into_iter().flatten().for_each(|point| draw(&mut curve, point));
        }
        curves.push(curve);
        curves.retain(|curve| !curve.is_empty());
        curves
    }
}

/// Returns the drawn points of a column: the lowest and the highest in their order, and the last.
fn drawn(points: &[Point]) -> Option<[Point; 3]> {
    let by_value = |one: &&Point, other: &&Point| one.1.total_cmp(&other.1);
    // The first of equal points.
    let (lowest, highest) = (*points.iter().min_by(by_value)?, *points.iter().rev().max_by(by_value)?);
    let [first, second] = if lowest.0 <= highest.0 { [lowest, highest] } else { [highest, lowest] };
    Some([first, second, *points.last()?])
}

/// Adds a point; of several with the same value, the first and the last are sufficient.
fn draw(curve: &mut Vec<Point>, point: Point) {
    if curve.last() == Some(&point) {
        return;
    }
    if let [.., (_, before), (time, last)] = curve.as_mut_slice()
        && (*before, *last) == (point.1, point.1)
    {
        *time = point.0;
        return;
    }
    curve.push(point);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn series(points: &[(f64, Option<f64>)]) -> Series {
        Series { points: points.to_vec() }
    }

    #[test]
    fn peaks_stay_and_the_number_of_points_is_bounded() {
        let mut all = Series::default();
        for at in 0..100_000_u32 {
            all.push(f64::from(at), Some(if at == 54_321 { 1e3 } else { f64::from(at % 7) }));
        }
        let curves = all.curves(1e5, 100);
        assert_eq!(curves.len(), 1);
        assert!(curves[0].len() <= 300, "{}", curves[0].len());
        assert!(curves[0].contains(&(54_321.0, 1e3)));
        assert!(curves[0].is_sorted_by(|one, other| one.0 <= other.0));
    }

    #[test]
    fn what_is_not_known_interrupts_the_curve() {
        let all = series(&[
            (0.0, Some(1.0)),
            (1.0, Some(2.0)),
            (2.0, None),
            (3.0, Some(3.0)),
            (9.0, None),
            (10.0, Some(9.0)),
        ]);
        let expected = vec![vec![(0.0, 1.0), (1.0, 2.0)], vec![(3.0, 3.0)], vec![(10.0, 9.0)]];
        assert_eq!(all.curves(10.0, 10), expected);
        assert_eq!(all.curves(5.0, 10), expected[..2], "what comes later is not drawn");
        assert_eq!(series(&[(0.0, None)]).curves(10.0, 10), Vec::<Vec<_>>::new());
    }

    #[test]
    fn what_stays_as_it_is_takes_two_points() {
        let mut level = Series::default();
        for at in 0..1000_u32 {
            level.push_change(f64::from(at), Some(f64::from(at / 500)));
        }
        level.interrupt(999.0);
        level.interrupt(999.0);
        assert_eq!(level.points, [(0.0, Some(0.0)), (500.0, Some(1.0)), (999.0, Some(1.0)), (999.0, None)]);
        assert!(level.changes());
        let constant = series(&[(0.0, Some(1.0)), (1.0, Some(1.0)), (2.0, Some(1.0)), (3.0, Some(1.0))]);
        assert_eq!(constant.curves(3.0, 4), [vec![(0.0, 1.0), (3.0, 1.0)]]);
        assert!(!constant.changes());
    }
}
