//! Types in words, and the named ones in full.

use std::fmt::{Display, Write as _};

use super::fields;
use super::markdown::{Table, code, escape, link};
use crate::words::{self, first_sentence};
use crate::{EnumValue, Scalar, Shape, Spec, Type, TypeDef, TypeId, TypeKind};

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

/// What a named type is in JSON.
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

/// What a wrapper is in JSON, such as `array of 6 numbers, in deg`.
fn wrapped(spec: &Spec, ty: &Type) -> String {
    let unit = spec.unit(ty).map(|unit| format!(", in {unit}")).unwrap_or_default();
    words(spec, spec.unwrapped(ty)) + &unit
}

fn heading(name: &str) -> String {
    format!("Type `{name}`")
}

pub(super) fn name_link(name: &str) -> String {
    link(&code(name), &heading(name))
}

/// A named type in full.
pub(super) fn render(out: &mut String, spec: &Spec, (id, def): (TypeId, &TypeDef)) {
    let _ = writeln!(out, "### {}\n\n{}\n", heading(&def.name), escape(&def.doc));
    match &def.kind {
        TypeKind::Object(fields) => {
            *out += "A JSON object:\n\n";
            fields::render(out, spec, fields, 0);
        }
        TypeKind::Array { fields, exact } => {
            let further = if *exact { "nothing after them" } else { "possibly with more after them" };
            let _ = writeln!(out, "A JSON array of these elements, {further}:\n");
            fields::render(out, spec, fields, 0);
        }
        TypeKind::Choice(choice) => {
            *out += "A JSON array. Its first element is an integer that tells which elements follow:\n\n";
            fields::variants(out, spec, choice);
        }
        TypeKind::IntEnum(values) => {
            *out += "An integer:\n\n";
            enum_values(out, values);
        }
        TypeKind::TextEnum(values) => {
            *out += "A string:\n\n";
            enum_values(out, values);
        }
        TypeKind::Wrapper(..) => {
            let _ = writeln!(out, "On the wire: {}.\n", wrapped(spec, &Type::Named(id)));
        }
    }
}

fn enum_values<T: Display>(out: &mut String, values: &[EnumValue<T>]) {
    let mut table = Table::new(&["value", "name", "meaning", "firmware"]);
    for value in values {
        let newer = value.advisory.then(|| "newer only".to_owned());
        let firmware: Vec<_> = newer.into_iter().chain(words::versions(&value.versions)).collect();
        let first = first_sentence(&value.doc).0.to_owned();
        table.row([code(&value.wire.to_string()), value.name.clone(), first, firmware.join(", ")]);
    }
    table.render(out);
    fields::longer_docs(out, values.iter().map(|value| (value.wire.to_string(), value.doc.as_str())));
}
