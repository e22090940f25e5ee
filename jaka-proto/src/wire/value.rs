//! Values of any shape.

use serde_json::{Map, Value};

use super::number::whole;
use super::reader::MAX_DEPTH;
use super::{Decode, DecodeError, Reader};

/// Any JSON, to 64 levels of nesting. A key that comes twice in an object is an error, and so is a fraction that a float rounds
/// to a whole number.
impl Decode for Value {
    fn decode(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        read(reader, 0)
    }

    /// Only strings, and arrays inside arrays, are used again: the shape is not known.
    fn decode_into(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        read_into(self, reader, 0)
    }
}

fn read(reader: &mut Reader<'_>, depth: u32) -> Result<Value, DecodeError> {
    if depth > MAX_DEPTH {
        return Err(reader.too_deep());
    }
    if reader.is_array() {
        let mut list = Vec::new();
        read_list(&mut list, reader, depth)?;
        return Ok(Value::Array(list));
    }
    if reader.is_object() {
        return read_object(reader, depth).map(Value::Object);
    }
    if reader.is_text() {
        return String::decode(reader).map(Value::String);
    }
    let raw = reader.raw()?;
    let value = serde_json::from_str(raw).map_err(|error| DecodeError::unfit(format!("JSON ({error})"), raw))?;
    if is_rounded(&value, raw) { Err(DecodeError::unfit("a number that a float holds", raw)) } else { Ok(value) }
}

/// Whether a number has become a whole one that it is not, such as 1e-400.
fn is_rounded(value: &Value, raw: &str) -> bool {
    /// From here on every float is whole.
    const WHOLE: f64 = 9_007_199_254_740_992.0;
    let float = value.as_f64().filter(|_| value.is_f64());
    float.is_some_and(|float| float.fract() == 0.0 && float.abs() < WHOLE && whole(raw).is_none())
}

/// The depth is that of the value: what was there before may nest as deep, and no deeper.
fn read_into(value: &mut Value, reader: &mut Reader<'_>, depth: u32) -> Result<(), DecodeError> {
    if depth > MAX_DEPTH {
        return Err(reader.too_deep());
    }
    match value {
        Value::String(text) if reader.is_text() => text.decode_into(reader),
        Value::Array(list) if reader.is_array() => read_list(list, reader, depth),
        _ => {
            *value = read(reader, depth)?;
            Ok(())
        }
    }
}

fn read_list(list: &mut Vec<Value>, reader: &mut Reader<'_>, depth: u32) -> Result<(), DecodeError> {
    let mut len = 0;
    reader.begin_array()?;
    while reader.next_element()? {
        let element = match list.get_mut(len) {
            Some(value) => read_into(value, reader, depth + 1),
            None => read(reader, depth + 1).map(|value| list.push(value)),
        };
        element.map_err(|error| error.in_element(len))?;
        len += 1;
    }
    list.truncate(len);
    Ok(())
}

fn read_object(reader: &mut Reader<'_>, depth: u32) -> Result<Map<String, Value>, DecodeError> {
    let mut object = Map::new();
    reader.begin_object()?;
    while let Some(key) = reader.next_key()? {
        let value = read(reader, depth + 1).map_err(|error| error.in_field(&key))?;
        if object.contains_key(&*key) {
            return Err(DecodeError::repeated().in_field(&key));
        }
        object.insert(key.into_owned(), value);
    }
    Ok(object)
}
