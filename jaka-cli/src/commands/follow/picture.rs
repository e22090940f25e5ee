//! A picture of a trajectory: positions, speeds and accelerations of the joints, and the way of the tool centre point.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::course::Course;
use crate::chart::{self, Chart, Drawn, TEXT};

/// Width and height in pixels: three panels over time, and below them two views of the tool's way.
const SIZE: (u32, u32) = (900, 3 * PANEL + VIEWS);
const PANEL: u32 = 260;
const VIEWS: u32 = 430;

/// Of joints 1 to 6; told apart without colours by their names at their ends.
const COLORS: [RGBColor; 6] = [
    RGBColor(20, 50, 130),
    RGBColor(245, 130, 30),
    RGBColor(40, 130, 60),
    RGBColor(190, 30, 30),
    RGBColor(120, 70, 160),
    RGBColor(20, 150, 170),
];
const WIDTH: u32 = 9;
const WAY: RGBColor = COLORS[0];
/// What is around a chart, in the units of the page.
const MARGIN: u32 = 48;
const RIGHT: u32 = 120;
const LEFT: u32 = 420;
const BELOW: u32 = 150;
/// How wide a view of the tool's way is compared with its height, without what is around it.
const WIDE: f64 =
    (chart::FINE * SIZE.0 / 2 - LEFT - MARGIN - RIGHT) as f64 / (chart::FINE * VIEWS - BELOW - 2 * MARGIN) as f64;

/// The picture, as SVG.
pub(super) fn svg(course: &Course) -> Result<String, String> {
    let drawn = chart::page(SIZE, |page| {
        let (panels, views) = page.split_vertically(chart::FINE * 3 * PANEL);
        let quantities = [
            ("position in deg", course.positions()),
            ("speed in deg/s", course.speeds()),
            ("acceleration in deg/s²", course.accelerations()),
        ];
        for (panel, (shows, curves)) in panels.split_evenly((3, 1)).iter().zip(&quantities) {
            draw_panel(panel, course.duration_s(), shows, curves)?;
        }
        for (view, (shows, upward)) in views.split_evenly((1, 2)).iter().zip([("y in mm", 1), ("z in mm", 2)]) {
            draw_view(view, shows, &course.tool_way().map(|place| (place[0], place[upward])).collect::<Vec<_>>())?;
        }
        Ok(())
    });
    drawn.map_err(|error| error.to_string())
}

/// A curve for each joint over time, and above them which is which.
fn draw_panel(
    panel: &DrawingArea<SVGBackend<'_>, Shift>,
    duration_s: f64,
    shows: &str,
    curves: &[Vec<(f64, f64)>; 6],
) -> Drawn {
    let values = widened(curves.iter().flatten().map(|(_, value)| *value), 0.08);
    let top = values.end + 0.12 * (values.end - values.start);
    let seconds = duration_s.max(1e-3);
    let mut chart = chart_on(panel, 0.0..seconds, values.start..top)?;
    chart::axes(&mut chart, shows, "s", [decimals(seconds), decimals(values.end - values.start)])?;
    for (number, (curve, color)) in (1_u32..).zip(curves.iter().zip(COLORS)) {
        chart::line(&mut chart, curve.clone(), color, WIDTH)?;
        let at = seconds * (f64::from(number) - 1.0) / 6.0;
        let level = top - 0.06 * (top - values.start);
        chart::line(&mut chart, vec![(at, level), (at + seconds * 0.03, level)], color, WIDTH)?;
        chart::text(&mut chart, &format!("joint {number}"), (at + seconds * 0.035, level), HPos::Left, TEXT)?;
    }
    Ok(())
}

/// The tool's way from one side, with the same scale in both directions.
fn draw_view(view: &DrawingArea<SVGBackend<'_>, Shift>, shows: &str, way: &[(f64, f64)]) -> Drawn {
    let along = widened(way.iter().map(|(x, _)| *x), 0.1);
    let across = widened(way.iter().map(|(_, y)| *y), 0.1);
    let half = ((along.end - along.start) / WIDE).max(across.end - across.start).max(1.0) / 2.0;
    let middle = |range: &Range<f64>| f64::midpoint(range.start, range.end);
    let (x, y) = (middle(&along), middle(&across));
    let mut chart = chart_on(view, x - WIDE * half..x + WIDE * half, y - half..y + half)?;
    chart::axes(&mut chart, shows, "", [decimals(2.0 * half); 2])?;
    chart::line(&mut chart, way.to_vec(), WAY, WIDTH)?;
    if let (Some(&start), Some(&end)) = (way.first(), way.last()) {
        let apart = (start.0 - end.0).hypot(start.1 - end.1);
        let ends = [(start, "start"), (end, "end")];
        let places = if apart < 0.1 * half { &[(start, "start and end")][..] } else { &ends };
        for &(place, name) in places {
            chart.draw_series([Circle::new(place, 24, WAY.filled())])?;
            // Towards the middle, where there is room.
            let (side, anchor) = if place.0 > x { (-1.0, HPos::Right) } else { (1.0, HPos::Left) };
            chart::text(&mut chart, name, (place.0 + side * 0.04 * half, place.1), anchor, TEXT)?;
        }
    }
    chart::text(&mut chart, "x in mm", (x + 0.95 * WIDE * half, y - 0.95 * half), HPos::Right, TEXT)
}

fn chart_on<'a, 'b>(
    area: &'a DrawingArea<SVGBackend<'b>, Shift>,
    x: Range<f64>,
    y: Range<f64>,
) -> Result<Chart<'a, 'b>, DrawingAreaErrorKind<std::io::Error>> {
    let mut builder = ChartBuilder::on(area);
    builder.margin(MARGIN).margin_right(RIGHT).x_label_area_size(BELOW).y_label_area_size(LEFT).build_cartesian_2d(x, y)
}

/// How many decimals tell the numbers at an axis apart.
fn decimals(span: f64) -> usize {
    match span {
        16.0.. => 0,
        1.6.. => 1,
        _ => 2,
    }
}

/// The range of values, somewhat wider, and never empty.
fn widened(values: impl Iterator<Item = f64>, by: f64) -> Range<f64> {
    let (least, most) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)));
    let more = (by * (most - least)).max(0.5);
    if least <= most { least - more..most + more } else { -1.0..1.0 }
}
