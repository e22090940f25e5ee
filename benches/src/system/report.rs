//! Output of a benchmark.

use std::fmt::Display;

use super::figures::Contender;

/// Prints a title and a description of the run.
pub fn title(title: &str, run: impl Display) {
    println!("\n{title}\n  {run}");
}

/// Prints the percentiles of each contender in microseconds.
pub fn percentiles(contenders: &[Contender<'_>]) {
    println!("  {:<34} {:>9} {:>9} {:>9} {:>9} {:>9}   us", "", "p50", "p90", "p99", "p99.9", "maximum");
    for Contender { name, samples, .. } in contenders {
        let [p50, p90, p99, p999, max] = [0.5, 0.9, 0.99, 0.999, 1.0].map(|share| samples.percentile(share));
        println!("  {name:<34} {p50:>9.2} {p90:>9.2} {p99:>9.2} {p999:>9.2} {max:>9.2}");
    }
}

/// Prints a figure, the most that it is to be, and whether it is.
pub fn verdict(what: &str, figure: f64, at_most: f64) {
    let met = if figure <= at_most { "met" } else { "MISSED" };
    println!("  {what:<50} {figure:>9.3}   target at most {at_most}: {met}");
}

/// Prints a figure without a target.
pub fn figure(what: &str, figure: f64) {
    println!("  {what:<50} {figure:>9.3}");
}
