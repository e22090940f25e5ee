//! JSON.

use std::fmt;

use jaka_spec::words::nearest;
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::value::RawValue;

use super::columns::{Column, Kind, Unit, number};
use super::report::Report;
use super::rows::{Row, Rows};
use crate::trajectory::timed::TimedPoint;

/// The entries of an object in their order, with values whose place in the text is known.
struct Entries<'t>(Vec<(String, &'t RawValue)>);

/// The list in a file.
const POINTS: &str = "points";

pub(super) fn read(text: &str, report: &mut Report<'_>) -> Vec<TimedPoint> {
    let mut rows = Rows::default();
    let whole: &RawValue = match serde_json::from_str(text) {
        Ok(whole) => whole,
        Err(error) => {
            let text = error.to_string();
            // The place is said already.
            let reason = text.rsplit_once(" at line ").map_or(text.as_str(), |(reason, _)| reason);
            report.error_at(error.line().max(1), error.column().max(1), format!("not valid JSON: {reason}"));
            return Vec::new();
        }
    };
    let reader = Reader { text };
    let points = reader.entries(whole, "the file", report).and_then(|entries| reader.points(whole, &entries, report));
    let mut first = None;
    for point in points.iter().flatten() {
        if let Some((row, has)) = reader.row(point, report) {
            if *first.get_or_insert(has) != has {
                report.error(reader.place(point), "a point: its keys are not those of the first point");
            }
            rows.add(&row, report);
        }
    }
    if let Some(points) = points.filter(|points| points.len() < 2) {
        report.error(reader.place(whole), format!("found {} points, expected at least 2", points.len()));
    }
    rows.finish()
}

struct Reader<'t> {
    text: &'t str,
}

impl<'t> Reader<'t> {
    /// The offset of a value, which is a part of the text.
    fn place(&self, value: &RawValue) -> usize {
        (value.get().as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize)
    }

    fn entries(&self, value: &'t RawValue, what: &str, report: &mut Report<'_>) -> Option<Vec<(String, &'t RawValue)>> {
        let Ok(Entries(entries)) = serde_json::from_str(value.get()) else {
            report.found(self.place(value), what, value.get(), "an object");
            return None;
        };
        for (index, (key, value)) in entries.iter().enumerate() {
            if entries[..index].iter().any(|(other, _)| other == key) {
                report.error(self.place(value), format!("key `{key}` comes twice"));
            }
        }
        Some(entries)
    }

    fn list(
        &self,
        value: &'t RawValue,
        what: &str,
        expected: &str,
        report: &mut Report<'_>,
    ) -> Option<Vec<&'t RawValue>> {
        let list = serde_json::from_str(value.get()).ok();
        if list.is_none() {
            report.found(self.place(value), what, value.get(), expected);
        }
        list
    }

    fn points(
        &self,
        whole: &RawValue,
        entries: &[(String, &'t RawValue)],
        report: &mut Report<'_>,
    ) -> Option<Vec<&'t RawValue>> {
        for (key, value) in entries.iter().filter(|(key, _)| key != POINTS) {
            report.error(self.place(value), format!("unknown key `{key}`; there is `{POINTS}` alone"));
        }
        let Some((_, points)) = entries.iter().find(|(key, _)| key == POINTS) else {
            report.error(self.place(whole), format!("`{POINTS}` is missing"));
            return None;
        };
        self.list(points, POINTS, "a list of objects", report)
    }

    /// What a point says, and what there is of it, right or wrong.
    fn row(&self, point: &'t RawValue, report: &mut Report<'_>) -> Option<(Row, [bool; 3])> {
        let entries = self.entries(point, "a point", report)?;
        let (mut row, mut read) = (Row::default(), [false; 3]);
        if !entries.iter().any(|(key, _)| key == Column::TIME) {
            report.error(self.place(point), format!("a point: `{}` is missing", Column::TIME));
        }
        for (key, value) in entries {
            if key == Column::TIME {
                row.time = self.number(value, &key, report).map(|time_s| (time_s, self.place(value)));
            } else if let Some((kind, unit)) = kind_of(&key) {
                if std::mem::replace(&mut read[kind as usize], true) {
                    report.error(self.place(value), format!("key `{key}`: there is one of this already"));
                }
                *row.angles(kind) = self.six(value, &key, unit, report);
            } else {
                report.error(self.place(value), unknown(&key));
            }
        }
        let [positions, velocities, accelerations] = read;
        for (kind, is_missing) in [(Kind::Position, !positions), (Kind::Velocity, accelerations && !velocities)] {
            if is_missing {
                let [degrees, radians] = Unit::BOTH.map(|unit| kind.key(unit));
                report.error(self.place(point), format!("a point: `{degrees}` or `{radians}` is missing"));
            }
        }
        Some((row, read))
    }

    fn six(&self, value: &'t RawValue, key: &str, unit: Unit, report: &mut Report<'_>) -> Option<[f64; 6]> {
        let list = self.list(value, key, "a list of six numbers", report)?;
        if list.len() != 6 {
            report.error(self.place(value), format!("{key}: found {} numbers, expected six", list.len()));
            return None;
        }
        let numbers: Vec<_> = list.into_iter().map(|value| self.number(value, key, report)).collect();
        let numbers: Option<Vec<_>> = numbers.into_iter().collect();
        numbers?.try_into().ok().map(|numbers: [f64; 6]| numbers.map(|number| unit.to_degrees(number)))
    }

    fn number(&self, value: &RawValue, what: &str, report: &mut Report<'_>) -> Option<f64> {
        let number = number(value.get());
        if number.is_none() {
            report.found(self.place(value), what, value.get(), "a finite number");
        }
        number
    }
}

fn keys() -> impl Iterator<Item = (String, Kind, Unit)> {
    let both = Kind::ALL.into_iter().flat_map(|kind| Unit::BOTH.map(|unit| (kind, unit)));
    both.map(|(kind, unit)| (kind.key(unit), kind, unit))
}

fn kind_of(key: &str) -> Option<(Kind, Unit)> {
    keys().find(|(known, ..)| known == key).map(|(_, kind, unit)| (kind, unit))
}

fn unknown(key: &str) -> String {
    let known: Vec<_> = std::iter::once(Column::TIME.to_owned()).chain(keys().map(|(key, ..)| key)).collect();
    match nearest(key, known.iter().map(String::as_str)) {
        Some(near) => format!("unknown key `{key}`; is it `{near}`?"),
        None => format!("unknown key `{key}`; the keys are {}", known.join(", ")),
    }
}

impl<'de> Deserialize<'de> for Entries<'de> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reading;

        impl<'de> Visitor<'de> for Reading {
            type Value = Entries<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(Entries(entries))
            }
        }

        deserializer.deserialize_map(Reading)
    }
}
