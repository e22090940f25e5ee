//! Writes JSON text.

use std::fmt::Write as _;

use serde_json::Value;

use super::Encode;

/// Writes JSON into a buffer that is reused from message to message.
#[derive(Debug, Default, Clone)]
pub struct Writer {
    text: String,
}

impl Writer {
    /// A writer with an empty buffer.
    pub fn new() -> Self {
        Self::default()
    }

    /// Empties the buffer and keeps its memory.
    pub fn clear(&mut self) {
        self.text.clear();
    }

    /// Returns the written text.
    pub fn as_str(&self) -> &str {
        &self.text
    }

    /// Converts the writer into the written text.
    #[inline]
    pub fn into_string(self) -> String {
        self.text
    }

    /// Writes text that is JSON already.
    #[inline]
    pub fn raw(&mut self, json: &str) {
        self.text.push_str(json);
    }

    /// Writes any JSON.
    pub fn json(&mut self, value: &Value) {
        // A string takes all that is written.
        let _ = write!(self.text, "{value}");
    }

    /// Writes a comma, unless an object or array begins here.
    #[inline]
    pub fn comma(&mut self) {
        if !matches!(self.text.as_bytes().last(), Some(b'{' | b'[')) {
            self.text.push(',');
        }
    }

    /// Writes a key, given with its quotes and colon, and the comma before it where one is due.
    #[inline]
    pub fn key(&mut self, quoted: &str) {
        self.comma();
        self.text.push_str(quoted);
    }

    /// Writes a number, shortest form that reads back as the same value; whole numbers without a fraction.
    ///
    /// JSON has no form for NaN and infinity: they become `null`. Requests that hold them are refused before.
    #[inline]
    pub fn float(&mut self, value: f64) {
        if !value.is_finite() {
            return self.text.push_str("null");
        }
        let mut buffer = zmij::Buffer::new();
        let text = buffer.format_finite(value);
        self.text.push_str(text.strip_suffix(".0").unwrap_or(text));
    }

    /// Writes a whole number.
    #[inline]
    pub fn int(&mut self, value: i64) {
        match u8::try_from(value) {
            // Enums, indices and switches: most numbers are one digit.
            Ok(digit @ 0..=9) => self.text.push(char::from(b'0' + digit)),
            _ => self.text.push_str(itoa::Buffer::new().format(value)),
        }
    }

    /// Writes a string with its quotes and escapes.
    pub fn text(&mut self, value: &str) {
        self.text.push('"');
        let mut rest = value;
        while let Some(at) = rest.bytes().position(|b| b < 0x20 || b == b'"' || b == b'\\') {
            self.text.push_str(&rest[..at]);
            self.escape(rest.as_bytes()[at]);
            rest = &rest[at + 1..];
        }
        self.text.push_str(rest);
        self.text.push('"');
    }

    /// Writes one of two JSON texts, for a truth value that is not written as `true` and `false`.
    #[inline]
    pub fn choose(&mut self, value: bool, off: &str, on: &str) {
        self.text.push_str(if value { on } else { off });
    }

    /// Writes an array, each element by `write`.
    #[inline]
    pub fn array<T>(&mut self, items: &[T], mut write: impl FnMut(&mut Self, &T)) {
        self.text.push('[');
        if let [first, rest @ ..] = items {
            write(self, first);
            for item in rest {
                self.text.push(',');
                write(self, item);
            }
        }
        self.text.push(']');
    }

    /// Writes a character that cannot stand in a string as it is.
    pub(super) fn escape(&mut self, byte: u8) {
        match byte {
            b'"' => self.text.push_str("\\\""),
            b'\\' => self.text.push_str("\\\\"),
            b'\n' => self.text.push_str("\\n"),
            b'\r' => self.text.push_str("\\r"),
            b'\t' => self.text.push_str("\\t"),
            other => {
                const HEX: &[u8; 16] = b"0123456789abcdef";
                self.text.push_str("\\u00");
                self.text.push(char::from(HEX[usize::from(other >> 4)]));
                self.text.push(char::from(HEX[usize::from(other & 15)]));
            }
        }
    }
}

impl Encode for f64 {
    #[inline]
    fn encode(&self, out: &mut Writer) {
        out.float(*self);
    }
}

impl Encode for i64 {
    #[inline]
    fn encode(&self, out: &mut Writer) {
        out.int(*self);
    }
}

impl Encode for bool {
    #[inline]
    fn encode(&self, out: &mut Writer) {
        out.choose(*self, "false", "true");
    }
}

impl Encode for String {
    #[inline]
    fn encode(&self, out: &mut Writer) {
        out.text(self);
    }
}

impl Encode for Value {
    fn encode(&self, out: &mut Writer) {
        out.json(self);
    }
}

impl<T: Encode> Encode for Vec<T> {
    fn encode(&self, out: &mut Writer) {
        out.array(self, |out, item| item.encode(out));
    }
}

impl<T: Encode, const N: usize> Encode for [T; N] {
    fn encode(&self, out: &mut Writer) {
        out.array(self, |out, item| item.encode(out));
    }
}
