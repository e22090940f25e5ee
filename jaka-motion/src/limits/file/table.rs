//! Reader for one TOML table.

use std::cell::RefCell;
use std::collections::BTreeSet;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::text_file::{FileErrors, Report, nearest};

/// Value with its offset in the text, in bytes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placed<T> {
    pub(super) at: usize,
    pub(super) value: T,
}

/// Table of the file, with typed access to its keys and an error for each unknown one.
#[derive(Debug)]
pub(super) struct Table<'a, 't> {
    /// Name in errors, such as ``box `camera` ``; empty for the file.
    what: String,
    pub(super) at: usize,
    entries: &'a DeTable<'t>,
    report: &'a RefCell<Report<'t>>,
    asked: RefCell<BTreeSet<&'static str>>,
}

/// Reads a file. Reports syntax errors, the errors that `read` finds, and keys that it does not ask for.
pub(super) fn read_file<T>(
    (text, file_name): (&str, &str),
    read: impl FnOnce(&Table<'_, '_>) -> T,
) -> Result<T, FileErrors> {
    let report = RefCell::new(Report::new(text, file_name));
    let (table, errors) = DeTable::parse_recoverable(text);
    for error in errors {
        let at = error.span().map_or(0, |span| span.start);
        report.borrow_mut().error(at, format!("not valid TOML: {}", error.message()));
    }
    let file = Table::new(String::new(), 0, table.get_ref(), &report);
    let found = read(&file);
    file.finish();
    drop(file);
    report.into_inner().finish(found)
}

impl<'a, 't> Table<'a, 't> {
    fn new(what: String, at: usize, entries: &'a DeTable<'t>, report: &'a RefCell<Report<'t>>) -> Self {
        Self { what, at, entries, report, asked: RefCell::default() }
    }

    /// Reports an error about this table.
    pub(super) fn error(&self, at: usize, message: &str) {
        let what = if self.what.is_empty() { String::new() } else { format!("{}: ", self.what) };
        self.report.borrow_mut().error(at, what + message);
    }

    /// Reports a key that is missing.
    pub(super) fn require(&self, key: &'static str) {
        if self.get(key).is_none() {
            self.error(self.at, &format!("`{key}` is missing"));
        }
    }

    pub(super) fn text(&self, key: &'static str) -> Option<Placed<&'a str>> {
        self.typed(key, "a string", DeValue::as_str)
    }

    pub(super) fn number(&self, key: &'static str) -> Option<Placed<f64>> {
        self.typed(key, "a finite number", finite)
    }

    /// Returns a list of `N` numbers. `alone` may make a list of a single number.
    pub(super) fn numbers<const N: usize>(
        &self,
        key: &'static str,
        expected: &str,
        alone: impl FnOnce(Placed<f64>) -> Option<[Placed<f64>; N]>,
    ) -> Option<[Placed<f64>; N]> {
        let at = self.get(key)?.span().start;
        let numbers = self.typed(key, expected, |value| match value.as_array() {
            Some(list) => list.iter().map(|number| placed(number, finite)).collect::<Option<Vec<_>>>()?.try_into().ok(),
            None => finite(value).and_then(|value| alone(Placed { at, value })),
        });
        numbers.map(|numbers| numbers.value)
    }

    /// Returns the table under a key.
    pub(super) fn table(&self, key: &'static str) -> Option<Self> {
        let table = self.typed(key, "a table", DeValue::as_table)?;
        Some(Self::new(key.to_owned(), table.at, table.value, self.report))
    }

    /// Returns the tables of a list under a key, each named by its own `name`.
    pub(super) fn tables(&self, key: &'static str, what: &str) -> Vec<Self> {
        let expected = "a list of tables";
        let list = self.typed(key, expected, DeValue::as_array);
        let mut tables = Vec::new();
        for element in list.iter().flat_map(|list| list.value.iter()) {
            match placed(element, DeValue::as_table) {
                Some(Placed { at, value }) => {
                    let name = value.get("name").and_then(|name| name.get_ref().as_str());
                    let what = name.map_or_else(|| what.to_owned(), |name| format!("{what} `{name}`"));
                    tables.push(Self::new(what, at, value, self.report));
                }
                None => self.error(element.span().start, &format!("`{key}` must be {expected}")),
            }
        }
        tables
    }

    /// Reports each key that nothing asked for.
    pub(super) fn finish(&self) {
        let asked = self.asked.borrow();
        for key in self.entries.keys().filter(|key| !asked.contains(key.get_ref().as_ref())) {
            let hint = match nearest(key.get_ref(), asked.iter().copied()) {
                Some(near) => format!("is it `{near}`?"),
                None => format!("the keys are {}", asked.iter().copied().collect::<Vec<_>>().join(", ")),
            };
            self.error(key.span().start, &format!("unknown key `{}`; {hint}", key.get_ref()));
        }
    }

    fn get(&self, key: &'static str) -> Option<&'a Spanned<DeValue<'t>>> {
        self.asked.borrow_mut().insert(key);
        self.entries.get(key)
    }

    fn typed<T>(
        &self,
        key: &'static str,
        expected: &str,
        convert: impl FnOnce(&'a DeValue<'t>) -> Option<T>,
    ) -> Option<Placed<T>> {
        let found = self.get(key)?;
        let value = placed(found, convert);
        if value.is_none() {
            self.error(found.span().start, &format!("`{key}` must be {expected}"));
        }
        value
    }
}

fn placed<'a, 't, T>(
    found: &'a Spanned<DeValue<'t>>,
    convert: impl FnOnce(&'a DeValue<'t>) -> Option<T>,
) -> Option<Placed<T>> {
    convert(found.get_ref()).map(|value| Placed { at: found.span().start, value })
}

fn finite(value: &DeValue<'_>) -> Option<f64> {
    let number = match value {
        DeValue::Float(float) => float.as_str().parse().ok()?,
        #[expect(clippy::cast_precision_loss, reason = "limits are small")]
        DeValue::Integer(int) => i64::from_str_radix(int.as_str(), int.radix()).ok()? as f64,
        _ => return None,
    };
    number.is_finite().then_some(number)
}
