//! Values of any shape.

use serde_json::{Map, Value};

use super::number::whole;
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

/// Any JSON, to 64 levels of nesting. A key that comes twice in an object is an error, and so is a fraction that a
/// float rounds to a whole number.
impl Decode for Value {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        reader.not_too_deep()?;
        if reader.is_array() {
            return reader.nested(Vec::decode).map(Self::Array);
        }
        if reader.is_object() {
            return reader.nested(read_object).map(Self::Object);
        }
        if reader.is_text() {
            return String::decode(reader).map(Self::String);
        }
        let raw = reader.raw()?;
        let value = serde_json::from_str(raw).map_err(|error| DecodeError::unfit(format!("JSON ({error})"), raw))?;
        if is_rounded(&value, raw) { Err(DecodeError::unfit("a number that a float holds", raw)) } else { Ok(value) }
    }

    /// Only strings, and arrays inside arrays, are used again: the shape is not known.
    fn decode_into(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        reader.not_too_deep()?;
        match self {
            Self::String(text) if reader.is_text() => text.decode_into(reader),
            // The earlier value may nest as deep, and no deeper.
            Self::Array(list) if reader.is_array() => reader.nested(|reader| list.decode_into(reader)),
            _ => {
                *self = Self::decode(reader)?;
                Ok(())
            }
        }
    }
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

/// Whether a number has become a whole one that it is not, such as 1e-400.
fn is_rounded(value: &Value, raw: &str) -> bool {
    /// From here on every float is whole.
    const WHOLE: f64 = 9_007_199_254_740_992.0;
    let float = value.as_f64().filter(|_| value.is_f64());
    float.is_some_and(|float| float.fract() == 0.0 && float.abs() < WHOLE && whole(raw).is_none())
}

fn read_object(reader: &mut Reader<'_>) -> Result<Map<String, Value>, DecodeError> {
    let mut object = Map::new();
    reader.begin_object()?;
    while let Some(key) = reader.next_key()? {
        let value = Value::decode(reader).map_err(|error| error.in_field(&key))?;
        if object.contains_key(&*key) {
            return Err(DecodeError::repeated().in_field(&key));
        }
        object.insert(key.into_owned(), value);
    }
    Ok(object)
}
