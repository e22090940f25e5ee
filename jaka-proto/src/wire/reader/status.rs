//! Status packets: fields that do not fit are left out, and the packet stays.

use super::fields::repeated;
use super::{Decode, DecodeError, Keys, Mark, Reader};

impl Reader<'_> {
    /// Enters an object whose fields are left out where they do not fit, if it is a whole message other than a reply:
    /// inside another message nothing is left out.
    ///
    /// # Errors
    /// The next value is not an object.
    pub fn begin_status(&mut self, names: &'static [&'static str]) -> Result<Keys, DecodeError> {
        self.peek();
        let is_message = self.text[..self.at].trim_ascii().is_empty();
        let mut keys = self.begin_fields(names)?;
        keys.lenient = is_message && !keys.captures;
        Ok(keys)
    }

    /// The fields that were left out of a status packet, each once, with what was expected and what was found. They are
    /// reported once.
    ///
    /// ```
    /// use jaka_proto::messages::status::RobotStatus;
    /// use jaka_proto::wire::{Decode, Reader};
    ///
    /// let mut reader = Reader::new(r#"{"len": 50, "rapidrate": "100%", "protective_stop": 1}"#);
    /// let status = RobotStatus::decode(&mut reader)?;
    /// assert_eq!((status.rapid_rate, status.protective_stop), (None, Some(true)));
    ///
    /// let unfit = reader.take_unfit();
    /// assert_eq!(unfit[0].to_string(), "field `rapid_rate`: expected a number, found `\"100%\"`");
    /// # Ok::<(), jaka_proto::wire::DecodeError>(())
    /// ```
    pub fn take_unfit(&mut self) -> Vec<DecodeError> {
        std::mem::take(&mut self.left_out)
    }

    /// Reads a status field's value over what the slot held before. A null counts as absent, and so does a value that
    /// does not fit, or a key that comes twice.
    ///
    /// # Errors
    /// It is not clear where the value ends.
    pub fn status_field_into<T: Decode>(
        &mut self,
        name: &'static str,
        slot: &mut Option<T>,
        keys: &mut Keys,
    ) -> Result<(), DecodeError> {
        let start = self.mark();
        if keys.has_seen() {
            return self.leave_out(slot, repeated(name), keys, start);
        }
        if self.null() && self.is_delimited() {
            return Ok(());
        }
        self.go_back(start);
        keys.note();
        let read = match slot {
            Some(value) => value.decode_into(self),
            None => T::decode(self).map(|value| *slot = Some(value)),
        };
        match read {
            Ok(()) if self.is_delimited() => Ok(()),
            Ok(()) => self.leave_out(slot, self.malformed("`,` or `}`").in_field(name), keys, start),
            Err(error) => self.leave_out(slot, error.in_field(name), keys, start),
        }
    }

    /// Reads a status field's value into its slot, in the way of `read`; otherwise as
    /// [`status_field_into`](Self::status_field_into).
    ///
    /// # Errors
    /// It is not clear where the value ends.
    pub fn status_field<T>(
        &mut self,
        name: &'static str,
        slot: &mut Option<T>,
        keys: &Keys,
        read: impl FnOnce(&mut Self, &mut Option<T>) -> Result<(), DecodeError>,
    ) -> Result<(), DecodeError> {
        let start = self.mark();
        match read(self, slot) {
            Ok(()) if self.is_delimited() && !self.has_left_out(name) => Ok(()),
            Ok(()) => self.leave_out(slot, self.malformed("`,` or `}`").in_field(name), keys, start),
            Err(error) => self.leave_out(slot, error, keys, start),
        }
    }

    /// Skips the value of a key that the type does not know, whatever it is.
    ///
    /// # Errors
    /// It is not clear where the value ends.
    pub fn skip_unknown(&mut self, keys: &Keys) -> Result<(), DecodeError> {
        let start = self.mark();
        match self.skip() {
            Ok(()) if self.is_delimited() => Ok(()),
            _ => self.pass_odd(keys, start),
        }
    }

    /// Empties the slot of a field, and passes over its value.
    #[cold]
    fn leave_out<T>(
        &mut self,
        slot: &mut Option<T>,
        error: DecodeError,
        keys: &Keys,
        start: Mark,
    ) -> Result<(), DecodeError> {
        *slot = None;
        if !keys.lenient {
            return Err(error);
        }
        self.pass_odd(keys, start)?;
        if !self.has_left_out(error.field()) {
            self.left_out.push(error);
        }
        Ok(())
    }

    fn has_left_out(&self, field: &str) -> bool {
        let outermost = field.split(['.', '[']).next().unwrap_or_default();
        self.left_out.iter().any(|error| error.is_in(outermost))
    }

    /// Whether the object that has been entered ends or goes on here.
    #[inline]
    pub(super) fn is_delimited(&mut self) -> bool {
        matches!(self.peek(), Some(b',' | b'}'))
    }

    /// Passes over a value of an object by its quotes and brackets alone, whatever stands between them.
    ///
    /// # Errors
    /// The object is to be read strictly, or brackets do not match, or something else follows than the next key.
    #[cold]
    pub(super) fn pass_odd(&mut self, keys: &Keys, start: Mark) -> Result<(), DecodeError> {
        self.go_back(start);
        if !keys.lenient {
            return self.skip();
        }
        self.odd_value().map(drop)
    }
}
