//! Values that are taken on the way through an object of a type that does not know their keys.

use super::{DecodeError, Reader};

/// Takes the next key and its value, by [`Reader::eat_key`] and [`Reader::keep`]; false if it is another key, which is
/// then where it was.
///
/// # Errors
/// The value is not to be taken so: the caller reads the text in another way.
pub(crate) type Take<'a> = fn(&mut Reader<'a>) -> Result<bool, DecodeError>;

/// Greatest number of values that can be taken.
const COUNT: usize = 3;

/// Function that takes values, and the values that it has taken.
#[derive(Debug, Clone)]
pub(super) struct Capture<'a> {
    take: Take<'a>,
    values: [Option<&'a str>; COUNT],
    /// True up to the outermost object: the objects inside it have other keys.
    wanted: bool,
}

impl Capture<'_> {
    /// Nothing is taken.
    pub(super) const NONE: Self = Self { take: |_| Ok(false), values: [None; COUNT], wanted: false };

    /// True for the first object that is entered, if something is taken.
    #[inline]
    pub(super) fn enter(&mut self) -> bool {
        std::mem::take(&mut self.wanted)
    }
}

impl<'a> Reader<'a> {
    /// Reads from the beginning of `text`, and has `take` take values of the outermost object.
    pub(crate) fn capturing(text: &'a str, take: Take<'a>) -> Self {
        let mut reader = Self::new(text);
        (reader.capture.take, reader.capture.wanted) = (take, true);
        reader
    }

    /// Takes the next key and its value, if it is one that is taken.
    ///
    /// Not inlined: readers of types from which nothing is taken would be slower.
    #[inline(never)]
    pub(super) fn capture_next(&mut self) -> Result<bool, DecodeError> {
        (self.capture.take)(self)
    }

    /// The values that were taken.
    pub(crate) fn captured(&self) -> [Option<&'a str>; COUNT] {
        self.capture.values
    }

    /// Goes over a key, given with its quotes and colon, if it is the next.
    #[inline]
    pub(crate) fn eat_key(&mut self, quoted: &str) -> bool {
        let eaten = self.rest().starts_with(quoted.as_bytes());
        self.at += if eaten { quoted.len() } else { 0 };
        eaten
    }

    /// Keeps a value in one of the places for those that are taken.
    ///
    /// # Errors
    /// There is none, or the place is taken: the key has come before.
    #[inline]
    pub(crate) fn keep(&mut self, place: usize, value: Option<&'a str>) -> Result<bool, DecodeError> {
        let value = value.ok_or_else(|| self.malformed("a value in its usual form"))?;
        let before = self.capture.values[place].replace(value);
        if before.is_some() { Err(DecodeError::repeated()) } else { Ok(true) }
    }

    /// The raw text of a string without escapes, or of a number, if that is the next value.
    pub(crate) fn usual_scalar(&mut self) -> Option<&'a str> {
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
