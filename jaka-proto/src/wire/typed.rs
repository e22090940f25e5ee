//! Values whose shape the sources leave in doubt.

use serde_json::Value;

use super::{Decode, DecodeError, Encode, Reader, Writer};

/// A value of a documented shape, or whatever else a controller sent in its place.
///
/// Used where no source prints a whole sample: nothing is lost, and the rest of the message still decodes.
#[derive(Debug, Clone, PartialEq)]
pub enum Typed<T> {
    /// The value has the documented shape.
    Known(T),
    /// It has another shape; this is its JSON.
    Raw(Value),
}

impl<T> Typed<T> {
    /// The value, if it has the documented shape.
    pub fn known(&self) -> Option<&T> {
        match self {
            Self::Known(value) => Some(value),
            Self::Raw(_) => None,
        }
    }
}

impl<T> From<T> for Typed<T> {
    fn from(value: T) -> Self {
        Self::Known(value)
    }
}

impl<T: Encode> Encode for Typed<T> {
    fn encode(&self, out: &mut Writer) {
        match self {
            Self::Known(value) => value.encode(out),
            Self::Raw(value) => value.encode(out),
        }
    }
}

impl<T: Decode> Decode for Typed<T> {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        match reader.or_raw(T::decode)? {
            Ok(value) => Ok(Self::Known(value)),
            Err(raw) => Value::decode(&mut Reader::new(raw)).map(Self::Raw),
        }
    }

    fn decode_into(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        let Self::Known(value) = self else {
            *self = Self::decode(reader)?;
            return Ok(());
        };
        if let Err(raw) = reader.or_raw(|reader| value.decode_into(reader))? {
            *self = Self::Raw(Value::decode(&mut Reader::new(raw))?);
        }
        Ok(())
    }
}
