//! Histogram of counts between bounds.

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::canvas::{Area, Drawn, FINE, FRAME, INK, Picture, WIDTH, anchored, picture, px};

/// Height, in pixels.
const HEIGHT: u32 = 200;
/// Space for the labels below the bars, and for the counts above them, as shares of the tallest bar.
const BELOW: f64 = 0.2;
const ABOVE: f64 = 0.15;

/// Draws a bar of logarithmic height for each count, with its label below it and the count above.
pub(crate) fn histogram(bars: &[(String, usize)]) -> Picture {
    picture((WIDTH, HEIGHT), |area| draw(area, bars))
}

#[allow(clippy::cast_precision_loss, reason = "heights need no digits")]
fn draw(area: &Area<'_>, bars: &[(String, usize)]) -> Drawn {
    let height = |count: usize| if count == 0 { 0.0 } else { 1.0 + (count as f64).log10() };
    let tallest = bars.iter().map(|(_, count)| height(*count)).fold(1.0, f64::max);
    let range = -BELOW * tallest..(1.0 + ABOVE) * tallest;
    let mut chart = ChartBuilder::on(area).margin(px(4)).build_cartesian_2d(0.0..bars.len() as f64, range)?;
    let floor = vec![(0.0, 0.0), (bars.len() as f64, 0.0)];
    chart.draw_series([PathElement::new(floor, INK.stroke_width(FINE))])?;
    for (at, (label, count)) in bars.iter().enumerate() {
        let (left, top) = (at as f64, height(*count));
        let bar = [(left + 0.15, 0.0), (left + 0.85, top)];
        chart.draw_series([Rectangle::new(bar, FRAME.filled())])?;
        for (text, y) in [(label.clone(), -BELOW * tallest / 2.0), (count.to_string(), top + ABOVE * tallest / 2.0)] {
            chart.draw_series([Text::new(text, (left + 0.5, y), anchored(11, HPos::Center))])?;
        }
    }
    Ok(())
}
