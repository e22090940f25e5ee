//! Chance that follows from a seed.

use proptest::prelude::RngCore;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// Random numbers, the same for the same seed and place.
#[derive(Debug)]
pub(super) struct Random(TestRng);

impl Random {
    /// `place` keeps apart what is drawn for different arms, rounds and purposes.
    pub(super) fn new(seed: u64, place: [u32; 3]) -> Self {
        let mut bytes = [0; 32];
        bytes[..8].copy_from_slice(&seed.to_le_bytes());
        for (to, part) in bytes[8..].chunks_mut(4).zip(place) {
            to.copy_from_slice(&part.to_le_bytes());
        }
        Self(TestRng::from_seed(RngAlgorithm::ChaCha, &bytes))
    }

    /// A number below `limit`, which is not 0.
    pub(super) fn below(&mut self, limit: u32) -> u32 {
        self.0.next_u32() % limit
    }

    /// True once in this many times on average; never where that is 0.
    pub(super) fn one_in(&mut self, times: u32) -> bool {
        times > 0 && self.below(times) == 0
    }

    /// One of these, of which there must be one.
    pub(super) fn pick<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        &items[self.0.next_u32() as usize % items.len()]
    }
}
