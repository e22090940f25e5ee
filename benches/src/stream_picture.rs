//! The picture of `docs/streams.md`: position, speed and acceleration of set-points as
//! [`Generator`](jaka_motion::Generator) makes them.

mod script;

use std::error::Error;

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use self::script::{END_S, JOINTS, MOMENTS, Quantity};
use crate::chart::{self, Chart, Drawn, TEXT};

/// Width and height on a page, in pixels.
const SHOWN: (u32, u32) = (800, 840);
/// Height of a panel in units of the limit, or of the largest value if it exceeds the limit.
const HEIGHT: f64 = 1.35;
/// Height of the names, between the limit and the edge of the panel, in the same units.
const NAMES: f64 = 1.17;
/// Time for which the whole picture is shown before it begins again.
const PAUSE_S: f64 = 3.0;
const LIMIT: RGBColor = RGBColor(190, 30, 30);
const MOMENT: RGBColor = RGBColor(120, 120, 120);
/// Of each joint of the picture; told apart without colours by their widths.
const CURVES: [(RGBColor, u32); 2] = [(RGBColor(245, 150, 50), 22), (RGBColor(20, 50, 130), 9)];

/// The picture, as SVG: a panel for each quantity, with its limit. The same text in each call.
///
/// # Errors
/// The script does not fit the arm, or drawing fails: neither depends on anything outside of this module.
pub fn svg() -> Result<String, Box<dyn Error>> {
    let quantities = script::quantities()?;
    let drawn = chart::page(SHOWN, |page| {
        for (panel, quantity) in page.split_evenly((3, 1)).iter().zip(&quantities) {
            let height = HEIGHT * quantity.most();
            let mut chart = ChartBuilder::on(panel)
                .margin(48)
                .margin_right(120)
                .x_label_area_size(150)
                .y_label_area_size(360)
                .build_cartesian_2d(0.0..END_S, -height..height)?;
            chart::axes(&mut chart, &format!("{} in {}", quantity.name, quantity.unit), "s", [0, 0])?;
            draw_moments(&mut chart, quantity)?;
            draw_limits(&mut chart, quantity)?;
            draw_curves(&mut chart, quantity)?;
        }
        Ok(())
    });
    Ok(moving(&drawn?))
}

/// Adds a cover to the picture; it withdraws to the right in the time of the set-points.
fn moving(picture: &str) -> String {
    // Of the plots, in the picture's own units.
    let (left, right) = (408, 4680);
    let (width, height) = (right - left, chart::FINE * SHOWN.1);
    let (period_s, last) = (END_S + PAUSE_S, END_S / (END_S + PAUSE_S) * 100.0);
    let cover = format!(
        "<style>.cover{{transform-box:fill-box;transform-origin:right;transform:scaleX(0)}}\
         @media(prefers-reduced-motion:no-preference){{.cover{{animation:{period_s}s linear infinite cover}}}}\
         @keyframes cover{{0%{{transform:scaleX(1)}}{last:.1}%{{transform:scaleX(0)}}}}</style>\n\
         <rect class=\"cover\" x=\"{left}\" y=\"0\" width=\"{width}\" height=\"{height}\" fill=\"#FFFFFF\" opacity=\"0.85\"/>\n</svg>"
    );
    picture.replacen("</svg>", &cover, 1)
}

/// A line where the goal changes, and above the limit what to.
fn draw_moments(chart: &mut Chart, quantity: &Quantity) -> Drawn {
    let height = HEIGHT * quantity.most();
    for moment in &MOMENTS {
        let since = moment.at_s();
        chart::line(chart, vec![(since, -height), (since, height)], MOMENT, 6)?;
        chart::text(chart, moment.name, (since + 0.05, NAMES * quantity.most()), HPos::Left, TEXT)?;
    }
    Ok(())
}

fn draw_limits(chart: &mut Chart, quantity: &Quantity) -> Drawn {
    for limit in [-quantity.limit, quantity.limit] {
        chart::line(chart, vec![(0.0, limit), (END_S, limit)], LIMIT, 6)?;
    }
    let text = format!("limit {:.0} {}", quantity.limit, quantity.unit);
    chart::text(chart, &text, (END_S - 0.05, -NAMES * quantity.most()), HPos::Right, LIMIT)
}

/// The curves, and below the limit which is which.
fn draw_curves(chart: &mut Chart, quantity: &Quantity) -> Drawn {
    let at = -NAMES * quantity.most();
    let mut since = 1.7;
    for ((joint, curve), (color, width)) in JOINTS.iter().zip(&quantity.curves).zip(CURVES) {
        chart::line(chart, curve.clone(), color, width)?;
        chart::line(chart, vec![(since, at), (since + 0.2, at)], color, width)?;
        chart::text(chart, &format!("joint {joint}"), (since + 0.25, at), HPos::Left, TEXT)?;
        since += 0.9;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::svg;

    #[test]
    fn the_picture_in_the_docs_is_what_its_command_makes() {
        let made = svg().expect("it can be drawn");
        let committed = include_str!("../../docs/streams.svg");
        assert!(
            made == committed,
            "cargo run --manifest-path benches/Cargo.toml --bin stream_picture -- docs/streams.svg"
        );
        assert!(made.len() <= 100_000, "{} bytes", made.len());
    }
}
