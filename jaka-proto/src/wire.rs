//! The JSON of the wire: a writer, a lenient reader, and the traits that tie them to types.
//!
//! Generated types implement [`Encode`] and [`Decode`], and through them serde's traits: the serde form of a type is
//! its JSON on the wire. Users meet this module where a value is kept raw ([`Typed`], [`Value`]), and when they decode
//! replies into types of their own.

mod decode;
mod encode;
mod error;
mod number;
pub mod python;
mod reader;
mod serde_impls;
mod typed;
mod value;
mod writer;

pub use decode::Decode;
pub use encode::Encode;
pub use error::DecodeError;
pub use reader::{Keys, Reader};
pub(crate) use reader::{lossy_text, read_message, trimmed};
#[doc(hidden)]
pub use serde_impls::{deserialize, serialize};
pub use typed::Typed;
pub use writer::Writer;

/// Any JSON, where the spec knows no type.
pub use serde_json::Value;

/// A struct or choice whose fields stand directly in a JSON object: a request, a reply, or a type inside one.
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

    /// Reads the whole object over another one, whose memory is used again. After an error, what is there means nothing.
    ///
    /// # Errors
    /// As [`read_fields`](Self::read_fields).
    fn read_fields_into(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        *self = Self::read_fields(reader)?;
        Ok(())
    }
}

/// No fields: the reply of a command that answers nothing but its success.
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
