//! Texts of the descriptions.

use std::fmt::Display;

use crate::{Command, EnumValue, Field, Spec, Type, words};

/// The texts that are not empty, as paragraphs.
pub(super) fn join(texts: &[&str]) -> String {
    let texts: Vec<_> = texts.iter().map(|text| text.trim()).filter(|text| !text.is_empty()).collect();
    texts.join("\n\n")
}

/// `In deg/s.`, where there is a unit.
pub(super) fn unit(unit: Option<&str>) -> String {
    unit.map(|unit| format!("In {unit}.")).unwrap_or_default()
}

/// Description of a field: its meaning, its unit, and the points on which sources disagree.
pub(super) fn field(spec: &Spec, fields: &[Field], field: &Field) -> String {
    let python = match &field.ty {
        Type::Python(inner) => format!("The value of the Python literal is {}.", spec.notation(inner)),
        _ => String::new(),
    };
    let newer = if field.range.advisory { "Newer firmware takes more than this range." } else { "" };
    let advised =
        words::advised(spec, fields, field, |other| other.wire.clone()).map(|advised| format!("Advised: {advised}."));
    let advised = advised.unwrap_or_default();
    let shape = if field.or_raw { "The sources leave doubt about the shape: another may come." } else { "" };
    let disputed = if field.disputed.is_empty() {
        String::new()
    } else {
        format!("Sources contradict each other: {}.", field.disputed.join("; "))
    };
    let versions = words::versions(&field.versions).map(|versions| format!("Known to firmware {versions}."));
    let versions = versions.unwrap_or_default();
    join(&[&field.doc, &unit(field.unit.as_deref()), &python, newer, &advised, shape, &disputed, &versions])
}

/// Description of a request: its effect and its requirements.
pub(super) fn request(command: &Command) -> String {
    let needs = words::requirements(&command.requires).map(|states| format!("The robot must be {states}."));
    join(&[&command.doc, &needs.unwrap_or_default(), &words::known_to(command).unwrap_or_default()])
}

/// The values that only newer firmware takes.
pub(super) fn newer_values<T: Display>(values: &[EnumValue<T>]) -> String {
    let newer: Vec<_> = values.iter().filter(|value| value.advisory).map(named).collect();
    if newer.is_empty() { String::new() } else { format!("Newer firmware also takes {}.", words::list(&newer, "and")) }
}

/// The values that the spec lists, where others are read too.
pub(super) fn known_values<T: Display>(values: &[EnumValue<T>]) -> String {
    let known: Vec<_> = values.iter().map(named).collect();
    format!("Known are {}; others are read too.", words::list(&known, "and"))
}

fn named<T: Display>(value: &EnumValue<T>) -> String {
    let versions = words::versions(&value.versions).map(|versions| format!(", firmware {versions}"));
    format!("{} ({}{})", value.wire, value.name, versions.unwrap_or_default())
}
