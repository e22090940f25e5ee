//! Reads JSON text, one value after the other, without building a tree.

mod capture;
mod fields;
mod odd;
mod skip;
mod status;

use std::borrow::Cow;

pub use fields::Keys;
pub(crate) use odd::lossy_text;
use skip::MAX_DEPTH;

use self::capture::Capture;
use super::error::DecodeError;
use super::number::{self, Scalar, whole};
use super::{Decode, Fields, Writer};
use crate::near::{first_of, plain_text};

/// A position in a JSON text.
#[derive(Debug, Clone)]
pub struct Reader<'a> {
    text: &'a str,
    at: usize,
    /// True if a comma must come before the next key or element.
    comma: bool,
    /// Number of open arrays and objects of any shape.
    depth: u32,
    capture: Capture<'a>,
    /// Whether odd values of unknown keys are passed over.
    tolerant: bool,
    /// Errors of the values that were left out of a status packet.
    left_out: Vec<DecodeError>,
}

/// A place to which a reader can go back.
#[derive(Debug, Clone, Copy)]
pub struct Mark {
    at: usize,
    comma: bool,
}

impl<'a> Reader<'a> {
    /// Reads from the beginning of `text`.
    pub fn new(text: &'a str) -> Self {
        Self { text, at: 0, comma: false, depth: 0, capture: Capture::NONE, tolerant: false, left_out: Vec::new() }
    }

    /// Returns the position of the reader.
    #[doc(hidden)]
    #[inline]
    pub fn mark(&self) -> Mark {
        Mark { at: self.at, comma: self.comma }
    }

    /// Goes back to an earlier position.
    #[doc(hidden)]
    #[inline]
    pub fn go_back(&mut self, to: Mark) {
        (self.at, self.comma) = (to.at, to.comma);
    }

    /// Fails unless nothing but white space is left.
    ///
    /// # Errors
    /// Something is left.
    pub fn end(&mut self) -> Result<(), DecodeError> {
        match self.peek() {
            None => Ok(()),
            Some(_) => Err(self.malformed("the end of the message")),
        }
    }

    /// Enters an object.
    ///
    /// # Errors
    /// The next value is not an object.
    pub fn begin_object(&mut self) -> Result<(), DecodeError> {
        self.begin(b'{', "an object")
    }

    /// Enters an array.
    ///
    /// # Errors
    /// The next value is not an array.
    #[inline]
    pub fn begin_array(&mut self) -> Result<(), DecodeError> {
        self.begin(b'[', "an array")
    }

    /// The next key of an object, or `None` after the last; the reader is then at the key's value.
    ///
    /// # Errors
    /// The text is not JSON.
    pub fn next_key(&mut self) -> Result<Option<Cow<'a, str>>, DecodeError> {
        if self.next(b'}', "`,` or `}`")? { self.key().map(Some) } else { Ok(None) }
    }

    /// Goes to the next element of an array; false after the last.
    ///
    /// # Errors
    /// The text is not JSON.
    #[inline]
    pub fn next_element(&mut self) -> Result<bool, DecodeError> {
        self.next(b']', "`,` or `]`")
    }

    /// Reads null, if that is the next value.
    #[inline]
    pub fn null(&mut self) -> bool {
        self.eat("null")
    }

    /// Reads a string.
    ///
    /// # Errors
    /// The next value is not a string.
    pub fn text(&mut self) -> Result<Cow<'a, str>, DecodeError> {
        if self.peek() == Some(b'"') { self.string("a string") } else { Err(self.unfit("a string")) }
    }

    /// The raw text of the next value.
    ///
    /// # Errors
    /// The text is not JSON.
    pub fn raw(&mut self) -> Result<&'a str, DecodeError> {
        self.peek();
        let start = self.at;
        self.skip_strictly()?;
        Ok(&self.text[start..self.at])
    }

    /// Reads a scalar if it is written in its usual form.
    #[inline]
    pub(super) fn usual<T: Scalar>(&mut self) -> Option<T> {
        self.peek()?;
        let (value, len) = T::usual(self.rest())?;
        self.at += len;
        self.comma = true;
        Some(value)
    }

    /// Reads the elements of an array as far as they are written in their usual form, and tells how many they were.
    #[inline]
    pub(super) fn usual_run<T: Scalar>(&mut self, take: impl FnMut(T)) -> usize {
        let (count, len) = number::run(self.rest(), take);
        self.at += len;
        self.comma |= count > 0;
        count
    }

    /// Whether the next value is a string.
    pub(crate) fn is_text(&mut self) -> bool {
        self.peek() == Some(b'"')
    }

    /// Whether the next value is an array.
    pub(crate) fn is_array(&mut self) -> bool {
        self.peek() == Some(b'[')
    }

    /// Whether the next value is an object.
    pub(crate) fn is_object(&mut self) -> bool {
        self.peek() == Some(b'{')
    }

    /// Reads an array or object of any shape.
    pub(super) fn nested<T>(
        &mut self,
        read: impl FnOnce(&mut Self) -> Result<T, DecodeError>,
    ) -> Result<T, DecodeError> {
        self.depth += 1;
        let value = read(self);
        self.depth -= 1;
        value
    }

    /// Fails inside of too many of them.
    pub(super) fn not_too_deep(&self) -> Result<(), DecodeError> {
        if self.depth > MAX_DEPTH { Err(self.too_deep()) } else { Ok(()) }
    }

    /// The error for a value that nests too deep.
    #[cold]
    pub(crate) fn too_deep(&self) -> DecodeError {
        self.malformed("at most 64 levels of nesting")
    }

    /// Reads a value that is written exactly so.
    #[inline]
    pub(crate) fn eat(&mut self, value: &str) -> bool {
        let eaten = self.peek().is_some() && self.rest().starts_with(value.as_bytes());
        if eaten {
            self.at += value.len();
            self.comma = true;
        }
        eaten
    }

    /// Reads a string of which `read` makes something; otherwise stays before it.
    pub(crate) fn text_with<T>(&mut self, read: impl FnOnce(&str) -> Option<T>) -> Option<T> {
        let start = self.mark();
        let value = if self.is_text() { self.string("a string").ok().and_then(|text| read(&text)) } else { None };
        if value.is_none() {
            self.go_back(start);
        }
        value
    }

    /// Reads a string without escapes and control characters, if that is the next value.
    #[inline]
    pub(crate) fn usual_text(&mut self) -> Option<&'a str> {
        self.peek();
        let (b'"', text) = self.rest().split_first()? else { return None };
        let start = self.at + 1;
        let end = start + plain_text(text)?;
        self.at = end + 1;
        self.comma = true;
        self.text.get(start..end)
    }

    /// The text of the next value if it is a number, or a string (trimmed) that may hold one; `None` otherwise.
    pub(super) fn scalar(&mut self) -> Result<Option<Cow<'a, str>>, DecodeError> {
        match self.peek() {
            Some(b'"') => self.string("a string").map(|text| Some(trimmed(text))),
            Some(b'-' | b'0'..=b'9') => Ok(Some(Cow::Borrowed(self.number()))),
            _ => Ok(None),
        }
    }

    /// Reads with `read`, or goes back and keeps the raw text of a value that does not fit.
    pub(super) fn or_raw<T>(
        &mut self,
        read: impl FnOnce(&mut Self) -> Result<T, DecodeError>,
    ) -> Result<Result<T, &'a str>, DecodeError> {
        let start = self.mark();
        if let Ok(value) = read(self) {
            return Ok(Ok(value));
        }
        self.go_back(start);
        self.raw().map(Err)
    }

    /// Reads a truth value, in any of the usual forms or as one of two words.
    fn word(&mut self, off: &str, on: &str) -> Result<bool, DecodeError> {
        let is = |text: &str, word: &str| {
            text.eq_ignore_ascii_case(word) || whole(text).is_some_and(|number| whole(word) == Some(number))
        };
        let start = self.mark();
        match self.scalar()? {
            Some(text) if is(&text, off) => Ok(false),
            Some(text) if is(&text, on) => Ok(true),
            _ => {
                self.go_back(start);
                bool::decode(self)
            }
        }
    }

    #[inline]
    fn rest(&self) -> &'a [u8] {
        self.text.as_bytes().get(self.at..).unwrap_or_default()
    }

    /// The next byte that is not white space.
    #[inline]
    fn peek(&mut self) -> Option<u8> {
        match *self.rest() {
            [byte, ..] if byte > b' ' => Some(byte),
            // Some firmware puts a blank after each comma and colon.
            [b' ', byte, ..] if byte > b' ' => {
                self.at += 1;
                Some(byte)
            }
            _ => self.peek_far(),
        }
    }

    #[inline(never)]
    fn peek_far(&mut self) -> Option<u8> {
        while let Some(b' ' | b'\t' | b'\r' | b'\n') = self.rest().first() {
            self.at += 1;
        }
        self.rest().first().copied()
    }

    fn malformed(&self, expected: &'static str) -> DecodeError {
        DecodeError::malformed(self.text, self.at, expected)
    }

    #[inline]
    fn expect(&mut self, byte: u8, expected: &'static str) -> Result<(), DecodeError> {
        if self.peek() != Some(byte) {
            return Err(self.malformed(expected));
        }
        self.at += 1;
        Ok(())
    }

    #[inline]
    fn begin(&mut self, open: u8, expected: &'static str) -> Result<(), DecodeError> {
        if self.peek() != Some(open) {
            return Err(self.unfit(expected));
        }
        self.at += 1;
        self.comma = false;
        Ok(())
    }

    /// The error for a value of another kind than `expected`.
    #[cold]
    fn unfit(&mut self, expected: &'static str) -> DecodeError {
        let start = self.at;
        match self.skip_strictly() {
            Ok(()) => DecodeError::unfit(expected, &self.text[start..self.at]),
            Err(malformed) => malformed,
        }
    }

    fn key(&mut self) -> Result<Cow<'a, str>, DecodeError> {
        let key = self.string("a key")?;
        self.expect(b':', "`:`")?;
        Ok(key)
    }

    #[inline]
    fn next(&mut self, close: u8, expected: &'static str) -> Result<bool, DecodeError> {
        match *self.rest() {
            [b',', byte, ..] if self.comma && byte > b' ' && byte != close => self.at += 1,
            [b',', b' ', byte, ..] if self.comma && byte > b' ' && byte != close => self.at += 2,
            _ => return self.next_closely(close, expected),
        }
        Ok(true)
    }

    #[inline(never)]
    fn next_closely(&mut self, close: u8, expected: &'static str) -> Result<bool, DecodeError> {
        if self.peek() == Some(close) {
            self.at += 1;
            self.comma = true;
            return Ok(false);
        }
        if self.comma {
            self.expect(b',', expected)?;
            if self.peek() == Some(close) {
                return Err(self.malformed("a value after the comma"));
            }
        }
        Ok(true)
    }

    fn string(&mut self, expected: &'static str) -> Result<Cow<'a, str>, DecodeError> {
        self.expect(b'"', expected)?;
        let start = self.at;
        let mut escaped = false;
        loop {
            let rest = self.rest();
            let Some(found) = first_of(*b"\"\\", rest) else {
                self.at = self.text.len();
                return Err(self.malformed("the end of a string"));
            };
            self.at += found + 1;
            if rest[found] == b'"' {
                break;
            }
            escaped = true;
            self.at += 1;
        }
        self.comma = true;
        let inner = &self.text[start..self.at - 1];
        if escaped { self.unescape(inner, start).map(Cow::Owned) } else { Ok(Cow::Borrowed(inner)) }
    }

    /// The escapes are rare: they are left to `serde_json`.
    #[cold]
    fn unescape(&self, inner: &str, start: usize) -> Result<String, DecodeError> {
        // serde_json takes no bare control characters; controllers may send them inside messages.
        let mut clean = Writer::new();
        clean.raw("\"");
        for c in inner.chars() {
            match u8::try_from(c) {
                Ok(control @ 0..=0x1f) => clean.escape(control),
                _ => clean.raw(c.encode_utf8(&mut [0; 4])),
            }
        }
        clean.raw("\"");
        serde_json::from_str(clean.as_str())
            .map_err(|_| DecodeError::malformed(self.text, start, "valid escapes in a string"))
    }

    fn number(&mut self) -> &'a str {
        let rest = &self.text[self.at..];
        let len = number::length(rest.as_bytes());
        self.at += len;
        self.comma = true;
        &rest[..len]
    }
}

/// Reads a payload, with whatever else the reply has.
///
/// # Errors
/// The text is not an object by its brackets, something follows it, or a field does not fit.
pub(crate) fn read_message<T: Fields>(text: &str) -> Result<T, DecodeError> {
    let mut reader = Reader::tolerant(text);
    let message = T::read_fields(&mut reader)?;
    finish(reader).map(|()| message)
}

// Not generic, or each type of a message would compile a copy.
fn finish(mut reader: Reader<'_>) -> Result<(), DecodeError> {
    reader.end()?;
    // Otherwise nothing would report what is left out of a reply that has the keys of a status packet.
    reader.left_out.into_iter().next().map_or(Ok(()), Err)
}

/// The text without the blanks around it.
#[inline]
pub(crate) fn trimmed(text: Cow<'_, str>) -> Cow<'_, str> {
    if let [b'!'..=b'~', .., b'!'..=b'~'] = text.as_bytes() {
        return text;
    }
    match text {
        Cow::Borrowed(text) => Cow::Borrowed(text.trim()),
        Cow::Owned(text) => Cow::Owned(text.trim().to_owned()),
    }
}
