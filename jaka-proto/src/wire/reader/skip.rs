//! Values of unknown keys.

use super::Reader;
use crate::near::first_of;
use crate::wire::error::DecodeError;
use crate::wire::number;

/// Greatest depth to which arrays and objects may nest.
pub(super) const MAX_DEPTH: u32 = 64;

impl Reader<'_> {
    /// Skips the next value, and checks that it is JSON throughout.
    ///
    /// # Errors
    /// The text is not JSON, or nests deeper than 64 levels.
    pub fn skip(&mut self) -> Result<(), DecodeError> {
        if self.tolerant { self.skip_tolerantly() } else { self.skip_strictly() }
    }

    #[inline]
    pub(super) fn skip_strictly(&mut self) -> Result<(), DecodeError> {
        self.skip_nested(0)
    }

    #[cold]
    fn skip_tolerantly(&mut self) -> Result<(), DecodeError> {
        let start = self.mark();
        if self.skip_strictly().is_ok() && matches!(self.peek(), None | Some(b',' | b'}' | b']')) {
            return Ok(());
        }
        self.go_back(start);
        self.odd_value().map(drop)
    }

    fn skip_nested(&mut self, depth: u32) -> Result<(), DecodeError> {
        if depth > MAX_DEPTH {
            return Err(self.too_deep());
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
        if number::is_number(self.number()) {
            return Ok(());
        }
        Err(DecodeError::malformed(self.text, start, "a number"))
    }

    fn skip_word(&mut self) -> Result<(), DecodeError> {
        let rest = self.rest();
        let Some(word) = ["true", "false", "null"].into_iter().find(|word| rest.starts_with(word.as_bytes())) else {
            return Err(self.malformed("a value"));
        };
        self.at += word.len();
        self.comma = true;
        Ok(())
    }

    /// Passes over the next value by its quotes and brackets alone: several times as fast as [`skip`](Self::skip), and
    /// blind to what is wrong inside.
    ///
    /// For one's own choice of keys of a status packet.
    ///
    /// # Errors
    /// The value does not end.
    #[inline]
    pub fn pass(&mut self) -> Result<(), DecodeError> {
        let end = match self.peek() {
            Some(b'{') => self.after_brackets(b'{', b'}'),
            Some(b'[') => self.after_brackets(b'[', b']'),
            Some(b'"') => after_string(self.text.as_bytes(), self.at + 1),
            Some(b'-' | b'0'..=b'9') => self.after_number(),
            _ if self.eat("false") || self.eat("true") => return Ok(()),
            _ => return self.skip_strictly(),
        };
        self.at = end.ok_or_else(|| self.malformed("a value that ends"))?;
        self.comma = true;
        Ok(())
    }

    /// Finds the end of the number that begins here; `None` if it goes on as something else.
    #[inline]
    fn after_number(&self) -> Option<usize> {
        let end = self.at + number::length(self.rest());
        let next = self.text.as_bytes().get(end);
        next.is_none_or(|next| matches!(next, b',' | b'}' | b']' | b' ' | b'\t' | b'\r' | b'\n')).then_some(end)
    }

    /// Finds the end of the array or object that begins here.
    fn after_brackets(&self, open: u8, close: u8) -> Option<usize> {
        let bytes = self.text.as_bytes();
        let mut at = self.at + 1;
        let mut depth = 1;
        while depth > 0 {
            at += first_of([b'"', open, close], bytes.get(at..)?)? + 1;
            match bytes[at - 1] {
                b'"' => at = after_string(bytes, at)?,
                bracket if bracket == open => depth += 1,
                _ => depth -= 1,
            }
        }
        Some(at)
    }
}

/// Finds the end of the string whose first character is at `at`.
pub(super) fn after_string(bytes: &[u8], mut at: usize) -> Option<usize> {
    loop {
        at += first_of(*b"\"\\", bytes.get(at..)?)? + 1;
        if bytes[at - 1] == b'"' {
            return Some(at);
        }
        at += 1;
    }
}
