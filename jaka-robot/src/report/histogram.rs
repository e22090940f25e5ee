//! Histogram of times, in memory that does not grow.

use std::time::Duration;

/// Microseconds up to here have a place each; above it each doubling has half as many.
const EXACT: u32 = 64;
const PLACES: usize = (EXACT + (u32::BITS - EXACT.ilog2()) * EXACT / 2) as usize;

/// Times in microseconds, up to 71 minutes, correct to 3 %.
#[derive(Clone, PartialEq, Default)]
pub(super) struct Histogram {
    /// Empty where no times are counted.
    counts: Box<[u64]>,
    most: Duration,
}

impl std::fmt::Debug for Histogram {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} times, {:?} at most", self.counts.iter().sum::<u64>(), self.most)
    }
}

impl Histogram {
    pub(super) fn new() -> Self {
        Self { counts: vec![0; PLACES].into(), most: Duration::ZERO }
    }

    /// Counts a time; nothing in a default histogram, which has no memory.
    pub(super) fn add(&mut self, time: Duration) {
        let place = place(u32::try_from(time.as_micros()).unwrap_or(u32::MAX));
        if let Some(count) = self.counts.get_mut(place) {
            *count += 1;
        }
        self.most = self.most.max(time);
    }

    /// The time that this share of them, from 0 to 1, does not exceed: zero without any.
    pub(super) fn at(&self, share: f64) -> Duration {
        let all: u64 = self.counts.iter().sum();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
        let before = (share.clamp(0.0, 1.0) * all.saturating_sub(1) as f64).round() as u64;
        let mut passed = 0;
        let found = self.counts.iter().position(|count| {
            passed += count;
            passed > before
        });
        match found {
            Some(_) if before + 1 >= all => self.most,
            Some(place) => Duration::from_micros(first_of(place).into()).min(self.most),
            None => Duration::ZERO,
        }
    }
}

/// Shares of times, in seconds; `None` if no times are counted.
#[cfg(feature = "serde")]
impl serde::Serialize for Histogram {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(serde::Serialize)]
        #[expect(clippy::struct_field_names, reason = "keys have their unit")]
        struct Form {
            p50_s: f64,
            p90_s: f64,
            p99_s: f64,
            max_s: f64,
        }
        let is_empty = self.counts.iter().all(|count| *count == 0);
        let [p50_s, p90_s, p99_s, max_s] = [0.5, 0.9, 0.99, 1.0].map(|share| self.at(share).as_secs_f64());
        (!is_empty).then_some(Form { p50_s, p90_s, p99_s, max_s }).serialize(serializer)
    }
}

fn place(micros: u32) -> usize {
    let doublings = (micros / EXACT).checked_ilog2().map_or(0, |log| log + 1);
    ((micros >> doublings) + doublings * EXACT / 2) as usize
}

/// The least number of microseconds of a place.
fn first_of(place: usize) -> u32 {
    let half = EXACT as usize / 2;
    let doublings = (place / half).saturating_sub(1);
    u32::try_from((place - doublings * half) << doublings).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_found_again_to_3_percent() {
        for micros in
            (0..4000).chain((0..32).flat_map(|bit| [(1 << bit) - 1, 1 << bit, (1 << bit) + 1])).chain([u32::MAX])
        {
            let first = first_of(place(micros));
            assert!(first <= micros && f64::from(micros - first) <= 0.032 * f64::from(micros), "{micros}: {first}");
            assert!(micros >= EXACT || first == micros);
        }
    }

    #[test]
    fn shares_of_times() {
        let mut times = Histogram::new();
        assert_eq!(times.at(0.5), Duration::ZERO);
        (1..=1000).rev().for_each(|millis| times.add(Duration::from_millis(millis)));
        let is_near = |share, millis: u64| {
            let time = times.at(share).as_secs_f64() * 1000.0;
            #[expect(clippy::cast_precision_loss)]
            let ratio = time / millis as f64;
            assert!((0.968..=1.0).contains(&ratio), "{share}: {time} ms");
        };
        is_near(0.0, 1);
        is_near(0.5, 500);
        is_near(0.99, 990);
        assert_eq!(times.at(1.0), Duration::from_secs(1));
    }
}
