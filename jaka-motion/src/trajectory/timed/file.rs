//! Points with times in files: meaning of the numbers, by names with units.

mod csv;
mod json;

pub(super) use self::csv::write as write_csv;
pub(super) use self::json::write as write_json;
use super::TimedPoint;
use crate::text_file::{FileErrors, Report};

/// Quantity of six numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Position,
    Velocity,
    Acceleration,
}

/// Unit of an angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Unit {
    Degrees,
    Radians,
}

/// Meaning of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Column {
    Time,
    Of(Kind, usize, Unit),
}

/// Content of a row or an object, as far as it could be read.
#[derive(Debug, Clone, Default)]
struct Row {
    /// Time and its offset in the text.
    time: Option<(f64, usize)>,
    /// Positions, velocities and accelerations, by [`Kind`], in degrees.
    angles: [Option<[f64; 6]>; 3],
}

/// Points read so far.
#[derive(Debug, Default)]
struct Rows {
    points: Vec<TimedPoint>,
    last_s: Option<f64>,
}

impl Kind {
    const ALL: [Self; 3] = [Self::Position, Self::Velocity, Self::Acceleration];

    /// Returns its name for one joint and for all, and the suffix after the unit of an angle.
    fn names(self) -> [&'static str; 3] {
        match self {
            Self::Position => ["joint", "joints", ""],
            Self::Velocity => ["velocity", "velocity", "_s"],
            Self::Acceleration => ["acceleration", "acceleration", "_s2"],
        }
    }

    /// Returns the name of its column.
    fn column(self, joint: usize, unit: Unit) -> String {
        let [one, _, per_time] = self.names();
        format!("{one}_{joint}_{}{per_time}", unit.name())
    }

    /// Returns the key of its list.
    fn key(self, unit: Unit) -> String {
        let [_, all, per_time] = self.names();
        format!("{all}_{}{per_time}", unit.name())
    }
}

impl Unit {
    const BOTH: [Self; 2] = [Self::Degrees, Self::Radians];

    fn name(self) -> &'static str {
        match self {
            Self::Degrees => "deg",
            Self::Radians => "rad",
        }
    }

    fn to_degrees(self, number: f64) -> f64 {
        match self {
            Self::Degrees => number,
            Self::Radians => number.to_degrees(),
        }
    }
}

impl Column {
    /// Name of the column of times, and their key.
    const TIME: &'static str = "time_s";

    /// Returns all possible columns, by name.
    fn all() -> Vec<(String, Self)> {
        let angles = Kind::ALL.into_iter().flat_map(|kind| {
            let joints = (1..=6).flat_map(|joint| Unit::BOTH.map(|unit| (joint, unit)));
            joints.map(move |(joint, unit)| (kind.column(joint, unit), Self::Of(kind, joint - 1, unit)))
        });
        std::iter::once((Self::TIME.to_owned(), Self::Time)).chain(angles).collect()
    }
}

impl Row {
    fn angles(&mut self, kind: Kind) -> &mut Option<[f64; 6]> {
        &mut self.angles[kind as usize]
    }
}

impl Rows {
    /// Adds a row; reports a time that is not after that of the row before.
    fn add(&mut self, row: &Row, report: &mut Report<'_>) {
        let Some((time_s, at)) = row.time else { return };
        match self.last_s {
            None if time_s != 0.0 => report.found(at, Column::TIME, &time_s.to_string(), "0, at the first point"),
            Some(last_s) if time_s <= last_s => {
                report.found(at, Column::TIME, &time_s.to_string(), &format!("more than the {last_s} before it"));
            }
            _ => {}
        }
        self.last_s = Some(time_s);
        let [Some(joints), velocity, acceleration] = row.angles else { return };
        self.points.push(TimedPoint { time_s, joints: joints.into(), velocity, acceleration });
    }

    fn finish(self) -> Vec<TimedPoint> {
        self.points
    }
}

/// Reads the points of a CSV text: see [`TimedPoint::from_csv`].
pub(super) fn read_csv(text: &str, file_name: &str) -> Result<Vec<TimedPoint>, FileErrors> {
    let mut report = Report::new(text, file_name);
    let points = csv::read(text, &mut report);
    report.finish(points)
}

/// Reads the points of a JSON text: see [`TimedPoint::from_json`].
pub(super) fn read_json(text: &str, file_name: &str) -> Result<Vec<TimedPoint>, FileErrors> {
    let mut report = Report::new(text, file_name);
    let points = json::read(text, &mut report);
    report.finish(points)
}

/// Returns the number of kinds that all points have.
fn kinds(points: &[TimedPoint]) -> usize {
    points.iter().map(|point| angles(point).count()).min().unwrap_or(1)
}

/// Returns the numbers that a point has, by their kinds: accelerations only with velocities.
fn angles(point: &TimedPoint) -> impl Iterator<Item = (Kind, [f64; 6])> {
    let all = [Some(point.joints.0), point.velocity, point.velocity.and(point.acceleration)];
    Kind::ALL.into_iter().zip(all).filter_map(|(kind, angles)| Some((kind, angles?)))
}
