//! The JSON of the wire: a writer, a lenient reader, and the traits that tie them to types.
//!
//! Generated types implement [`Encode`] and [`Decode`], and through them serde's traits: the serde form of a type is
//! its JSON on the wire. Users need this module for raw values ([`Typed`], [`Value`]), and to decode replies into types
//! of their own.

mod decode;
mod error;
mod number;
pub mod python;
mod reader;
mod serde_impls;
mod value;
mod writer;

use decode::not_an_array_of;
pub use error::DecodeError;
pub use reader::{Keys, Reader};
pub(crate) use reader::{lossy_text, read_message, trimmed};
#[doc(hidden)]
pub use serde_impls::{deserialize, serialize};
pub use value::Typed;
pub use writer::Writer;

/// Any JSON, for values without a type in the spec.
pub use serde_json::Value;

/// A value with a JSON form on the wire.
pub trait Encode {
    /// Writes the value.
    fn encode(&self, out: &mut Writer);
}

/// A value that can be read from the wire, in any of the forms that controllers use.
pub trait Decode: Sized {
    /// Reads the value.
    ///
    /// # Errors
    /// The text is not JSON, or the value does not fit.
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError>;

    /// Reads the value over another one, and reuses its memory. After an error, the content is meaningless.
    ///
    /// # Errors
    /// As [`decode`](Self::decode).
    fn decode_into(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        *self = Self::decode(reader)?;
        Ok(())
    }

    /// Reads an array over a list, and reuses its memory.
    #[doc(hidden)]
    fn decode_list(list: &mut Vec<Self>, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        let mut len = 0;
        reader.begin_array()?;
        while reader.next_element()? {
            let decoded = match list.get_mut(len) {
                Some(value) => value.decode_into(reader),
                None => Self::decode(reader).map(|value| list.push(value)),
            };
            decoded.map_err(|error| error.in_element(len))?;
            len += 1;
        }
        list.truncate(len);
        Ok(())
    }

    /// Reads an array of exactly `N` values. Types that need no allocation for it have a way of their own.
    #[doc(hidden)]
    fn decode_array<const N: usize>(reader: &mut Reader<'_>) -> Result<[Self; N], DecodeError> {
        let start = reader.mark();
        Vec::decode(reader)?.try_into().map_err(|_| not_an_array_of(N, reader, start))
    }
}

/// A struct or choice with fields directly in a JSON object: a request, a reply, or a type inside one.
pub trait Fields: Sized {
    /// Writes the fields, without the braces around them.
    fn write_fields(&self, out: &mut Writer);

    /// Reads the whole object. Keys that the type does not know are skipped.
    ///
    /// # Errors
    /// A field is missing or does not fit its type, or the text is not a JSON object.
    fn read_fields(reader: &mut Reader<'_>) -> Result<Self, DecodeError>;

    /// The value without any field; `None` if a field is required.
    fn without_fields() -> Option<Self> {
        Self::read_fields(&mut Reader::new("{}")).ok()
    }

    /// Reads the whole object over another one, and reuses its memory. After an error, the content is meaningless.
    ///
    /// # Errors
    /// As [`read_fields`](Self::read_fields).
    fn read_fields_into(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        *self = Self::read_fields(reader)?;
        Ok(())
    }
}

/// No fields: the reply of a command that answers its success alone.
impl Fields for () {
    fn write_fields(&self, _out: &mut Writer) {}

    fn read_fields(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let mut keys = reader.begin_fields(&[])?;
        while reader.next_field(&mut keys)?.is_some() {
            reader.skip()?;
        }
        Ok(())
    }
}
