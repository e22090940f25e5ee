//! Types in words, with links to the named ones.

use super::markdown::{code, link};
use crate::{Scalar, Shape, Spec, Type};

/// The type in words, with a link to a named one.
pub(super) fn words(spec: &Spec, ty: &Type) -> String {
    match ty {
        Type::Scalar(scalar) => scalar_words(scalar)[0].clone(),
        Type::Named(id) => format!("{} ({})", name_link(&spec[*id].name), shape(spec, ty)),
        Type::List(element) => format!("array of {}", plural(spec, element)),
        Type::Array(element, len) => format!("array of {len} {}", plural(spec, element)),
        Type::Python(inner) => format!("string that holds a Python literal: {}", words(spec, inner)),
    }
}

fn plural(spec: &Spec, ty: &Type) -> String {
    match ty {
        Type::Scalar(scalar) => scalar_words(scalar)[1].clone(),
        Type::List(_) | Type::Array(..) => words(spec, ty).replacen("array", "arrays", 1),
        Type::Named(id) => format!("{} (each: {})", name_link(&spec[*id].name), shape(spec, ty)),
        Type::Python(_) => words(spec, ty),
    }
}

/// One and many.
fn scalar_words(scalar: &Scalar) -> [String; 2] {
    match scalar {
        Scalar::Bool { off, on } => [(); 2].map(|()| format!("{} or {}", code(off), code(on))),
        Scalar::Int => ["integer", "integers"].map(str::to_owned),
        Scalar::Float => ["number", "numbers"].map(str::to_owned),
        Scalar::Text => ["string", "strings"].map(str::to_owned),
        Scalar::Json => ["any JSON", "any JSON"].map(str::to_owned),
    }
}

/// JSON form of a named type, in words.
fn shape(spec: &Spec, ty: &Type) -> String {
    let shape = match spec.shape(ty) {
        Shape::IntEnum(_) => "integer",
        Shape::TextEnum(_) => "string",
        Shape::Tuple { .. } | Shape::Choice(_) => "array",
        Shape::Object(_) => "object",
        Shape::Scalar(_) | Shape::Python(_) | Shape::List(..) => return wrapped(spec, ty),
    };
    shape.to_owned()
}

/// JSON form of a wrapper, in words, such as `array of 6 numbers, in deg`.
pub(super) fn wrapped(spec: &Spec, ty: &Type) -> String {
    let unit = spec.unit(ty).map(|unit| format!(", in {unit}")).unwrap_or_default();
    words(spec, spec.unwrapped(ty)) + &unit
}

/// Heading of a named type.
pub(super) fn heading(name: &str) -> String {
    format!("Type `{name}`")
}

/// Link to a named type.
pub(super) fn name_link(name: &str) -> String {
    link(&code(name), &heading(name))
}
