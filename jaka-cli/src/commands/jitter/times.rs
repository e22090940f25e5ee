//! Times that were measured, and their percentiles.

use std::time::Duration;

/// Times in ascending order.
#[derive(Debug, Default)]
pub(super) struct Times(Vec<Duration>);

impl Times {
    pub(super) fn add(&mut self, times: impl IntoIterator<Item = Duration>) {
        self.0.extend(times);
        self.0.sort_unstable();
    }

    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    /// The time within which this many of a hundred are; zero if there are none.
    pub(super) fn within(&self, percent: usize) -> Duration {
        let place = (self.0.len() * percent).div_ceil(100).max(1) - 1;
        self.0.get(place).copied().unwrap_or_default()
    }

    /// How many are at least so long.
    pub(super) fn at_least(&self, time: Duration) -> usize {
        self.0.len() - self.0.partition_point(|one| *one < time)
    }
}

/// A time in microseconds.
pub(super) fn micros(time: Duration) -> f64 {
    time.as_secs_f64() * 1e6
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_of_all_that_was_added() {
        let mut times = Times::default();
        assert_eq!((times.within(99), times.at_least(Duration::ZERO)), (Duration::ZERO, 0));
        times.add((51..=100).map(Duration::from_millis));
        times.add((1..=50).map(Duration::from_millis));
        let within = [50, 90, 99, 100].map(|percent| times.within(percent).as_millis());
        assert_eq!((times.count(), within), (100, [50, 90, 99, 100]));
        assert_eq!((times.at_least(Duration::from_millis(8)), times.at_least(Duration::from_millis(101))), (93, 0));
    }
}
