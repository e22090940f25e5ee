//! Common parts of all pictures.

use std::io;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::failure::Failure;
use crate::plots::chart;
pub(super) use crate::plots::chart::{Chart, Drawn, FINE};

/// Width of a picture over time, in pixels.
pub(super) const WIDTH: u32 = 1000;
/// Widths of the margins to the left and to the right of the time axis, in pixels.
pub(super) const LEFT: u32 = 210;
pub(super) const RIGHT: u32 = 14;
/// Number of pixel columns of the time axis, which limits the drawn points of a series.
pub(super) const COLUMNS: u32 = WIDTH - LEFT - RIGHT;

pub(super) const INK: RGBColor = RGBColor(0, 0, 0);
pub(super) const FRAME: RGBColor = RGBColor(110, 110, 110);
const MESH: RGBColor = RGBColor(222, 222, 222);

/// Picture as SVG, or its failure.
pub(super) type Picture = Result<String, Failure>;
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Draws a picture of this width and height in pixels. The page sets its displayed size.
pub(super) fn picture(size: (u32, u32), draw: impl FnOnce(&Area<'_>) -> Drawn) -> Picture {
    let drawn = chart::page(size, draw).map_err(|error| io::Error::other(error.to_string()));
    let text = drawn.map_err(|error| Failure::local("a picture cannot be drawn", error))?;
    // A page does not need the namespace.
    let sized = format!("<svg width=\"{}\" height=\"{}\"", size.0, size.1);
    Ok(text.replacen(&sized, "<svg", 1).replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1))
}

/// Converts pixels to whole units.
#[allow(clippy::cast_possible_wrap, reason = "pictures are small")]
pub(super) fn px(pixels: u32) -> i32 {
    (FINE * pixels) as i32
}

/// Returns a font of this size in pixels.
fn font(size: u32) -> TextStyle<'static> {
    // The backend reduces the size by this factor.
    ("sans-serif", f64::from(FINE * size) * 1.24).into_font().color(&INK)
}

/// Returns a font of this size in pixels, with the side at which a text begins.
pub(super) fn anchored(size: u32, anchor: HPos) -> TextStyle<'static> {
    font(size).pos(Pos::new(anchor, VPos::Center))
}

/// Formats a number as a label of an axis of this length.
pub(super) fn label(number: f64, length: f64) -> String {
    let decimals = match length {
        _ if length < 0.1 => 3,
        _ if length < 1.0 => 2,
        _ if length < 10.0 => 1,
        _ => 0,
    };
    crate::text::number::fixed(number, decimals)
}

/// Formatter for the numbers of an axis.
pub(super) type Label<'a> = &'a dyn Fn(&f64) -> String;

/// Draws lines at the numbers of both axes, up to these counts, with their labels and descriptions.
pub(super) fn mesh(
    chart: &mut Chart<'_, '_>,
    most: [usize; 2],
    [x, y]: [Label<'_>; 2],
    show: Option<[&str; 2]>,
) -> Drawn {
    let mut mesh = chart.configure_mesh();
    mesh.bold_line_style(MESH.stroke_width(FINE / 2))
        .light_line_style(TRANSPARENT)
        .axis_style(FRAME.stroke_width(FINE / 2))
        .set_all_tick_mark_size(px(3))
        .x_labels(most[0])
        .y_labels(most[1])
        .x_label_formatter(x)
        .y_label_formatter(y)
        .label_style(font(11))
        .axis_desc_style(font(12));
    if let Some([right, up]) = show {
        mesh.x_desc(right).y_desc(up);
    }
    mesh.draw()
}
