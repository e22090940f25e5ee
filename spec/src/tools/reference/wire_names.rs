//! Docs with the names of the wire, for readers who write no Rust.

use std::collections::BTreeMap;

use crate::{Choice, Command, Field, Reply, Request, Spec, TypeKind};

/// The spec, with commands and fields in the docs called as on the wire. In the spec's files docs use the names of
/// Rust; errata quote the document, and stay as they are.
pub(super) fn in_wire_names(spec: &Spec) -> Spec {
    let commands = Names(spec.commands().map(|command| (command.name.clone(), command.wire.clone())).collect());
    let mut spec = spec.clone();
    for topic in &mut spec.topics {
        commands.rewrite(&mut topic.doc);
        topic.commands.iter_mut().for_each(|command| of_command(command, &commands));
        topic.errors.iter_mut().for_each(|error| commands.rewrite(&mut error.doc));
    }
    for def in &mut spec.types {
        let fields: Vec<_> = def.kind.fields().cloned().collect();
        let names = commands.and_those_of(fields.iter());
        names.rewrite(&mut def.doc);
        match &mut def.kind {
            TypeKind::Object(fields) | TypeKind::Array { fields, .. } => of_fields(fields, &names),
            TypeKind::Choice(choice) => of_choice(choice, &names),
            TypeKind::IntEnum(values) => values.iter_mut().for_each(|value| names.rewrite(&mut value.doc)),
            TypeKind::TextEnum(values) => values.iter_mut().for_each(|value| names.rewrite(&mut value.doc)),
            TypeKind::Wrapper(..) => {}
        }
    }
    spec
}

fn of_command(command: &mut Command, commands: &Names) {
    let names = commands.and_those_of(command.fields());
    names.rewrite(&mut command.doc);
    command.deprecated.iter_mut().for_each(|instead| names.rewrite(instead));
    match &mut command.request {
        Request::Fields(fields) => of_fields(fields, &names),
        Request::Choice(choice) => of_choice(choice, &names),
    }
    if let Reply::Fields(fields) = &mut command.reply {
        of_fields(fields, &names);
    }
}

fn of_choice(choice: &mut Choice, names: &Names) {
    for variant in &mut choice.variants {
        names.rewrite(&mut variant.doc);
        of_fields(&mut variant.fields, names);
    }
}

fn of_fields(fields: &mut [Field], names: &Names) {
    for field in fields {
        names.rewrite(&mut field.doc);
    }
}

/// Names on the wire, by the names in Rust.
struct Names(BTreeMap<String, String>);

impl Names {
    /// These names and those of fields, which come first. A text that is a key itself, or the name of two keys, stays
    /// as it is.
    fn and_those_of<'f>(&self, fields: impl Iterator<Item = &'f Field>) -> Self {
        let mut names = self.0.clone();
        let fields: Vec<_> = fields.filter(|field| !field.wire.is_empty()).collect();
        for field in &fields {
            let is_ambiguous = fields
                .iter()
                .any(|other| other.wire == field.name || other.name == field.name && other.wire != field.wire);
            let wire = if is_ambiguous { &field.name } else { &field.wire };
            names.insert(field.name.clone(), wire.clone());
        }
        Self(names)
    }

    /// Replaces each code span that is one of the names.
    fn rewrite(&self, text: &mut String) {
        let parts = text.split('`').enumerate();
        let parts = parts.map(|(i, part)| self.0.get(part).filter(|_| i % 2 == 1).map_or(part, String::as_str));
        *text = parts.collect::<Vec<_>>().join("`");
    }
}
