//! Objects and lists of a JSON file, with the place of each value.

use std::borrow::Cow;

use jaka_proto::wire::{DecodeError, Reader};
use serde_json::value::RawValue;

use super::csv::number;
use crate::text_file::Report;

/// Entries of an object in their order, with the texts of their values.
pub(super) type Entries<'t> = Vec<(Cow<'t, str>, &'t str)>;

/// JSON file.
pub(super) struct File<'t> {
    text: &'t str,
    /// Text of the whole value.
    pub(super) whole: &'t str,
}

/// Key of the list in a file.
const POINTS: &str = "points";

impl<'t> File<'t> {
    /// Reads the text; `None` if it is not JSON.
    pub(super) fn new(text: &'t str, report: &mut Report<'_>) -> Option<Self> {
        match serde_json::from_str::<&RawValue>(text) {
            Ok(whole) => Some(Self { text, whole: whole.get() }),
            Err(error) => {
                let said = error.to_string();
                // The error has the place already.
                let reason = said.rsplit_once(" at line ").map_or(said.as_str(), |(reason, _)| reason);
                let lines = text.split_inclusive('\n').map(str::len);
                let line_start: usize = lines.take(error.line().saturating_sub(1)).sum();
                let at = line_start + error.column().saturating_sub(1);
                report.error(at, format!("not valid JSON: {reason}"));
                None
            }
        }
    }

    /// Returns the offset of a value, which is a part of the text.
    pub(super) fn place(&self, value: &str) -> usize {
        (value.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize)
    }

    pub(super) fn entries(&self, value: &'t str, what: &str, report: &mut Report<'_>) -> Option<Entries<'t>> {
        let Ok(entries) = entries(value) else {
            report.found(self.place(value), what, value, "an object");
            return None;
        };
        for (index, (key, value)) in entries.iter().enumerate() {
            if entries[..index].iter().any(|(other, _)| other == key) {
                report.error(self.place(value), format!("key `{key}` appears twice"));
            }
        }
        Some(entries)
    }

    fn list(&self, value: &'t str, what: &str, expected: &str, report: &mut Report<'_>) -> Option<Vec<&'t str>> {
        let Ok(list) = serde_json::from_str::<Vec<&RawValue>>(value) else {
            report.found(self.place(value), what, value, expected);
            return None;
        };
        Some(list.into_iter().map(RawValue::get).collect())
    }

    /// Returns the points, at least two.
    pub(super) fn points(&self, report: &mut Report<'_>) -> Option<Vec<&'t str>> {
        let entries = self.entries(self.whole, "the file", report)?;
        for (key, value) in entries.iter().filter(|(key, _)| key != POINTS) {
            report.error(self.place(value), format!("unknown key `{key}`; the only key is `{POINTS}`"));
        }
        let Some((_, points)) = entries.iter().find(|(key, _)| key == POINTS) else {
            report.error(self.place(self.whole), format!("`{POINTS}` is missing"));
            return None;
        };
        self.list(points, POINTS, "a list of objects", report)
    }

    /// Returns a list of `N` numbers.
    pub(super) fn numbers<const N: usize>(
        &self,
        value: &'t str,
        key: &str,
        count: &str,
        report: &mut Report<'_>,
    ) -> Option<[f64; N]> {
        let list = self.list(value, key, &format!("a list of {count} numbers"), report)?;
        if list.len() != N {
            report.error(self.place(value), format!("{key}: found {} numbers, expected {count}", list.len()));
            return None;
        }
        let numbers: Vec<_> = list.into_iter().map(|value| self.number(value, key, report)).collect();
        let numbers: Option<Vec<_>> = numbers.into_iter().collect();
        numbers?.try_into().ok()
    }

    pub(super) fn number(&self, value: &str, what: &str, report: &mut Report<'_>) -> Option<f64> {
        let number = number(value);
        if number.is_none() {
            report.found(self.place(value), what, value, "a finite number");
        }
        number
    }
}

fn entries(object: &str) -> Result<Entries<'_>, DecodeError> {
    let (mut reader, mut entries) = (Reader::new(object), Vec::new());
    reader.begin_object()?;
    while let Some(key) = reader.next_key()? {
        entries.push((key, reader.raw()?));
    }
    Ok(entries)
}
