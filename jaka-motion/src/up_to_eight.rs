//! A short list in place.

/// Up to eight sets of six numbers, without an allocation.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct UpToEight {
    values: [[f64; 6]; 8],
    count: usize,
}

impl UpToEight {
    /// Adds a value; a ninth is dropped, and the arms here have no more than eight branches.
    pub(crate) fn push(&mut self, value: [f64; 6]) {
        if let Some(place) = self.values.get_mut(self.count) {
            *place = value;
            self.count += 1;
        }
    }

    pub(crate) fn as_slice(&self) -> &[[f64; 6]] {
        &self.values[..self.count]
    }

    pub(crate) fn as_mut_slice(&mut self) -> &mut [[f64; 6]] {
        &mut self.values[..self.count]
    }
}
