//! Numbers and strings as the wire has them.

use std::fmt::Write;

use serde_json::Number;

/// The shortest text that reads back as the same number; whole numbers without a fraction.
pub(super) fn float(float: f64) -> String {
    let text = Number::from_f64(float).map(|number| number.to_string()).unwrap_or_default();
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

/// Writes a string with the wire's escapes, which has the short ones for line ends and tabs only.
pub(super) fn push_string(out: &mut String, text: &str) {
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            '\0'..' ' => {
                // A string takes all that is written.
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            _ => out.push(c),
        }
    }
    out.push('"');
}
