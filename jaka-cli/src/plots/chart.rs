//! Common parts of charts of quantities over time. `benches` draws the picture of `docs/streams.md` with it, too.

use std::io;

use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

pub(crate) type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;
pub(crate) type Drawn = Result<(), DrawingAreaErrorKind<io::Error>>;

/// Units in a pixel of a page. The backend writes whole units: they are small, so that curves are smooth.
pub(crate) const FINE: u32 = 6;
const FONT: (&str, u32) = ("sans-serif", 93);
pub(crate) const TEXT: RGBColor = RGBColor(30, 30, 30);
const MESH: RGBColor = RGBColor(225, 225, 225);

/// Draws a page of this many pixels, as SVG. Equal calls give the same text.
pub(crate) fn page(
    (width, height): (u32, u32),
    draw: impl FnOnce(&DrawingArea<SVGBackend<'_>, plotters::coord::Shift>) -> Drawn,
) -> Result<String, DrawingAreaErrorKind<io::Error>> {
    let mut text = String::new();
    let fine = (FINE * width, FINE * height);
    {
        let page = SVGBackend::with_string(&mut text, fine).into_drawing_area();
        page.fill(&WHITE)?;
        draw(&page)?;
        page.present()?;
    }
    let sized = |(width, height)| format!("width=\"{width}\" height=\"{height}\"");
    Ok(text.replacen(&sized(fine), &sized((width, height)), 1))
}

/// Draws the axes of a chart, with a description at the left, the unit of the x axis at its numbers, and these numbers
/// of decimals.
pub(crate) fn axes(chart: &mut Chart, shows: &str, unit: &str, [x, y]: [usize; 2]) -> Drawn {
    chart
        .configure_mesh()
        .disable_x_mesh()
        .bold_line_style(MESH.stroke_width(3))
        .light_line_style(TRANSPARENT)
        .axis_style(TEXT.stroke_width(3))
        .set_all_tick_mark_size(15)
        .x_labels(8)
        .y_labels(8)
        .x_label_formatter(&|value| format!("{value:.x$} {unit}"))
        .y_label_formatter(&|value| format!("{value:.y$}"))
        .y_desc(shows)
        .label_style(FONT.with_color(TEXT))
        .axis_desc_style(FONT.with_color(TEXT))
        .draw()
}

pub(crate) fn line(chart: &mut Chart, points: Vec<(f64, f64)>, color: RGBColor, width: u32) -> Drawn {
    chart.draw_series([PathElement::new(points, color.stroke_width(width))]).map(drop)
}

pub(crate) fn text(chart: &mut Chart, text: &str, at: (f64, f64), side: HPos, color: RGBColor) -> Drawn {
    let style = FONT.with_color(color).into_text_style(&(1, 1)).pos(Pos::new(side, VPos::Center));
    chart.draw_series([Text::new(text.to_owned(), at, style)]).map(drop)
}
