//! Points with times in CSV.

use std::fmt::Write;

use super::{Column, Kind, Row, Rows, Unit, angles, kinds};
use crate::text_file::{Report, nearest};
use crate::trajectory::csv::{fields, lines, number};
use crate::trajectory::timed::TimedPoint;

pub(super) fn read(text: &str, report: &mut Report<'_>) -> Vec<TimedPoint> {
    let mut lines = lines(text);
    let Some((at, header)) = lines.next() else {
        report.error(0, "found no line, expected one that names the columns");
        return Vec::new();
    };
    let columns = columns(at, header, report);
    let (mut rows, mut count) = (Rows::default(), 0);
    for (at, line) in lines {
        count += 1;
        if let Some(row) = row(at, line, &columns, report) {
            rows.add(&row, report);
        }
    }
    if count < 2 {
        report.error(at, format!("found {count} points, expected at least 2"));
    }
    rows.finish()
}

/// Returns the text of points, with the digits that distinguish each number from all others.
pub(in crate::trajectory::timed) fn write(points: &[TimedPoint]) -> String {
    let kinds = kinds(points);
    let names = Kind::ALL.into_iter().take(kinds);
    let names = names.flat_map(|kind| (1..=6).map(move |joint| kind.column(joint, Unit::Degrees)));
    let mut text = std::iter::once(Column::TIME.to_owned()).chain(names).collect::<Vec<_>>().join(",");
    text.push('\n');
    for point in points {
        text.push_str(&point.time_s.to_string());
        for number in angles(point).take(kinds).flat_map(|(_, angles)| angles) {
            // Writing to a string does not fail.
            let _ = write!(text, ",{number}");
        }
        text.push('\n');
    }
    text
}

/// Returns the columns that the header names; `None` for one that is unknown.
fn columns(at: usize, header: &str, report: &mut Report<'_>) -> Vec<Option<(String, Column)>> {
    let known = Column::all();
    let mut columns: Vec<Option<(String, Column)>> = Vec::new();
    for (at, name) in fields((at, header)) {
        let column = known.iter().find(|(known, _)| known == name).cloned();
        match &column {
            None => report.error(at, unknown(name, &known)),
            Some((_, column)) if columns.iter().flatten().any(|(_, other)| is_same(column, other)) => {
                report.error(at, format!("column `{name}` appears twice"));
            }
            Some(_) => {}
        }
        columns.push(column);
    }
    missing(at, &columns, report);
    columns
}

fn unknown(name: &str, known: &[(String, Column)]) -> String {
    match nearest(name, known.iter().map(|(known, _)| known.as_str())) {
        Some(near) => format!("unknown column `{name}`; is it `{near}`?"),
        None => format!("unknown column `{name}`; they are `time_s`, `joint_1_deg`, `joint_1_rad` and the like"),
    }
}

/// Whether two columns have the same meaning, in any units.
fn is_same(one: &Column, other: &Column) -> bool {
    match (one, other) {
        (Column::Of(kind, joint, _), Column::Of(other, another, _)) => (kind, joint) == (other, another),
        _ => one == other,
    }
}

/// Reports the required columns that are missing.
fn missing(at: usize, columns: &[Option<(String, Column)>], report: &mut Report<'_>) {
    let has = |wanted: Column| columns.iter().flatten().any(|(_, column)| is_same(column, &wanted));
    if !has(Column::Time) {
        report.error(at, format!("there is no column `{}`", Column::TIME));
    }
    let lacks = |kind: Kind| (0..6).filter(move |joint| !has(Column::Of(kind, *joint, Unit::Degrees)));
    for kind in Kind::ALL {
        let later = Kind::ALL.into_iter().skip(kind as usize);
        let is_wanted = kind == Kind::Position || later.into_iter().any(|kind| lacks(kind).count() < 6);
        for joint in lacks(kind).filter(|_| is_wanted) {
            let [degrees, radians] = Unit::BOTH.map(|unit| kind.column(joint + 1, unit));
            report.error(at, format!("there is no column `{degrees}` or `{radians}`"));
        }
    }
}

/// Returns the content of a line; `None` if it has too many or too few fields.
fn row(at: usize, line: &str, columns: &[Option<(String, Column)>], report: &mut Report<'_>) -> Option<Row> {
    let count = fields((at, line)).count();
    if count != columns.len() {
        report.error(at, format!("found {count} fields, expected {}, as many as columns", columns.len()));
        return None;
    }
    let (mut row, mut counts) = (Row::default(), [0; 3]);
    for ((at, field), (name, column)) in
        fields((at, line)).zip(columns).filter_map(|(field, column)| Some((field, column.as_ref()?)))
    {
        let Some(number) = number(field) else {
            report.found(at, name, field, "a finite number");
            continue;
        };
        match *column {
            Column::Time => row.time = Some((number, at)),
            Column::Of(kind, joint, unit) => {
                row.angles(kind).get_or_insert_default()[joint] = unit.to_degrees(number);
                counts[kind as usize] += 1;
            }
        }
    }
    for (angles, count) in row.angles.iter_mut().zip(counts) {
        *angles = angles.filter(|_| count == 6);
    }
    Some(row)
}
