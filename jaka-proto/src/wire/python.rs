//! Python literals as JSON text and back, so that one decoder reads both.
//!
//! Controllers print some values with Python's `repr`: the string `extio_status`, and the whole reply of
//! `get_extio_status` where no module is fitted (4.34). [`to_json`] reads such text; [`from_json`] writes it,
//! for a simulated controller.

use std::error::Error;
use std::fmt::{self, Write};

use serde_json::Value;

use super::{Decode, DecodeError, Reader, Writer};

/// The most brackets that may be open at once.
const MAX_DEPTH: usize = 64;

/// Turns a Python literal into JSON text, without white space.
///
/// - Tuples and lists become arrays, dicts with string keys become objects, and `(1)` is just `1`.
/// - Strings stand in either quotes, with Python 2's `u` or without. Adjacent `\xNN` are read as UTF-8 where there
///   is no `u` and they are valid: so Python 2 prints a name that is not ASCII. Otherwise each is a code point.
/// - Numbers pass as text, without Python 2's `L`; `nan`, `inf` and what is as large are refused, for JSON knows none.
/// - `True`, `False` and `None` become `true`, `false` and `null`.
///
/// ```
/// let json = jaka_proto::python::to_json("(0, [], {'state': 0})")?;
/// assert_eq!(json, r#"[0,[],{"state":0}]"#);
/// # Ok::<(), jaka_proto::python::PythonError>(())
/// ```
pub fn to_json(literal: &str) -> Result<String, PythonError> {
    let mut transcoder = Transcoder { text: literal, at: 0, depth: 0, out: String::with_capacity(literal.len()) };
    transcoder.value()?;
    match transcoder.token() {
        None => Ok(transcoder.out),
        Some(_) => Err(transcoder.expected("the end")),
    }
}

/// Turns JSON text into a Python literal in the controller's style.
///
/// Arrays become tuples, objects become dicts, and strings stand in single quotes.
///
/// ```
/// let literal = jaka_proto::python::from_json(r#"[1, [8], {"on": true}]"#)?;
/// assert_eq!(literal, "(1, (8,), {'on': True})");
/// # Ok::<(), jaka_proto::wire::DecodeError>(())
/// ```
///
/// # Errors
/// The text is not JSON, or has a number that is not one in Python, such as `1e999`.
pub fn from_json(json: &str) -> Result<String, DecodeError> {
    let mut reader = Reader::new(json);
    let mut out = String::with_capacity(json.len());
    write_value(&mut reader, MAX_DEPTH, &mut out)?;
    reader.end()?;
    Ok(out)
}

impl Writer {
    /// Writes what `write` writes as JSON, but as a Python literal inside a string.
    pub fn python(&mut self, write: impl FnOnce(&mut Self)) {
        let mut inner = Self::new();
        write(&mut inner);
        // A writer writes JSON; if it did not, the text itself is the best that can be sent.
        let literal = from_json(inner.as_str()).unwrap_or_else(|_| inner.into_string());
        self.text(&literal);
    }
}

impl Reader<'_> {
    /// Reads a value that is written as a Python literal inside a string.
    ///
    /// # Errors
    /// As [`field`](Self::field).
    pub fn field_python<T: Decode>(&mut self, name: &'static str, slot: &mut Option<T>) -> Result<(), DecodeError> {
        self.field_with(name, slot, |reader| {
            let literal = reader.text()?;
            let json = to_json(&literal)
                .map_err(|error| DecodeError::unfit(format!("a Python literal ({error})"), &literal))?;
            T::decode(&mut Reader::new(&json))
        })
    }
}

/// Writes a value in which so many brackets may be open at once.
fn write_value(reader: &mut Reader<'_>, depth: usize, out: &mut String) -> Result<(), DecodeError> {
    if reader.is_array() {
        let inner = depth.checked_sub(1).ok_or_else(|| reader.too_deep())?;
        let mut count = 0;
        out.push('(');
        reader.begin_array()?;
        while reader.next_element()? {
            out.push_str(if count > 0 { ", " } else { "" });
            write_value(reader, inner, out)?;
            count += 1;
        }
        out.push_str(if count == 1 { ",)" } else { ")" });
    } else if reader.is_object() {
        let inner = depth.checked_sub(1).ok_or_else(|| reader.too_deep())?;
        let mut separator = "";
        out.push('{');
        reader.begin_object()?;
        while let Some(key) = reader.next_key()? {
            out.push_str(separator);
            write_string(&key, out);
            out.push_str(": ");
            write_value(reader, inner, out)?;
            separator = ", ";
        }
        out.push('}');
    } else if reader.is_text() {
        write_string(&reader.text()?, out);
    } else {
        out.push_str(match reader.raw()? {
            "true" => "True",
            "false" => "False",
            "null" => "None",
            number if to_json(number).is_ok_and(|same| same == number) => number,
            other => return Err(DecodeError::unfit("a finite number", other)),
        });
    }
    Ok(())
}

fn write_string(text: &str, out: &mut String) {
    out.push('\'');
    for c in text.chars() {
        match c {
            '\'' => out.push_str("\\'"),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            '\0'..' ' | '\x7f' => {
                // A string takes all that is written.
                let _ = write!(out, "\\x{:02x}", u32::from(c));
            }
            _ => out.push(c),
        }
    }
    out.push('\'');
}

/// A literal that cannot be read: where that shows, and what was expected there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PythonError {
    position: usize,
    expected: &'static str,
}

impl fmt::Display for PythonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "python literal: expected {} at byte {}", self.expected, self.position)
    }
}

impl Error for PythonError {}

type Step = Result<(), PythonError>;

/// Reads Python from the front of `text` and writes JSON to `out`.
struct Transcoder<'a> {
    text: &'a str,
    /// Offset of the next byte to read, always between two characters.
    at: usize,
    depth: usize,
    out: String,
}

impl<'a> Transcoder<'a> {
    fn value(&mut self) -> Step {
        match self.token() {
            Some(b'(') => self.tuple(),
            Some(b'[') => self.bracketed(b']', Self::value),
            Some(b'{') => self.bracketed(b'}', Self::entry),
            Some(b'\'' | b'"' | b'u' | b'U') => self.string(),
            Some(b'0'..=b'9' | b'-' | b'+' | b'.') => self.number(),
            _ => self.word(),
        }
    }

    /// Reads a tuple, or a value in parentheses: only a comma tells the two apart.
    fn tuple(&mut self) -> Step {
        let begin = self.out.len();
        self.out.push('[');
        if self.items(b')', Self::value)? == (1, 0) {
            self.out.remove(begin);
        } else {
            self.out.push(']');
        }
        Ok(())
    }

    /// Reads a list or a dict, whose brackets are JSON's.
    fn bracketed(&mut self, close: u8, item: fn(&mut Self) -> Step) -> Step {
        self.out.push(if close == b']' { '[' } else { '{' });
        self.items(close, item)?;
        self.out.push(char::from(close));
        Ok(())
    }

    fn entry(&mut self) -> Step {
        self.string()?;
        self.token();
        if !self.eat(b':') {
            return Err(self.expected("':'"));
        }
        self.out.push(':');
        self.value()
    }

    fn string(&mut self) -> Step {
        let unicode = self.eat(b'u') || self.eat(b'U');
        let Some(quote @ (b'\'' | b'"')) = self.peek() else { return Err(self.expected("a string")) };
        self.at += 1;
        let mut text = String::new();
        while !self.eat(quote) {
            if !unicode && self.rest().starts_with("\\x") {
                self.bytes(&mut text)?;
            } else {
                text.push(self.char()?);
            }
        }
        self.out.push_str(&Value::from(text).to_string());
        Ok(())
    }

    /// Reads adjacent `\xNN`.
    fn bytes(&mut self, out: &mut String) -> Step {
        let mut bytes = Vec::new();
        while self.rest().starts_with("\\x") {
            self.at += 2;
            bytes.extend(u8::try_from(self.hex(2)?));
        }
        match std::str::from_utf8(&bytes) {
            Ok(text) => out.push_str(text),
            Err(_) => out.extend(bytes.into_iter().map(char::from)),
        }
        Ok(())
    }

    fn char(&mut self) -> Result<char, PythonError> {
        let begin = self.at;
        match self.next_char()? {
            '\\' => {}
            c => return Ok(c),
        }
        match self.next_char()? {
            c @ ('\\' | '\'' | '"') => Ok(c),
            'n' => Ok('\n'),
            't' => Ok('\t'),
            'r' => Ok('\r'),
            'x' => self.hex(2).and_then(|code| Self::code_point(code, begin)),
            'u' => self.utf16(begin),
            'U' => self.hex(8).and_then(|code| Self::code_point(code, begin)),
            _ => Err(PythonError { position: begin, expected: "an escape" }),
        }
    }

    /// Reads an opening bracket and what follows, up to and with `close`; writes only the items and commas.
    /// Returns the numbers of items and of commas.
    fn items(&mut self, close: u8, item: fn(&mut Self) -> Step) -> Result<(usize, usize), PythonError> {
        if self.depth >= MAX_DEPTH {
            return Err(self.expected("no more than 64 open brackets"));
        }
        self.depth += 1;
        self.at += 1;
        let (mut count, mut commas) = (0, 0);
        while self.token() != Some(close) {
            if commas < count {
                return Err(self.expected(comma_or(close)));
            }
            if count > 0 {
                self.out.push(',');
            }
            item(self)?;
            count += 1;
            self.token();
            commas += usize::from(self.eat(b','));
        }
        self.at += 1;
        self.depth -= 1;
        Ok((count, commas))
    }

    /// Reads a word and writes that of JSON.
    fn word(&mut self) -> Step {
        let words = [("True", "true"), ("False", "false"), ("None", "null")];
        let Some((read, written)) = words.into_iter().find(|(read, _)| self.rest().starts_with(read)) else {
            return Err(self.expected("a value"));
        };
        self.at += read.len();
        self.out.push_str(written);
        Ok(())
    }

    /// Copies a number, without a `+`, with a digit on both sides of its point, and without a final `L`.
    fn number(&mut self) -> Step {
        let (begin, written) = (self.at, self.out.len());
        if !self.copy(b"-") {
            self.eat(b'+');
        }
        self.whole()?;
        let fraction = self.fraction();
        let exponent = self.exponent()?;
        if !self.out[written..].parse().is_ok_and(f64::is_finite) {
            return Err(PythonError { position: begin, expected: "a finite number" });
        }
        if !fraction && !exponent && !self.eat(b'L') {
            self.eat(b'l');
        }
        Ok(())
    }

    fn whole(&mut self) -> Step {
        let begin = self.at;
        if matches!(self.rest().as_bytes(), [b'.', b'0'..=b'9', ..]) {
            self.out.push('0');
            return Ok(());
        }
        let zero = self.peek() == Some(b'0');
        match self.digits() {
            0 => Err(self.expected("a digit")),
            2.. if zero => Err(PythonError { position: begin, expected: "a number without leading zeros" }),
            _ => Ok(()),
        }
    }

    /// Copies the point and the digits after it; false if there is none.
    fn fraction(&mut self) -> bool {
        if !self.copy(b".") {
            return false;
        }
        if self.digits() == 0 {
            self.out.push('0');
        }
        true
    }

    /// Copies the exponent; false if there is none.
    fn exponent(&mut self) -> Result<bool, PythonError> {
        if !self.copy(b"eE") {
            return Ok(false);
        }
        self.copy(b"+-");
        if self.digits() == 0 { Err(self.expected("a digit")) } else { Ok(true) }
    }

    /// Copies decimal digits and counts them.
    fn digits(&mut self) -> usize {
        let begin = self.at;
        while self.copy(b"0123456789") {}
        self.at - begin
    }

    /// Copies the next byte if it is one of these.
    fn copy(&mut self, wanted: &[u8]) -> bool {
        match self.peek() {
            Some(byte) if wanted.contains(&byte) => {
                self.at += 1;
                self.out.push(char::from(byte));
                true
            }
            _ => false,
        }
    }

    fn hex(&mut self, digits: u32) -> Result<u32, PythonError> {
        let mut code = 0;
        for _ in 0..digits {
            let digit = self.peek().and_then(|byte| char::from(byte).to_digit(16));
            code = code << 4 | digit.ok_or_else(|| self.expected("a hexadecimal digit"))?;
            self.at += 1;
        }
        Ok(code)
    }

    /// Reads the digits of `\uNNNN`, and a second escape if the first is half of a pair.
    fn utf16(&mut self, begin: usize) -> Result<char, PythonError> {
        let mut code = self.hex(4)?;
        if (0xd800..0xdc00).contains(&code) && self.rest().starts_with("\\u") {
            self.at += 2;
            let low = self.hex(4)?;
            if (0xdc00..0xe000).contains(&low) {
                code = 0x1_0000 + ((code - 0xd800) << 10) + (low - 0xdc00);
            }
        }
        Self::code_point(code, begin)
    }

    fn code_point(code: u32, begin: usize) -> Result<char, PythonError> {
        char::from_u32(code).ok_or(PythonError { position: begin, expected: "an escape of a character" })
    }

    fn next_char(&mut self) -> Result<char, PythonError> {
        let c = self.rest().chars().next().ok_or_else(|| self.expected("a closing quote"))?;
        self.at += c.len_utf8();
        Ok(c)
    }

    /// Skips white space and looks at what follows.
    fn token(&mut self) -> Option<u8> {
        while let Some(b' ' | b'\t' | b'\r' | b'\n') = self.peek() {
            self.at += 1;
        }
        self.peek()
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn eat(&mut self, byte: u8) -> bool {
        let eaten = self.peek() == Some(byte);
        self.at += usize::from(eaten);
        eaten
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn expected(&self, expected: &'static str) -> PythonError {
        PythonError { position: self.at, expected }
    }
}

fn comma_or(close: u8) -> &'static str {
    match close {
        b')' => "',' or ')'",
        b']' => "',' or ']'",
        _ => "',' or '}'",
    }
}

#[cfg(test)]
mod tests;
