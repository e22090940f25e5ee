//! The notation of types: `int`, `float[6]`, `Pose[]`, `python(ExtioStatus)`.

use crate::names::is_camel;
use crate::{Scalar, Type, TypeId};

/// Greatest number of brackets and `python(…)` in a type.
const MOST_LEVELS: usize = 4;

/// Reads a type, or returns its mistake; `id` gives the id of a named type.
pub(crate) fn parse(text: &str, id: &mut impl FnMut(&str) -> TypeId) -> Result<Type, String> {
    let levels = text.matches(['[', '(']).count();
    if levels > MOST_LEVELS {
        return Err(format!("a type has at most {MOST_LEVELS} brackets"));
    }
    nested(text, id)
}

fn nested(text: &str, id: &mut impl FnMut(&str) -> TypeId) -> Result<Type, String> {
    if let Some(inner) = text.strip_suffix(']') {
        let (element, len) = inner.rsplit_once('[').ok_or_else(|| unknown(text))?;
        let element = Box::new(nested(element, id)?);
        return match len {
            "" => Ok(Type::List(element)),
            len => match len.parse() {
                Ok(len @ 1..=64) => Ok(Type::Array(element, len)),
                _ => Err(format!("`{len}` is not an array length from 1 to 64")),
            },
        };
    }
    if let Some(inner) = text.strip_prefix("python(") {
        let inner = inner.strip_suffix(')').ok_or_else(|| unknown(text))?;
        return Ok(Type::Python(Box::new(nested(inner, id)?)));
    }
    match Scalar::named(text) {
        Some(scalar) => Ok(Type::Scalar(scalar)),
        None if is_camel(text) => Ok(Type::Named(id(text))),
        None => Err(unknown(text)),
    }
}

fn unknown(text: &str) -> String {
    format!(
        "`{text}` is not a type; a type is bool, int, float, text, json, the name of a `[[type]]`, \
         one of these with `[]` or `[6]` after it, or python(…) around one"
    )
}

/// The notation of a type; `name` gives the name of a named type.
pub(crate) fn notation<'n>(ty: &Type, name: &dyn Fn(TypeId) -> &'n str) -> String {
    match ty {
        Type::Scalar(scalar) => scalar.name().to_owned(),
        Type::Named(id) => name(*id).to_owned(),
        Type::List(element) => format!("{}[]", notation(element, name)),
        Type::Array(element, len) => format!("{}[{len}]", notation(element, name)),
        Type::Python(inner) => format!("python({})", notation(inner, name)),
    }
}
