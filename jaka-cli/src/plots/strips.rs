//! Strips with one time axis, one below the other.

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::canvas::{
    Area, COLUMNS, Chart, Drawn, FINE, INK, LEFT, Label, Picture, RIGHT, WIDTH, anchored, label, mesh, picture, px,
};
use super::series::{Point, Series};

/// Height of the time axis, in pixels.
const AXIS: u32 = 26;
/// Greatest number of times on the axis.
pub(super) const TIMES: usize = 10;
/// Distance between the numbers of an axis, in pixels.
const NUMBER: u32 = 12;

/// Strip with a quantity over time.
#[derive(Debug)]
pub(crate) struct Strip {
    pub(crate) title: String,
    pub(crate) trace: Trace,
}

/// Form in which a strip shows a quantity.
#[derive(Debug)]
pub(crate) enum Trace {
    /// Number that changes steadily.
    Curve(Series),
    /// Number that is constant until it changes.
    Steps(Series),
    /// Quantity that is on or off.
    Level(Series),
    /// Marked times.
    Marks(Vec<f64>),
}

impl Trace {
    /// Returns the height in pixels, and the greatest number of numbers on the axis, so that they do not touch.
    fn size(&self) -> (u32, usize) {
        match self {
            Self::Curve(_) => (72, 4),
            Self::Steps(_) => (48, 2),
            Self::Level(_) | Self::Marks(_) => (20, 0),
        }
    }

    /// Returns the range of the strip's axis: at least one unit, so that a constant quantity looks constant.
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
    let height: u32 = strips.iter().map(|strip| strip.trace.size().0).sum();
    picture((WIDTH, height + AXIS), |page| {
        let mut rest = page.clone();
        for (at, strip) in strips.iter().enumerate() {
            let axis = if at + 1 == strips.len() { AXIS } else { 0 };
            let (area, below) = rest.split_vertically(px(strip.trace.size().0 + axis));
            draw(&area, strip, end, axis)?;
            rest = below;
        }
        Ok(())
    })
}

fn draw(area: &Area<'_>, strip: &Strip, end: f64, axis: u32) -> Drawn {
    let ((low, high), (height, numbers)) = (strip.trace.range(), strip.trace.size());
    // Space between the number at an end of the axis and that of the next strip.
    let gap = if numbers == 0 { 1 } else { NUMBER / 2 };
    let mut chart = chart(area, end, (low, high), [gap, axis])?;
    let labels: [Label<'_>; 2] = [&|time| label(*time, end), &|value| label(*value, high - low)];
    mesh(&mut chart, [TIMES, numbers], labels, None)?;
    for curve in strip.trace.curves(end) {
        line(&mut chart, curve)?;
    }
    title(area, &strip.title, height)
}

/// Returns a chart with its time axis aligned to all others, with the free heights above and below it, and the height
/// of the axis.
pub(super) fn chart<'a, 'b>(
    area: &'a Area<'b>,
    end: f64,
    (low, high): (f64, f64),
    [gap, axis]: [u32; 2],
) -> Result<Chart<'a, 'b>, DrawingAreaErrorKind<std::io::Error>> {
    ChartBuilder::on(area)
        .margin_right(px(RIGHT))
        .margin_top(px(gap))
        .margin_bottom(px(gap))
        .x_label_area_size(px(axis))
        .y_label_area_size(px(LEFT))
        .build_cartesian_2d(0.0..end, low..high)
}

fn line(chart: &mut Chart<'_, '_>, points: Vec<Point>) -> Drawn {
    match points.as_slice() {
        // A line of one point would be invisible.
        [point] => chart.draw_series([Circle::new(*point, px(1), INK.filled())]).map(drop),
        _ => chart.draw_series([PathElement::new(points, INK.stroke_width(FINE))]).map(drop),
    }
}

/// Draws the title of a strip of this height, left of its numbers.
pub(super) fn title(area: &Area<'_>, text: &str, height: u32) -> Drawn {
    area.draw(&Text::new(text.to_owned(), (px(2), px(height) / 2), anchored(12, HPos::Left)))
}

/// Returns a curve that is constant until it changes.
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

/// Returns a line with a spike at each time, at most one in a column.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the positions of texts left of the axis, in pixels from the top; titles are elsewhere.
    fn numbers(picture: &str) -> Vec<f64> {
        let attribute = |text: &str, name: &str| {
            let (_, rest) = text.split_once(&format!(" {name}=\"")).expect("it has it");
            rest.split_once('"').and_then(|(number, _)| number.parse::<f64>().ok()).expect("it is a number")
        };
        let texts = picture.split("<text").skip(1).filter_map(|text| text.split_once('>').map(|(text, _)| text));
        let left = |text: &&str| {
            (f64::from(px(20))..f64::from(px(LEFT))).contains(&attribute(text, "x"))
                && text.contains("text-anchor=\"end\"")
        };
        texts.filter(left).map(|text| attribute(text, "y") / f64::from(FINE)).collect()
    }

    fn strip(low: f64, high: f64, trace: fn(Series) -> Trace) -> Strip {
        let mut series = Series::default();
        for (time, value) in [(0.0, low), (5.0, high), (10.0, low)] {
            series.push(time, Some(value));
        }
        Strip { title: "joint 1 (deg/s)".to_owned(), trace: trace(series) }
    }

    #[test]
    fn numbers_do_not_touch_each_other() {
        let mut all: Vec<_> = (0..60)
            .flat_map(|at| {
                [strip(-f64::from(at), f64::from(at * at) / 7.0, Trace::Curve), strip(0.0, f64::from(at), Trace::Steps)]
            })
            .collect();
        all.extend([strip(-5.0, 5.0, Trace::Curve), strip(-10.0, 10.0, Trace::Curve), strip(-5.0, 5.0, Trace::Curve)]);
        let mut places = numbers(&strips(10.0, &all).expect("it can be drawn"));
        assert!(places.len() > 2 * all.len(), "{}", places.len());
        places.sort_by(f64::total_cmp);
        let nearest = places.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::MAX, f64::min);
        assert!(nearest >= 11.0, "{nearest} px of 11 px");
    }
}
