//! Requests over time, with their reply times.

use itertools::Itertools as _;
use plotters::prelude::*;

use super::canvas::{Area, COLUMNS, Chart, Drawn, FINE, INK, Picture, WIDTH, label, mesh, picture, px};
use super::strips::{TIMES, chart, title};

/// Height of the strip and of its axis, in pixels.
const HEIGHT: u32 = 190;
const AXIS: u32 = 26;
/// Limits of the reply times: the axis needs an end.
const LIMITS_MS: (f64, f64) = (0.01, 1e6);

/// Outcome of a request.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Latency {
    /// Accepted after this many milliseconds.
    Accepted(f64),
    /// Refused after this many milliseconds.
    Refused(f64),
    /// Not answered.
    Unanswered,
}

/// Draws requests at their send times, in seconds; of each kind only the slowest in a column.
pub(crate) fn calls(end: f64, requests: &[(f64, Latency)]) -> Picture {
    picture((WIDTH, HEIGHT + AXIS), |area| draw(area, end, requests))
}

fn draw(area: &Area<'_>, end: f64, requests: &[(f64, Latency)]) -> Drawn {
    let times = requests.iter().filter_map(|(_, latency)| power(*latency));
    let (low, high) = times.fold((0.0_f64, 1.0_f64), |(low, high), power| (low.min(power), high.max(power)));
    let (low, high) = (low.floor(), high.ceil() + 0.5);
    let mut chart = chart(area, end, (low, high), [1, AXIS])?;
    mesh(&mut chart, [TIMES, 9], [&|time| label(*time, end), &|power| powers(*power)], None)?;
    let kinds: [fn(&Latency) -> bool; 3] = [
        |latency| matches!(latency, Latency::Accepted(_)),
        |latency| matches!(latency, Latency::Refused(_)),
        |latency| matches!(latency, Latency::Unanswered),
    ];
    for is_kind in kinds {
        let of_kind = requests.iter().filter(|(time, latency)| *time <= end && is_kind(latency));
        marks(&mut chart, slowest(of_kind, end), high)?;
    }
    title(area, "reply after (ms)", HEIGHT)
}

/// Returns the height of a request in the plot: the decimal logarithm of its reply time in milliseconds; `None` without
/// a reply.
fn power(latency: Latency) -> Option<f64> {
    match latency {
        Latency::Accepted(ms) | Latency::Refused(ms) => Some(ms.clamp(LIMITS_MS.0, LIMITS_MS.1).log10()),
        Latency::Unanswered => None,
    }
}

/// Formats the milliseconds of a whole power of ten.
fn powers(power: f64) -> String {
    if (power - power.round()).abs() > 0.01 {
        return String::new();
    }
    let decimals = if power < -1.5 { 2 } else { usize::from(power < -0.5) };
    format!("{:.decimals$}", 10_f64.powf(power.round()))
}

/// Returns the slowest request in each column.
fn slowest<'r>(requests: impl Iterator<Item = &'r (f64, Latency)>, end: f64) -> Vec<(f64, Latency)> {
    let column = |time: f64| (time / end * f64::from(COLUMNS)).floor();
    let slower = requests.copied().coalesce(|last, next| match column(last.0) >= column(next.0) {
        true if power(next.1) > power(last.1) => Ok(next),
        true => Ok(last),
        false => Err((last, next)),
    });
    slower.collect()
}

fn marks(chart: &mut Chart<'_, '_>, requests: Vec<(f64, Latency)>, top: f64) -> Drawn {
    for (time, latency) in requests {
        let at = (time, power(latency).unwrap_or(top - 0.25));
        match latency {
            Latency::Accepted(_) => chart.draw_series([Circle::new(at, px(3) / 2, INK.filled())])?,
            Latency::Refused(_) => chart.draw_series([TriangleMarker::new(at, px(5), INK.filled())])?,
            Latency::Unanswered => chart.draw_series([Cross::new(at, px(4), INK.stroke_width(FINE * 3 / 2))])?,
        };
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_milliseconds() {
        assert_eq!([-2.0, -1.0, 0.0, 2.0, 0.5].map(powers), ["0.01", "0.1", "1", "100", ""]);
    }

    #[test]
    fn the_slowest_of_a_column_stays() {
        let requests: Vec<_> =
            (0..5000).map(|at| (f64::from(at) / 10.0, Latency::Accepted(f64::from(at % 100)))).collect();
        let drawn = slowest(requests.iter(), 1e4);
        assert!(drawn.len() < 50);
        assert!(drawn.iter().all(|(_, latency)| matches!(latency, Latency::Accepted(ms) if *ms > 98.0)));
    }
}
