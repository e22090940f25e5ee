//! Strings and keys as JSON text.

use std::fmt::Write;

/// Writes a string with the wire's escapes, which has the short ones for line ends and tabs only.
pub(crate) fn push_string(out: &mut String, text: &str) {
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

/// A key with its quotes and colon.
pub(crate) fn key(wire: &str) -> String {
    let mut key = String::with_capacity(wire.len() + 3);
    push_string(&mut key, wire);
    key.push(':');
    key
}
