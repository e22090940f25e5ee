//! Reproducible random numbers.

/// `SplitMix64` random number generator; equal seeds give equal numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct SplitMix64 {
    pub(super) seed: u64,
    state: u64,
}

impl SplitMix64 {
    pub(crate) fn new(seed: u64) -> Self {
        Self { seed, state: seed }
    }

    fn next_u64(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Returns a random number from -1 to 1.
    pub(crate) fn between_ones(&mut self) -> f64 {
        // 32 bits are exact.
        let bits = u32::try_from(self.next_u64() >> 32).unwrap_or(u32::MAX);
        f64::from(bits) / f64::from(u32::MAX) * 2.0 - 1.0
    }

    /// Returns true once in this many times on average; never for 0.
    pub(crate) fn one_in(&mut self, times: u64) -> bool {
        self.next_u64().checked_rem(times) == Some(0)
    }

    /// Returns a random item; `None` for an empty list.
    pub(crate) fn pick<'a, T>(&mut self, items: &'a [T]) -> Option<&'a T> {
        let count = u64::try_from(items.len()).unwrap_or(u64::MAX);
        let index = self.next_u64().checked_rem(count)?;
        items.get(usize::try_from(index).ok()?)
    }

    pub(crate) fn bytes(&mut self, count: usize) -> Vec<u8> {
        let mut bytes = vec![0; count];
        for chunk in bytes.chunks_mut(8) {
            chunk.copy_from_slice(&self.next_u64().to_le_bytes()[..chunk.len()]);
        }
        bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_the_algorithm() {
        // First outputs of the author's program for this seed.
        let mut generator = SplitMix64::new(1_234_567);
        let rolls = [generator.next_u64(), generator.next_u64(), generator.next_u64()];
        assert_eq!(rolls, [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]);
    }

    #[test]
    fn chances_are_as_said() {
        let mut generator = SplitMix64::new(7);
        let hits = (0..10_000).filter(|_| generator.one_in(20)).count();
        assert!((400..600).contains(&hits), "{hits}");
        assert!(!(0..100).any(|_| generator.one_in(0)));
        assert!((0..100).all(|_| generator.one_in(1)));
        assert_eq!(generator.pick::<u8>(&[]), None);
        assert_eq!(generator.bytes(13).len(), 13);
        let numbers: Vec<_> = (0..1000).map(|_| generator.between_ones()).collect();
        assert!(numbers.iter().all(|number| number.abs() <= 1.0), "{numbers:?}");
        assert!(numbers.iter().any(|number| *number < -0.95) && numbers.iter().any(|number| *number > 0.95));
    }
}
