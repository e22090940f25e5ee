//! The fields of requests, replies and types.

use super::common::{required_doc, snake_name, versions};
use super::wire::{NEEDS_KEY, field_type, key, written};
use crate::item::{Item, Placed, Unique};
use crate::model::{Field, Type};
use crate::names::RESERVED_FIELDS;
use crate::range::Range;
use crate::resolve::{Index, NO_ENUM, Need};
use crate::scalar::Scalar;
use crate::version::Versions;
use crate::{advice, evidence};

/// Fields of a struct, from `[[… .key]]`. One written as an object has keys, none of which is one of `taken`; one
/// written as an array has no `taken`.
pub(crate) fn fields<'s>(
    item: &Item<'_, 's>,
    (key, what): (&'static str, &str),
    taken: Option<&[&str]>,
    index: &mut Index<'s>,
) -> Vec<Field> {
    let mut names = Unique::default();
    let mut keys = Unique::default();
    let mut optional_seen = false;
    let read = |item: &Item<'_, 's>| {
        let (wire, name) = key_and_name(item, taken);
        names.add(item, "name", &name);
        if taken.is_some() {
            keys.add(item, "key", &wire);
        }
        let field = read(item, wire.value, name, index);
        if taken.is_none() && optional_seen && !field.optional {
            item.error(item.at, OPTIONAL_LAST);
        }
        optional_seen |= field.optional;
        field
    };
    let fields: Vec<_> = item.items(key, what).iter().map(read).collect();
    index.advised(item, &fields);
    fields
}

pub(crate) const OPTIONAL_LAST: &str = "an element after an optional one must be optional too";

/// One field of a struct; `taken` as in [`fields`].
pub(crate) fn field<'s>(item: &Item<'_, 's>, taken: Option<&[&str]>, index: &mut Index<'s>) -> Field {
    let (wire, name) = key_and_name(item, taken);
    read(item, wire.value, name, index)
}

fn key_and_name<'s>(item: &Item<'_, 's>, taken: Option<&[&str]>) -> (Placed<'s, String>, Placed<'s, String>) {
    let Some(taken) = taken else {
        let name = item.required_text("name");
        return (Placed { at: item.at, value: String::new() }, snake_name(item, &name));
    };
    let wire = key(item, taken);
    let name = snake_name(item, &wire);
    (wire, name)
}

fn read<'s>(item: &Item<'_, 's>, wire: String, name: Placed<'s, String>, index: &mut Index<'s>) -> Field {
    check_name(item, &name);
    let ty = field_type(item, index);
    let field = Field {
        name: name.value,
        constructors: constructors(item, &ty, index),
        ty,
        unit: item.text("unit").map(|text| text.value),
        range: range(item),
        advised: advice::read(item),
        ascii: item.flag("ascii").is_some_and(|flag| flag.value),
        optional: item.flag("optional").is_some_and(|flag| flag.value),
        or_raw: item.flag("or_raw").is_some_and(|flag| flag.value),
        doc: required_doc(item),
        disputed: item.texts("disputed").into_iter().map(|text| text.value).collect(),
        versions: versions(item, &Versions::default()),
        evidence: evidence::read(item),
        wire,
    };
    check_field(item, &field);
    item.finish();
    field
}

/// Whether Rust gets a constructor for each value of the field's enum.
fn constructors<'s>(item: &Item<'_, 's>, ty: &Type, index: &mut Index<'s>) -> bool {
    let Some(flag) = item.flag("constructors").filter(|flag| flag.value) else { return false };
    if item.flag("optional").is_some_and(|flag| flag.value) {
        item.error(flag.at, "`constructors` is for a field that is always there");
    }
    match ty {
        Type::Named(id) => index.needs(item, flag.at, Need::Enum(*id)),
        _ => item.error(flag.at, NO_ENUM),
    }
    true
}

/// The field after an `[[override]]`: a missing key of the table changes nothing. The table must not have the keys in
/// `taken`; an element of an array has none.
pub(crate) fn changed_field<'s>(item: &Item<'_, 's>, base: &Field, taken: &[&str], index: &mut Index<'s>) -> Field {
    let wire = if item.has("wire") { key(item, taken).value } else { base.wire.clone() };
    if base.wire.is_empty() && !wire.is_empty() {
        item.error(item.at, "an element of an array has no key");
    }
    let name = snake_name(item, &Placed { at: item.at, value: base.name.clone() });
    check_name(item, &name);
    let flag = |key, before: bool| item.flag(key).map_or(before, |flag| flag.value);
    let mut ty = base.ty.clone();
    if item.has("type") {
        ty = field_type(item, index);
    } else {
        written(item, &mut ty);
    }
    let limits = if is_number(&ty) { base.range } else { Range::default() };
    let advised = match item.has("advised") {
        true => advice::read(item),
        false if is_number(&ty) || ty == base.ty => base.advised.clone(),
        false => Vec::new(),
    };
    let bound = |key, before| item.bound(key).map_or(before, |bound| Some(bound.value).filter(|b| b.is_finite()));
    let mut field = Field {
        wire,
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
        advised,
        ascii: flag("ascii", base.ascii),
        optional: flag("optional", base.optional),
        constructors: base.constructors && !item.has("type") && !flag("optional", base.optional),
        or_raw: flag("or_raw", base.or_raw),
        doc: if item.has("doc") { required_doc(item) } else { base.doc.clone() },
        disputed: base.disputed.clone(),
        versions: versions(item, &base.versions),
        evidence: base.evidence.clone(),
    };
    settle(item, &mut field, base);
    check_field(item, &field);
    item.finish();
    field
}

/// Settles a disputed field: a pack that chooses one of the sources' readings says why. A reason for a field that is
/// not disputed is not an error.
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
    if field.range.min.zip(field.range.max).is_some_and(|(min, max)| min > max) {
        item.error(item.at, "`min` is greater than `max`");
    }
    if (field.range != Range::default()) && !is_number(&field.ty) {
        item.error(item.at, "`min`, `max` and `advisory` are for numbers");
    }
    if field.range.advisory && field.range.min.is_none() && field.range.max.is_none() {
        item.error(item.at, "`advisory` is for a range: give `min` or `max`");
    }
    let is_whole = match &field.ty {
        Type::Scalar(_) => true,
        Type::Python(inner) => !inner.needs_key(),
        other => !other.needs_key(),
    };
    if !is_whole || field.ty.needs_key() && (field.wire.is_empty() || field.or_raw) {
        item.error(item.at, NEEDS_KEY);
    }
    if field.ascii && field.ty.scalar() != Some(&Scalar::Text) {
        item.error(item.at, "`ascii` is for text");
    }
    if field.disputed.len() == 1 {
        item.error(item.at, "`disputed` lists the readings of at least two sources");
    }
}

/// True for a number, and for an array of numbers.
fn is_number(ty: &Type) -> bool {
    ty.scalar().is_some_and(Scalar::is_number)
}

fn range(item: &Item<'_, '_>) -> Range {
    Range {
        min: item.number("min").map(|n| n.value),
        max: item.number("max").map(|n| n.value),
        advisory: item.flag("advisory").is_some_and(|flag| flag.value),
    }
}

/// The type inside a wrapper.
pub(super) fn wrapped_type<'s>(item: &Item<'_, 's>, index: &mut Index<'s>) -> Type {
    let ty = field_type(item, index);
    if ty.needs_key() {
        item.error(item.at, NEEDS_KEY);
    }
    ty
}
