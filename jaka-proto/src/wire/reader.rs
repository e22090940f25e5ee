//! Reads JSON text, one value after the other, without building a tree.

use std::borrow::Cow;

use memchr::memchr2;

use super::decode::whole;
use super::error::DecodeError;
use super::{Decode, Fields, Writer};

/// How deep arrays and objects may nest.
const MAX_DEPTH: u32 = 64;

/// A position in a JSON text.
#[derive(Debug, Clone)]
pub struct Reader<'a> {
    text: &'a str,
    at: usize,
    /// True where a comma must come before the next key or element.
    comma: bool,
}

impl<'a> Reader<'a> {
    /// Reads from the beginning of `text`.
    pub fn new(text: &'a str) -> Self {
        Self { text, at: 0, comma: false }
    }

    /// The next byte that is no white space.
    fn peek(&mut self) -> Option<u8> {
        let rest = &self.text.as_bytes()[self.at..];
        let blanks = rest.iter().take_while(|b| matches!(b, b' ' | b'\t' | b'\r' | b'\n')).count();
        self.at += blanks;
        rest.get(blanks).copied()
    }

    fn malformed(&self, expected: &'static str) -> DecodeError {
        DecodeError::malformed(self.text, self.at, expected)
    }

    fn expect(&mut self, byte: u8, expected: &'static str) -> Result<(), DecodeError> {
        if self.peek() != Some(byte) {
            return Err(self.malformed(expected));
        }
        self.at += 1;
        Ok(())
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
    /// The next value is no object.
    pub fn begin_object(&mut self) -> Result<(), DecodeError> {
        self.begin(b'{', "an object")
    }

    /// Enters an array.
    ///
    /// # Errors
    /// The next value is no array.
    pub fn begin_array(&mut self) -> Result<(), DecodeError> {
        self.begin(b'[', "an array")
    }

    fn begin(&mut self, open: u8, expected: &'static str) -> Result<(), DecodeError> {
        if self.peek() != Some(open) {
            return Err(self.unfit(expected));
        }
        self.at += 1;
        self.comma = false;
        Ok(())
    }

    /// The error for a value of another kind than `expected`.
    fn unfit(&mut self, expected: &'static str) -> DecodeError {
        let start = self.at;
        match self.skip() {
            Ok(()) => DecodeError::unfit(expected, &self.text[start..self.at]),
            Err(malformed) => malformed,
        }
    }

    /// The next key of an object, or `None` behind the last; the reader then stands on the key's value.
    ///
    /// # Errors
    /// The text is no JSON.
    pub fn next_key(&mut self) -> Result<Option<Cow<'a, str>>, DecodeError> {
        if !self.next(b'}', "`,` or `}`")? {
            return Ok(None);
        }
        let key = self.string("a key")?;
        self.expect(b':', "`:`")?;
        Ok(Some(key))
    }

    /// Goes to the next element of an array; false behind the last.
    ///
    /// # Errors
    /// The text is no JSON.
    pub fn next_element(&mut self) -> Result<bool, DecodeError> {
        self.next(b']', "`,` or `]`")
    }

    fn next(&mut self, close: u8, expected: &'static str) -> Result<bool, DecodeError> {
        if self.peek() == Some(close) {
            self.at += 1;
            self.comma = true;
            return Ok(false);
        }
        if self.comma {
            self.expect(b',', expected)?;
            if self.peek() == Some(close) {
                return Err(self.malformed("a value behind the comma"));
            }
        }
        Ok(true)
    }

    /// Reads a field's value into its slot. A null counts as absent.
    ///
    /// # Errors
    /// The value does not fit, or the slot is taken: the key appears twice.
    pub fn field<T: Decode>(&mut self, name: &'static str, slot: &mut Option<T>) -> Result<(), DecodeError> {
        self.field_with(name, slot, T::decode)
    }

    /// Reads a truth value that is written as one of two words, or in any of the usual forms.
    ///
    /// # Errors
    /// As [`field`](Self::field).
    pub fn field_word(
        &mut self,
        name: &'static str,
        slot: &mut Option<bool>,
        off: &str,
        on: &str,
    ) -> Result<(), DecodeError> {
        self.field_with(name, slot, |reader| reader.word(off, on))
    }

    /// Reads a value that is written as a Python literal inside a string.
    ///
    /// # Errors
    /// As [`field`](Self::field).
    pub fn field_python<T: Decode>(&mut self, name: &'static str, slot: &mut Option<T>) -> Result<(), DecodeError> {
        self.field_with(name, slot, |reader| {
            let literal = reader.text()?;
            let json = crate::python::to_json(&literal)
                .map_err(|error| DecodeError::unfit(format!("a Python literal ({error})"), &literal))?;
            T::decode(&mut Reader::new(&json))
        })
    }

    fn field_with<T>(
        &mut self,
        name: &'static str,
        slot: &mut Option<T>,
        decode: impl FnOnce(&mut Self) -> Result<T, DecodeError>,
    ) -> Result<(), DecodeError> {
        if slot.is_some() {
            return Err(DecodeError::repeated().in_field(name));
        }
        if !self.null() {
            *slot = Some(decode(self).map_err(|error| error.in_field(name))?);
        }
        Ok(())
    }

    /// Reads the next element of an array, which must be there.
    ///
    /// # Errors
    /// The array ends, or the element does not fit.
    pub fn element<T: Decode>(&mut self, name: &'static str) -> Result<T, DecodeError> {
        self.optional_element(name)?.ok_or_else(|| DecodeError::missing(name, ""))
    }

    /// Reads the next element of an array, if there is one and it is not null.
    ///
    /// # Errors
    /// The element does not fit.
    pub fn optional_element<T: Decode>(&mut self, name: &'static str) -> Result<Option<T>, DecodeError> {
        let mut slot = None;
        // Behind the array's end its bracket is left in place, so that further optional elements see it too.
        let bracket = self.clone();
        if self.next_element()? {
            self.field(name, &mut slot)?;
        } else {
            *self = bracket;
        }
        Ok(slot)
    }

    /// Leaves an array; elements that the type does not know are skipped.
    ///
    /// # Errors
    /// The text is no JSON.
    pub fn end_array(&mut self) -> Result<(), DecodeError> {
        while self.next_element()? {
            self.skip()?;
        }
        Ok(())
    }

    /// Leaves an array that must have no further elements.
    ///
    /// # Errors
    /// There is a further element.
    pub fn end_exact_array(&mut self) -> Result<(), DecodeError> {
        if self.next_element()? {
            return Err(self.unfit("the end of the array"));
        }
        Ok(())
    }

    /// Reads the tag that tells which variant an object holds, and goes back to the object's beginning.
    ///
    /// # Errors
    /// The tag is missing or no whole number.
    pub fn tag(&mut self, name: &'static str, key: &'static str) -> Result<i64, DecodeError> {
        let mut ahead = self.clone();
        let mut tag = None;
        ahead.begin_object()?;
        while let Some(found) = ahead.next_key()? {
            if found == key { ahead.field(name, &mut tag)? } else { ahead.skip()? }
        }
        tag.ok_or_else(|| DecodeError::missing(name, key))
    }

    /// Reads null, if that is the next value.
    pub fn null(&mut self) -> bool {
        let null = self.peek() == Some(b'n') && self.text[self.at..].starts_with("null");
        if null {
            self.at += 4;
            self.comma = true;
        }
        null
    }

    /// Reads a string.
    ///
    /// # Errors
    /// The next value is no string.
    pub fn text(&mut self) -> Result<Cow<'a, str>, DecodeError> {
        if self.peek() == Some(b'"') { self.string("a string") } else { Err(self.unfit("a string")) }
    }

    fn string(&mut self, expected: &'static str) -> Result<Cow<'a, str>, DecodeError> {
        self.expect(b'"', expected)?;
        let start = self.at;
        let mut escaped = false;
        loop {
            let rest = &self.text.as_bytes()[self.at..];
            let Some(found) = memchr2(b'"', b'\\', rest) else {
                self.at = self.text.len();
                return Err(self.malformed("the end of a string"));
            };
            self.at += found + 1;
            if rest[found] == b'"' {
                break;
            }
            escaped = true;
            self.at += 1;
            if self.at > self.text.len() {
                self.at = self.text.len();
                return Err(self.malformed("the end of a string"));
            }
        }
        self.comma = true;
        let inner = &self.text[start..self.at - 1];
        if escaped { self.unescape(inner, start).map(Cow::Owned) } else { Ok(Cow::Borrowed(inner)) }
    }

    /// The escapes are rare: they are left to `serde_json`.
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

    /// The text of the next value if it is a number, or a string (trimmed) that may hold one; `None` otherwise.
    pub(super) fn scalar(&mut self) -> Result<Option<Cow<'a, str>>, DecodeError> {
        match self.peek() {
            Some(b'"') => self.string("a string").map(|text| Some(trimmed(text))),
            Some(b'-' | b'0'..=b'9') => Ok(Some(Cow::Borrowed(self.number()))),
            _ => Ok(None),
        }
    }

    fn number(&mut self) -> &'a str {
        let rest = &self.text[self.at..];
        let is_part = |b: &u8| matches!(b, b'0'..=b'9' | b'-' | b'+' | b'.' | b'e' | b'E');
        let len = rest.bytes().take_while(is_part).count();
        self.at += len;
        self.comma = true;
        &rest[..len]
    }

    /// The raw text of the next value.
    ///
    /// # Errors
    /// The text is no JSON.
    pub fn raw(&mut self) -> Result<&'a str, DecodeError> {
        self.peek();
        let start = self.at;
        self.skip()?;
        Ok(&self.text[start..self.at])
    }

    /// Reads `T`, or keeps the raw text of a value that does not fit.
    pub(super) fn either<T: Decode>(&mut self) -> Result<Result<T, &'a str>, DecodeError> {
        let start = self.clone();
        if let Ok(value) = T::decode(self) {
            return Ok(Ok(value));
        }
        *self = start;
        self.raw().map(Err)
    }

    /// Skips the next value.
    ///
    /// # Errors
    /// The text is no JSON, or nests deeper than 64 levels.
    pub fn skip(&mut self) -> Result<(), DecodeError> {
        self.skip_nested(0)
    }

    fn skip_nested(&mut self, depth: u32) -> Result<(), DecodeError> {
        if depth > MAX_DEPTH {
            return Err(self.malformed("at most 64 levels of nesting"));
        }
        match self.peek() {
            Some(b'{') => {
                self.begin_object()?;
                while self.next_key()?.is_some() {
                    self.skip_nested(depth + 1)?;
                }
                Ok(())
            }
            Some(b'[') => {
                self.begin_array()?;
                while self.next_element()? {
                    self.skip_nested(depth + 1)?;
                }
                Ok(())
            }
            Some(b'"') => self.string("a string").map(drop),
            Some(b'-' | b'0'..=b'9') => self.skip_number(),
            _ => self.skip_word(),
        }
    }

    fn skip_number(&mut self) -> Result<(), DecodeError> {
        let start = self.at;
        let fits = self.number().parse::<f64>().is_ok();
        if fits { Ok(()) } else { Err(DecodeError::malformed(self.text, start, "a number")) }
    }

    fn skip_word(&mut self) -> Result<(), DecodeError> {
        let rest = &self.text[self.at..];
        let Some(word) = ["true", "false", "null"].into_iter().find(|word| rest.starts_with(word)) else {
            return Err(self.malformed("a value"));
        };
        self.at += word.len();
        self.comma = true;
        Ok(())
    }

    /// Reads a truth value, in any of the usual forms or as one of two words.
    fn word(&mut self, off: &str, on: &str) -> Result<bool, DecodeError> {
        let is = |text: &str, word: &str| {
            text.eq_ignore_ascii_case(word) || whole(text).is_some_and(|number| whole(word) == Some(number))
        };
        let mut ahead = self.clone();
        match ahead.scalar()? {
            Some(text) if is(&text, off) => {
                *self = ahead;
                Ok(false)
            }
            Some(text) if is(&text, on) => {
                *self = ahead;
                Ok(true)
            }
            _ => bool::decode(self),
        }
    }
}

/// Reads one message.
///
/// # Errors
/// The text is no JSON object, something follows it, or a field does not fit.
pub(crate) fn read_message<T: Fields>(text: &str) -> Result<T, DecodeError> {
    let mut reader = Reader::new(text);
    let message = T::read_fields(&mut reader)?;
    reader.end()?;
    Ok(message)
}

/// The text without the blanks around it.
pub(crate) fn trimmed(text: Cow<'_, str>) -> Cow<'_, str> {
    match text {
        Cow::Borrowed(text) => Cow::Borrowed(text.trim()),
        Cow::Owned(text) => Cow::Owned(text.trim().to_owned()),
    }
}
