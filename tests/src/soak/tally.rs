//! Counts of events.

use std::collections::BTreeMap;
use std::fmt;

/// Number of events of each kind.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Tally(BTreeMap<String, u64>);

impl Tally {
    pub(super) fn add(&mut self, what: &str, count: u64) {
        if let Some(sum) = self.0.get_mut(what) {
            *sum += count;
        } else {
            self.0.insert(what.to_owned(), count);
        }
    }

    pub(super) fn one(&mut self, what: &str) {
        self.add(what, 1);
    }

    pub(super) fn get(&self, what: &str) -> u64 {
        self.0.get(what).copied().unwrap_or_default()
    }

    pub(super) fn join(&mut self, other: &Self) {
        other.0.iter().for_each(|(what, count)| self.add(what, *count));
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let each: Vec<_> = self.0.iter().map(|(what, count)| format!("{count} {what}")).collect();
        f.write_str(&each.join(", "))
    }
}
