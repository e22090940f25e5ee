//! JSON.

use std::borrow::Cow;

use jaka_proto::wire::{DecodeError, Reader};
use serde_json::value::RawValue;

use super::{Column, Kind, Row, Rows, Unit, angles, kinds};
use crate::text_file::{Report, nearest};
use crate::trajectory::csv::number;
use crate::trajectory::timed::TimedPoint;

/// The entries of an object in their order, with the texts of their values.
type Entries<'t> = Vec<(Cow<'t, str>, &'t str)>;

/// The list in a file.
const POINTS: &str = "points";

pub(super) fn read(text: &str, report: &mut Report<'_>) -> Vec<TimedPoint> {
    let mut rows = Rows::default();
    let whole = match serde_json::from_str::<&RawValue>(text) {
        Ok(whole) => whole.get(),
        Err(error) => {
            let said = error.to_string();
            // The place is said already.
            let reason = said.rsplit_once(" at line ").map_or(said.as_str(), |(reason, _)| reason);
            let lines = text.split_inclusive('\n').map(str::len);
            let line_start: usize = lines.take(error.line().saturating_sub(1)).sum();
            let at = line_start + error.column().saturating_sub(1);
            report.error(at, format!("not valid JSON: {reason}"));
            return Vec::new();
        }
    };
    let file = File { text };
    let points = file.entries(whole, "the file", report).and_then(|entries| file.points(whole, &entries, report));
    let mut first = None;
    for point in points.iter().flatten() {
        if let Some((row, has)) = file.row(point, report) {
            if *first.get_or_insert(has) != has {
                report.error(file.place(point), "a point: its keys are not those of the first point");
            }
            rows.add(&row, report);
        }
    }
    if let Some(points) = points.filter(|points| points.len() < 2) {
        report.error(file.place(whole), format!("found {} points, expected at least 2", points.len()));
    }
    rows.finish()
}

/// Text of points, with as many digits as tell each number from all others.
pub(in crate::trajectory::timed) fn write(points: &[TimedPoint]) -> String {
    let kinds = kinds(points);
    let point = |point: &TimedPoint| {
        let lists = angles(point).take(kinds).map(|(kind, angles)| {
            let numbers = angles.map(|number| number.to_string()).join(", ");
            format!(", \"{}\": [{numbers}]", kind.key(Unit::Degrees))
        });
        format!("    {{\"{}\": {}{}}}", Column::TIME, point.time_s, lists.collect::<String>())
    };
    format!("{{\"points\": [\n{}\n]}}\n", points.iter().map(point).collect::<Vec<_>>().join(",\n"))
}

struct File<'t> {
    text: &'t str,
}

impl<'t> File<'t> {
    /// The offset of a value, which is a part of the text.
    fn place(&self, value: &str) -> usize {
        (value.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize)
    }

    fn entries(&self, value: &'t str, what: &str, report: &mut Report<'_>) -> Option<Entries<'t>> {
        let Ok(entries) = entries(value) else {
            report.found(self.place(value), what, value, "an object");
            return None;
        };
        for (index, (key, value)) in entries.iter().enumerate() {
            if entries[..index].iter().any(|(other, _)| other == key) {
                report.error(self.place(value), format!("key `{key}` comes twice"));
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

    fn points(
        &self,
        whole: &str,
        entries: &[(Cow<'t, str>, &'t str)],
        report: &mut Report<'_>,
    ) -> Option<Vec<&'t str>> {
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
    fn row(&self, point: &'t str, report: &mut Report<'_>) -> Option<(Row, [bool; 3])> {
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

    fn six(&self, value: &'t str, key: &str, unit: Unit, report: &mut Report<'_>) -> Option<[f64; 6]> {
        let list = self.list(value, key, "a list of six numbers", report)?;
        if list.len() != 6 {
            report.error(self.place(value), format!("{key}: found {} numbers, expected six", list.len()));
            return None;
        }
        let numbers: Vec<_> = list.into_iter().map(|value| self.number(value, key, report)).collect();
        let numbers: Option<Vec<_>> = numbers.into_iter().collect();
        numbers?.try_into().ok().map(|numbers: [f64; 6]| numbers.map(|number| unit.to_degrees(number)))
    }

    fn number(&self, value: &str, what: &str, report: &mut Report<'_>) -> Option<f64> {
        let number = number(value);
        if number.is_none() {
            report.found(self.place(value), what, value, "a finite number");
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

fn entries(object: &str) -> Result<Entries<'_>, DecodeError> {
    let (mut reader, mut entries) = (Reader::new(object), Vec::new());
    reader.begin_object()?;
    while let Some(key) = reader.next_key()? {
        entries.push((key, reader.raw()?));
    }
    Ok(entries)
}
