//! Firmware versions, as bounds of a controller's abilities.

use std::fmt;

/// A firmware version, such as 1.5 or 1.6.5: one to four numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Version(Vec<u32>);

impl Version {
    /// Numbers in a version, at most.
    const MOST: usize = 4;

    pub(crate) fn read(text: &str) -> Option<Self> {
        let number = |part: &str| part.parse().ok().filter(|_| part.bytes().all(|b| b.is_ascii_digit()));
        let numbers: Option<Vec<u32>> = text.split('.').map(number).collect();
        numbers.filter(|numbers| numbers.len() <= Self::MOST).map(Self)
    }

    /// Its numbers, the major one first.
    pub fn numbers(&self) -> &[u32] {
        &self.0
    }
}

impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let numbers: Vec<_> = self.0.iter().map(u32::to_string).collect();
        f.write_str(&numbers.join("."))
    }
}

/// The firmware versions that know an item.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Versions {
    /// First version that has it.
    pub since: Option<Version>,
    /// Last version that has it, with all below it: 1.6 is the last also for 1.6.5.
    pub until: Option<Version>,
}

impl Versions {
    /// These bounds, and those of `others` for missing ones.
    pub(crate) fn or(self, others: &Self) -> Self {
        let Self { since, until } = others.clone();
        Self { since: self.since.or(since), until: self.until.or(until) }
    }

    /// True if no version lies between the two.
    pub(crate) fn is_void(&self) -> bool {
        let (Some(since), Some(until)) = (&self.since, &self.until) else { return false };
        let first = since.0.iter().copied().chain(std::iter::repeat(0));
        first.take(until.0.len()).gt(until.0.iter().copied())
    }
}
