//! Values of some keys, taken on the way through an object of a type that does not know these keys.

use super::fields::begins_with;
use super::{DecodeError, Reader};

/// How many keys can be captured.
const COUNT: usize = 3;

/// The keys whose values are captured, and the values as far as they have come.
#[derive(Debug, Clone)]
pub(super) struct Capture<'a> {
    /// Each with its quotes and colon.
    keys: &'static [&'static str; COUNT],
    /// The raw text of each value.
    values: [Option<&'a str>; COUNT],
    /// The place of the key that usually comes next.
    next: usize,
    /// True up to the outermost object: the objects inside it have other keys.
    wanted: bool,
}

impl Capture<'_> {
    /// Nothing is captured.
    pub(super) const NONE: Self = Self { keys: &[""; COUNT], values: [None; COUNT], next: 0, wanted: false };

    /// True for the first object that is entered, if something is captured.
    #[inline]
    pub(super) fn enter(&mut self) -> bool {
        std::mem::take(&mut self.wanted)
    }

    /// The place of the key with which `text` begins.
    #[inline]
    fn place(&self, text: &[u8]) -> Option<usize> {
        match self.keys.get(self.next) {
            Some(key) if begins_with(text, key) => Some(self.next),
            _ => self.keys.iter().position(|key| begins_with(text, key)),
        }
    }
}

impl<'a> Reader<'a> {
    /// Reads from the beginning of `text`, and captures the values of these keys of the outermost object, each given with its
    /// quotes and colon, as far as keys and values are written in their usual form: strings without escapes, and numbers. Any other
    /// form of them is an error.
    pub(crate) fn capturing(text: &'a str, keys: &'static [&'static str; COUNT]) -> Self {
        let mut reader = Self::new(text);
        (reader.capture.keys, reader.capture.wanted) = (keys, true);
        reader
    }

    /// The raw text of each captured value.
    pub(crate) fn captured(&self) -> [Option<&'a str>; COUNT] {
        self.capture.values
    }

    /// Captures the next key's value; false if another key comes, or one of these in an unusual form.
    ///
    /// # Errors
    /// The value is not written as usual, or the key has come before.
    pub(super) fn capture_value(&mut self) -> Result<bool, DecodeError> {
        let Some(place) = self.capture.place(self.rest()) else { return Ok(false) };
        self.at += self.capture.keys[place].len();
        self.capture.next = place + 1;
        let value = self.usual_value().ok_or_else(|| self.malformed("a string or a number in its usual form"))?;
        if self.capture.values[place].replace(value).is_some() { Err(DecodeError::repeated()) } else { Ok(true) }
    }

    /// The raw text of a string without escapes or of a number, if that is the next value.
    #[inline]
    fn usual_value(&mut self) -> Option<&'a str> {
        match self.peek()? {
            b'"' => {
                let start = self.at;
                self.usual_text()?;
                self.text.get(start..self.at)
            }
            b'-' | b'0'..=b'9' => Some(self.number()),
            _ => None,
        }
    }
}
