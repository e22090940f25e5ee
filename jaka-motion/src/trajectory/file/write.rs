//! Points as text, with as many digits as tell each number from all others.

use std::fmt::Write;

use super::columns::{Column, Kind, Unit};
use crate::trajectory::timed::TimedPoint;

pub(super) fn csv(points: &[TimedPoint]) -> String {
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

pub(super) fn json(points: &[TimedPoint]) -> String {
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

/// How many kinds all points have.
fn kinds(points: &[TimedPoint]) -> usize {
    points.iter().map(|point| angles(point).count()).min().unwrap_or(1)
}

/// What a point has: accelerations only with velocities.
fn angles(point: &TimedPoint) -> impl Iterator<Item = (Kind, [f64; 6])> {
    let all = [Some(point.joints.0), point.velocity, point.velocity.and(point.acceleration)];
    Kind::ALL.into_iter().zip(all).filter_map(|(kind, angles)| Some((kind, angles?)))
}
