//! The text of a frame.

use std::borrow::Cow;
use std::fmt::Write;

/// The text of a frame.
///
/// JSON is UTF-8. A byte that is none, such as one of a name in GBK, becomes the escape `\udcNN`, which no JSON text has by itself:
/// one half of a pair that stands alone. So it is seen, the rest of the message can be read, and whoever reads the string that
/// it stands in is told.
///
/// ```
/// use jaka_proto::framing::text;
///
/// assert_eq!(text(br#"{"errorMsg": "no"}"#), r#"{"errorMsg": "no"}"#);
/// assert_eq!(text(b"{\"errorMsg\": \"\xc4\xe3\"}"), r#"{"errorMsg": "\udcc4\udce3"}"#);
/// ```
pub fn text(frame: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(frame) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(with_escapes(frame)),
    }
}

#[cold]
fn with_escapes(frame: &[u8]) -> String {
    let mut text = String::with_capacity(frame.len() + 64);
    for chunk in frame.utf8_chunks() {
        text.push_str(chunk.valid());
        for byte in chunk.invalid() {
            // Behind an escape's backslash, another one would make an escape that JSON has.
            if text.bytes().rev().take_while(|byte| *byte == b'\\').count() % 2 == 1 {
                text.push(char::REPLACEMENT_CHARACTER);
            } else {
                // Writing to a string cannot fail.
                let _ = write!(text, "\\udc{byte:02x}");
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::text;

    #[test]
    fn no_byte_becomes_a_part_of_an_escape() {
        assert_eq!(text(b"\"a\\\xff\""), "\"a\\\u{fffd}\"");
        assert_eq!(text(b"\"a\\\\\xff\""), r#""a\\\\\udcff""#.replace("\\\\\\\\", "\\\\"));
        assert!(serde_json::from_str::<String>(&text(b"\"a\\\xff\"")).is_err());
        assert!(serde_json::from_str::<String>(&text(b"\"a\\\\\xff\"")).is_err());
        assert!(serde_json::from_str::<String>(&text(b"\"\xed\xa0\xbd\"")).is_err());
    }
}
