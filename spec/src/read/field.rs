//! The fields of requests, replies and types.

use super::common::{Unique, required_doc, snake_name, versions};
use crate::item::{Item, Placed};
use crate::model::{Field, Range, Type};
use crate::names::RESERVED_FIELDS;
use crate::resolve::Index;
use crate::type_text;

/// Fields of a struct written as an object, from `[[… .key]]`.
pub(super) fn fields<'s>(item: &Item<'_, 's>, key: &'static str, what: &str, index: &mut Index<'s>) -> Vec<Field> {
    let mut names = Unique::default();
    let mut keys = Unique::default();
    let read = |item: &Item<'_, 's>| {
        let wire = item.required_text("wire");
        keys.add(item, "key", &wire);
        field(item, wire, index, &mut names)
    };
    item.items(key, what).iter().map(read).collect()
}

/// Fields of a struct written as an array: they have a place instead of a key.
pub(super) fn elements<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Vec<Field> {
    let mut names = Unique::default();
    let mut optional_seen = false;
    let read = |item: &Item<'_, 's>| {
        let field = field(item, Placed { at: item.at, value: String::new() }, index, &mut names);
        if optional_seen && !field.optional {
            item.error(item.at, "an element behind an optional one must be optional too");
        }
        optional_seen |= field.optional;
        field
    };
    item.items("field", "field").iter().map(read).collect()
}

fn field<'s>(
    item: &Item<'_, 's>,
    wire: Placed<'s, String>,
    index: &mut Index<'s>,
    names: &mut Unique<'s, String>,
) -> Field {
    let name = snake_name(item, &wire);
    names.add(item, "name", &name);
    if RESERVED_FIELDS.contains(&name.value.as_str()) {
        item.error(name.at, &format!("`{}` is a name of the generated code; give another as `name`", name.value));
    }
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
        versions: versions(item),
        wire: wire.value,
    };
    check_field(item, &field);
    item.finish();
    field
}

fn check_field(item: &Item<'_, '_>, field: &Field) {
    let scalar = innermost(&field.ty);
    let numeric = matches!(scalar, Type::Int | Type::Float);
    if field.range.min.zip(field.range.max).is_some_and(|(min, max)| min > max) {
        item.error(item.at, "`min` is greater than `max`");
    }
    if (field.range != Range::default()) && !numeric {
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
