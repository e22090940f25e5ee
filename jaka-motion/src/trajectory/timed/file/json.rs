//! Points with times in JSON.

use super::{Column, Kind, Row, Rows, Unit, angles, kinds};
use crate::text_file::{Report, nearest};
use crate::trajectory::json::File;
use crate::trajectory::timed::TimedPoint;

pub(super) fn read(text: &str, report: &mut Report<'_>) -> Vec<TimedPoint> {
    let mut rows = Rows::default();
    let Some(file) = File::new(text, report) else { return Vec::new() };
    let points = file.points(report);
    let mut first = None;
    for point in points.iter().flatten() {
        if let Some((row, has)) = row(&file, point, report) {
            if *first.get_or_insert(has) != has {
                report.error(file.place(point), "a point: its keys differ from the keys of the first point");
            }
            rows.add(&row, report);
        }
    }
    if let Some(points) = points.filter(|points| points.len() < 2) {
        report.error(file.place(file.whole), format!("found {} points, expected at least 2", points.len()));
    }
    rows.finish()
}

/// Returns the text of points, with the digits that distinguish each number from all others.
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

/// Returns the content of a point, and flags for the kinds of numbers that it has, valid or not.
fn row<'t>(file: &File<'t>, point: &'t str, report: &mut Report<'_>) -> Option<(Row, [bool; 3])> {
    let entries = file.entries(point, "a point", report)?;
    let (mut row, mut read) = (Row::default(), [false; 3]);
    if !entries.iter().any(|(key, _)| key == Column::TIME) {
        report.error(file.place(point), format!("a point: `{}` is missing", Column::TIME));
    }
    for (key, value) in entries {
        if key == Column::TIME {
            row.time = file.number(value, &key, report).map(|time_s| (time_s, file.place(value)));
        } else if let Some((kind, unit)) = kind_of(&key) {
            if std::mem::replace(&mut read[kind as usize], true) {
                report.error(file.place(value), format!("key `{key}` appears twice"));
            }
            let numbers = file.numbers(value, &key, "six", report);
            *row.angles(kind) = numbers.map(|numbers: [f64; 6]| numbers.map(|number| unit.to_degrees(number)));
        } else {
            report.error(file.place(value), unknown(&key));
        }
    }
    let [positions, velocities, accelerations] = read;
    for (kind, is_missing) in [(Kind::Position, !positions), (Kind::Velocity, accelerations && !velocities)] {
        if is_missing {
            let [degrees, radians] = Unit::BOTH.map(|unit| kind.key(unit));
            report.error(file.place(point), format!("a point: `{degrees}` or `{radians}` is missing"));
        }
    }
    Some((row, read))
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
