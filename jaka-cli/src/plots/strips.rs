//! Strips with one time axis, one below the other.

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::canvas::{
    Area, COLUMNS, Chart, Drawn, FINE, FRAME, INK, LEFT, MESH, Picture, RIGHT, WIDTH, anchored, font, label, picture,
    px,
};
use super::series::{Point, Series};

/// The time axis, in pixels.
const AXIS: u32 = 26;

/// A strip: what a quantity does over time.
#[derive(Debug)]
pub(crate) struct Strip {
    pub(crate) title: String,
    pub(crate) trace: Trace,
}

/// How a strip shows what it shows.
#[derive(Debug)]
pub(crate) enum Trace {
    /// A number that changes steadily.
    Curve(Series),
    /// A number that stays as it is until it changes.
    Steps(Series),
    /// What is on or off.
    Level(Series),
    /// Moments.
    Marks(Vec<f64>),
}

impl Trace {
    /// In pixels.
    fn height(&self) -> u32 {
        match self {
            Self::Curve(_) => 64,
            Self::Steps(_) => 44,
            Self::Level(_) | Self::Marks(_) => 20,
        }
    }

    /// What the strip reaches from and to: a unit at least, so that what is still looks so.
    fn range(&self) -> (f64, f64) {
        match self {
            Self::Curve(series) | Self::Steps(series) => {
                let (low, high) = series.range().unwrap_or_default();
                let (middle, half) = (f64::midpoint(low, high), ((high - low) / 2.0).max(0.5) * 1.1);
                (middle - half, middle + half)
            }
            Self::Level(_) | Self::Marks(_) => (-0.2, 1.2),
        }
    }

    fn curves(&self, end: f64) -> Vec<Vec<Point>> {
        match self {
            Self::Curve(series) => series.curves(end, COLUMNS),
            Self::Steps(series) | Self::Level(series) => {
                series.curves(end, COLUMNS).iter().map(|curve| cornered(curve)).collect()
            }
            Self::Marks(moments) => vec![spikes(moments, end)],
        }
    }
}

/// Draws strips over the time from 0 to `end`, in seconds.
pub(crate) fn strips(end: f64, strips: &[Strip]) -> Picture {
    let height: u32 = strips.iter().map(|strip| strip.trace.height()).sum();
    picture((WIDTH, height + AXIS), |page| {
        let mut rest = page.clone();
        for (at, strip) in strips.iter().enumerate() {
            let axis = if at + 1 == strips.len() { AXIS } else { 0 };
            let (area, below) = rest.split_vertically(px(strip.trace.height() + axis));
            draw(&area, strip, end, axis)?;
            rest = below;
        }
        Ok(())
    })
}

fn draw(area: &Area<'_>, strip: &Strip, end: f64, axis: u32) -> Drawn {
    let (low, high) = strip.trace.range();
    let mut chart = chart(area, end, (low, high), axis)?;
    let numbers = if matches!(strip.trace, Trace::Level(_) | Trace::Marks(_)) { 0 } else { 4 };
    mesh(&mut chart, end, numbers, &|value| label(*value, high - low))?;
    for curve in strip.trace.curves(end) {
        line(&mut chart, curve)?;
    }
    title(area, &strip.title, strip.trace.height())
}

/// A chart whose time axis is where that of all others is.
pub(super) fn chart<'a, 'b>(
    area: &'a Area<'b>,
    end: f64,
    (low, high): (f64, f64),
    axis: u32,
) -> Result<Chart<'a, 'b>, DrawingAreaErrorKind<std::io::Error>> {
    ChartBuilder::on(area)
        .margin_right(px(RIGHT))
        .margin_top(px(1))
        .x_label_area_size(px(axis))
        .y_label_area_size(px(LEFT))
        .build_cartesian_2d(0.0..end, low..high)
}

/// Lines at times and numbers, which are not too many for the strip's height, and the axes' labels.
pub(super) fn mesh(chart: &mut Chart<'_, '_>, end: f64, numbers: usize, number: &dyn Fn(&f64) -> String) -> Drawn {
    chart
        .configure_mesh()
        .bold_line_style(MESH.stroke_width(FINE / 2))
        .light_line_style(TRANSPARENT)
        .axis_style(FRAME.stroke_width(FINE / 2))
        .set_all_tick_mark_size(px(3))
        .x_labels(10)
        .y_labels(numbers)
        .x_label_formatter(&|seconds| label(*seconds, end))
        .y_label_formatter(number)
        .label_style(font(11))
        .draw()
}

fn line(chart: &mut Chart<'_, '_>, points: Vec<Point>) -> Drawn {
    match points.as_slice() {
        // A line of one point would not be seen.
        [point] => chart.draw_series([Circle::new(*point, px(1), INK.filled())]).map(drop),
        _ => chart.draw_series([PathElement::new(points, INK.stroke_width(FINE))]).map(drop),
    }
}

/// What a strip of this height shows, left of its numbers.
pub(super) fn title(area: &Area<'_>, text: &str, height: u32) -> Drawn {
    area.draw(&Text::new(text.to_owned(), (px(2), px(height) / 2), anchored(12, HPos::Left)))
}

/// A curve that stays as it is until it changes.
fn cornered(curve: &[Point]) -> Vec<Point> {
    let mut cornered: Vec<Point> = Vec::with_capacity(2 * curve.len());
    for &(time, value) in curve {
        if let Some(&(_, before)) = cornered.last()
            && before.to_bits() != value.to_bits()
        {
            cornered.push((time, before));
        }
        cornered.push((time, value));
    }
    cornered
}

/// A line with a spike at each moment, one in a column at most.
fn spikes(moments: &[f64], end: f64) -> Vec<Point> {
    let mut line = vec![(0.0, 0.0)];
    let mut last = f64::NEG_INFINITY;
    for &time in moments.iter().filter(|time| **time <= end) {
        if time - last >= end / f64::from(COLUMNS) {
            line.extend([(time, 0.0), (time, 1.0), (time, 0.0)]);
            last = time;
        }
    }
    line.push((end, 0.0));
    line
}
