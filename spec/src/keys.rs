//! Keys that messages have in addition to their fields, and strings and keys as JSON text.

use std::fmt::Write;

/// The key under which messages name their command.
pub const COMMAND_NAME: &str = "cmdName";
/// The key of the code with which a reply says whether its command was accepted.
pub const ERROR_CODE: &str = "errorCode";
/// The key of the message that explains a refusal.
pub const ERROR_MESSAGE: &str = "errorMsg";
/// The three keys that every reply has.
pub const ENVELOPE: &[&str] = &[COMMAND_NAME, ERROR_CODE, ERROR_MESSAGE];

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
