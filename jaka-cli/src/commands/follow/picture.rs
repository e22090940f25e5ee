//! Picture of a trajectory: positions, speeds and accelerations of the joints, and the path of the tool centre point.

use std::array;
use std::io;
use std::ops::Range;

use itertools::Itertools as _;
use jaka_motion::{Checker, Sample, Trajectory};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::report::{SLOW_PLACES, tool_at};
use crate::plots::chart;
use crate::plots::chart::{Drawn, TEXT};
use crate::plots::{ViewAxes, draw_way};

/// Width and height in pixels: three panels over time, and below them two views of the tool's path.
const SIZE: (u32, u32) = (900, 3 * PANEL + VIEWS);
const PANEL: u32 = 260;
const VIEWS: u32 = 430;

/// Colours of joints 1 to 6. Their names at the ends of the curves distinguish them without colours.
const COLORS: [RGBColor; 6] = [
    RGBColor(20, 50, 130),
    RGBColor(245, 130, 30),
    RGBColor(40, 130, 60),
    RGBColor(190, 30, 30),
    RGBColor(120, 70, 160),
    RGBColor(20, 150, 170),
];
const WIDTH: u32 = 9;
/// Colour of the points at which the tool is slowest, relative to the requested speed.
const SLOW: RGBColor = RGBColor(110, 110, 110);
/// Margins around a chart, in the units of the page.
const MARGIN: u32 = 48;
const RIGHT: u32 = 120;
const LEFT: u32 = 420;
const BELOW: u32 = 150;
/// Number of drawn samples, limited to the visible resolution.
const SAMPLES: u32 = 1000;
/// Label of the horizontal axis of the tool's path, which explains the marks at the path's ends.
const ALONG: &str = "x in mm; a circle at the start, a square at the end";

/// Draws the picture, as SVG.
pub(super) fn svg(trajectory: &Trajectory, checker: &Checker) -> io::Result<String> {
    let time_s = |number: u32| trajectory.duration_s() * f64::from(number) / f64::from(SAMPLES);
    let samples: Vec<_> = (0..=SAMPLES).map(time_s).map(|time_s| (time_s, trajectory.at(time_s))).collect();
    let curves = |of: fn(&Sample) -> [f64; 6]| -> [Vec<(f64, f64)>; 6] {
        array::from_fn(|joint| samples.iter().map(|(time_s, sample)| (*time_s, of(sample)[joint])).collect())
    };
    let quantities = [
        ("position in deg", curves(|sample| sample.joints.0)),
        ("speed in deg/s", curves(|sample| sample.velocity)),
        ("acceleration in deg/s²", curves(|sample| sample.acceleration)),
    ];
    let tool: Vec<_> = samples.iter().map(|(_, sample)| tool_at(sample, checker)).collect();
    let drawn = chart::page(SIZE, |page| {
        let (panels, views) = page.split_vertically(chart::FINE * 3 * PANEL);
        for (panel, (shows, curves)) in panels.split_evenly((3, 1)).iter().zip(&quantities) {
            draw_panel(panel, trajectory, shows, curves)?;
        }
        for (area, (up, axis)) in views.split_evenly((1, 2)).iter().zip([("y in mm", 1), ("z in mm", 2)]) {
            let way = tool.iter().map(|place| (place[0], place[axis])).collect();
            draw_way(area, ViewAxes { right: ALONG, up }, &[way])?;
        }
        Ok(())
    });
    drawn.map_err(|error| io::Error::other(error.to_string()))
}

/// Draws a curve for each joint over time, with a legend above, and lines at the slowest points.
fn draw_panel(
    panel: &DrawingArea<SVGBackend<'_>, Shift>,
    trajectory: &Trajectory,
    shows: &str,
    curves: &[Vec<(f64, f64)>; 6],
) -> Drawn {
    let duration_s = trajectory.duration_s();
    let values = widened(curves.iter().flatten().map(|(_, value)| *value), 0.08);
    let top = values.end + 0.12 * (values.end - values.start);
    let seconds = duration_s.max(1e-3);
    let mut chart = ChartBuilder::on(panel)
        .margin(MARGIN)
        .margin_right(RIGHT)
        .x_label_area_size(BELOW)
        .y_label_area_size(LEFT)
        .build_cartesian_2d(0.0..seconds, values.start..top)?;
    chart::axes(&mut chart, shows, "s", [decimals(seconds), decimals(values.end - values.start)])?;
    for place in trajectory.slow_places().iter().take(SLOW_PLACES) {
        let text = format!("slow: {:.0} %", 100.0 * place.share);
        chart::line(&mut chart, vec![(place.time_s, values.start), (place.time_s, values.end)], SLOW, WIDTH / 3)?;
        chart::text(&mut chart, &text, (place.time_s, values.start), HPos::Left, SLOW)?;
    }
    for (number, (curve, color)) in (1_u32..).zip(curves.iter().zip(COLORS)) {
        chart::line(&mut chart, curve.clone(), color, WIDTH)?;
        let at = seconds * (f64::from(number) - 1.0) / 6.0;
        let level = top - 0.06 * (top - values.start);
        chart::line(&mut chart, vec![(at, level), (at + seconds * 0.03, level)], color, WIDTH)?;
        chart::text(&mut chart, &format!("joint {number}"), (at + seconds * 0.035, level), HPos::Left, TEXT)?;
    }
    Ok(())
}

/// Returns the number of decimals that distinguishes the numbers of an axis.
fn decimals(span: f64) -> usize {
    match span {
        16.0.. => 0,
        1.6.. => 1,
        _ => 2,
    }
}

/// Returns the range of values, slightly widened, and never empty.
fn widened(values: impl Iterator<Item = f64>, by: f64) -> Range<f64> {
    let (least, most) = values.minmax().into_option().unwrap_or_default();
    let more = (by * (most - least)).max(0.5);
    least - more..most + more
}
