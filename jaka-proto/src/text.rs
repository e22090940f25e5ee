//! Text from outside, made safe to show.
//!
//! What a controller sends may contain anything: escape sequences that a terminal obeys, characters that reverse the
//! text around them, line ends that forge a line of a log. Fields and raw messages keep such text as it is, since it is
//! data. Code that shows it passes it through here; the errors of this crate do so themselves.
//!
//! ```
//! use jaka_proto::text::{Visible, visible_json};
//!
//! assert_eq!(Visible("\u{1b}[2Jall is well\n").to_string(), r"\u{1b}[2Jall is well\n");
//! assert_eq!(visible_json("{\"a\": \"\u{202e}\"}"), r#"{"a": "\u202e"}"#);
//! ```

use std::borrow::Cow;
use std::fmt::{self, Write};

/// Whether a character is shown as it is: no control character, nothing that directs the text around it without being
/// seen, and no separator of lines or paragraphs. These are the general categories Cc, Cf, Zl and Zp of Unicode.
pub fn is_visible(c: char) -> bool {
    !c.is_control() && !matches!(c, jaka_proto_derive::hidden_characters!())
}

/// Text in one line: displays every character that is not [visible](is_visible) as an escape, such as `\u{1b}` or `\n`.
///
/// Allocates nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Visible<'t>(pub &'t str);

impl fmt::Display for Visible<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        VisibleWriter(f).write_str(self.0)
    }
}

/// Passes on text in one line: see [`Visible`]. For texts with parts of many kinds, such as errors.
#[derive(Debug)]
pub struct VisibleWriter<W>(pub W);

impl<W: Write> Write for VisibleWriter<W> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        escape(&mut self.0, text, is_visible)
    }
}

/// The text in one line: see [`Visible`]. Borrowed where nothing has to be escaped.
pub fn visible(text: &str) -> Cow<'_, str> {
    escaped(text, is_visible)
}

/// Escapes text of several lines as [`visible`] does, but keeps line feeds.
pub fn visible_lines(text: &str) -> Cow<'_, str> {
    escaped(text, |c| is_visible(c) || c == '\n')
}

/// JSON in which every character of a string that is not [visible](is_visible) is escaped as JSON does it, so that it
/// reads the same. White space between its parts stays.
///
/// Also takes text that is not JSON, which stays text that is not JSON, and becomes visible.
pub fn visible_json(text: &str) -> Cow<'_, str> {
    escaped_json(text, |white| white)
}

/// Escapes JSON as [`visible_json`] does, in one line: line ends and tabs between the parts become blanks.
pub fn visible_json_line(text: &str) -> Cow<'_, str> {
    escaped_json(text, |_| ' ')
}

/// The first 60 characters of a text, with `…` in place of the rest.
pub fn excerpt(text: &str) -> String {
    match text.char_indices().nth(60) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

fn escaped(text: &str, stays: impl Fn(char) -> bool) -> Cow<'_, str> {
    if text.chars().all(&stays) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    // A string takes all that is written.
    let _ = escape(&mut out, text, stays);
    Cow::Owned(out)
}

fn escape(out: &mut impl Write, text: &str, stays: impl Fn(char) -> bool) -> fmt::Result {
    let mut rest = text;
    while let Some((at, c)) = rest.char_indices().find(|&(_, c)| !stays(c)) {
        out.write_str(&rest[..at])?;
        match c {
            '\n' => out.write_str("\\n"),
            '\r' => out.write_str("\\r"),
            '\t' => out.write_str("\\t"),
            _ => write!(out, "\\u{{{:x}}}", u32::from(c)),
        }?;
        rest = &rest[at + c.len_utf8()..];
    }
    out.write_str(rest)
}

fn escaped_json(text: &str, white: impl Fn(char) -> char) -> Cow<'_, str> {
    if text.chars().all(is_visible) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    let (mut is_string, mut is_escaped) = (false, false);
    for c in text.chars() {
        if is_visible(c) {
            out.push(c);
        } else if !is_string && matches!(c, '\n' | '\r' | '\t') {
            out.push(white(c));
        } else {
            for unit in c.encode_utf16(&mut [0; 2]) {
                // A string takes all that is written.
                let _ = write!(out, "\\u{unit:04x}");
            }
        }
        is_string ^= c == '"' && !is_escaped;
        is_escaped = is_string && c == '\\' && !is_escaped;
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    const HOSTILE: &str =
        "a\u{1b}[2J\u{9b}31m\u{7f}\r\nb\t\u{202e}c\u{2066}\u{200f}\u{61c}\u{2028}\u{feff}\u{e0041}é关节 1";

    #[test]
    fn what_a_terminal_obeys_is_shown_and_all_else_stays() {
        let shown = r"a\u{1b}[2J\u{9b}31m\u{7f}\r\nb\t\u{202e}c\u{2066}\u{200f}\u{61c}\u{2028}\u{feff}\u{e0041}é关节 1";
        assert_eq!(Visible(HOSTILE).to_string(), shown);
        assert_eq!(visible(HOSTILE), shown);
        assert_eq!(visible_lines(HOSTILE), shown.replace(r"\n", "\n"));
        let mut out = String::new();
        write!(VisibleWriter(&mut out), "{}{}", HOSTILE, 1).expect("a string takes all");
        assert_eq!(out, format!("{shown}1"));
        // And so it stays.
        assert!(matches!(visible(shown), Cow::Borrowed(_)));
    }

    #[test]
    fn what_is_hidden_is_what_is_invisible() {
        for c in ('\0'..=char::MAX).filter(|&c| !is_visible(c)) {
            assert!(c.escape_debug().len() > 1, "{c:?}");
        }
        for range in ['\u{0}'..='\u{1f}', '\u{7f}'..='\u{9f}', '\u{202a}'..='\u{202e}', '\u{2066}'..='\u{2069}'] {
            assert!(range.into_iter().all(|c| !is_visible(c)));
        }
        assert!(['\u{200e}', '\u{200f}', '\u{61c}', '\u{2028}', '\u{2029}'].into_iter().all(|c| !is_visible(c)));
        assert!([' ', '\u{a0}', '\u{3000}', '\u{301}', '\u{fffd}', '関', '😀'].into_iter().all(is_visible));
    }

    #[test]
    fn json_reads_the_same() {
        let json = serde_json::json!({"a\u{202e}": [HOSTILE, "\"\\\u{85}"], "b": 1});
        for text in [json.to_string(), format!("{json:#}")] {
            let (shown, line) = (visible_json(&text), visible_json_line(&text));
            assert!(shown.chars().all(|c| is_visible(c) || c == '\n') && line.chars().all(is_visible));
            for shown in [shown, line] {
                assert_eq!(serde_json::from_str::<serde_json::Value>(&shown).expect("it is JSON"), json);
            }
        }
        assert_eq!(visible_json("{\"a\":\t1,\n\"b\\\"\n\":2}\u{1b}"), "{\"a\":\t1,\n\"b\\\"\\u000a\":2}\\u001b");
        assert_eq!(visible_json_line("{\"a\":\t1,\n\"\\\\\":\r2}"), "{\"a\": 1, \"\\\\\": 2}");
    }
}
