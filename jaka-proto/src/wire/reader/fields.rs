//! Objects by the keys of their type, and arrays by the places of their elements.

use super::{Decode, DecodeError, Reader, Writer};
use crate::near::plain_text;

/// The keys of a type, on the way through an object.
#[derive(Debug)]
pub struct Keys {
    /// Each with its quotes and colon.
    names: &'static [&'static str],
    /// The place of the key found last.
    found: usize,
    /// A bit for each key that came with a value, where values are read in place.
    seen: u128,
    /// Whether values of keys that the type does not know are captured.
    pub(super) captures: bool,
    /// Whether a value that does not fit is left out: so it is in a status packet.
    pub(super) lenient: bool,
}

impl Keys {
    /// Empties the slot of a key that did not come.
    #[inline]
    pub fn absent<T>(&self, at: usize, slot: &mut Option<T>) {
        if self.seen >> at & 1 == 0 {
            *slot = None;
        }
    }

    /// Fails for a key that did not come.
    ///
    /// # Errors
    /// The key is missing.
    #[inline]
    pub fn required(&self, at: usize, name: &'static str, key: &'static str) -> Result<(), DecodeError> {
        if self.seen >> at & 1 == 0 { Err(DecodeError::missing(name, key)) } else { Ok(()) }
    }

    /// Whether the key found last had a value before.
    #[inline]
    pub(super) fn has_seen(&self) -> bool {
        self.seen >> self.found & 1 == 1
    }

    /// Notes that the key found last has a value.
    #[inline]
    pub(super) fn note(&mut self) {
        self.seen |= 1 << self.found;
    }

    /// The place of the key with which `text` begins, if it is written as usual.
    #[inline]
    fn place_of_usual(&self, text: &[u8]) -> Option<usize> {
        self.names.iter().position(|name| begins_with(text, name))
    }

    /// The place of a key that may be written in any way; the one after the last if the type does not know it.
    #[cold]
    fn place_of_any(&self, key: &str) -> usize {
        let mut quoted = Writer::new();
        quoted.text(key);
        quoted.raw(":");
        self.names.iter().position(|name| *name == quoted.as_str()).unwrap_or(self.names.len())
    }
}

impl Reader<'_> {
    /// Enters an object whose keys are these, each given with its quotes and colon.
    ///
    /// # Errors
    /// The next value is not an object.
    pub fn begin_fields(&mut self, names: &'static [&'static str]) -> Result<Keys, DecodeError> {
        self.begin_object()?;
        Ok(Keys { names, found: usize::MAX, seen: 0, captures: self.capture.enter(), lenient: false })
    }

    /// Goes to the next key, and returns its place among those of the type: the one after the last for any other key.
    /// `None` after the object's end.
    ///
    /// # Errors
    /// The text is not JSON.
    pub fn next_field(&mut self, keys: &mut Keys) -> Result<Option<usize>, DecodeError> {
        self.find_field(keys)
    }

    /// Finds the next key for [`next_field`](Self::next_field) and [`next_wanted`](Self::next_wanted).
    #[expect(clippy::inline_always, reason = "a choice of keys out of a packet takes a tenth longer otherwise")]
    #[inline(always)]
    fn find_field(&mut self, keys: &mut Keys) -> Result<Option<usize>, DecodeError> {
        while self.next(b'}', "`,` or `}`")? {
            // Most often it is the key after the last one, and needs no search.
            let guess = keys.found.wrapping_add(1);
            if let Some(name) = keys.names.get(guess).filter(|name| begins_with(self.rest(), name)) {
                self.at += name.len();
                keys.found = guess;
                return Ok(Some(guess));
            }
            if keys.captures && self.capture_next()? {
                continue;
            }
            if let Some(place) = keys.place_of_usual(self.rest()) {
                self.at += keys.names[place].len();
                keys.found = place;
                return Ok(Some(place));
            }
            if self.pass_usual_key() {
                return Ok(Some(keys.names.len()));
            }
            let place = self.unusual_key(keys)?;
            keys.found = place;
            return Ok(Some(place));
        }
        Ok(None)
    }

    /// Goes to the next key that is one of the type's, and [passes](Self::pass) over the values of others.
    ///
    /// # Errors
    /// The text is not JSON, as far as it is read.
    pub fn next_wanted(&mut self, keys: &mut Keys) -> Result<Option<usize>, DecodeError> {
        while let Some(place) = self.find_field(keys)? {
            if place < keys.names.len() {
                return Ok(Some(place));
            }
            let start = self.mark();
            if self.pass().is_err() {
                self.pass_odd(keys, start)?;
            }
        }
        Ok(None)
    }

    /// Skips a key that the type does not have, if it is written as usual.
    #[inline]
    fn pass_usual_key(&mut self) -> bool {
        let Some((b'"', text)) = self.rest().split_first() else { return false };
        let Some(len) = plain_text(text) else { return false };
        let is_usual = text.get(len + 1) == Some(&b':');
        self.at += if is_usual { len + 3 } else { 0 };
        is_usual
    }

    /// Reads a key that may be written with escapes, with a bare control character, or with white space before its
    /// colon.
    #[inline(never)]
    fn unusual_key(&mut self, keys: &Keys) -> Result<usize, DecodeError> {
        if keys.captures {
            // It may be a key that is captured: the caller reads the text in another way.
            return Err(self.malformed("a key in its usual form"));
        }
        let key = self.key()?;
        Ok(keys.place_of_any(&key))
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

    pub(in crate::wire) fn field_with<T>(
        &mut self,
        name: &'static str,
        slot: &mut Option<T>,
        decode: impl FnOnce(&mut Self) -> Result<T, DecodeError>,
    ) -> Result<(), DecodeError> {
        if slot.is_some() {
            return Err(repeated(name));
        }
        if !self.null() {
            *slot = Some(decode(self).map_err(|error| error.in_field(name))?);
        }
        Ok(())
    }

    /// Reads a field's value over what the slot held before. A null counts as absent.
    ///
    /// # Errors
    /// The value does not fit, or the key has come before.
    pub fn field_into<T: Decode>(
        &mut self,
        name: &'static str,
        slot: &mut Option<T>,
        keys: &mut Keys,
    ) -> Result<(), DecodeError> {
        if keys.has_seen() {
            return Err(repeated(name));
        }
        if !self.null() {
            keys.note();
            match slot {
                Some(value) => value.decode_into(self),
                None => T::decode(self).map(|value| *slot = Some(value)),
            }
            .map_err(|error| error.in_field(name))?;
        }
        Ok(())
    }

    /// Reads the value of a field that may not be absent, as [`field_into`](Self::field_into) does.
    ///
    /// # Errors
    /// As [`field_into`](Self::field_into).
    pub fn required_into<T: Decode>(
        &mut self,
        name: &'static str,
        slot: &mut T,
        keys: &mut Keys,
    ) -> Result<(), DecodeError> {
        if keys.has_seen() {
            return Err(repeated(name));
        }
        if !self.null() {
            keys.note();
            slot.decode_into(self).map_err(|error| error.in_field(name))?;
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
        if !self.at_element()? || self.null() {
            return Ok(None);
        }
        T::decode(self).map(Some).map_err(|error| error.in_field(name))
    }

    /// Reads the next element of an array, which must be there, over what was in its place.
    ///
    /// # Errors
    /// As [`element`](Self::element).
    pub fn element_into<T: Decode>(&mut self, name: &'static str, slot: &mut T) -> Result<(), DecodeError> {
        if !self.at_element()? || self.null() {
            return Err(DecodeError::missing(name, ""));
        }
        slot.decode_into(self).map_err(|error| error.in_field(name))
    }

    /// Reads the next element of an array over what was in its place, if there is one and it is not null.
    ///
    /// # Errors
    /// The element does not fit.
    pub fn optional_element_into<T: Decode>(
        &mut self,
        name: &'static str,
        slot: &mut Option<T>,
    ) -> Result<(), DecodeError> {
        *slot = self.optional_element(name)?;
        Ok(())
    }

    /// Goes to the next element of an array. After the last, the bracket is left in place: further optional elements
    /// see it too.
    #[inline]
    fn at_element(&mut self) -> Result<bool, DecodeError> {
        if self.peek() == Some(b']') { Ok(false) } else { self.next_element() }
    }

    /// Leaves an array; elements that the type does not know are skipped.
    ///
    /// # Errors
    /// The text is not JSON.
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
        let start = self.mark();
        let mut tag = None;
        self.begin_object()?;
        while let Some(found) = self.next_key()? {
            if found == key { self.field(name, &mut tag)? } else { self.skip()? }
        }
        self.go_back(start);
        tag.ok_or_else(|| DecodeError::missing(name, key))
    }
}

/// Whether `text` begins with a quoted key; the byte after the quote saves most comparisons.
#[inline]
fn begins_with(text: &[u8], key: &str) -> bool {
    text.get(1) == key.as_bytes().get(1) && text.starts_with(key.as_bytes())
}

#[cold]
pub(super) fn repeated(name: &'static str) -> DecodeError {
    DecodeError::repeated().in_field(name)
}
