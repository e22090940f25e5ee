//! Search for the end of a frame by its brackets and strings, one byte at a time or many at once.

use super::is_white;
use crate::near::first_of;

/// State of the scanner within a frame.
#[derive(Debug)]
pub(super) struct Nesting {
    form: Form,
    /// Brackets open; 0 when the frame has ended.
    depth: usize,
    /// The quote that ends the string it is in.
    pub(super) quote: Option<u8>,
    /// Whether the last byte was a backslash that escapes the next.
    pub(super) escaped: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Json,
    Python,
    /// JSON with a possibly missing end.
    Status,
}

/// Result of a scan of a frame.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Scanned {
    /// Its end.
    Frame,
    /// The beginning of the next one, before its end.
    Cut,
    /// Neither: all, or all but what may be such a beginning, is inside.
    All,
}

impl Nesting {
    /// After the first byte.
    pub(super) fn new(form: Form) -> Self {
        Self { form, depth: 1, quote: None, escaped: false }
    }

    /// Visits the bytes of a frame from a place on: how many, and what was found at the end of them.
    #[inline]
    pub(super) fn find_end(&mut self, frame: &[u8], from: usize) -> (usize, Scanned) {
        let mut at = from;
        while let Some(found) = self.next_mark(&frame[at..]) {
            at += found;
            if self.form == Form::Status {
                match self.is_cut(frame, at) {
                    Some(false) => {}
                    Some(true) => return (at - from, Scanned::Cut),
                    None => return (at - from, Scanned::All),
                }
            }
            at += 1;
            if self.ends_with(frame[at - 1]) {
                return (at - from, Scanned::Frame);
            }
        }
        (frame.len() - from, Scanned::All)
    }

    /// Whether a byte may change anything.
    #[inline]
    pub(super) fn is_mark(&self, byte: u8) -> bool {
        self.escaped || matches!(byte, b'"' | b'\'' | b'\\' | b'{' | b'}' | b'(' | b')')
    }

    /// The place of the next byte that changes anything.
    #[inline]
    fn next_mark(&self, bytes: &[u8]) -> Option<usize> {
        match (self.quote, self.form) {
            (Some(_), _) if self.escaped => (!bytes.is_empty()).then_some(0),
            (Some(quote), _) => first_of([quote, b'\\'], bytes),
            (None, Form::Json | Form::Status) => first_of(*b"\"{}", bytes),
            (None, Form::Python) => first_of(*b"\"'()", bytes),
        }
    }

    /// Visits one byte; true if the frame ends with it.
    #[inline]
    fn ends_with(&mut self, byte: u8) -> bool {
        if let Some(quote) = self.quote {
            let ends = byte == quote && !self.escaped;
            self.escaped = byte == b'\\' && !self.escaped;
            if ends {
                self.quote = None;
            }
            return false;
        }
        match byte {
            b'{' | b'(' => self.depth += 1,
            b'}' | b')' => self.depth -= 1,
            quote => self.quote = Some(quote),
        }
        self.depth == 0
    }

    /// Whether another packet begins where no JSON has an object: `None` where the next bytes must tell.
    #[inline]
    fn is_cut(&self, frame: &[u8], at: usize) -> Option<bool> {
        match frame[at] {
            b'{' if self.quote.is_none() && !may_have_value(&frame[..at]) => begins_with(&frame[at + 1..], b"\"len\""),
            // In a string that has not ended, the packet's first quote seems to end it.
            b'"' if self.quote.is_some() && !self.escaped && frame[at - 1] == b'{' => {
                begins_with(&frame[at + 1..], b"len\"")
            }
            _ => Some(false),
        }
    }
}

/// Whether a value can follow in JSON.
fn may_have_value(before: &[u8]) -> bool {
    before.iter().rfind(|byte| !is_white(**byte)).is_some_and(|byte| b":,[".contains(byte))
}

/// Whether `bytes` begin so; `None` if they are too few to tell.
fn begins_with(bytes: &[u8], beginning: &[u8]) -> Option<bool> {
    let len = bytes.len().min(beginning.len());
    let begins = bytes[..len] == beginning[..len];
    (!begins || len == beginning.len()).then_some(begins)
}
