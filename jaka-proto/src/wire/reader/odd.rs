//! Objects that are odd: complete by their quotes and brackets, and not JSON throughout.
//!
//! So are half a surrogate pair (valid JSON, which stands for no text), NaN, more levels of nesting than are read, and
//! bytes that are no UTF-8.

use std::borrow::Cow;

use super::skip::after_string;
use super::{DecodeError, Reader};
use crate::near::first_of;

impl<'a> Reader<'a> {
    /// Reads from the beginning of `text`, and passes over odd values of unknown keys.
    pub(crate) fn tolerant(text: &'a str) -> Self {
        Self { tolerant: true, ..Self::new(text) }
    }

    /// The next key of an object, with U+FFFD for escapes that stand for no character, or `None` after the last.
    ///
    /// # Errors
    /// It is not clear where the key ends.
    pub(crate) fn next_odd_key(&mut self) -> Result<Option<Cow<'a, str>>, DecodeError> {
        if !self.next(b'}', "`,` or `}`")? {
            return Ok(None);
        }
        let start = self.at;
        let end = if self.is_text() { after_string(self.text.as_bytes(), self.at + 1) } else { None };
        self.at = end.ok_or_else(|| self.malformed("a key"))?;
        let key = lossy_text(&self.text[start..self.at]);
        self.expect(b':', "`:`")?;
        Ok(Some(key))
    }

    /// The text of a value, found by its quotes and brackets alone.
    ///
    /// # Errors
    /// Brackets do not match, or something follows that cannot follow a value.
    pub(crate) fn odd_value(&mut self) -> Result<&'a str, DecodeError> {
        let text = self.text;
        let end = match self.peek() {
            Some(b'{' | b'[') => self.after_nested(),
            Some(b'"') => after_string(text.as_bytes(), self.at + 1),
            _ => self.after_word(),
        };
        let start = self.at;
        self.at = end.ok_or_else(|| self.malformed("a value that ends"))?;
        self.comma = true;
        let value = &text[start..self.at];
        match self.peek() {
            Some(b',' | b'}' | b']') => Ok(value),
            _ => Err(self.malformed("`,` or a bracket")),
        }
    }

    /// Finds the end of the array or object that begins here; `None` if its brackets do not match.
    fn after_nested(&self) -> Option<usize> {
        let bytes = self.text.as_bytes();
        let (mut at, mut open) = (self.at, Vec::new());
        loop {
            at += first_of(*b"\"{}[]", bytes.get(at..)?)? + 1;
            match bytes[at - 1] {
                b'"' => at = after_string(bytes, at)?,
                b'{' => open.push(b'}'),
                b'[' => open.push(b']'),
                close => {
                    open.pop().filter(|expected| *expected == close)?;
                    if open.is_empty() {
                        return Some(at);
                    }
                }
            }
        }
    }

    /// Finds the end of the number or word that begins here; `None` if it is empty or does not end.
    fn after_word(&self) -> Option<usize> {
        let ends = |byte: &u8| byte.is_ascii_whitespace() || b",:\"{}[]".contains(byte);
        let len = self.rest().iter().position(ends)?;
        (len > 0).then_some(self.at + len)
    }
}

/// The text of a string that is given with its quotes, with U+FFFD for what stands for no text.
pub(crate) fn lossy_text(quoted: &str) -> Cow<'_, str> {
    if let Ok(text) = Reader::new(quoted).text() {
        return text;
    }
    let inner = quoted.strip_prefix('"').and_then(|text| text.strip_suffix('"')).unwrap_or_default();
    let mut rest = inner.chars();
    let mut text = String::with_capacity(quoted.len());
    while let Some(next) = rest.next() {
        text.push(if next == '\\' { escape(&mut rest) } else { next });
    }
    text.into()
}

/// Returns the character for the escape whose backslash has been taken.
fn escape(rest: &mut std::str::Chars<'_>) -> char {
    match rest.next() {
        Some(plain @ ('"' | '\\' | '/')) => plain,
        Some('b') => '\u{8}',
        Some('f') => '\u{c}',
        Some('n') => '\n',
        Some('r') => '\r',
        Some('t') => '\t',
        Some('u') => code_point(rest).unwrap_or(char::REPLACEMENT_CHARACTER),
        _ => char::REPLACEMENT_CHARACTER,
    }
}

/// The character of four digits, or of a pair of such; none for one half of a pair alone.
fn code_point(rest: &mut std::str::Chars<'_>) -> Option<char> {
    let first = unit(rest)?;
    let mut ahead = rest.clone();
    let second = if ahead.next() == Some('\\') && ahead.next() == Some('u') { unit(&mut ahead) } else { None };
    let pair = second.and_then(|second| char::decode_utf16([first, second]).next()?.ok());
    match pair {
        Some(pair) if pair.len_utf16() == 2 => {
            *rest = ahead;
            Some(pair)
        }
        _ => char::from_u32(first.into()),
    }
}

fn unit(rest: &mut std::str::Chars<'_>) -> Option<u16> {
    let digits = rest.as_str().get(..4).filter(|digits| digits.bytes().all(|byte| byte.is_ascii_hexdigit()))?;
    *rest = rest.as_str()[4..].chars();
    u16::from_str_radix(digits, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::lossy_text;

    #[test]
    fn what_stands_for_no_text_is_replaced_and_all_else_is_kept() {
        for (quoted, expected) in [
            (r#""plain""#, "plain"),
            (r#""a\"\\\/\b\f\n\r\t\u4e2d\ud83d""#, "a\"\\/\u{8}\u{c}\n\r\t中\u{fffd}"),
            (r#""\ud83d\ude00\ud83d""#, "😀\u{fffd}"),
            (r#""\ud83d\ud83d\ude00""#, "\u{fffd}😀"),
            (r#""\ud83d\u0041\ude00\\""#, "\u{fffd}A\u{fffd}\\"),
            (r#""\ud83d\n""#, "\u{fffd}\n"),
            (r#""\x41\u12\u12g4\q""#, "\u{fffd}41\u{fffd}12\u{fffd}12g4\u{fffd}"),
            (r#""\ud83d\"""#, "\u{fffd}\""),
        ] {
            assert_eq!(lossy_text(quoted), expected, "{quoted}");
        }
    }
}
