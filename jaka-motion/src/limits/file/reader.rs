//! Values of a TOML file with their places, and errors at these.

use jaka_spec::words::nearest;
use jaka_spec::{Error, Source};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value and its offset in the file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placed<T> {
    pub(super) at: usize,
    pub(super) value: T,
}

/// A table with its name for messages.
#[derive(Debug)]
pub(super) struct Table<'a, 's> {
    pub(super) at: usize,
    what: String,
    entries: &'a DeTable<'s>,
}

impl<'a, 's> Table<'a, 's> {
    pub(super) fn new(what: String, at: usize, entries: &'a DeTable<'s>) -> Self {
        Self { at, what, entries }
    }

    fn about(&self, message: &str) -> String {
        if self.what.is_empty() { message.to_owned() } else { format!("{}: {message}", self.what) }
    }
}

/// What has been wrong so far.
#[derive(Debug)]
pub(super) struct Reader<'s> {
    source: Source<'s>,
    errors: Vec<Error>,
}

impl<'t> Reader<'t> {
    pub(super) fn new(source: Source<'t>) -> Self {
        Self { source, errors: Vec::new() }
    }

    pub(super) fn error(&mut self, at: usize, message: String) {
        self.errors.push(self.source.error(at, message));
    }

    pub(super) fn finish(mut self) -> Vec<Error> {
        self.errors.sort();
        self.errors.dedup();
        self.errors
    }

    /// Reports each key that is not one of these.
    pub(super) fn keys(&mut self, table: &Table<'_, '_>, known: &[&str]) {
        for key in table.entries.keys().filter(|key| !known.contains(&key.get_ref().as_ref())) {
            let hint = match nearest(key.get_ref(), known.iter().copied()) {
                Some(near) => format!("is it `{near}`?"),
                None => format!("the keys are {}", known.join(", ")),
            };
            self.error(key.span().start, table.about(&format!("unknown key `{}`; {hint}", key.get_ref())));
        }
    }

    pub(super) fn required<T>(
        &mut self,
        table: &Table<'_, '_>,
        key: &str,
        read: impl FnOnce(&mut Self, &Table<'_, '_>, &str) -> Option<T>,
    ) -> Option<T> {
        if !table.entries.contains_key(key) {
            self.error(table.at, table.about(&format!("`{key}` is missing")));
        }
        read(self, table, key)
    }

    pub(super) fn text(&mut self, table: &Table<'_, '_>, key: &str) -> Option<Placed<String>> {
        self.typed(table, key, "a string", |value| value.as_str().map(str::to_owned))
    }

    pub(super) fn number(&mut self, table: &Table<'_, '_>, key: &str) -> Option<Placed<f64>> {
        self.typed(table, key, "a finite number", number)
    }

    /// A list of six numbers, or one number for all six.
    pub(super) fn six(&mut self, table: &Table<'_, '_>, key: &str) -> Option<[Placed<f64>; 6]> {
        let expected = "a finite number, or a list of six";
        let six = self.typed(table, key, expected, |value| match value.as_array() {
            Some(list) => numbers(list),
            None => number(value).map(|number| [Placed { at: usize::MAX, value: number }; 6]),
        })?;
        let placed = |each: Placed<f64>| if each.at == usize::MAX { Placed { at: six.at, ..each } } else { each };
        Some(six.value.map(placed))
    }

    pub(super) fn three(&mut self, table: &Table<'_, '_>, key: &str) -> Option<Placed<[f64; 3]>> {
        self.typed(table, key, "a list of three finite numbers", |value| {
            Some(numbers(value.as_array()?)?.map(|each| each.value))
        })
    }

    /// One of the words.
    pub(super) fn choice<T: Copy>(&mut self, table: &Table<'_, '_>, key: &str, words: &[(&str, T)]) -> Option<T> {
        let text = self.required(table, key, Self::text)?;
        let found = words.iter().find(|(word, _)| *word == text.value).map(|(_, value)| *value);
        if found.is_none() {
            let words: Vec<_> = words.iter().map(|(word, _)| format!("\"{word}\"")).collect();
            self.error(text.at, table.about(&format!("`{key}` must be {}", words.join(" or "))));
        }
        found
    }

    pub(super) fn table<'a, 's>(&mut self, table: &Table<'a, 's>, key: &str) -> Option<Table<'a, 's>> {
        let found = self.typed(table, key, "a table", DeValue::as_table)?;
        Some(Table::new(key.to_owned(), found.at, found.value))
    }

    pub(super) fn tables<'a, 's>(&mut self, table: &Table<'a, 's>, key: &str) -> Vec<Table<'a, 's>> {
        let list = self.typed(table, key, "a list of tables", |value| {
            let tables = value.as_array()?.iter();
            tables.map(|each| Some((each.span().start, each.get_ref().as_table()?))).collect::<Option<Vec<_>>>()
        });
        let list = list.map(|list| list.value).unwrap_or_default();
        list.into_iter().map(|(at, table)| Table::new(super::named(key, table), at, table)).collect()
    }

    fn typed<'a, 's, T>(
        &mut self,
        table: &Table<'a, 's>,
        key: &str,
        expected: &str,
        convert: impl FnOnce(&'a DeValue<'s>) -> Option<T>,
    ) -> Option<Placed<T>> {
        let found = table.entries.get(key)?;
        let (at, value) = (found.span().start, convert(found.get_ref()));
        if value.is_none() {
            self.error(at, table.about(&format!("`{key}` must be {expected}")));
        }
        value.map(|value| Placed { at, value })
    }
}

/// The numbers of a list that has as many.
fn numbers<const COUNT: usize>(list: &[Spanned<DeValue<'_>>]) -> Option<[Placed<f64>; COUNT]> {
    let placed = |each: &Spanned<DeValue<'_>>| {
        let value = number(each.get_ref())?;
        Some(Placed { at: each.span().start, value })
    };
    list.iter().map(placed).collect::<Option<Vec<_>>>()?.try_into().ok()
}

fn number(value: &DeValue<'_>) -> Option<f64> {
    let number: f64 = match value {
        DeValue::Float(float) => float.as_str().parse().ok()?,
        #[expect(clippy::cast_precision_loss, reason = "no limit has so many digits")]
        DeValue::Integer(int) => i64::from_str_radix(int.as_str(), int.radix()).ok()? as f64,
        _ => return None,
    };
    number.is_finite().then_some(number)
}
