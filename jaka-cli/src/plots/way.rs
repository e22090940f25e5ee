//! Path of a point, viewed from one side.

use std::ops::Range;

use itertools::Itertools as _;
use plotters::prelude::*;

use super::canvas::{Area, Drawn, FINE, INK, Picture, label, mesh, picture, px};
use super::series::Point;

/// Sizes in pixels: the picture, and the space for its labels.
const SIZE: (u32, u32) = (490, 440);
const LABELS: (u32, u32) = (66, 46);
const MARGIN: u32 = 12;
/// Distance between drawn points, in pixels.
const APART: f64 = 0.5;
/// Smallest range of a path, in millimetres, so that an arm at rest looks so.
const LEAST: f64 = 20.0;

/// Names of the axes to the right and upwards, which define the side of the view.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ViewAxes {
    pub(crate) right: &'static str,
    pub(crate) up: &'static str,
}

/// Draws curves in millimetres, with both axes in the same scale. A circle marks the start, a square the end.
pub(crate) fn way(view: ViewAxes, curves: &[Vec<Point>]) -> Picture {
    picture(SIZE, |area| draw_way(area, view, curves))
}

/// Draws the picture of [`way`] on a part of another picture.
pub(crate) fn draw_way(area: &Area<'_>, view: ViewAxes, curves: &[Vec<Point>]) -> Drawn {
    let (width, height) = area.dim_in_pixel();
    let (right, up, scale) = ranges(curves, (width / FINE, height / FINE));
    let length = right.end - right.start;
    let mut chart = ChartBuilder::on(area)
        .margin(px(MARGIN))
        .x_label_area_size(px(LABELS.1))
        .y_label_area_size(px(LABELS.0))
        .build_cartesian_2d(right, up)?;
    let number = |number: &f64| label(*number, length);
    mesh(&mut chart, [6, 8], [&number, &number], Some([view.right, view.up]))?;
    for curve in curves {
        chart.draw_series([PathElement::new(thinned(curve, APART * scale), INK.stroke_width(FINE))])?;
    }
    let first = curves.iter().flatten().next();
    let last = curves.iter().flatten().next_back();
    if let (Some(&first), Some(&(x, y))) = (first, last) {
        let half = 4.0 * scale;
        chart.draw_series([Circle::new(first, px(6), INK.stroke_width(FINE * 2))])?;
        chart.draw_series([Rectangle::new([(x - half, y - half), (x + half, y + half)], INK.filled())])?;
    }
    Ok(())
}

/// Returns the ranges of the axes of a picture of this size in pixels, and the number of millimetres of a pixel.
fn ranges(curves: &[Vec<Point>], size: (u32, u32)) -> (Range<f64>, Range<f64>, f64) {
    let points = || curves.iter().flatten();
    let x = points().map(|point| point.0).minmax().into_option().unwrap_or_default();
    let y = points().map(|point| point.1).minmax().into_option().unwrap_or_default();
    let width = f64::from(size.0 - LABELS.0 - 2 * MARGIN);
    let height = f64::from(size.1 - LABELS.1 - 2 * MARGIN);
    let scale = 1.1 * ((x.1 - x.0).max(LEAST) / width).max((y.1 - y.0).max(LEAST) / height);
    let around = |(low, high), pixels: f64| {
        let middle = f64::midpoint(low, high);
        middle - pixels * scale / 2.0..middle + pixels * scale / 2.0
    };
    (around(x, width), around(y, height), scale)
}

/// Returns the points of a curve that are this far apart, with the first and the last.
fn thinned(curve: &[Point], apart: f64) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    for (at, &(x, y)) in curve.iter().enumerate() {
        let is_far = kept.last().is_none_or(|last| (x - last.0).hypot(y - last.1) >= apart);
        if is_far || at + 1 == curve.len() {
            kept.push((x, y));
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_axes_have_the_same_scale() {
        let (right, up, scale) = ranges(&[vec![(0.0, 0.0), (412.0, 10.0)]], SIZE);
        let pixels = |range: &Range<f64>| (range.end - range.start) / scale;
        assert!((pixels(&right) - 400.0).abs() < 1e-6 && (pixels(&up) - 370.0).abs() < 1e-6);
        assert!(right.contains(&0.0) && right.contains(&412.0) && up.contains(&10.0));
        let (right, ..) = ranges(&[], SIZE);
        assert!(right.contains(&0.0) && right.end > 9.0);
    }

    #[test]
    fn ends_and_corners_stay() {
        let curve = [(0.0, 0.0), (0.1, 0.0), (5.0, 0.0), (5.0, 5.0), (5.1, 5.0)];
        assert_eq!(thinned(&curve, 1.0), [(0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (5.1, 5.0)]);
    }
}
