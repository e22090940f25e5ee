//! Named types in full.

use std::fmt::{Display, Write as _};

use super::markdown::{Table, code, escape};
use super::{fields, type_phrase};
use crate::words::{self, first_sentence};
use crate::{EnumValue, Spec, Type, TypeDef, TypeId, TypeKind, evidence_sentence};

/// A named type in full.
pub(super) fn render(out: &mut String, spec: &Spec, (id, def): (TypeId, &TypeDef)) {
    let _ = writeln!(out, "### {}\n\n{}\n", type_phrase::heading(&def.name), escape(&def.doc));
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
            let _ = writeln!(out, "On the wire: {}.\n", type_phrase::wrapped(spec, &Type::Named(id)));
        }
    }
}

fn enum_values<T: Display>(out: &mut String, values: &[EnumValue<T>]) {
    let mut table = Table::new(&["value", "name", "meaning", "firmware"]);
    for value in values {
        let newer = value.advisory.then(|| "newer only".to_owned());
        let firmware: Vec<_> = newer.into_iter().chain(words::versions(&value.versions)).collect();
        let evidence = evidence_sentence(&value.evidence).map(|evidence| format!(" {evidence}")).unwrap_or_default();
        let first = format!("{}{evidence}", first_sentence(&value.doc).0);
        table.row([code(&value.wire.to_string()), value.name.clone(), first, firmware.join(", ")]);
    }
    table.render(out);
    fields::longer_docs(out, values.iter().map(|value| (value.wire.to_string(), value.doc.as_str())));
}
