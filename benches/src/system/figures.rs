//! Samples of contenders that take turns, and their percentiles.

use std::error::Error;
use std::fmt;
use std::time::Duration;

/// Times that one contender took, in nanoseconds.
#[derive(Debug, Default, Clone)]
pub struct Samples {
    all: Vec<u32>,
    /// Index of the first sample of each round.
    rounds: Vec<usize>,
}

/// One of the compared programs.
pub struct Contender<'a> {
    /// Name of the contender.
    pub name: &'static str,
    /// Times that it took.
    pub samples: Samples,
    run: Box<Run<'a>>,
}

type Run<'a> = dyn FnMut(&mut Samples) -> Result<(), Box<dyn Error>> + 'a;

impl Samples {
    /// Adds a time, up to 4 s.
    pub fn push(&mut self, time: Duration) {
        self.all.push(u32::try_from(time.as_nanos()).unwrap_or(u32::MAX));
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// True if there are no samples.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// The time that a share from 0 to 1 of the samples of all rounds stay within, in microseconds.
    pub fn percentile(&self, share: f64) -> f64 {
        micros(percentile(&mut self.all.clone(), share))
    }

    /// The medians of the rounds, in microseconds.
    pub fn medians(&self) -> Vec<f64> {
        let ends = self.rounds.iter().skip(1).copied().chain([self.all.len()]);
        let rounds = self.rounds.iter().zip(ends).map(|(start, end)| &self.all[*start..end]);
        rounds.map(|round| micros(percentile(&mut round.to_vec(), 0.5))).collect()
    }
}

impl<'a> Contender<'a> {
    /// One that adds the samples of a round each time it is called.
    pub fn new(name: &'static str, run: impl FnMut(&mut Samples) -> Result<(), Box<dyn Error>> + 'a) -> Self {
        Self { name, samples: Samples::default(), run: Box::new(run) }
    }
}

impl fmt::Debug for Contender<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Contender").field("name", &self.name).finish_non_exhaustive()
    }
}

/// Lets all run one round after the other. Each round begins with another, and the first, which warms up, does not
/// count.
///
/// # Errors
/// The first error of a contender.
pub fn alternate(contenders: &mut [Contender<'_>], rounds: usize) -> Result<(), Box<dyn Error>> {
    let count = contenders.len();
    for round in 0..=rounds {
        for turn in 0..count {
            let Contender { samples, run, .. } = &mut contenders[(round + turn) % count];
            if round == 1 {
                samples.all.clear();
                samples.rounds.clear();
            }
            samples.rounds.push(samples.all.len());
            run(samples)?;
        }
    }
    Ok(())
}

/// The median of the ratios of two contenders' medians, round by round.
pub fn ratio_of_rounds(ours: &Samples, limit: &Samples) -> f64 {
    let mut ratios: Vec<_> = ours.medians().iter().zip(limit.medians()).map(|(ours, limit)| ours / limit).collect();
    ratios.sort_unstable_by(f64::total_cmp);
    ratios.get(ratios.len() / 2).copied().unwrap_or(f64::NAN)
}

fn percentile(samples: &mut [u32], share: f64) -> u32 {
    let Some(last) = samples.len().checked_sub(1) else { return 0 };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
    let place = (share.clamp(0.0, 1.0) * last as f64).round() as usize;
    *samples.select_nth_unstable(place).1
}

fn micros(nanos: u32) -> f64 {
    f64::from(nanos) / 1000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_take_turns_and_the_first_does_not_count() {
        let order = std::cell::RefCell::new(String::new());
        let one = |name: char, micros: u64| {
            let order = &order;
            move |samples: &mut Samples| {
                order.borrow_mut().push(name);
                samples.push(Duration::from_micros(micros));
                Ok(())
            }
        };
        let mut contenders = [Contender::new("a", one('a', 30)), Contender::new("b", one('b', 10))];
        alternate(&mut contenders, 3).expect("nobody fails");
        assert_eq!(*order.borrow(), "abbaabba");
        let [a, b] = contenders.map(|contender| contender.samples);
        assert_eq!((a.len(), b.medians()), (3, vec![10.0; 3]));
        assert!((ratio_of_rounds(&a, &b) - 3.0).abs() < 1e-9);
    }

    #[test]
    fn percentiles_are_those_of_all_samples() {
        let mut samples = Samples::default();
        (0..=100).for_each(|micros| samples.push(Duration::from_micros(micros)));
        for share in [0.0, 0.5, 0.99, 1.0] {
            assert!((samples.percentile(share) - 100.0 * share).abs() < 1e-9);
        }
        assert!(Samples::default().medians().is_empty());
    }
}
