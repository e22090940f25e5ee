//! The notation of types: `int`, `float[6]`, `Pose[]`, `python(ExtioStatus)`.

use crate::Type;
use crate::names::is_camel;

/// How many brackets and `python(…)` a type may have.
const MOST_LEVELS: usize = 4;

/// Reads a type, or says what is wrong with it.
pub(crate) fn parse(text: &str) -> Result<Type, String> {
    let levels = text.matches(['[', '(']).count();
    if levels > MOST_LEVELS {
        return Err(format!("a type has at most {MOST_LEVELS} brackets"));
    }
    nested(text)
}

fn nested(text: &str) -> Result<Type, String> {
    if let Some(inner) = text.strip_suffix(']') {
        let (element, len) = inner.rsplit_once('[').ok_or_else(|| unknown(text))?;
        let element = Box::new(nested(element)?);
        return match len {
            "" => Ok(Type::List(element)),
            len => match len.parse() {
                Ok(len @ 1..=64) => Ok(Type::Array(element, len)),
                _ => Err(format!("`{len}` is no array length from 1 to 64")),
            },
        };
    }
    if let Some(inner) = text.strip_prefix("python(") {
        let inner = inner.strip_suffix(')').ok_or_else(|| unknown(text))?;
        return Ok(Type::Python(Box::new(nested(inner)?)));
    }
    match text {
        "bool" => Ok(Type::Bool { off: "false".to_owned(), on: "true".to_owned() }),
        "int" => Ok(Type::Int),
        "float" => Ok(Type::Float),
        "text" => Ok(Type::Text),
        "json" => Ok(Type::Json),
        name if is_camel(name) => Ok(Type::Named(name.to_owned())),
        _ => Err(unknown(text)),
    }
}

fn unknown(text: &str) -> String {
    format!(
        "`{text}` is no type; a type is bool, int, float, text, json, the name of a `[[type]]`, \
         one of these with `[]` or `[6]` behind it, or python(…) around one"
    )
}
