//! One TOML table being read: typed access to its keys, and an error for each unknown key.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::Source;
use crate::report::{At, Report};
use crate::words::nearest;

/// A value and its place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed<'s, T> {
    /// Position of the value in the file.
    pub(crate) at: At<'s>,
    /// The value.
    pub(crate) value: T,
}

/// A table of the file, with a name for error messages such as ``command `jog` ``.
#[derive(Debug)]
pub(crate) struct Item<'a, 's> {
    /// Its name; empty for the file.
    pub(crate) what: String,
    /// Position at which the table begins.
    pub(crate) at: At<'s>,
    table: &'a DeTable<'s>,
    report: &'a Report,
    asked: RefCell<BTreeSet<&'static str>>,
}

/// Used names, with the place of the first; `None` for names of the spec that a pack extends.
#[derive(Debug)]
pub(crate) struct Unique<'s, T>(BTreeMap<T, Option<At<'s>>>);

impl<'a, 's> Item<'a, 's> {
    pub(crate) fn new(what: String, at: At<'s>, table: &'a DeTable<'s>, report: &'a Report) -> Self {
        Self { what, at, table, report, asked: RefCell::default() }
    }

    pub(crate) fn source(&self) -> Source<'s> {
        self.at.source
    }

    /// Reports an error about this table, at `at`.
    pub(crate) fn error(&self, at: At<'s>, message: &str) {
        let message = if self.what.is_empty() { message.to_owned() } else { format!("{}: {message}", self.what) };
        self.report.error(at, message);
    }

    fn get(&self, key: &'static str) -> Option<(At<'s>, &'a DeValue<'s>)> {
        self.asked.borrow_mut().insert(key);
        let value = self.table.get(key)?;
        Some((At::new(self.source(), &value.span()), value.get_ref()))
    }

    fn typed<T>(
        &self,
        key: &'static str,
        expected: &str,
        convert: impl FnOnce(&'a DeValue<'s>) -> Option<T>,
    ) -> Option<Placed<'s, T>> {
        let (at, found) = self.get(key)?;
        let value = convert(found);
        if value.is_none() {
            self.error(at, &format!("`{key}` must be {expected}"));
        }
        value.map(|value| Placed { at, value })
    }

    /// True if the table has the key, with any value.
    pub(crate) fn has(&self, key: &'static str) -> bool {
        self.get(key).is_some()
    }

    /// True if the value under `key` is a string; this does not mark the key as read.
    pub(crate) fn is_text(&self, key: &'static str) -> bool {
        self.table.get(key).is_some_and(|value| value.get_ref().is_str())
    }

    /// A text.
    pub(crate) fn text(&self, key: &'static str) -> Option<Placed<'s, String>> {
        self.typed(key, "a string", text)
    }

    /// Reports a key that is missing.
    pub(crate) fn require(&self, key: &'static str) {
        if !self.has(key) {
            self.error(self.at, &format!("`{key}` is missing"));
        }
    }

    /// The text under `key`; an empty one, after an error, if there is none.
    pub(crate) fn required_text(&self, key: &'static str) -> Placed<'s, String> {
        self.require(key);
        let found = self.text(key);
        if let Some(text) = found.as_ref().filter(|text| text.value.trim().is_empty()) {
            self.error(text.at, &format!("`{key}` is empty"));
        }
        found.unwrap_or(Placed { at: self.at, value: String::new() })
    }

    pub(crate) fn texts(&self, key: &'static str) -> Vec<Placed<'s, String>> {
        self.list(key, "a list of strings", text)
    }

    pub(crate) fn flag(&self, key: &'static str) -> Option<Placed<'s, bool>> {
        self.typed(key, "true or false", DeValue::as_bool)
    }

    pub(crate) fn int(&self, key: &'static str) -> Option<Placed<'s, i64>> {
        self.typed(key, "a whole number", int)
    }

    /// A finite number.
    pub(crate) fn number(&self, key: &'static str) -> Option<Placed<'s, f64>> {
        self.typed(key, "a finite number", finite)
    }

    /// A limit; infinity means that there is none.
    pub(crate) fn bound(&self, key: &'static str) -> Option<Placed<'s, f64>> {
        self.typed(key, "a number, or inf or -inf for no limit", |value| {
            number(value).filter(|number| !number.is_nan())
        })
    }

    /// The list under `key` as JSON texts of its scalars.
    pub(crate) fn json_scalars(&self, key: &'static str) -> Option<Placed<'s, Vec<String>>> {
        self.typed(key, "a list of scalars", |value| {
            value.as_array()?.iter().map(|element| json_scalar(element.get_ref())).collect()
        })
    }

    /// The tables of `[[… .key]]`, each named by `what` and its own `name` or `wire`.
    pub(crate) fn items(&self, key: &'static str, what: &str) -> Vec<Item<'a, 's>> {
        let tables = self.list(key, "a list of tables", |value| value.as_table());
        tables.into_iter().map(|table| self.child(what, table.at, table.value)).collect()
    }

    /// The table of `[… .key]`.
    pub(crate) fn item(&self, key: &'static str, what: &str) -> Option<Item<'a, 's>> {
        let table = self.typed(key, "a table", |value| value.as_table())?;
        Some(self.child(what, table.at, table.value))
    }

    fn child(&self, what: &str, at: At<'s>, table: &'a DeTable<'s>) -> Item<'a, 's> {
        let name = ["target", "name", "wire", "tag"].iter().find_map(|key| json_scalar(table.get(*key)?.get_ref()));
        let name = name.map(|name| format!("{what} `{}`", name.trim_matches('"')));
        let what = match (&name, self.what.as_str()) {
            (Some(name), "") => name.clone(),
            (None, "") => what.to_owned(),
            (Some(name), outer) => format!("{outer}, {name}"),
            (None, outer) => format!("{outer}, {what}"),
        };
        Item::new(what, at, table, self.report)
    }

    fn list<T>(
        &self,
        key: &'static str,
        expected: &str,
        convert: impl Fn(&'a DeValue<'s>) -> Option<T>,
    ) -> Vec<Placed<'s, T>> {
        let Some(array) = self.typed(key, expected, |value| value.as_array()) else {
            return Vec::new();
        };
        let mut list = Vec::new();
        for element in array.value {
            let at = At::new(self.source(), &element.span());
            match convert(element.get_ref()) {
                Some(value) => list.push(Placed { at, value }),
                None => self.error(at, &format!("`{key}` must be {expected}")),
            }
        }
        list
    }

    /// Reports each key that was never read.
    pub(crate) fn finish(&self) {
        let asked = self.asked.borrow();
        for key in self.table.keys().filter(|key| !asked.contains(key.get_ref().as_ref())) {
            let hint = match nearest(key.get_ref(), asked.iter().copied()) {
                Some(near) => format!("is it `{near}`?"),
                None => format!("the keys are {}", asked.iter().copied().collect::<Vec<_>>().join(", ")),
            };
            let at = At::new(self.source(), &key.span());
            self.error(at, &format!("unknown key `{}`; {hint}", key.get_ref()));
        }
    }
}

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

    pub(crate) fn has(&self, name: &T) -> bool {
        self.0.contains_key(name)
    }

    /// The names that are taken before anything is read.
    pub(crate) fn taken(names: impl Iterator<Item = T>) -> Self {
        Self(names.map(|name| (name, None)).collect())
    }
}

fn text(value: &DeValue<'_>) -> Option<String> {
    value.as_str().map(str::to_owned)
}

fn int(value: &DeValue<'_>) -> Option<i64> {
    match value {
        DeValue::Integer(int) => i64::from_str_radix(int.as_str(), int.radix()).ok(),
        _ => None,
    }
}

fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Float(float) => float.as_str().parse().ok(),
        #[expect(clippy::cast_precision_loss, reason = "limits of the protocol are small")]
        other => int(other).map(|i| i as f64),
    }
}

fn finite(value: &DeValue<'_>) -> Option<f64> {
    number(value).filter(|number| number.is_finite())
}

fn json_scalar(value: &DeValue<'_>) -> Option<String> {
    match value {
        DeValue::Boolean(value) => Some(value.to_string()),
        DeValue::String(value) if !value.contains(['"', '\\']) => Some(format!("\"{value}\"")),
        other => int(other).map(|i| i.to_string()),
    }
}

/// The parsed file, with every syntax error reported.
pub(crate) fn parse<'s>(source: Source<'s>, report: &Report) -> Spanned<DeTable<'s>> {
    let (table, errors) = DeTable::parse_recoverable(source.text);
    for error in errors {
        let at = At::new(source, &error.span().unwrap_or(0..0));
        report.error(at, format!("not valid TOML: {}", error.message()));
    }
    table
}
