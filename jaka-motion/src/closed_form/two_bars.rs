//! Upper arm and forearm.

use std::f64::consts::PI;

use super::Precision;

/// Two bars in a plane, joined end to end: the angles at the first joint and between the bars that bring the end to
/// `x, y`, two ways.
///
/// An error is by how many mm the end is too far away or too near, where that is more than the slack.
pub(super) fn two_bars(bars: [f64; 2], x: f64, y: f64, precision: Precision) -> Result<[(f64, f64); 2], f64> {
    let ([first, second], distance) = (bars, x.hypot(y));
    let short = (distance - (first + second)).max((first - second).abs() - distance);
    if short > precision.slack_mm() {
        return Err(short);
    }
    let cos = (x * x + y * y - first * first - second * second) / (2.0 * first * second);
    let bend = cos.clamp(-1.0, 1.0).acos().clamp(precision.apart(), PI - precision.apart());
    Ok([bend, -bend].map(|bend| (y.atan2(x) - (second * bend.sin()).atan2(first + second * bend.cos()), bend)))
}
