//! Search for changes, and notes of them.

use std::fmt::Display;

use super::{Difference, Impact};
use crate::{Field, Scalar, Spec, Type, Versions};

/// Text for an item that only the new spec has.
pub(super) const ADDED: &str = "added";
/// Text for an item that only the old spec has.
pub(super) const REMOVED: &str = "removed";

/// The two specs, and the changes noted so far.
pub(super) struct Differ<'s> {
    pub(super) old: &'s Spec,
    pub(super) new: &'s Spec,
    changes: Vec<Difference>,
}

impl<'s> Differ<'s> {
    pub(super) fn new(old: &'s Spec, new: &'s Spec) -> Self {
        Self { old, new, changes: Vec::new() }
    }

    pub(super) fn note(&mut self, place: &str, what: impl Into<String>, impact: Impact) {
        self.changes.push(Difference { place: place.to_owned(), what: what.into(), impact });
    }

    /// Both items, or nothing after a note that there is only one. A removal is always major.
    pub(super) fn both<'i, T>(&mut self, place: &str, pair: &Pair<'i, T>, added: Impact) -> Option<(&'i T, &'i T)> {
        match pair {
            Pair::Removed(_) => self.note(place, REMOVED, Impact::Major),
            Pair::Added(_) => self.note(place, ADDED, added),
            Pair::Both(old, new) => return Some((old, new)),
        }
        None
    }

    /// Notes that a text for people changed. What it says now, the spec shows better than a line here.
    pub(super) fn reworded<T: PartialEq>(&mut self, place: &str, what: &str, old: &T, new: &T) {
        if old != new {
            self.note(place, format!("{what} changed"), Impact::Patch);
        }
    }

    /// Notes a changed value, with the old and the new one.
    pub(super) fn value<T: PartialEq + Display>(&mut self, place: &str, what: &str, old: &T, new: &T, impact: Impact) {
        if old != new {
            self.note(place, format!("{what} changed from `{old}` to `{new}`"), impact);
        }
    }

    /// Notes that a value that may be absent changed, was added or was removed.
    pub(super) fn option<T: PartialEq + Display>(
        &mut self,
        place: &str,
        what: &str,
        values: (Option<&T>, Option<&T>),
        impact: Impact,
    ) {
        match values {
            (Some(old), Some(new)) => self.value(place, what, old, new, impact),
            (Some(old), None) => self.note(place, format!("{what} removed, was `{old}`"), impact),
            (None, Some(new)) => self.note(place, format!("{what} added: `{new}`"), impact),
            (None, None) => {}
        }
    }

    /// Notes that something is so in one spec alone: the words and the impact of its coming, and of its going.
    pub(super) fn flag(&mut self, place: &str, (old, new): (bool, bool), comes: (&str, Impact), goes: (&str, Impact)) {
        match (old, new) {
            (false, true) => self.note(place, comes.0, comes.1),
            (true, false) => self.note(place, goes.0, goes.1),
            _ => {}
        }
    }

    /// Notes that the range of firmware versions that have the item changed.
    pub(super) fn versions(&mut self, place: &str, old: &Versions, new: &Versions) {
        self.option(place, "`since`", (old.since.as_ref(), new.since.as_ref()), Impact::Patch);
        self.option(place, "`until`", (old.until.as_ref(), new.until.as_ref()), Impact::Patch);
    }

    /// Notes that the generated item is `Copy` in one spec alone.
    pub(super) fn copies(&mut self, place: &str, values: (bool, bool)) {
        self.flag(place, values, ("becomes `Copy`", Impact::Minor), ("is no longer `Copy`", Impact::Major));
    }

    /// The changes, those with the greatest impact first, then by place.
    pub(super) fn finish(mut self) -> Vec<Difference> {
        self.changes.sort_by(|a, b| b.impact.cmp(&a.impact).then_with(|| a.place.cmp(&b.place)));
        self.changes
    }
}

/// An item of either list, or one of each that belong together.
pub(super) enum Pair<'i, T> {
    Removed(&'i T),
    Added(&'i T),
    Both(&'i T, &'i T),
}

impl<'i, T> Pair<'i, T> {
    /// The newer item of the two.
    pub(super) fn any(&self) -> &'i T {
        match self {
            Self::Removed(item) | Self::Added(item) | Self::Both(_, item) => item,
        }
    }
}

impl Differ<'_> {
    /// True if both types are the same in Rust, however they are written on the wire.
    pub(super) fn same_type(&self, old: &Type, new: &Type) -> bool {
        match (old, new) {
            (Type::Python(old), new) => self.same_type(old, new),
            (old, Type::Python(new)) => self.same_type(old, new),
            (Type::Scalar(Scalar::Bool { .. }), Type::Scalar(Scalar::Bool { .. })) => true,
            (Type::Scalar(old), Type::Scalar(new)) => old == new,
            (Type::List(old), Type::List(new)) => self.same_type(old, new),
            (Type::Array(old, old_len), Type::Array(new, new_len)) => old_len == new_len && self.same_type(old, new),
            (Type::Named(old), Type::Named(new)) => self.old[*old].name == self.new[*new].name,
            (Type::Scalar(_) | Type::List(_) | Type::Array(..) | Type::Named(_), _) => false,
        }
    }
}

/// The items of both lists, matched by their keys: in the order of the new list, and then what it lacks.
pub(super) fn pairs<'i, T, K: PartialEq>(old: &'i [T], new: &'i [T], key: impl Fn(&T) -> K) -> Vec<Pair<'i, T>> {
    let find = |list: &'i [T], wanted: &T| list.iter().find(|item| key(item) == key(wanted));
    let present = new.iter().map(|new| find(old, new).map_or(Pair::Added(new), |old| Pair::Both(old, new)));
    let removed = old.iter().filter(|old| find(new, old).is_none()).map(Pair::Removed);
    present.chain(removed).collect()
}

/// The key by which a field is matched.
pub(super) fn key(field: &Field) -> String {
    if field.wire.is_empty() { field.name.clone() } else { field.wire.clone() }
}

/// The keys of `fields` that `others` have too, in the order of `fields`.
pub(super) fn common(fields: &[Field], others: &[Field]) -> Vec<String> {
    fields.iter().map(key).filter(|found| others.iter().any(|other| key(other) == *found)).collect()
}
