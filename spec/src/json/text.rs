//! Numbers and strings as the wire has them.

use serde_json::Number;

pub(super) use crate::quote::push_string;

/// The shortest text that reads back as the same number; whole numbers without a fraction.
pub(super) fn float(float: f64) -> String {
    let text = Number::from_f64(float).map(|number| number.to_string()).unwrap_or_default();
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}
