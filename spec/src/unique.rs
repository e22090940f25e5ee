//! Names that may stand only once.

use std::collections::BTreeMap;

use crate::item::{Item, Placed};
use crate::report::At;

/// Names that are taken, with the place of the first; none for those of the spec that a pack adds to.
#[derive(Debug)]
pub(crate) struct Unique<'s, T>(BTreeMap<T, Option<At<'s>>>);

impl<T> Default for Unique<'_, T> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<'s, T: Ord + Clone + std::fmt::Display> Unique<'s, T> {
    /// Adds a name; false, after an error, if it is taken.
    pub(crate) fn add(&mut self, item: &Item<'_, 's>, what: &str, name: &Placed<'s, T>) -> bool {
        let Some(first) = self.0.get(&name.value) else {
            self.0.insert(name.value.clone(), Some(name.at));
            return true;
        };
        let place = first.map_or_else(|| "by the spec that this adds to".to_owned(), |first| format!("at {first}"));
        item.error(name.at, &format!("the {what} `{}` is taken already, {place}", name.value));
        false
    }

    /// The names that are taken before anything is read.
    pub(crate) fn taken(names: impl Iterator<Item = T>) -> Self {
        Self(names.map(|name| (name, None)).collect())
    }
}
