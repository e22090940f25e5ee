//! Tables of fields.

use std::fmt::Write as _;

use super::markdown::{Table, code, escape};
use super::type_phrase;
use crate::words::{self, first_sentence};
use crate::{Choice, Field, Spec, evidence_sentence};

/// A table of the fields, and below it what does not fit into its rows. `first` is the place of the first element,
/// where the fields are elements of an array.
pub(super) fn render(out: &mut String, spec: &Spec, fields: &[Field], first: usize) {
    let mut table = Table::new(&["key", "#", "name", "type", "unit", "range", "optional", "meaning"]);
    for (index, field) in fields.iter().enumerate() {
        let is_element = field.wire.is_empty();
        table.row([
            if is_element { String::new() } else { code(&field.wire) },
            if is_element { (first + index).to_string() } else { String::new() },
            if field.wire == field.name { String::new() } else { code(&field.name) },
            field_type(spec, field),
            field.unit.clone().unwrap_or_default(),
            range(spec, fields, field),
            if field.optional { "optional".to_owned() } else { String::new() },
            meaning(field),
        ]);
    }
    table.render(out);
    longer_docs(out, fields.iter().map(|field| (label(field), field.doc.as_str())));
    for field in fields {
        disputed(out, field);
    }
}

/// The fields for each value of the tag, which is a key, or the first element of an array.
pub(super) fn variants(out: &mut String, spec: &Spec, choice: &Choice) {
    let tag = if choice.tag.is_empty() { String::new() } else { code(&choice.tag) + " " };
    for variant in &choice.variants {
        let _ = writeln!(out, "**{tag}{} ({})**: {}\n", variant.wire, variant.name, escape(&variant.doc));
        render(out, spec, &variant.fields, 1);
    }
}

/// Lists the sentences of the docs after the first, which the tables leave out.
pub(super) fn longer_docs<'d>(out: &mut String, docs: impl Iterator<Item = (String, &'d str)>) {
    let mut any = false;
    for (label, doc) in docs {
        let rest = first_sentence(doc).1.trim();
        if !rest.is_empty() {
            any = true;
            let _ = writeln!(out, "- `{label}`: {}", escape(rest).replace('\n', "\n  ").replace("\n  \n", "\n\n"));
        }
    }
    if any {
        *out += "\n";
    }
}

fn label(field: &Field) -> String {
    if field.wire.is_empty() { field.name.clone() } else { field.wire.clone() }
}

fn field_type(spec: &Spec, field: &Field) -> String {
    let ty = type_phrase::words(spec, &field.ty);
    let ascii = if field.ascii { ", printable ASCII only" } else { "" };
    let or_raw = if field.or_raw { ", or another shape" } else { "" };
    format!("{ty}{ascii}{or_raw}")
}

fn range(spec: &Spec, fields: &[Field], field: &Field) -> String {
    let range = words::range(field.range);
    let newer = field.range.advisory.then(|| "newer firmware takes more".to_owned());
    let advised =
        words::advised(spec, fields, field, |other| other.wire.clone()).map(|advised| format!("advised: {advised}"));
    [range, newer, advised].into_iter().flatten().collect::<Vec<_>>().join("; ")
}

fn meaning(field: &Field) -> String {
    let first = first_sentence(&field.doc).0;
    let versions =
        words::versions(&field.versions).map(|versions| format!(" Firmware {versions}.")).unwrap_or_default();
    let disputed = if field.disputed.is_empty() { "" } else { " Disputed: see below." };
    let evidence = evidence_sentence(&field.evidence).map(|evidence| format!(" {evidence}")).unwrap_or_default();
    format!("{first}{versions}{disputed}{evidence}")
}

fn disputed(out: &mut String, field: &Field) {
    if field.disputed.is_empty() {
        return;
    }
    let _ = writeln!(out, "Sources contradict each other on `{}`:\n", label(field));
    for reading in &field.disputed {
        let _ = writeln!(out, "- {}", escape(reading));
    }
    *out += "\n";
}
