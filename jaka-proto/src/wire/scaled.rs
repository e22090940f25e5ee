//! Numbers in another unit.

/// A number, or what is made of numbers, in another unit.
#[doc(hidden)]
pub trait Scaled {
    /// Multiplies each number by a factor.
    #[must_use]
    fn times(&self, factor: f64) -> Self;
}

impl Scaled for f64 {
    fn times(&self, factor: f64) -> Self {
        self * factor
    }
}

impl<T: Scaled> Scaled for Option<T> {
    fn times(&self, factor: f64) -> Self {
        self.as_ref().map(|value| value.times(factor))
    }
}

impl<T: Scaled> Scaled for Vec<T> {
    fn times(&self, factor: f64) -> Self {
        self.iter().map(|value| value.times(factor)).collect()
    }
}

impl<T: Scaled, const N: usize> Scaled for [T; N] {
    fn times(&self, factor: f64) -> Self {
        self.each_ref().map(|value| value.times(factor))
    }
}
