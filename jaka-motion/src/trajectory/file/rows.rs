//! The points of a file, one by one.

use super::columns::{Column, Kind};
use crate::text_file::Report;
use crate::trajectory::timed::TimedPoint;

/// What a row or an object says, as far as it could be read.
#[derive(Debug, Clone, Default)]
pub(super) struct Row {
    /// The time and its place.
    pub(super) time: Option<(f64, usize)>,
    /// Positions, velocities and accelerations, by [`Kind`], in degrees.
    pub(super) angles: [Option<[f64; 6]>; 3],
}

/// The points so far.
#[derive(Debug, Default)]
pub(super) struct Rows {
    points: Vec<TimedPoint>,
    last_s: Option<f64>,
}

impl Row {
    pub(super) fn angles(&mut self, kind: Kind) -> &mut Option<[f64; 6]> {
        &mut self.angles[kind as usize]
    }
}

impl Rows {
    /// Adds a row, whose time comes after that of the one before.
    pub(super) fn add(&mut self, row: &Row, report: &mut Report<'_>) {
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

    pub(super) fn finish(self) -> Vec<TimedPoint> {
        self.points
    }
}
