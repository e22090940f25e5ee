//! The fields of requests, replies and types.

use super::common::{Unique, required_doc, snake_name, versions};
use crate::item::{Item, Placed};
use crate::model::{Field, Range, Type};
use crate::names::RESERVED_FIELDS;
use crate::resolve::Index;
use crate::type_text;
use crate::version::Versions;

/// Fields of a struct written as an object, from `[[… .key]]`.
pub(super) fn fields<'s>(item: &Item<'_, 's>, key: &'static str, what: &str, index: &mut Index<'s>) -> Vec<Field> {
    let mut names = Unique::default();
    let mut keys = Unique::default();
    let read = |item: &Item<'_, 's>| {
        let wire = item.required_text("wire");
        let name = snake_name(item, &wire);
        keys.add(item, "key", &wire);
        names.add(item, "name", &name);
        read(item, wire.value, name, index)
    };
    item.items(key, what).iter().map(read).collect()
}

/// One field of a struct written as an object.
pub(crate) fn field<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Field {
    let wire = item.required_text("wire");
    let name = snake_name(item, &wire);
    read(item, wire.value, name, index)
}

/// Fields of a struct written as an array: they have a place instead of a key.
pub(super) fn elements<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Vec<Field> {
    let mut names = Unique::default();
    let mut optional_seen = false;
    let read = |item: &Item<'_, 's>| {
        let name = snake_name(item, &Placed { at: item.at, value: String::new() });
        names.add(item, "name", &name);
        let field = read(item, String::new(), name, index);
        if optional_seen && !field.optional {
            item.error(item.at, "an element behind an optional one must be optional too");
        }
        optional_seen |= field.optional;
        field
    };
    item.items("field", "field").iter().map(read).collect()
}

/// One field of a struct written as an array.
pub(crate) fn element<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Field {
    let name = snake_name(item, &Placed { at: item.at, value: String::new() });
    read(item, String::new(), name, index)
}

fn read<'s>(item: &Item<'_, 's>, wire: String, name: Placed<'s, String>, index: &mut Index<'s>) -> Field {
    check_name(item, &name);
    let field = Field {
        name: name.value,
        ty: field_type(item, index),
        unit: item.text("unit").map(|text| text.value),
        range: range(item),
        ascii: item.flag("ascii").is_some_and(|flag| flag.value),
        optional: item.flag("optional").is_some_and(|flag| flag.value),
        or_raw: item.flag("or_raw").is_some_and(|flag| flag.value),
        doc: required_doc(item),
        disputed: item.texts("disputed").into_iter().map(|text| text.value).collect(),
        versions: versions(item, &Versions::default()),
        wire,
    };
    check_field(item, &field);
    item.finish();
    field
}

/// The field as an `[[override]]` changes it: what the table does not say stays as it is.
pub(crate) fn changed_field<'s>(item: &Item<'_, 's>, base: &Field, index: &mut Index<'s>) -> Field {
    let name = snake_name(item, &Placed { at: item.at, value: base.name.clone() });
    check_name(item, &name);
    let flag = |key, before: bool| item.flag(key).map_or(before, |flag| flag.value);
    let ty = if item.has("type") { field_type(item, index) } else { base.ty.clone() };
    let limits = if is_number(&ty) { base.range } else { Range::default() };
    let bound = |key, before| item.bound(key).map_or(before, |bound| Some(bound.value).filter(|b| b.is_finite()));
    let mut field = Field {
        wire: base.wire.clone(),
        name: name.value,
        ty,
        unit: item
            .text("unit")
            .map_or_else(|| base.unit.clone(), |unit| Some(unit.value).filter(|unit| !unit.is_empty())),
        range: Range {
            min: bound("min", limits.min),
            max: bound("max", limits.max),
            advisory: flag("advisory", limits.advisory),
        },
        ascii: flag("ascii", base.ascii),
        optional: flag("optional", base.optional),
        or_raw: flag("or_raw", base.or_raw),
        doc: if item.has("doc") { required_doc(item) } else { base.doc.clone() },
        disputed: base.disputed.clone(),
        versions: versions(item, &base.versions),
    };
    settle(item, &mut field, base);
    check_field(item, &field);
    item.finish();
    field
}

/// Where sources contradict each other, whoever takes a side says why. Where they do no longer, that is no error.
fn settle(item: &Item<'_, '_>, field: &mut Field, base: &Field) {
    match item.text("settled") {
        Some(settled) => {
            field.disputed.clear();
            field.doc = format!("{}\n\nSettled: {}", field.doc, settled.value.trim());
        }
        None if !base.disputed.is_empty() && (field.ty != base.ty || field.doc != base.doc) => {
            let readings = base.disputed.join("; ");
            item.error(item.at, &format!("the meaning is disputed ({readings}); say in `settled` how you found out"));
        }
        None => {}
    }
}

fn check_name(item: &Item<'_, '_>, name: &Placed<'_, String>) {
    if RESERVED_FIELDS.contains(&name.value.as_str()) {
        item.error(name.at, &format!("`{}` is a name of the generated code; give another as `name`", name.value));
    }
}

fn check_field(item: &Item<'_, '_>, field: &Field) {
    let scalar = innermost(&field.ty);
    if field.range.min.zip(field.range.max).is_some_and(|(min, max)| min > max) {
        item.error(item.at, "`min` is greater than `max`");
    }
    if (field.range != Range::default()) && !is_number(&field.ty) {
        item.error(item.at, "`min`, `max` and `advisory` are for numbers");
    }
    if field.range.advisory && field.range.min.is_none() && field.range.max.is_none() {
        item.error(item.at, "`advisory` is for a range: give `min` or `max`");
    }
    if has_words(scalar) && (field.wire.is_empty() || field.ty != *scalar) {
        item.error(item.at, "words for false and true are read only where the field itself is a bool with a key");
    }
    if field.ascii && *scalar != Type::Text {
        item.error(item.at, "`ascii` is for text");
    }
    if field.disputed.len() == 1 {
        item.error(item.at, "`disputed` lists the readings of at least two sources");
    }
}

/// True for a bool that is written in words of its own, such as `robot_enabled`.
fn has_words(ty: &Type) -> bool {
    let usual = |form: &str| matches!(form.to_ascii_lowercase().trim_matches('"'), "false" | "true" | "0" | "1");
    matches!(ty, Type::Bool { off, on } if !usual(off) || !usual(on))
}

/// True for a number, and for an array of numbers.
fn is_number(ty: &Type) -> bool {
    matches!(innermost(ty), Type::Int | Type::Float)
}

fn innermost(ty: &Type) -> &Type {
    match ty {
        Type::List(element) | Type::Array(element, _) | Type::Python(element) => innermost(element),
        other => other,
    }
}

fn range(item: &Item<'_, '_>) -> Range {
    Range {
        min: item.number("min").map(|n| n.value),
        max: item.number("max").map(|n| n.value),
        advisory: item.flag("advisory").is_some_and(|flag| flag.value),
    }
}

pub(super) fn field_type<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Type {
    let text = item.required_text("type");
    let mut ty = match type_text::parse(&text.value) {
        Ok(ty) => ty,
        Err(message) => {
            if !text.value.is_empty() {
                item.error(text.at, &message);
            }
            return Type::Json;
        }
    };
    if let Some(written) = item.json_scalars("written") {
        match (innermost_mut(&mut ty), written.value.as_slice()) {
            (Type::Bool { off, on }, [no, yes]) if no != yes => {
                no.clone_into(off);
                yes.clone_into(on);
            }
            _ => item.error(written.at, "`written` gives a bool's two forms: how false is written, then true"),
        }
    }
    index.type_use(item, text.at, &ty);
    ty
}

fn innermost_mut(ty: &mut Type) -> &mut Type {
    match ty {
        Type::List(element) | Type::Array(element, _) | Type::Python(element) => innermost_mut(element),
        other => other,
    }
}
