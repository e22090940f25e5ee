//! The text of a frame.

use std::borrow::Cow;
use std::fmt::Write;

/// The text of a frame.
///
/// JSON is UTF-8. A byte that is not, such as one of a name in GBK, becomes the escape `\udcNN`, half of a surrogate
/// pair, which does not occur alone in valid text. So the byte is visible, the rest of the message can be read, and
/// reading the string that contains it is an error.
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
            if is_open_escape(&text) {
                text.push(char::REPLACEMENT_CHARACTER);
            } else {
                // Writing to a string cannot fail.
                let _ = write!(text, "\\udc{byte:02x}");
            }
        }
    }
    text
}

/// Whether what follows would become a part of the escape at the end: of a backslash, or of the first half of a pair.
fn is_open_escape(text: &str) -> bool {
    let is_escape = |before: &[u8]| before.iter().rev().take_while(|byte| **byte == b'\\').count() % 2 == 1;
    let bytes = text.as_bytes();
    let high_half = match bytes {
        [before @ .., b'u', b'd' | b'D', b'8' | b'9' | b'a' | b'A' | b'b' | b'B', c, d] => {
            c.is_ascii_hexdigit() && d.is_ascii_hexdigit() && is_escape(before)
        }
        _ => false,
    };
    high_half || is_escape(bytes)
}

#[cfg(test)]
mod tests {
    use super::text;

    #[test]
    fn no_byte_becomes_a_part_of_an_escape() {
        for (frame, expected) in [
            (b"'a\xff'".as_slice(), r"'a\udcff'"),
            (b"'a\\\xff'", "'a\\\u{fffd}'"),
            (b"'a\\\\\xff\xfe'", r"'a\\\udcff\udcfe'"),
            (b"'\\ud83d\xff\xfe'", "'\\ud83d\u{fffd}\\udcfe'"),
            (b"'\\\\ud83d\xff'", r"'\\ud83d\udcff'"),
            (b"'\\u12\xff'", r"'\u12\udcff'"),
            (b"'\xed\xa0\xbd'", r"'\udced\udca0\udcbd'"),
        ] {
            assert_eq!(text(frame), expected);
            let json = text(frame).replace('\'', "\"");
            assert!(serde_json::from_str::<String>(&json).is_err(), "{json} is text");
        }
    }
}
