//! The picture of `docs/streams.md`: position, speed and acceleration of set-points as [`Generator`](jaka_motion::Generator) makes them.

mod script;

use std::error::Error;
use std::io;

use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use self::script::{END_S, JOINTS, MOMENTS, Quantity};

/// Width and height, in units of which all lengths here are. The backend writes whole ones: they are small, so that curves are smooth.
const SIZE: (u32, u32) = (FINE * SHOWN.0, FINE * SHOWN.1);
/// Width and height on a page, in pixels.
const SHOWN: (u32, u32) = (800, 840);
const FINE: u32 = 6;
const FONT: (&str, u32) = ("sans-serif", 93);
/// How high a panel is, where 1 is the limit.
const HEIGHT: f64 = 1.35;
/// At which height names stand, between limit and edge.
const NAMES: f64 = 1.17;
const TEXT: RGBColor = RGBColor(30, 30, 30);
const LIMIT: RGBColor = RGBColor(190, 30, 30);
const MOMENT: RGBColor = RGBColor(120, 120, 120);
const MESH: RGBColor = RGBColor(225, 225, 225);
/// Of each joint of the picture; told apart without colours by their widths.
const CURVES: [(RGBColor, u32); 2] = [(RGBColor(245, 150, 50), 22), (RGBColor(20, 50, 130), 9)];

type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;
type Drawn = Result<(), DrawingAreaErrorKind<io::Error>>;

/// The picture, as SVG: a panel for each quantity, with its limit. The same text in each call.
///
/// # Errors
/// The script does not fit the arm, or drawing fails: neither depends on anything outside of this module.
pub fn svg() -> Result<String, Box<dyn Error>> {
    let quantities = script::quantities()?;
    let mut text = String::new();
    draw(&quantities, &mut text)?;
    let sized = |(width, height)| format!("width=\"{width}\" height=\"{height}\"");
    Ok(text.replacen(&sized(SIZE), &sized(SHOWN), 1))
}

fn draw(quantities: &[Quantity; 3], text: &mut String) -> Drawn {
    let page = SVGBackend::with_string(text, SIZE).into_drawing_area();
    page.fill(&WHITE)?;
    for (panel, quantity) in page.split_evenly((3, 1)).iter().zip(quantities) {
        let height = HEIGHT * quantity.limit;
        let mut chart = ChartBuilder::on(panel)
            .margin(48)
            .margin_right(120)
            .x_label_area_size(150)
            .y_label_area_size(360)
            .build_cartesian_2d(0.0..END_S, -height..height)?;
        draw_axes(&mut chart, quantity)?;
        draw_moments(&mut chart, quantity)?;
        draw_limits(&mut chart, quantity)?;
        draw_curves(&mut chart, quantity)?;
    }
    page.present()
}

fn draw_axes(chart: &mut Chart, quantity: &Quantity) -> Drawn {
    chart
        .configure_mesh()
        .disable_x_mesh()
        .bold_line_style(MESH.stroke_width(3))
        .light_line_style(TRANSPARENT)
        .axis_style(TEXT.stroke_width(3))
        .set_all_tick_mark_size(15)
        .x_labels(8)
        .y_labels(8)
        .x_label_formatter(&|seconds| format!("{seconds:.0} s"))
        .y_label_formatter(&|value| format!("{value:.0}"))
        .y_desc(format!("{} in {}", quantity.name, quantity.unit))
        .label_style(FONT.with_color(TEXT))
        .axis_desc_style(FONT.with_color(TEXT))
        .draw()
}

/// A line where the goal changes, and above the limit what to.
fn draw_moments(chart: &mut Chart, quantity: &Quantity) -> Drawn {
    let height = HEIGHT * quantity.limit;
    for moment in &MOMENTS {
        let since = moment.at_s();
        draw_line(chart, vec![(since, -height), (since, height)], MOMENT, 6)?;
        draw_text(chart, moment.name, (since + 0.05, NAMES * quantity.limit), HPos::Left, TEXT)?;
    }
    Ok(())
}

fn draw_limits(chart: &mut Chart, quantity: &Quantity) -> Drawn {
    for limit in [-quantity.limit, quantity.limit] {
        draw_line(chart, vec![(0.0, limit), (END_S, limit)], LIMIT, 6)?;
    }
    let text = format!("limit {:.0} {}", quantity.limit, quantity.unit);
    draw_text(chart, &text, (END_S - 0.05, -NAMES * quantity.limit), HPos::Right, LIMIT)
}

/// The curves, and below the limit which is which.
fn draw_curves(chart: &mut Chart, quantity: &Quantity) -> Drawn {
    let at = -NAMES * quantity.limit;
    let mut since = 1.7;
    for ((joint, curve), (color, width)) in JOINTS.iter().zip(&quantity.curves).zip(CURVES) {
        draw_line(chart, curve.clone(), color, width)?;
        draw_line(chart, vec![(since, at), (since + 0.2, at)], color, width)?;
        draw_text(chart, &format!("joint {joint}"), (since + 0.25, at), HPos::Left, TEXT)?;
        since += 0.9;
    }
    Ok(())
}

fn draw_line(chart: &mut Chart, points: Vec<(f64, f64)>, color: RGBColor, width: u32) -> Drawn {
    chart.draw_series([PathElement::new(points, color.stroke_width(width))]).map(drop)
}

fn draw_text(chart: &mut Chart, text: &str, at: (f64, f64), side: HPos, color: RGBColor) -> Drawn {
    let style = FONT.with_color(color).into_text_style(&(1, 1)).pos(Pos::new(side, VPos::Center));
    chart.draw_series([Text::new(text.to_owned(), at, style)]).map(drop)
}

#[cfg(test)]
mod tests {
    use super::svg;

    #[test]
    fn the_picture_in_the_docs_is_what_its_command_makes() {
        let made = svg().expect("it can be drawn");
        let committed = include_str!("../../docs/streams.svg");
        assert!(made == committed, "cargo run -p jaka-benches --bin stream_picture -- docs/streams.svg");
        assert!(made.len() <= 100_000, "{} bytes", made.len());
    }
}
