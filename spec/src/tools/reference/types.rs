//! Types in words, and the named ones in full.

use std::fmt::{Display, Write as _};

use super::fields;
use super::markdown::{Table, code, escape, link};
use crate::tools::words::first_sentence;
use crate::{EnumValue, Spec, Type, TypeDef, TypeKind};

/// The type in words, with a link to a named one.
pub(super) fn words(spec: &Spec, ty: &Type) -> String {
    match ty {
        Type::Bool { off, on } => format!("{} or {}", code(off), code(on)),
        Type::Int => "integer".to_owned(),
        Type::Float => "number".to_owned(),
        Type::Text => "string".to_owned(),
        Type::Json => "any JSON".to_owned(),
        Type::Named(name) => format!("{} ({})", name_link(name), shape(spec, name)),
        Type::List(element) => format!("array of {}", plural(spec, element)),
        Type::Array(element, len) => format!("array of {len} {}", plural(spec, element)),
        Type::Python(inner) => format!("string that holds a Python literal: {}", words(spec, inner)),
    }
}

fn plural(spec: &Spec, ty: &Type) -> String {
    match ty {
        Type::Int => "integers".to_owned(),
        Type::Float => "numbers".to_owned(),
        Type::Text => "strings".to_owned(),
        Type::List(_) | Type::Array(..) => words(spec, ty).replacen("array", "arrays", 1),
        Type::Named(name) => format!("{} (each: {})", name_link(name), shape(spec, name)),
        other => words(spec, other),
    }
}

/// What a named type is in JSON.
fn shape(spec: &Spec, name: &str) -> String {
    let shape = match spec.type_def(name).map(|def| &def.kind) {
        Some(TypeKind::IntEnum(_)) => "integer",
        Some(TypeKind::TextEnum(_)) => "string",
        Some(TypeKind::Array { .. } | TypeKind::Choice(_)) => "array",
        Some(TypeKind::Wrapper(ty, unit)) => return wrapped(spec, ty, unit.as_deref()),
        Some(TypeKind::Object(_)) | None => "object",
    };
    shape.to_owned()
}

/// What a wrapper is in JSON, such as `array of 6 numbers, in deg`.
fn wrapped(spec: &Spec, ty: &Type, unit: Option<&str>) -> String {
    let unit = unit.map(|unit| format!(", in {unit}")).unwrap_or_default();
    words(spec, ty) + &unit
}

fn heading(name: &str) -> String {
    format!("Type `{name}`")
}

pub(super) fn name_link(name: &str) -> String {
    link(&code(name), &heading(name))
}

/// A named type in full.
pub(super) fn render(out: &mut String, spec: &Spec, def: &TypeDef) {
    let _ = writeln!(out, "### {}\n\n{}\n", heading(&def.name), escape(&def.doc));
    match &def.kind {
        TypeKind::Object(fields) => {
            *out += "A JSON object:\n\n";
            fields::render(out, spec, fields, 0);
        }
        TypeKind::Array { fields, exact } => {
            let further = if *exact { "nothing behind them" } else { "possibly with more behind them" };
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
        TypeKind::Wrapper(ty, unit) => {
            let _ = writeln!(out, "On the wire: {}.\n", wrapped(spec, ty, unit.as_deref()));
        }
    }
}

fn enum_values<T: Display>(out: &mut String, values: &[EnumValue<T>]) {
    let mut table = Table::new(&["value", "name", "meaning", "firmware"]);
    for value in values {
        let newer = if value.advisory { "newer only" } else { "" };
        let first = first_sentence(&value.doc).0.to_owned();
        table.row([code(&value.wire.to_string()), value.name.clone(), first, newer.to_owned()]);
    }
    table.render(out);
    fields::longer_docs(out, values.iter().map(|value| (value.wire.to_string(), value.doc.as_str())));
}
