//! `[robot_status]`: sources of the status that a robot needs.

use std::collections::BTreeMap;

use super::Module;
use crate::Source;
use crate::item::Item;
use crate::model::{Field, TypeId};
use crate::names::nearest;
use crate::needed::{ABSENT, FieldSource, NEEDED_FIELDS, NeededField, PROGRAM, StatusLine};
use crate::report::{At, Report};
use crate::spec::Spec;

/// Lines and entries of a file for the needs of a robot.
#[derive(Debug, Default)]
pub(super) struct Lines<'s> {
    /// Places of its lines, by the needed field.
    lines: BTreeMap<&'static str, At<'s>>,
    /// Entries that change a field of the status packet, by the name that the field had.
    changes: BTreeMap<String, (At<'s>, String)>,
}

impl<'s> Lines<'s> {
    /// Reads the table into the spec; the type of the status packet, if a line changes it.
    pub(super) fn read(&mut self, item: &Item<'_, 's>, spec: &mut Spec) -> Option<TypeId> {
        let Some(status) = spec.status_type() else {
            item.error(item.at, "the spec has no status packet");
            return None;
        };
        for needed in NEEDED_FIELDS {
            let Some(text) = item.text(needed.name) else { continue };
            let line = StatusLine::of(&text.value);
            if line == StatusLine::Absent && needed.is_required {
                let message = format!("`{}` is required: without it, {}", needed.name, needed.without);
                item.error(text.at, &format!("{message}; write the field that has it, or {}", by_program(needed)));
                continue;
            }
            self.lines.insert(needed.name, text.at);
            spec.status_lines.insert(needed.name, line);
        }
        item.finish();
        (!self.lines.is_empty()).then_some(status)
    }

    /// Takes note of an entry that changes a field of the status packet.
    pub(super) fn note(&mut self, field: &str, item: &Item<'_, 's>) {
        self.changes.insert(field.to_owned(), (item.at, item.what.clone()));
    }

    /// Checks that each needed field has a source. `edits` are the entries of the file, with the types that they
    /// change.
    pub(super) fn check(
        &self,
        spec: &Spec,
        source: Source<'s>,
        edits: impl Iterator<Item = (At<'s>, String, Option<TypeId>)>,
        report: &Report,
    ) {
        let edits: Vec<_> = edits.collect();
        let built_in = spec.as_built_in();
        for needed in NEEDED_FIELDS {
            let Some(known) = built_in.status_fields().iter().find(|known| known.name == needed.name) else { continue };
            if spec.status_source(known).is_some() {
                continue;
            }
            let named =
                if let Some(StatusLine::Field(name)) = spec.status_lines.get(needed.name) { name } else { needed.name };
            let field = spec.status_fields().iter().find(|field| field.name == named);
            if let Some(at) = self.lines.get(needed.name) {
                report.error(*at, format!("`[robot_status]`: {}", line_problem(spec, needed, named, field)));
                continue;
            }
            // The entry that changes the field, or else its type, or else a part of that.
            let of_type = |id: Option<TypeId>| id.is_some() && id == known.ty.named();
            let entry = self.changes.get(named).map(|(at, what)| (*at, what.clone())).or_else(|| {
                let edit =
                    edits.iter().find(|(.., id)| of_type(*id)).or_else(|| edits.iter().find(|(.., id)| id.is_some()));
                edit.map(|(at, what, _)| (*at, what.clone()))
            });
            let (at, what) = entry.unwrap_or_else(|| (At { source, offset: 0 }, "this pack".to_owned()));
            report.error(at, format!("{what}: {}", unmapped(needed, field.is_some())));
        }
    }
}

/// A module's status packet has the built-in types, not those that a pack describes otherwise.
pub(super) fn check_module(module: &Module, source: Source<'_>, report: &Report) {
    let has_status = module.spec.status_type().is_some_and(|id| module.topic.types.contains(&id));
    let is_packs = |field: &Field| {
        let topic = field.ty.named().and_then(|id| module.spec.topic_of(id));
        topic.is_some_and(|topic| topic.is_pack)
    };
    for needed in module.spec.robot_status().filter(|_| has_status) {
        let FieldSource::Field(field) = needed.source else { continue };
        if is_packs(field) {
            let message = format!(
                "the type of `{}` is this pack's own, and a robot needs the built-in one; in `[robot_status]`, \
                 write {}",
                field.name,
                by_program(needed.needed)
            );
            report.error(At { source, offset: 0 }, message);
        }
    }
}

/// Problem of a line that names no field which means the same.
fn line_problem(spec: &Spec, needed: &NeededField, name: &str, field: Option<&Field>) -> String {
    let program = by_program(needed);
    if field.is_some() {
        return format!(
            "the field `{name}` has another type or unit than `{}` as built in; write one that has the same, or \
             {program}",
            needed.name
        );
    }
    let near = nearest(name, spec.status_fields().iter().map(|field| &*field.name));
    let hint = near.map(|near| format!("; there is `{near}`")).unwrap_or_default();
    format!("status packets have no field with the name `{name}` in Rust{hint}")
}

/// A field that a robot needs, and that is not there any more as built in.
fn unmapped(needed: &NeededField, is_there: bool) -> String {
    let name = needed.name;
    let what = if is_there { "changes the type or unit of" } else { "gives another name to" };
    let absent = if needed.is_required {
        String::new()
    } else {
        format!("`{name} = \"{ABSENT}\"` where packets never have it, or ")
    };
    format!(
        "it {what} `{name}`, which a robot needs; say in a table `[robot_status]` which field of the built-in type and \
         unit has it, `{name} = \"FIELD\"`, or {absent}{}",
        by_program(needed)
    )
}

fn by_program(needed: &NeededField) -> String {
    format!("`{} = \"{PROGRAM}\"` where the program implements `MotionStatus` itself", needed.name)
}
